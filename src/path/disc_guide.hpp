#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "path/disc_ends.hpp"
#include "path/disc_map.hpp"
#include "path/guide_distances.hpp"
#include "path/optimal.hpp"

namespace waywright::path {

/// Guides the search for the shortest path of a disc: a point agent searches for its shortest path from the goal back
/// to the start, and crosses no edge that is closed for the disc (DiscMap::is_closed). The distance of a vertex, minus
/// the radius, is a lower bound of the rest of a disc's path that turns around the vertex.
///
/// Let P be a path of the disc that is not longer than a length l, and r the radius. Then:
/// - The centre of the disc crosses no closed edge. So P is a path of the guide, too.
/// - Let v be a vertex of a pivot of P, and x the position of the disc when it reaches this pivot. The segment from
///   x to v has the length r. It crosses no wall, because no wall is nearer to x than r. It crosses no closed bridge.
///   If it crossed one, v would lie in the piece of the disc beyond the bridge. This piece lies in the disc whose
///   diameter is the bridge, because the bridge is shorter than the disc is wide and its ends do not lie inside the
///   disc. But walls touch the disc of the bridge only at the two ends of the bridge. Therefore a path of the guide
///   leads from the start over x to v, and another path of the guide leads from v over x to the goal. The sum of their
///   lengths is at most l + 2 r. So if the guide has followed all windows whose bound is below l + 2 r, then v has a
///   distance, and this distance is at most r longer than the rest of P.
/// - A straight line of P leads from one pivot or end to the next. The segment between their vertices lies in the
///   strip that the disc sweeps, so no wall meets it, and for the reason above no closed bridge meets it. Consider a
///   position on this segment. The nearest position on the line of P is at most r away. The segment between these two
///   positions crosses no closed edge: a closed edge that crosses this segment would end in the strip, or would cross
///   P, the segment between the vertices, or a segment from a vertex to a position of P. All of these are impossible.
///   So a path of the guide that is not longer than l + 2 r leads through each position on the segment between the
///   vertices, and the guide has followed a window across each edge that this segment crosses.
///
/// The guide enters no dead end without the start, but a vertex of P may lie there: the disc may touch it while its
/// centre is outside of the dead end. GuideDistances::is_unknown() recognises these vertices and the edges in dead
/// ends: they belong to tree faces that the guide has not entered. DiscOptimal uses no distances and no marks for them.
/// For a vertex elsewhere, the proof above holds. The segment from x to the vertex, or P itself, may enter a dead end
/// without an end of the path. Then it enters and leaves the dead end across the same edge. The straight piece of this
/// edge between these two positions is not longer than the detour through the dead end.
///
/// If a path that is shorter than the limit leads through a position, Optimal keeps a shortest path to it, not
/// only to the goal. The reason is that Optimal leaves out a window or a root only in two cases: another path to each
/// position of the window, or to the root, is at most as long, or the bound of the window is not below the limit.
class DiscGuide {
 public:
  /// Starts the search. Requires: `ends` belongs to `map`, and no face contains both ends; `start` and `goal` are the
  /// ends in the coordinates of the world.
  void begin(const DiscMap& map, const DiscEnds& ends, const Point& start, const Point& goal);
  /// Continues until `expansions` reaches `limit` or the search has ended. Before continue_to(), the search ends when
  /// the guide has found its path or there is none. After continue_to(), it ends when the guide has followed all
  /// windows whose bound is below the new limit. Returns whether the search has ended.
  bool step(std::size_t limit, std::size_t& expansions) { return search_.step(limit, expansions); }
  /// Returns whether the guide has found a path. If it has found none, the disc has no path either.
  [[nodiscard]] bool is_found() const { return search_.is_found(0); }
  /// The length of the guide's path. Requires: is_found().
  [[nodiscard]] double length() const { return search_.length(0); }
  /// Collects the edges that the guide's path crosses, from the start to the goal. Each one is a half-edge of the face
  /// that the path leaves.
  /// Requires: is_found().
  [[nodiscard]] std::span<const mesh::HalfEdge> collect_exits();
  /// Makes the next calls of step() find the distances for all paths of the disc that are not longer than `length`.
  void continue_to(double length);
  /// Returns the distances of the guide. Requires: step() has returned true after continue_to().
  [[nodiscard]] const GuideDistances& distances() const { return distances_; }

 private:
  double radius_ = 0.0;
  std::vector<mesh::HalfEdge> first_;  ///< a half-edge of each face at the disc's goal
  std::vector<mesh::HalfEdge> last_;   ///< a half-edge of each face at the disc's start
  std::vector<mesh::HalfEdge> exits_;
  GuideDistances distances_;
  Optimal search_;
};

}  // namespace waywright::path

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/path.hpp"

#include "memory/scratch.hpp"
#include "path/looked_at.hpp"
#include "path/open_list.hpp"
#include "path/point_ends.hpp"
#include "path/taut_string.hpp"

namespace waywright::path {

/// Triangulation A* for a point agent: A* over the half-edges through which a channel enters a face. The search enters
/// each half-edge only once. The path is the taut string through the channel. The bound of a node is the length of the
/// string to the funnel's apex plus the length of the shortest path from there through the portal to the goal. This is
/// a lower bound for every path along the channel. The search continues until no open bound is below the length of the
/// best path found.
///
/// A channel leads from face to face across passages, never through a vertex. So no path passes through a wall, or at a
/// vertex from one wedge between walls into another.
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Difference: in the paper, the bound
/// g is the largest of several estimates from the portals' ends. This class stores the funnel of each channel. The
/// funnel gives a tighter bound at the same cost.
class TaStar {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Starts a search between two ends. If `looked_at` is not null, the search records in it the faces at which it
  /// looks. Then the triangulation may change, as in Optimal::begin().
  /// Requires: no face contains both ends; the ends do not change during the search and, without `looked_at`, the
  /// triangulation does not change either.
  void begin(const Triangulation& triangulation, const PointEnds& ends, LookedAt* looked_at);
  /// Makes room for faces that were added to the mesh after begin().
  void grow_to_mesh() { entered_.grow_to(std::size_t{3} * mesh_->face_slots()); }
  /// Continues the search until one of three things happens: `path.expansions` reaches `limit`; the search finds a path
  /// that is better than `path`; no channel is left that could contain a better path. Returns whether no channel is
  /// left.
  bool step(std::size_t limit, Path& path);
  /// Writes to Path::channel the edges that the best path crosses.
  void write_channel(Path& path) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A channel that the search has followed to an edge of a face.
  struct Node {
    mesh::HalfEdge entry;  ///< the edge through which the channel enters the face, as a half-edge of that face
    std::uint32_t before;  ///< the node from whose face the channel comes, or kNone
    Funnel funnel;
    double bound;  ///< no path from start to goal along this channel is shorter
  };

  void clear_entries();
  /// Opens a node for each passage of the start face of `h`.
  void leave_start_face(mesh::HalfEdge h);
  /// Opens a node for each passage of the node's face, except the edge of entry.
  void leave(std::uint32_t index);
  void open(mesh::HalfEdge exit, std::uint32_t before, const Funnel& funnel);
  /// Ends the node's string at the goal. Returns whether this is the best path so far.
  bool arrive(std::uint32_t index);
  void write_path(Path& path) const;
  [[nodiscard]] double bound(const Funnel& funnel) const;
  [[nodiscard]] double lower_bound() const;

  const PointEnds* ends_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  LookedAt* looked_at_ = nullptr;  ///< or null
  TautTree tree_;
  std::vector<Node> nodes_;
  OpenList open_;                               ///< indices in `nodes_`
  memory::ZeroedArray<std::uint32_t> entered_;  ///< by half-edge: the last query that entered a face through it
  memory::Stamp stamp_;
  bool is_found_ = false;
  double best_length_ = 0.0;
  std::uint32_t best_turn_ = 0;
  std::uint32_t best_node_ = 0;
  double dropped_bound_ = 0.0;  ///< the least bound of the channels that reached a half-edge already entered
};

}  // namespace waywright::path

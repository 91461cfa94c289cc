#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "clearance/changed_walls.hpp"
#include "clearance/disc.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/rounding.hpp"
#include "exact/gap.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// The scratch of BridgeFinder. Keep the object: later searches use its memory again.
struct BridgeScratch {
  /// A vertex, relative to a corner of a face from which a search starts.
  struct Seen {
    Point offset;              ///< from the corner
    double square;             ///< of the distance from the corner
    double error;              ///< see BridgeFinder::is_not_acute()
    std::uint32_t beyond = 0;  ///< bits for the two lines that BridgeFinder::find_wall() describes: 1 for x, 2 for y
  };
  /// The face beyond an edge that a corner sees, and the vertices that bound the view.
  struct View {
    mesh::HalfEdge entry;
    mesh::Vertex left;
    mesh::Vertex right;
    Seen entry_left;  ///< the ends of the edge
    Seen entry_right;
  };

  std::vector<mesh::HalfEdge> to_enter;  ///< half-edges through which a search enters faces
  std::vector<View> to_cross;
  memory::ZeroedArray<std::uint32_t> visited;  ///< by face: the number of the last search that visited it
  memory::Stamp stamp;

  /// Starts a search that visits each face at most once.
  void begin() { stamp.next(1, visited); }
  /// Returns whether this is the search's first visit of the face.
  [[nodiscard]] bool visit(mesh::Face f) { return std::exchange(visited[number(f)], stamp.value()) != stamp.value(); }
};

/// Finds the bridges of a mesh, one candidate at a time.
///
/// A *bridge* is the shortest connection between two pieces of wall at a gap: the segment from a wall vertex to another
/// wall vertex, or from a wall vertex to the foot of its perpendicular strictly inside a wall. The closed disc whose
/// diameter is the bridge touches walls at the two ends of the bridge only. So a bridge crosses no wall, and no other
/// bridge. A disc whose diameter is larger than the bridge cannot have its centre on the bridge.
///
/// Requires: each vertex of the mesh is the end of a wall. Then
/// - a bridge between two vertices is an edge of the mesh, because the empty disc proves that it is Delaunay, and
/// - at each corner of a face starts at most one bridge that ends inside a wall.
///
/// All decisions are exact. Only explicit vertices are ends of bridges: where two sides cross, the angles between them
/// are less than 180 degrees, and a bridge needs 90 degrees on its left and on its right.
///
/// Source: the bridges are the Gabriel edges (Gabriel and Sokal 1969) of the walls. Edelsbrunner, *The union of balls
/// and its dual shape*, 1995, explains what the bridges say about discs.
class BridgeFinder {
 public:
  using Triangulation = constraint::ExactTriangulation;

  BridgeFinder(const Triangulation& triangulation, BridgeScratch& scratch)
      : scratch_(scratch),
        triangulation_(triangulation),
        mesh_(triangulation.topology()),
        geometry_(triangulation.triangulation().geometry()),
        rounding_(constraint::largest_rounding(triangulation)) {
    scratch.visited.grow_to(mesh_.face_slots());
  }

  /// Returns whether the free edge of `h` is a bridge. Requires: `h` and its twin belong to faces of the domain.
  [[nodiscard]] bool is_bridge(mesh::HalfEdge h);
  /// Looks for the bridge that starts at the origin of `corner`, runs into the face of `corner` and ends inside a wall.
  /// Returns the wall, as a half-edge that has the bridge on its left, or kNoHalfEdge if there is no such bridge.
  [[nodiscard]] mesh::HalfEdge find_wall(mesh::HalfEdge corner);

  /// The disc whose diameter is the edge of `h`.
  [[nodiscard]] Disc disc_of(mesh::HalfEdge h) const {
    return Disc::of_edge(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }
  /// The circle through the three vertices of the face of `h`.
  [[nodiscard]] Disc circle_of(mesh::HalfEdge h) const {
    return Disc::of_triangle(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), position_of(mesh_.apex(h)),
                             rounding_);
  }
  /// Returns false only if no position of the edge `border`, without its ends, lies strictly inside the circle of the
  /// face of `h`.
  [[nodiscard]] bool may_circle_meet(mesh::HalfEdge h, mesh::HalfEdge border) const;
  /// Returns false only if no position of the edge `border`, without its ends, lies strictly inside the disc whose
  /// diameter is the edge of `h`. Requires: `border` is another edge.
  [[nodiscard]] bool may_disc_meet(mesh::HalfEdge h, mesh::HalfEdge border) const;
  /// Returns false only if no point of the edge lies in the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, mesh::HalfEdge h) const {
    return disc.may_touch(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }

  /// Returns false only if no point of the box lies in the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, const Box& box) const { return disc.may_touch(box, rounding_); }
  /// Returns false only if no changed wall touches the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, const ChangedWalls& changed) const {
    if (changed.are_all()) return true;
    const auto& boxes = changed.boxes();
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return may_touch(disc, box); });
  }

  /// The first function returns the gap of a bridge along an edge. The second one returns the gap of a bridge from the
  /// origin of `corner` to its foot inside `wall`.
  [[nodiscard]] exact::Gap gap_along(mesh::HalfEdge h) const {
    const Point& to = position_of(mesh_.target(h));
    return {position_of(mesh_.origin(h)), to, to};
  }
  [[nodiscard]] exact::Gap gap_to_wall(mesh::HalfEdge corner, mesh::HalfEdge wall) const;

 private:
  /// A gap that may be a bridge.
  struct Candidate {
    exact::Gap gap;
    mesh::Vertex from;
    mesh::Vertex to;  ///< kNoVertex if the gap ends at a foot
    Disc disc;

    /// Returns false only if the segment from an end to `v` contains no position strictly inside the exact disc. Each
    /// coordinate of `v` may be wrong by `rounding`.
    [[nodiscard]] bool may_enter_from(mesh::Vertex end, const Point& v, double rounding) const {
      return end == from ? disc.may_enter(v, rounding) : !Disc::is_surely_not_acute(v, gap.a, gap.from, rounding);
    }
  };

  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_.rounded(number(v)); }
  [[nodiscard]] bool is_explicit(mesh::Vertex v) const { return geometry_.is_explicit(number(v)); }
  /// Says where `v` lies relative to a gap that ends at a foot on the line from a to b: positive if `v` is farther
  /// along this line than the foot, zero if it lies on the line of the gap, negative otherwise.
  [[nodiscard]] exact::Sign side_of_foot(const exact::Gap& gap, mesh::Vertex v) const;
  [[nodiscard]] bool has_foot_on(const exact::Gap& gap, mesh::HalfEdge corner, mesh::HalfEdge wall) const;
  [[nodiscard]] bool is_blocked_by(const exact::Gap& gap, mesh::HalfEdge wall) const;
  /// Returns whether a vertex, which is not an end of the candidate, surely lies in the closed disc.
  [[nodiscard]] bool is_blocked_by(const Candidate& candidate, mesh::Vertex v) const {
    return v != candidate.from && v != candidate.to && is_explicit(v) && candidate.disc.surely_contains(position_of(v));
  }
  [[nodiscard]] bool is_clear(const Candidate& candidate);
  [[nodiscard]] bool enter(const Candidate& candidate, mesh::HalfEdge h);
  [[nodiscard]] bool enter_at_end(const Candidate& candidate, mesh::HalfEdge h, mesh::Vertex end, mesh::Vertex v);
  [[nodiscard]] bool enter_untested(const Candidate& candidate, mesh::HalfEdge h);
  /// Returns whether the angle at `v` between `p` and `q` is surely at least 90 degrees.
  [[nodiscard]] bool is_not_acute(mesh::Vertex p, mesh::Vertex v, mesh::Vertex q) const {
    return Disc::is_surely_not_acute(position_of(p), position_of(v), position_of(q), rounding_);
  }
  /// Returns false only if no foot bridge starts at the origin of `corner` and runs into the face of `corner`.
  [[nodiscard]] bool may_have_foot(mesh::HalfEdge corner) const {
    const mesh::Vertex w = mesh_.origin(corner);
    const mesh::Vertex x = mesh_.target(corner);
    const mesh::Vertex y = mesh_.apex(corner);
    const Point along = position_of(y) - position_of(x);
    const Point to_x = position_of(x) - position_of(w);
    const Point to_y = position_of(y) - position_of(w);
    const double at_x = to_x.x * along.x + to_x.y * along.y;
    const double at_y = to_y.x * along.x + to_y.y * along.y;
    if ((at_x < 0.0) & (at_y > 0.0)) return true;  // one branch instead of several that are hard to predict
    return !is_not_acute(w, x, y) && !is_not_acute(w, y, x);
  }
  [[nodiscard]] mesh::HalfEdge cross(mesh::HalfEdge corner, const BridgeScratch::Seen& x, const BridgeScratch::Seen& y,
                                     BridgeScratch::View& view);
  [[nodiscard]] bool is_bridge_to(mesh::HalfEdge corner, mesh::HalfEdge wall);
  [[nodiscard]] BridgeScratch::Seen seen_from(const Point& corner, mesh::Vertex v) const {
    const Point offset = position_of(v) - corner;
    const double square = offset.x * offset.x + offset.y * offset.y;
    double error = 0x1p-48 * square;
    if (rounding_ > 0.0) error += 16.0 * rounding_ * (std::abs(offset.x) + std::abs(offset.y) + rounding_);
    return {offset, square, error, 0};
  }
  /// Returns whether the angle at `v` between the corner and `p` is surely at least 90 degrees. If c is the corner,
  /// then (c - v) . (p - v) = (v - c)^2 - (v - c) . (p - c). The errors of the two vertices together bound the errors
  /// of this formula.
  [[nodiscard]] static bool is_not_acute(const BridgeScratch::Seen& v, const BridgeScratch::Seen& p) {
    const double dot = v.offset.x * p.offset.x + v.offset.y * p.offset.y;
    return dot - v.square >= v.error + p.error;
  }
  /// Returns false only if no foot bridge from the corner crosses the edge between `p` and `q`, or ends on it.
  [[nodiscard]] static bool may_cross(const BridgeScratch::Seen& p, const BridgeScratch::Seen& q) {
    const double dot = p.offset.x * q.offset.x + p.offset.y * q.offset.y;
    const double error = p.error + q.error;
    const bool is_not_acute_at_p = dot - p.square >= error;
    const bool is_not_acute_at_q = dot - q.square >= error;
    const bool are_both_beyond = (p.beyond & q.beyond) != 0;
    return !(is_not_acute_at_p | is_not_acute_at_q | are_both_beyond);
  }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex from, mesh::Vertex to, mesh::Vertex v) const {
    return geometry_.orientation(geometry_.view(number(from)), geometry_.view(number(to)), geometry_.view(number(v)));
  }

  BridgeScratch& scratch_;
  const Triangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  double rounding_;
};

}  // namespace waywright::clearance

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "clearance/disc.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/rounding.hpp"
#include "exact/gap.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// The scratch of BridgeFinder. Keep the object: later searches use its memory again.
struct BridgeScratch {
  /// The faces beyond an edge that a corner sees, and the vertices that bound the view.
  struct View {
    mesh::HalfEdge entry;
    mesh::Vertex left;
    mesh::Vertex right;
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

  /// The circle through the three vertices of the face of `h`.
  [[nodiscard]] Disc circle_of(mesh::HalfEdge h) const {
    return Disc::of_triangle(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), position_of(mesh_.apex(h)),
                             rounding_);
  }
  /// Returns false only if no point of the edge lies in the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, mesh::HalfEdge h) const {
    return disc.may_touch(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }

  /// The gap of a bridge along an edge, and of a bridge from the origin of `corner` to the inside of `wall`.
  [[nodiscard]] exact::Gap gap_along(mesh::HalfEdge h) const {
    const Point& to = position_of(mesh_.target(h));
    return {position_of(mesh_.origin(h)), to, to};
  }
  [[nodiscard]] exact::Gap gap_to_wall(mesh::HalfEdge corner, mesh::HalfEdge wall) const;

 private:
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_.rounded(number(v)); }
  [[nodiscard]] bool is_explicit(mesh::Vertex v) const { return geometry_.is_explicit(number(v)); }
  /// Says where `v` lies relative to a gap that ends at a foot on the line from a to b: positive if `v` is farther
  /// along this line than the foot, zero if it lies on the line of the gap, negative otherwise.
  [[nodiscard]] exact::Sign side_of_foot(const exact::Gap& gap, mesh::Vertex v) const;
  [[nodiscard]] bool has_foot_on(const exact::Gap& gap, mesh::HalfEdge corner, mesh::HalfEdge wall) const;
  [[nodiscard]] bool is_blocked_by(const exact::Gap& gap, mesh::HalfEdge wall) const;
  [[nodiscard]] bool is_clear(const exact::Gap& gap, const Disc& disc);
  [[nodiscard]] bool enter(const exact::Gap& gap, const Disc& disc, mesh::HalfEdge h);
  [[nodiscard]] bool is_bridge_to(mesh::HalfEdge corner, mesh::HalfEdge wall);
  [[nodiscard]] exact::Sign side(mesh::Vertex from, mesh::Vertex to, mesh::Vertex v) const {
    return geometry_.orientation(geometry_.view(number(from)), geometry_.view(number(to)), geometry_.view(number(v)));
  }

  BridgeScratch& scratch_;
  const Triangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  double rounding_;
};

}  // namespace waywright::clearance

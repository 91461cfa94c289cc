#pragma once

#include <cstdint>

#include "constraint/exact_triangulation.hpp"

// How often a polygon's rings turn around a face: its winding number there. From one side of an edge to the other the
// number changes by the polygon's sides on the edge. An even-odd polygon needs only the number's parity, to which every
// side adds 1, whichever way it runs. So of such a polygon no side's direction is ever looked at.

namespace waywright::constraint {

/// Whether a side that lies on the edge of `h` runs the same way as `h`, which has the polygon's inside on its left if
/// the ring turns counter-clockwise.
[[nodiscard]] inline bool runs_along(const ExactTriangulation& triangulation, const Side& side, mesh::HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  return delaunay.comes_before(side.from, side.to) == delaunay.comes_before(mesh.origin(h), mesh.target(h));
}

/// The winding numbers of one polygon; of an even-odd polygon only their parity counts. Each rule has code of its own,
/// because even-odd polygons are the most and their code is faster.
template <FillRule rule>
class Winding {
 public:
  /// Requires: the rule is the polygon's.
  Winding(const ExactTriangulation& triangulation, std::uint32_t polygon)
      : triangulation_(triangulation), polygon_(polygon) {}

  [[nodiscard]] std::uint32_t polygon() const { return polygon_; }

  /// Whether the polygon covers what its rings turn around so many times.
  [[nodiscard]] static bool covers(std::int32_t turns) {
    return rule == FillRule::even_odd ? (turns & 1) != 0 : turns != 0;
  }

  /// The winding number in the face of `h`, less that in the face beyond.
  [[nodiscard]] std::int32_t across(mesh::HalfEdge h) const {
    std::int32_t turns = 0;
    triangulation_.for_each_side(h, [&](const Side& side) {
      if (side.item != polygon_) return;
      if constexpr (rule == FillRule::even_odd) {
        turns ^= 1;
      } else {
        turns += runs_along(triangulation_, side, h) ? 1 : -1;
      }
    });
    return turns;
  }

  /// Whether the winding number changes across the edge. If it does not, the polygon covers both faces or neither.
  [[nodiscard]] bool changes_across(mesh::HalfEdge h) const { return covers(across(h)); }

 private:
  const ExactTriangulation& triangulation_;
  std::uint32_t polygon_;
};

/// Calls visit(winding) with the Winding of a polygon.
template <class Visit>
auto with_winding(const ExactTriangulation& triangulation, std::uint32_t polygon, Visit&& visit) {
  if (triangulation.items().fill(polygon) == FillRule::even_odd) {
    return visit(Winding<FillRule::even_odd>(triangulation, polygon));
  }
  return visit(Winding<FillRule::nonzero>(triangulation, polygon));
}

}  // namespace waywright::constraint

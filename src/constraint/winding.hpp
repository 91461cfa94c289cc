#pragma once

#include <cstdint>

#include "constraint/exact_triangulation.hpp"

// The winding number of a polygon in a face: how many times its rings go around the face. Across an edge, the number
// changes by the polygon's sides on the edge. For an even-odd polygon only the parity of the number counts, and every
// side changes the parity, whatever its direction. So the code never reads the directions of the sides of an even-odd
// polygon.

namespace waywright::constraint {

/// Whether a side that lies on the edge of `h` runs in the direction of `h`. If it does, and its ring is
/// counter-clockwise, the inside of the ring is left of `h`.
[[nodiscard]] inline bool runs_along(const ExactTriangulation& triangulation, const Side& side, mesh::HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  return delaunay.comes_before(side.from, side.to) == delaunay.comes_before(mesh.origin(h), mesh.target(h));
}

/// The winding numbers of one polygon; for an even-odd polygon only their parity counts. Each fill rule has its own
/// code, because most polygons are even-odd and their code is faster.
template <FillRule rule>
class Winding {
 public:
  /// Requires: `rule` is the fill rule of the polygon.
  Winding(const ExactTriangulation& triangulation, std::uint32_t polygon)
      : triangulation_(triangulation), polygon_(polygon) {}

  [[nodiscard]] std::uint32_t polygon() const { return polygon_; }

  /// Whether the polygon covers a face in which it has this winding number.
  [[nodiscard]] static bool covers(std::int32_t winding_number) { return is_filled(rule, winding_number); }

  /// The winding number in the face of `h` minus the winding number in the face of the twin of `h`.
  [[nodiscard]] std::int32_t across(mesh::HalfEdge h) const {
    std::int32_t change = 0;
    triangulation_.for_each_side(h, [&](const Side& side) {
      if (side.item != polygon_) return;
      if constexpr (rule == FillRule::even_odd) {
        change ^= 1;
      } else {
        change += runs_along(triangulation_, side, h) ? 1 : -1;
      }
    });
    return change;
  }

  /// Whether the winding number changes across the edge. If it does not, the polygon covers both faces or neither.
  [[nodiscard]] bool changes_across(mesh::HalfEdge h) const { return covers(across(h)); }

 private:
  const ExactTriangulation& triangulation_;
  std::uint32_t polygon_;
};

/// Calls visit(winding) with the Winding of a polygon. Returns the result.
template <class Visit>
auto with_winding(const ExactTriangulation& triangulation, std::uint32_t polygon, Visit&& visit) {
  if (triangulation.items().fill(polygon) == FillRule::even_odd) {
    return visit(Winding<FillRule::even_odd>(triangulation, polygon));
  }
  return visit(Winding<FillRule::nonzero>(triangulation, polygon));
}

}  // namespace waywright::constraint

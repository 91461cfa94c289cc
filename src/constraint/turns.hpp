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

/// The polygon's winding number in the face of `h`, less that in the face beyond. Of an even-odd polygon only the
/// parity counts.
[[nodiscard]] inline std::int32_t turns_across(const ExactTriangulation& triangulation, mesh::HalfEdge h,
                                               std::uint32_t polygon) {
  const bool is_even_odd = triangulation.items().fill(polygon) == FillRule::even_odd;
  std::int32_t turns = 0;
  triangulation.for_each_side(h, [&](const Side& side) {
    if (side.item == polygon) turns += is_even_odd || runs_along(triangulation, side, h) ? 1 : -1;
  });
  return turns;
}

/// Whether the polygon's winding number changes across the edge; of an even-odd polygon, whether its parity does. If it
/// does not, the polygon covers both faces or neither.
[[nodiscard]] inline bool turns_change(const ExactTriangulation& triangulation, mesh::HalfEdge h,
                                       std::uint32_t polygon) {
  return triangulation.items().covers(polygon, turns_across(triangulation, h, polygon));
}

}  // namespace waywright::constraint

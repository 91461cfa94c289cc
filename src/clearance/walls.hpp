#pragma once

#include <utility>

#include "constraint/constrained_triangulation.hpp"

namespace waywright::clearance {

/// Two explicit positions on the line of a wall, in the direction of the wall.
struct WallLine {
  Point from;
  Point to;
};

/// Returns the ends of a side that lies on the wall, in the direction of `wall`.
[[nodiscard]] inline WallLine wall_line(const constraint::ConstrainedTriangulation& triangulation, mesh::HalfEdge wall,
                                        const constraint::Side& side) {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  WallLine line{geometry.rounded(number(side.from)), geometry.rounded(number(side.to))};
  if (!constraint::runs_along(triangulation, side, wall)) std::swap(line.from, line.to);
  return line;
}
[[nodiscard]] inline WallLine wall_line(const constraint::ConstrainedTriangulation& triangulation,
                                        mesh::HalfEdge wall) {
  return wall_line(triangulation, wall, triangulation.any_side(wall));
}

/// Calls visit(slot) for each side on the wall, with the slot of the side's item. The domain has the slot 0.
template <class Visit>
void for_each_item_on(const constraint::ConstrainedTriangulation& triangulation, mesh::HalfEdge wall, Visit&& visit) {
  triangulation.for_each_side(wall, [&](const constraint::Side& side) { visit(side.item); });
}

/// Calls visit(slot) for each side on each wall at the vertex, with the slot of the side's item.
template <class Visit>
void for_each_item_at(const constraint::ConstrainedTriangulation& triangulation, mesh::Vertex v, Visit&& visit) {
  triangulation.topology().for_each_outgoing(v, [&](mesh::HalfEdge h) {
    if (triangulation.topology().is_fixed(h)) for_each_item_on(triangulation, h, visit);
  });
}

}  // namespace waywright::clearance

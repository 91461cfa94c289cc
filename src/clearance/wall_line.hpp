#pragma once

#include <utility>

#include "constraint/exact_triangulation.hpp"

namespace waywright::clearance {

/// Two explicit positions on the line of a wall, in the direction of the wall.
struct WallLine {
  Point from;
  Point to;
};

/// Returns the ends of a side that lies on the wall, in the direction of `wall`. The side and the wall lie on one line,
/// so the (x, y) order of their ends says whether they have the same direction.
[[nodiscard]] inline WallLine wall_line(const constraint::ExactTriangulation& triangulation, mesh::HalfEdge wall,
                                        const constraint::Side& side) {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto comes_before = [&](mesh::Vertex p, mesh::Vertex q) {
    return triangulation.triangulation().comes_before(p, q);
  };
  WallLine line{geometry.rounded(number(side.from)), geometry.rounded(number(side.to))};
  const bool is_along = comes_before(side.from, side.to) == comes_before(mesh.origin(wall), mesh.target(wall));
  if (!is_along) std::swap(line.from, line.to);
  return line;
}
[[nodiscard]] inline WallLine wall_line(const constraint::ExactTriangulation& triangulation, mesh::HalfEdge wall) {
  return wall_line(triangulation, wall, triangulation.any_side(wall));
}

}  // namespace waywright::clearance

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// A copy of the mesh of a world, in the canonical order of World::dump. World::snapshot fills it.
///
/// - The vertices are in (x, y) order: they are sorted by x and, for equal x, by y.
/// - Each triangle is counter-clockwise and starts with its smallest index. The triangles are sorted by their indices.
/// - Each edge has its smaller index first. The edges are sorted by their indices.
/// - Ids ascend.
///
/// @code{.cpp}
/// const MeshSnapshot mesh = world.snapshot();
/// for (const auto& [a, b, c] : mesh.triangles) draw_triangle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
/// for (const MeshSnapshot::ConstrainedEdge& edge : mesh.constraints) {
///   draw_line(mesh.vertices[edge.vertices[0]], mesh.vertices[edge.vertices[1]]);
/// }
/// @endcode
struct MeshSnapshot {
  /// A constrained edge: a side of an item, or the border of the domain, lies on it.
  struct ConstrainedEdge {
    std::array<std::uint32_t, 2> vertices{};  ///< indices in MeshSnapshot::vertices, the smaller first
    std::uint32_t first_id = 0;               ///< the index of the edge's first id in MeshSnapshot::ids
    std::uint32_t id_count = 0;               ///< the number of the edge's ids
  };

  std::vector<Point> vertices;                          ///< each coordinate rounded to the nearest double
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices in `vertices`
  std::vector<ConstrainedEdge> constraints;
  std::vector<ItemId> ids;  ///< the items of all constrained edges, edge after edge; 0 stands for the domain's border
};

/// @}

}  // namespace waywright

#pragma once

#include <cstdint>
#include <vector>

#include "waywright/mesh_snapshot.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// What the canonical order of a mesh is made in. An object to keep: its memory serves call after call.
struct CanonicalOrder {
  struct FixedEdge {
    std::uint32_t i, j;
    mesh::HalfEdge h;
  };

  std::vector<mesh::Vertex> vertices;  ///< by (x, y)
  std::vector<std::uint32_t> rank;     ///< of each vertex slot, its position in `vertices`
  std::vector<FixedEdge> fixed;
};

/// Fills `snapshot` with the mesh in the one order that depends on its items alone; see MeshSnapshot.
void take_snapshot(const ExactTriangulation& triangulation, CanonicalOrder& order, MeshSnapshot& snapshot);

}  // namespace waywright::constraint

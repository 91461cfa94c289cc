#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "waywright/mesh_snapshot.hpp"

#include "constraint/constrained_triangulation.hpp"

namespace waywright::constraint {

/// Scratch for the canonical order of a mesh. Use one object for many calls, because it keeps its memory.
struct CanonicalOrder {
  struct FixedEdge {
    std::uint32_t i, j;
    mesh::HalfEdge h;
  };

  std::vector<mesh::Vertex> vertices;  ///< in (x, y) order
  std::vector<std::uint32_t> index;    ///< by vertex slot: its index in `vertices`
  std::vector<FixedEdge> fixed;
};

/// Fills `snapshot` with the mesh in its canonical order, which depends only on the items; see MeshSnapshot.
void take_snapshot(const ConstrainedTriangulation& triangulation, CanonicalOrder& order, MeshSnapshot& snapshot);

/// Returns the mesh as canonical text, with its coordinates as reduced fractions: see World::dump.
[[nodiscard]] std::string dump(const ConstrainedTriangulation& triangulation);

}  // namespace waywright::constraint

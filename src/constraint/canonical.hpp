#pragma once

#include <vector>

#include "waywright/mesh_snapshot.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// A mesh in the one order that depends on its items alone; see MeshSnapshot.
struct CanonicalMesh {
  std::vector<mesh::Vertex> order;  ///< the vertices by (x, y)
  MeshSnapshot snapshot;
};

[[nodiscard]] CanonicalMesh canonical_mesh(const ExactTriangulation& triangulation);

}  // namespace waywright::constraint

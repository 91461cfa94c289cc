#pragma once

#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// What an agent without a size can do on a mesh. Whatever searches and the abstraction must know about an agent, they
/// ask here, and never look at the labels of edges themselves: an edge that the mesh must keep (TriangleMesh::is_fixed)
/// and an edge that an agent cannot cross need not be the same.
///
/// For a point agent every constrained edge is a wall. Other agents will differ in this class: in which edges they can
/// cross, in the width that they need, in what crossing costs. All functions are inline and hold no state, so they cost
/// what the questions to the mesh cost.
class PointAgent {
 public:
  /// Whether the agent can cross the edge of `h`: whether it is a passage between its two faces.
  [[nodiscard]] static bool can_cross(const mesh::TriangleMesh& mesh, mesh::HalfEdge h) { return !mesh.is_fixed(h); }
};

}  // namespace waywright::nav

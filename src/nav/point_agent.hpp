#pragma once

#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// What an agent without a size can do on a mesh. The searches and the abstraction ask only this class about an agent.
/// They never read the labels of edges for this purpose: an edge that the mesh must keep (TriangleMesh::is_fixed) and
/// an edge that an agent cannot cross need not be the same.
///
/// For a point agent every constrained edge is a wall. Other agents will have a class like this one: it says which
/// edges they can cross, which width they need, and what crossing costs. All functions are inline and have no state, so
/// they cost no more than the calls of the mesh in them.
class PointAgent {
 public:
  /// Returns whether the agent can cross the edge of `h`, so that the edge is a passage between its two faces.
  [[nodiscard]] static bool can_cross(const mesh::TriangleMesh& mesh, mesh::HalfEdge h) { return !mesh.is_fixed(h); }
};

}  // namespace waywright::nav

#pragma once

#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// Says which edges of a mesh an agent without extent can cross. The searches and the abstraction ask only this class
/// about an agent. They do not call TriangleMesh::is_fixed for this purpose. That function says which edges the mesh
/// must keep, and an agent of another kind may be able to cross some of these, or may be too large for others.
///
/// For a point agent every constrained edge is a wall. An agent of another kind needs a class like this one, which says
/// which edges it can cross, which width it needs, and what crossing costs. The functions are inline and the class has
/// no state. So a call costs no more than the call of the mesh in it.
class PointAgent {
 public:
  /// Returns whether the agent can cross the edge of `h`, so that the edge is a passage between its two faces.
  [[nodiscard]] static bool can_cross(const mesh::TriangleMesh& mesh, mesh::HalfEdge h) { return !mesh.is_fixed(h); }
};

}  // namespace waywright::nav

#pragma once

#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// Says which edges of a mesh an agent without extent can cross. The searches for point agents and the abstraction use
/// only this class to decide this. (The searches for discs read the walls and bridges of a path::DiscMap.)
/// TriangleMesh::is_fixed is another question: it says which edges the mesh must keep. An agent of another kind may be
/// able to cross some fixed edges, or may be too large for some free edges.
///
/// For a point agent every constrained edge is a wall. Another kind of point agent needs a class with the same
/// function. Its agent must not cross the boundary of a polygon, because Components stores one cover for each
/// component. Its answer must not depend on the label of a fixed edge, because Abstraction ignores changes of labels.
/// The function is inline and the class has no state. So a call costs no more than a call of TriangleMesh::is_fixed.
class PointAgent {
 public:
  /// Returns whether the agent can cross the edge of `h`, so that the edge is a passage between its two faces.
  [[nodiscard]] static bool can_cross(const mesh::TriangleMesh& mesh, mesh::HalfEdge h) { return !mesh.is_fixed(h); }
};

}  // namespace waywright::nav

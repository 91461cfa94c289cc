#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace waywright::mesh {

/// Changes a piece of a TriangleMesh without its undo log. Several threads can change one mesh at once, each with an
/// object of its own.
///
/// Requires: TriangleMesh::make_room_for_labels() has been called. Each thread has a set of vertices of its own, and
/// these sets are disjoint. A thread changes only faces whose three vertices are its own. If another face has a vertex
/// of the thread's own, the thread may read the vertices of this face, and the twins and labels of its edges that have
/// an end of the thread's own. (If the thread reads `twin`, `label` or `is_fixed` of an edge between two vertices of
/// other threads, this is a data race.) Then no thread reads data that another one writes: a thread writes the twin and
/// the label of an edge only if both ends of the edge are its own, and the vertices of a face only if all three are.
class UnloggedMesh {
 public:
  explicit UnloggedMesh(TriangleMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] HalfEdge twin(HalfEdge h) const { return mesh_.twin(h); }
  [[nodiscard]] Vertex origin(HalfEdge h) const { return mesh_.origin(h); }
  [[nodiscard]] Vertex target(HalfEdge h) const { return mesh_.target(h); }
  [[nodiscard]] Vertex apex(HalfEdge h) const { return mesh_.apex(h); }
  [[nodiscard]] HalfEdge outgoing(Vertex v) const { return mesh_.outgoing(v); }
  [[nodiscard]] HalfEdge next_around(HalfEdge h) const { return mesh_.next_around(h); }
  [[nodiscard]] bool is_fixed(HalfEdge h) const { return mesh_.is_fixed(h); }
  [[nodiscard]] Label label(HalfEdge h) const { return mesh_.label(h); }
  [[nodiscard]] HalfEdge find(Vertex from, Vertex to) const { return mesh_.find(from, to); }
  [[nodiscard]] bool has_many_and_more_edges(Vertex u, Vertex v) const { return mesh_.has_many_and_more_edges(u, v); }
  [[nodiscard]] bool is_live(Face f) const { return mesh_.is_live(f); }

  /// Keeps the face for add_face(). Until then, is_live() is false.
  void free_face(Face f) {
    free_faces_.push_back(f);
    mesh_.half_edges_[number(first(f))].origin = kNoVertex;
  }
  /// Returns the face that was freed last. Requires: add_face() has not yet returned all faces that were freed.
  [[nodiscard]] Face add_face() {
    const Face f = free_faces_.back();
    free_faces_.pop_back();
    return f;
  }
  void set_vertices(Face f, Vertex a, Vertex b, Vertex c) { mesh_.set_vertices(f, a, b, c); }
  void link(HalfEdge g, HalfEdge h, Label label) { mesh_.link(g, h, label); }
  void set_label(HalfEdge h, Label label) { mesh_.write_label(h, label); }
  TriangleMesh::Flipped flip(HalfEdge h) { return mesh_.flip_unlogged(h); }

 private:
  TriangleMesh& mesh_;
  std::vector<Face> free_faces_;
};

}  // namespace waywright::mesh

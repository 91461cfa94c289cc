#include "mesh/triangle_mesh.hpp"

// Undoes edits. The code undoes each edit in exactly the mesh that the edit produced, so every index in its record has
// the same meaning as when the record was made. Nothing here allocates.

namespace waywright::mesh {

void TriangleMesh::begin() {
  journal_.begin();
  saved_faces_.clear();
}

void TriangleMesh::roll_back() {
  journal_.roll_back([&](const Undo& edit) { undo(edit); });
  begin();
}

void TriangleMesh::undo(const Undo& edit) {
  switch (edit.kind) {
    case EditKind::add_vertex:
      push_free_vertex(Vertex{edit.index});
      break;
    case EditKind::free_vertex:
      (void)pop_free_vertex();
      break;
    case EditKind::add_face:
      push_free_face(Face{edit.index});
      break;
    case EditKind::free_face:
      (void)pop_free_face();
      break;
    case EditKind::rebuild_face:
      restore(Face{edit.index}, saved_faces_[edit.saved]);
      break;
    case EditKind::split_face:
      undo_split_face(Face{edit.index});
      break;
    case EditKind::split_edge:
      undo_split_edge(HalfEdge{edit.index});
      break;
    case EditKind::flip:
      undo_flip(HalfEdge{edit.index});
      break;
    case EditKind::set_label:
    case EditKind::relabel:
      write_label(HalfEdge{edit.index}, edit.saved);
      break;
    case EditKind::set_label_of_twin:
    case EditKind::relabel_twin:
      break;
    case EditKind::save_label:
      labels_[edit.index] = edit.saved;
      break;
  }
}

// Turns f = (a, b, v) back into (a, b, c): see split_face. Other records undo the two other faces.
void TriangleMesh::undo_split_face(Face f) {
  const HalfEdge ab = first(f);
  const HalfEdge bc = first(face(twin(next(ab))));
  const HalfEdge ca = first(face(twin(previous(ab))));
  const Vertex c = target(bc);
  set_origin(previous(ab), c);
  take_over(next(ab), bc);
  take_over(previous(ab), ca);
  set_outgoing(origin(ab), ab);
  set_outgoing(target(ab), next(ab));
  set_outgoing(c, previous(ab));
}

// Turns h = a -> v back into a -> b: see split_edge.
void TriangleMesh::undo_split_edge(HalfEdge h) {
  const HalfEdge va = twin(h);
  const HalfEdge vb = next(twin(next(h)));
  const HalfEdge t = twin(vb);
  const Label edge_label = label(h);
  set_origin(next(h), origin(t));
  set_origin(next(t), origin(h));
  take_over(next(h), next(vb));
  take_over(next(t), next(va));
  link(h, t, edge_label);
  for (const HalfEdge edge : {h, t, previous(h), previous(t)}) set_outgoing(origin(edge), edge);
}

// Turns h = a -> d, which d -> c follows, back into a -> b: see flip.
void TriangleMesh::undo_flip(HalfEdge h) {
  const HalfEdge t = previous(twin(next(h)));
  take_over(next(h), t);
  take_over(next(t), h);
  set_origin(next(h), origin(t));
  set_origin(next(t), origin(h));
  link(h, t, 0);
  for (const HalfEdge edge : {h, t, previous(h), previous(t)}) set_outgoing(origin(edge), edge);
}

// Also sets the twins of the neighbours that are live. A neighbour that is restored later sets its twins itself. A
// neighbour that is still free must not be written to: its slot holds a link of the free list.
void TriangleMesh::restore(Face f, const SavedFace& saved) {
  HalfEdge h = first(f);
  for (const HalfEdgeRecord& record : saved) {
    half_edges_[number(h)] = record;
    set_outgoing(record.origin, h);
    const HalfEdge t = twin(h);
    if (is_live(face(t))) half_edges_[number(t)].twin = number(h) | (record.twin & kFixed);
    h = next(h);
  }
}

void TriangleMesh::push_free_face(Face f) {
  for (std::uint32_t i = 0; i < 3; ++i) half_edges_[number(first(f)) + i] = {number(kNoHalfEdge), kNoVertex};
  half_edges_[number(first(f))].twin = free_faces_.push(number(f));
  ++free_face_count_;
}

Face TriangleMesh::pop_free_face() {
  const Face f{free_faces_.pop(half_edges_[number(first(Face{free_faces_.first()}))].twin)};
  --free_face_count_;
  return f;
}

void TriangleMesh::push_free_vertex(Vertex v) {
  outgoing_[number(v)] = kFree | free_vertices_.push(number(v));
  ++free_vertex_count_;
}

Vertex TriangleMesh::pop_free_vertex() {
  const Vertex v{free_vertices_.pop(outgoing_[free_vertices_.first()] & ~kFree)};
  outgoing_[number(v)] = number(kNoHalfEdge);
  --free_vertex_count_;
  return v;
}

}  // namespace waywright::mesh

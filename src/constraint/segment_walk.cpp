#include "constraint/segment_walk.hpp"

namespace waywright::constraint {

// Searches around the vertex for an edge whose target lies on the line, ahead of the vertex, or for a face whose first
// corner lies right of the line and whose second corner lies left of it.
SegmentWalk::Stop SegmentWalk::leave_vertex(mesh::Vertex u) const {
  mesh::HalfEdge h = mesh_.outgoing(u);
  Sign p_side = orientation(mesh_.target(h));
  for (;;) {
    const mesh::Vertex p = mesh_.target(h);
    if (p_side == Sign::zero && p != delaunay_.ghost() && is_ahead(u, p)) return stop_at_vertex(p);
    const Sign q_side = orientation(mesh_.apex(h));
    if (p_side == Sign::negative && q_side == Sign::positive) return stop_at_edge(mesh::next(h));
    h = mesh_.next_around(h);
    p_side = q_side;
  }
}

/// Returns the first stop of a segment that starts on an edge. If the end of the segment lies on the edge's line, the
/// stop is the vertex ahead. Otherwise the stop is the edge itself, as a half-edge of the face that the segment does
/// not enter.
SegmentWalk::Stop SegmentWalk::stop_on_start_edge() const {
  const mesh::HalfEdge h = start_.h;
  if (geometry().order(from(), to()) == 0) return {mesh::kNoVertex, h, false, true};
  const Sign end_side = geometry().orientation(delaunay_.view(mesh_.origin(h)), delaunay_.view(mesh_.target(h)), to());
  if (end_side == Sign::zero) {
    return stop_at_vertex(is_ahead(mesh_.origin(h), mesh_.target(h)) ? mesh_.target(h) : mesh_.origin(h));
  }
  return {mesh::kNoVertex, end_side == Sign::positive ? mesh_.twin(h) : h};
}

/// Returns the first stop of a segment that starts inside the face of `any`.
SegmentWalk::Stop SegmentWalk::leave_face(mesh::HalfEdge any) const {
  const std::array<mesh::HalfEdge, 3> edges = {any, mesh::next(any), mesh::previous(any)};
  std::array<Sign, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i) corner[i] = orientation(mesh_.origin(edges[i]));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const mesh::Vertex v = mesh_.origin(edges[i]);
    // A corner on the line lies ahead if the corner after it is left of the line and the corner before it is right of
    // it.
    if (corner[i] == Sign::zero && corner[next] == Sign::positive && corner[(i + 2) % 3] == Sign::negative) {
      return stop_at_vertex(v, any);
    }
    if (corner[i] == Sign::negative && corner[next] == Sign::positive) {
      return stop_at_edge(edges[i]);
    }
  }
  // Unreachable: a line through a point inside a face leaves the face through an edge or a corner.
  return {mesh::kNoVertex, mesh::kNoHalfEdge, true};  // GCOVR_EXCL_LINE
}

}  // namespace waywright::constraint

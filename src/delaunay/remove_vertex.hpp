#pragma once

#include <algorithm>
#include <cassert>

#include "delaunay/triangulation.hpp"

namespace waywright::delaunay {

template <class Geometry>
void Triangulation<Geometry>::free_edge(mesh::HalfEdge h) {
  mesh_.set_label(h, 0);
  freed_.push_back(h);
}

// A flip rebuilds two faces, so half-edges that wait on the stack may come to stand for other edges. Every edge of such
// faces is put on the stack anew, so none is missed.
template <class Geometry>
void Triangulation<Geometry>::legalise_freed() {
  while (!freed_.empty()) {
    const mesh::HalfEdge h = freed_.back();
    freed_.pop_back();
    if (mesh_.is_fixed(h) || is_legal(h)) continue;
    const mesh::HalfEdge t = mesh_.twin(h);
    mesh_.flip(h);
    for (const mesh::HalfEdge side : {h, previous(h), t, previous(t)}) freed_.push_back(side);
  }
}

template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex(mesh::Vertex v) {
  mesh::HalfEdge to_p = mesh::kNoHalfEdge;
  mesh::HalfEdge to_q = mesh::kNoHalfEdge;
  mesh_.for_each_outgoing(v, [&](mesh::HalfEdge h) {
    if (!mesh_.is_fixed(h)) return;
    to_q = to_p == mesh::kNoHalfEdge ? to_q : h;
    to_p = to_p == mesh::kNoHalfEdge ? h : to_p;
  });
  return to_p == mesh::kNoHalfEdge ? remove_free_vertex(v) : remove_vertex_on_line(v, to_p, to_q);
}

//         w2 ---- w1         The faces around v leave a hole, star-shaped about v. Its first edge, w0 - w1, is the
//         base;
//        /  \\   /  |         the chain runs the other way around, from w0 to w1.
//      w3 --- v --- w0
//        \\   |    /
//          ---w4--
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_free_vertex(mesh::Vertex v) {
  const mesh::HalfEdge start = mesh_.outgoing(v);
  const mesh::Vertex end = mesh_.apex(start);
  const mesh::HalfEdge outer = mesh_.twin(next(start));
  const mesh::Label label = mesh_.label(outer);
  left_chain_.clear();
  cavity_.clear();
  mesh_.for_each_outgoing(v, [&](mesh::HalfEdge h) {
    cavity_.push_back(mesh::face(h));
    if (h != start) append_to(left_chain_, next(h));
  });
  std::reverse(left_chain_.begin(), left_chain_.end());
  for (const mesh::Face f : cavity_) mesh_.free_face(f);
  mesh_.link(triangulate(left_chain_, end, true), outer, label);
  forget(v, outer);
  return mesh::kNoHalfEdge;
}

//          a2 --- a1         v lies on the line from p to q. On each side of it, the faces around v leave a hole over
//          the
//        /   \\  /   \\       edge p - q that takes the place of p - v and v - q.
//       p --- v --- q
//        \\   / \\   /
//          b1 --- b2
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex_on_line(mesh::Vertex v, mesh::HalfEdge to_p,
                                                              mesh::HalfEdge to_q) {
  const mesh::Vertex p = mesh_.target(to_p);
  const mesh::Vertex q = mesh_.target(to_q);
  const mesh::Label label = mesh_.label(to_p);
  left_chain_.clear();
  right_chain_.clear();
  cavity_.clear();
  for (mesh::HalfEdge h = to_q; h != to_p; h = mesh_.next_around(h)) append_to(left_chain_, next(h));
  for (mesh::HalfEdge h = to_p; h != to_q; h = mesh_.next_around(h)) append_to(right_chain_, next(h));
  mesh_.for_each_outgoing(v, [&](mesh::HalfEdge h) { cavity_.push_back(mesh::face(h)); });
  std::reverse(left_chain_.begin(), left_chain_.end());
  std::reverse(right_chain_.begin(), right_chain_.end());
  for (const mesh::Face f : cavity_) mesh_.free_face(f);
  const mesh::HalfEdge left = triangulate(left_chain_, q);
  const mesh::HalfEdge right = triangulate(right_chain_, p);
  mesh_.link(left, right, label);
  forget(v, left);
  return left;
}

template <class Geometry>
void Triangulation<Geometry>::forget(mesh::Vertex v, mesh::HalfEdge near) {
  mesh_.free_vertex(v);
  sectors_.forget(geometry_.nearest(number(v)), v, mesh_.origin(near));
  geometry_.clear(number(v));
  remember(near);
}

}  // namespace waywright::delaunay

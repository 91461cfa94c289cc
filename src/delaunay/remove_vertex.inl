#pragma once

#include <cstdint>

#include "delaunay/tie_rule.hpp"
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

// Each step waits for the one before, so both ways round are gone at once. What a removal asks about the vertices
// around comes meanwhile, each as soon as a face tells which it is: the apex of a face is the next one's.
template <class Geometry>
const typename Triangulation<Geometry>::Star& Triangulation<Geometry>::star(mesh::Vertex v) {
  star_.spokes.clear();
  star_.fixed.clear();
  clockwise_.clear();
  mesh::HalfEdge left = mesh_.outgoing(v);
  mesh::HalfEdge right = left;
  prefetch(mesh_.target(right));
  do {
    star_.spokes.push_back(left);
    prefetch(mesh_.apex(left));
    prefetch_face_beyond(next(left));
    left = mesh_.next_around(left);
    if (left == right) break;
    right = mesh_.previous_around(right);
    clockwise_.push_back(right);
    prefetch(mesh_.target(right));
    prefetch_face_beyond(next(right));
  } while (left != right);
  star_.spokes.insert(star_.spokes.end(), clockwise_.rbegin(), clockwise_.rend());
  for (std::uint32_t i = 0; i < star_.spokes.size(); ++i) {
    if (mesh_.is_fixed(star_.spokes[i])) star_.fixed.push_back(i);
  }
  return star_;
}

template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex(const Star& star) {
  return star.fixed.empty() ? remove_free_vertex(star) : remove_vertex_on_line(star);
}

//         w2 ---- w1         The faces around v leave a hole, star-shaped about v. Its border starts at w0; its last
//        /  \   /  |         side, from w4 to w0, is the base.
//      w3 --- v --- w0
//        \   |    /
//          ---w4--
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_free_vertex(const Star& star) {
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  collect_hole(star, 0, 0);
  const mesh::HalfEdge last = hole_sides_.back();
  hole_sides_.pop_back();
  const mesh::HalfEdge base = refill_hole();
  mesh_.close(base, last);
  forget(v, base);
  return mesh::kNoHalfEdge;
}

//          a2 --- a1         v lies on the line from p to q. On each side of it, the faces around v leave a hole over
//        /   \  /   \       the edge p - q that takes the place of p - v and v - q.
//       p --- v --- q
//        \   / \   /
//          b1 --- b2
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex_on_line(const Star& star) {
  const std::size_t to_p = star.fixed[0];
  const std::size_t to_q = star.fixed[1];
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  const mesh::Label label = mesh_.label(star.spokes[to_p]);
  collect_hole(star, to_q, to_p);
  const mesh::HalfEdge left = refill_hole();
  collect_hole(star, to_p, to_q);
  const mesh::HalfEdge right = refill_hole();
  mesh_.link(left, right, label);
  forget(v, left);
  return left;
}

/// The sides opposite to a star's vertex, in the faces from the spoke at one position to that at another, and the
/// places of their ends.
template <class Geometry>
void Triangulation<Geometry>::collect_hole(const Star& star, std::size_t from, std::size_t to) {
  const std::size_t degree = star.spokes.size();
  const std::size_t count = from < to ? to - from : to + degree - from;
  hole_sides_.resize(count);
  hole_places_.resize(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = from + i < degree ? from + i : from + i - degree;
    hole_sides_[i] = next(star.spokes[at]);
    hole_places_[i] = view(mesh_.origin(hole_sides_[i]));
  }
  hole_places_[count] = view(mesh_.target(hole_sides_[count - 1]));
}

/// Triangulates the polygon between the hole's sides and the base from its last vertex to its first.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::refill_hole() {
  triangles_.clear();
  triangles_.push_back(triangle_over(0, static_cast<std::uint32_t>(hole_sides_.size())));
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto [from, apex, to] = triangles_[i];
    if (apex - from > 1) triangles_.push_back(triangle_over(from, apex));
    if (to - apex > 1) triangles_.push_back(triangle_over(apex, to));
  }
  return mesh_.refill(hole_sides_, triangles_);
}

//           m                Over a base, the vertex whose circle with its ends holds no other. On the base stands a
//        .     .             circle that holds no vertex of the hole: that of the triangle beyond it or, for the first,
//     from ----- to          that through v (the half-plane beyond it, if v lies on the base). Each vertex has its own
//        .  n  .             circle through the base's ends, and the first is the one that reaches least far in front
//           .                of the base. A vertex beyond the base, or on its line, has a circle that reaches less far
//                            in front than the empty one; taken for a candidate, it gives way to each in front.
//
// So that need not be asked: where m lies beyond the base, the determinant's sign is turned about, and it is positive
// for n in front, which lies outside m's circle, as it is where m lies in front and its circle holds n. For n beyond,
// it is negative where m lies in front, and where neither does, either may be chosen. Ties are those of lifts of which
// one is lowered by an infinitesimal, and there the same is true. Its sign is that of the determinant but where n is
// lowered: then n lies in every circle, also in m's, so it can't be that m lies beyond the base and n in front.
//
// No vertex in the circle can be hidden behind a side of the hole, for v lies in the circle and saw them all. Source:
// Devillers, *Vertex removal in two-dimensional Delaunay triangulation: speed-up by low degrees optimization*, 2011,
// where tables choose; asking in order costs about as many in-circle tests at the degrees that there are.
template <class Geometry>
typename Triangulation<Geometry>::Triangle Triangulation<Geometry>::triangle_over(std::uint32_t from,
                                                                                  std::uint32_t to) const {
  const View& a = hole_places_[from];
  const View& b = hole_places_[to];
  std::uint32_t apex = from + 1;
  for (std::uint32_t i = apex + 1; i < to; ++i) {
    if (circle_holds(geometry_, a, hole_places_[apex], b, hole_places_[i])) apex = i;
  }
  return {from, apex, to};
}

template <class Geometry>
void Triangulation<Geometry>::forget(mesh::Vertex v, mesh::HalfEdge near) {
  mesh_.free_vertex(v);
  sectors_.forget(geometry_.nearest(number(v)), v, mesh_.origin(near));
  geometry_.clear(number(v));
  remember(near);
}

}  // namespace waywright::delaunay

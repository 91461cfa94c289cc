#pragma once

#include <algorithm>
#include <cstdint>

#include "delaunay/tie_rule.hpp"
#include "delaunay/triangulation.hpp"

namespace waywright::delaunay {

template <class Geometry>
void Triangulation<Geometry>::unfix_edge(mesh::HalfEdge h) {
  mesh_.set_label(h, 0);
  unfixed_.push_back(h);
}

template <class Geometry>
void Triangulation<Geometry>::legalise_unfixed() {
  legalise(geometry_, mesh_, unfixed_);
}

// Each step around the vertex waits for memory whose address the previous step has read, so the function goes around
// the vertex in both directions at once. In the meantime it prefetches the data of the neighbours that a removal needs.
// It knows a neighbour as soon as it reads a face: the apex of the face is the next neighbour.
template <class Geometry>
const typename Triangulation<Geometry>::Star& Triangulation<Geometry>::star(mesh::Vertex v) {
  star_.spokes.clear();
  star_.fixed.clear();
  clockwise_.clear();
  mesh::HalfEdge left = mesh_.outgoing(v);
  mesh::HalfEdge right = left;
  prefetch(mesh_.target(right));
  do {
    if (star_.spokes.size() == kManySpokes && has_crossing(star_.spokes)) break;
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

/// Whether more than two of the spokes are fixed.
template <class Geometry>
bool Triangulation<Geometry>::has_crossing(const std::vector<mesh::HalfEdge>& spokes) const {
  return std::count_if(spokes.begin(), spokes.end(), [&](mesh::HalfEdge h) { return mesh_.is_fixed(h); }) > 2;
}

template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex(const Star& star) {
  return star.fixed.empty() ? remove_free_vertex(star) : remove_vertex_on_line(star);
}

//         w2 ---- w1      The faces around v leave a cavity, which is star-shaped around v. Its border starts
//        /  \   /  |      at w0. The last edge of the border, from w4 to w0, is the base.
//      w3 --- v --- w0
//        \   |    /
//          ---w4--
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_free_vertex(const Star& star) {
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  collect_cavity(star, 0, 0);
  const mesh::HalfEdge last = cavity_edges_.back();
  cavity_edges_.pop_back();
  const mesh::HalfEdge base = refill_cavity();
  mesh_.close(base, last);
  free_vertex(v, base);
  return mesh::kNoHalfEdge;
}

//          a2 --- a1     v lies on the line from p to q. The edge p - q replaces p - v and v - q. On the left and
//        /   \  /   \    on the right of the line, the faces around v leave a cavity with the edge p - q as its base.
//       p --- v --- q
//        \   / \   /
//          b1 --- b2
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::remove_vertex_on_line(const Star& star) {
  const std::size_t to_p = star.fixed[0];
  const std::size_t to_q = star.fixed[1];
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  const mesh::Label label = mesh_.label(star.spokes[to_p]);
  collect_cavity(star, to_q, to_p);
  const mesh::HalfEdge left = refill_cavity();
  collect_cavity(star, to_p, to_q);
  const mesh::HalfEdge right = refill_cavity();
  mesh_.link(left, right, label);
  free_vertex(v, left);
  return left;
}

/// Collects the half-edges opposite to a star's vertex in the faces between two spokes, and the positions of their
/// ends. The faces are those from the spoke at index `from`, counter-clockwise, to the spoke at index `to`.
template <class Geometry>
void Triangulation<Geometry>::collect_cavity(const Star& star, std::size_t from, std::size_t to) {
  const std::size_t degree = star.spokes.size();
  const std::size_t count = from < to ? to - from : to + degree - from;
  cavity_edges_.resize(count);
  cavity_positions_.resize(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = from + i < degree ? from + i : from + i - degree;
    cavity_edges_[i] = next(star.spokes[at]);
    cavity_positions_[i] = view(mesh_.origin(cavity_edges_[i]));
  }
  cavity_positions_[count] = view(mesh_.target(cavity_edges_[count - 1]));
}

/// Triangulates a cavity. Its border consists of the edges in `cavity_edges_` and of the base, which runs from the last
/// vertex to the first. Cost: expected linear. The simple method for small cavities takes quadratic time at worst.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::refill_cavity() {
  if (cavity_edges_.size() > kLargeCavity) {
    std::uint64_t seed = 0;
    for (const mesh::HalfEdge h : cavity_edges_) seed = changed_seed(seed, geometry_.rounded(number(mesh_.origin(h))));
    large_cavity_.triangulate(geometry_, std::span(cavity_positions_).first(cavity_edges_.size() + 1), seed,
                              triangles_);
    return mesh_.refill(cavity_edges_, triangles_);
  }
  triangles_.clear();
  triangles_.push_back(triangle_over(0, static_cast<std::uint32_t>(cavity_edges_.size())));
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto [from, apex, to] = triangles_[i];
    if (apex - from > 1) triangles_.push_back(triangle_over(from, apex));
    if (to - apex > 1) triangles_.push_back(triangle_over(apex, to));
  }
  return mesh_.refill(cavity_edges_, triangles_);
}

//           m          Finds the triangle on a base: its apex is the vertex whose circle through the base's ends
//        .     .       contains no other vertex. One circle through these ends is known to contain no vertex of the
//     from ----- to    cavity: the circle of the triangle beyond the base or, for the first base, the circle through v
//        .  n  .       (if v lies on the base, the half-plane beyond the base). Each vertex has its own circle through
//           .          these ends. The apex is the vertex whose circle reaches least far in front of the base. A vertex
//                      beyond the base, or on its line, has a circle that reaches less far in front than the empty
//                      circle; if such a vertex is the candidate, each vertex in front of the base must replace it.
//
// The determinant is the in-circle determinant of the two ends of the base, of the candidate m and of the next vertex
// n. A vertex lies *in front* of the base if it lies where the triangle will be, and *beyond* the base if the line
// through the base separates it from there. The code need not test whether the candidate m lies in front. If m lies in
// front, the determinant is positive for each n in m's circle. If m lies beyond the base, the sign of the determinant
// is reversed: it is positive for each n in front, because n then lies outside m's circle. For n beyond the base, the
// determinant is negative if m lies in front; if m lies beyond it, too, the code may choose either. Ties are decided as
// if one lifted point were lowered by an infinitesimal, and the same argument holds for these points. In a tie, the
// sign of the determinant still decides, except if n is the lowered point. Then n lies in every circle, also in the
// circle of m. So it is impossible that m lies beyond the base and n in front of it.
//
// No edge of the cavity hides a vertex that lies in the circle, because v lies in the circle, and no edge of the cavity
// lay between v and a vertex of the cavity. Source: Devillers, *Vertex removal in two-dimensional Delaunay
// triangulation: speed-up by low degrees optimization*, 2011, which uses decision tables. For vertices of usual
// degrees, this loop needs about as many in-circle tests.
template <class Geometry>
typename Triangulation<Geometry>::Triangle Triangulation<Geometry>::triangle_over(std::uint32_t from,
                                                                                  std::uint32_t to) const {
  const View& a = cavity_positions_[from];
  const View& b = cavity_positions_[to];
  std::uint32_t apex = from + 1;
  for (std::uint32_t i = apex + 1; i < to; ++i) {
    if (circle_contains(geometry_, a, cavity_positions_[apex], b, cavity_positions_[i])) apex = i;
  }
  return {from, apex, to};
}

template <class Geometry>
void Triangulation<Geometry>::free_vertex(mesh::Vertex v, mesh::HalfEdge near) {
  mesh_.free_vertex(v);
  sectors_.replace(geometry_.rounded(number(v)), v, mesh_.origin(near));
  geometry_.clear(number(v));
  remember(near);
}

}  // namespace waywright::delaunay

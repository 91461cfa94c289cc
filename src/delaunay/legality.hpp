#pragma once

#include <cstddef>
#include <vector>

#include "base/compiler.hpp"
#include "delaunay/geometry.hpp"
#include "exact/position.hpp"
#include "mesh/index.hpp"

namespace waywright::delaunay {

/// Whether the circle through `a`, `b` and `c` (counter-clockwise) contains `d`, another position on the circle. This
/// function breaks the tie.
///
/// The first of the four lifted points is lowered by an infinitesimal. If the first is d, the circle contains d. If it
/// is one of the others, a swap of this point and d in the determinant leads to the same case. The orientation of d and
/// the two remaining points gives the sign: the circle contains d if it is negative.
/// Not inlined: ties are rare.
[[nodiscard]] WAYWRIGHT_NO_INLINE inline bool tied_circle_contains(const Geometry& geometry, const Geometry::View& a,
                                                                   const Geometry::View& b, const Geometry::View& c,
                                                                   const Geometry::View& d) {
  const Geometry::View* first = &d;
  for (const Geometry::View* const v : {&a, &b, &c}) {
    if (geometry.order(*v, *first) < 0) first = v;
  }
  if (first == &d) return true;
  const exact::Sign rest = first == &a   ? geometry.orientation(d, b, c)
                           : first == &b ? geometry.orientation(a, d, c)
                                         : geometry.orientation(a, b, d);
  return rest == exact::Sign::negative;
}

/// Whether the circle through `a`, `b` and `c` (counter-clockwise) contains `d`; breaks ties. Requires: `d` differs
/// from the other three.
[[nodiscard]] inline bool circle_contains(const Geometry& geometry, const Geometry::View& a, const Geometry::View& b,
                                          const Geometry::View& c, const Geometry::View& d) {
  const exact::Sign sign = geometry.in_circle(a, b, c, d);
  if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
  return tied_circle_contains(geometry, a, b, c, d);
}

// Tests and flips of edges. `Mesh` is mesh::TriangleMesh or mesh::UnloggedMesh.

/// Whether an edge is legal if its four vertices lie on a circle: the first of them in (x, y) order is one of its ends.
/// Not inlined: ties are rare, and without this code is_legal() can keep its data in registers.
template <class Mesh>
[[nodiscard]] WAYWRIGHT_NO_INLINE bool is_legal_on_circle(const Geometry& geometry, const Mesh& mesh,
                                                          mesh::HalfEdge h) {
  const mesh::HalfEdge t = mesh.twin(h);
  const auto first_of = [&](mesh::Vertex p, mesh::Vertex q) {
    return geometry.order(geometry.view(number(p)), geometry.view(number(q))) < 0 ? p : q;
  };
  const mesh::Vertex end = first_of(mesh.origin(h), mesh.origin(t));
  return first_of(end, first_of(mesh.apex(h), mesh.apex(t))) == end;
}

//        c        The edge a - b is legal if d lies outside the circle through a, b and c.
//      /   \.
//    a ----- b
//      \   /
//        d
/// Whether the edge of `h` has the empty-circle property for its two faces. `c` is the position of the apex of `h`.
/// Requires: the edge is free and lies inside the domain.
template <class Mesh>
[[nodiscard]] bool is_legal(const Geometry& geometry, const Mesh& mesh, mesh::HalfEdge h, const Geometry::View& c) {
  const mesh::HalfEdge t = mesh.twin(h);
  const auto view = [&](mesh::Vertex v) { return geometry.view(number(v)); };
  const exact::Sign sign = geometry.in_circle(view(mesh.origin(h)), view(mesh.origin(t)), c, view(mesh.apex(t)));
  return sign == exact::Sign::zero ? is_legal_on_circle(geometry, mesh, h) : sign == exact::Sign::negative;
}
template <class Mesh>
[[nodiscard]] bool is_legal(const Geometry& geometry, const Mesh& mesh, mesh::HalfEdge h) {
  return is_legal(geometry, mesh, h, geometry.view(number(mesh.apex(h))));
}

// A flip rebuilds two faces. Afterwards, half-edges in the queue may represent other edges. So the function adds the
// four outer edges of the two faces again. The edge between the two faces is legal after the flip.
//
// With a stack instead of a queue, the flips go on at one side of a freed edge before they begin at the other side. If
// a long edge between two rows of n points becomes free, there are then n^2 flips. With the queue, there are about n.
/// Flips the edges in `freed`, and the edges that these flips make illegal, until every free edge is legal. Empties
/// `freed`.
template <class Mesh>
WAYWRIGHT_NO_INLINE void legalise(const Geometry& geometry, Mesh& mesh, std::vector<mesh::HalfEdge>& freed) {
  constexpr std::size_t kMostDone = 4096;
  for (std::size_t done = 0; done < freed.size();) {
    if (done >= kMostDone && 2 * done >= freed.size()) {
      freed.erase(freed.begin(), freed.begin() + static_cast<std::ptrdiff_t>(done));
      done = 0;
    }
    const mesh::HalfEdge h = freed[done++];
    if (mesh.is_fixed(h) || is_legal(geometry, mesh, h)) continue;
    const mesh::HalfEdge t = mesh.twin(h);
    mesh.flip(h);
    for (const mesh::HalfEdge edge : {h, previous(h), t, previous(t)}) freed.push_back(edge);
  }
  freed.clear();
}

}  // namespace waywright::delaunay

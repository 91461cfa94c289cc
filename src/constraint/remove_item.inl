#pragma once

#include <algorithm>
#include <utility>

#include "constraint/constrained_triangulation.hpp"
#include "constraint/scattered_order.hpp"

namespace waywright::constraint {

// First takes the item off its edges and corners, then flips the edges that have become free until they are Delaunay,
// and only then removes vertices: the removal of a vertex from a Delaunay triangulation leaves a Delaunay
// triangulation.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::remove(ItemId id) {
  const std::uint32_t slot = items_.slot(id);
  items_.outline(slot, outline_);
  // In a large world, a removal spends most of its time waiting for memory. The code prefetches data as soon as it
  // knows the address. Some of the faces that were made together with a corner probably still have it as a vertex.
  for (const mesh::Vertex v : outline_.corners) {
    triangulation_.prefetch(v);
    triangulation_.prefetch_faces_made_with(v);
    prefetch_corner_uses(v);
  }
  const ItemHash::Words hash = hash_of(slot, outline_);
  for (const mesh::Vertex v : outline_.corners) triangulation_.prefetch_star(v);
  items_.remove_item(slot, hash);
  touched_.clear();
  new_walls_.forget();
  items_.for_each_side(slot, [&](std::uint32_t side) { remove_side(side); });
  for (const mesh::Vertex v : outline_.corners) remove_corner_use(v, slot);
  triangulation_.legalise_unfixed();
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  remove_unneeded();
}

/// Removes the vertices in `touched_` that are not needed any more, in their order. If this turns out to be costly
/// (CostWatch), removes the remaining ones in scattered order (append_scattered).
template <class Geometry>
void ConstrainedTriangulation<Geometry>::remove_unneeded() {
  CostWatch watch(kEdgesPerVertex);
  std::uint32_t i = 0;
  for (; i < touched_.size() && !watch.is_costly(); ++i) watch.add(remove_if_unneeded(touched_[i]));
  if (i == touched_.size()) return;
  order_.clear();
  append_scattered(i, static_cast<std::uint32_t>(touched_.size()), false, order_);
  for (const std::uint32_t late : order_) remove_if_unneeded(touched_[late]);
}

// Takes the side off its edges, beginning at both ends. edge_of_side() finds the next edge at one of the two ends:
// usually at the end with fewer edges. So the function is not slow if the side runs through a vertex with many edges:
// it takes the remaining edges from the other end.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::remove_side(std::uint32_t slot) {
  const mesh::TriangleMesh& mesh = topology();
  const Side& side = items_.side(slot);
  mesh::Vertex u = side.from;
  mesh::Vertex w = side.to;
  while (u != w) {
    const mesh::HalfEdge h = edge_of_side(u, w, slot);
    mesh::Vertex& end = mesh.origin(h) == u ? u : w;
    end = mesh.target(h);
    touched_.push_back(end);
    const Uses rest = uses_.remove(mesh.label(h), slot);
    if (rest == UseLists::kNone) {
      triangulation_.unfix_edge(h);
    } else {
      triangulation_.fix(h, rest);
    }
  }
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::remove_corner_use(mesh::Vertex v, std::uint32_t item) {
  set_corner_uses(v, uses_.remove(corner_uses_[number(v)], item));
  touched_.push_back(v);
}

template <class Geometry>
std::size_t ConstrainedTriangulation<Geometry>::remove_if_unneeded(mesh::Vertex v) {
  if (corner_uses_[number(v)] != UseLists::kNone) return 0;
  // No item has a corner at `v`, so each side at `v` continues straight through it. If `v` has two fixed edges, they
  // therefore lie on one line. If it has more, sides cross there, and `v` stays.
  const auto& star = triangulation_.star(v);
  if (star.fixed.size() > 2) return 0;
  if (star.fixed.size() == 2) uses_.release(topology().label(star.spokes[star.fixed[1]]));
  const std::size_t degree = star.spokes.size();
  triangulation_.remove_vertex(star);
  return degree;
}

// First looks at a few edges of `u`, then alternately at an edge of each of the two vertices.
template <class Geometry>
mesh::HalfEdge ConstrainedTriangulation<Geometry>::edge_of_side(mesh::Vertex u, mesh::Vertex w,
                                                                std::uint32_t side) const {
  const mesh::TriangleMesh& mesh = topology();
  const auto lies_on = [&](mesh::HalfEdge h) { return mesh.is_fixed(h) && uses_.contains(mesh.label(h), side); };
  mesh::HalfEdge g = mesh.outgoing(u);
  for (std::size_t i = 0; i < mesh::TriangleMesh::kFewEdges; ++i) {
    if (lies_on(g)) return g;
    g = mesh.next_around(g);
  }
  for (mesh::HalfEdge h = mesh.outgoing(w);; h = mesh.next_around(h)) {
    if (lies_on(g)) return g;
    if (lies_on(h)) return h;
    g = mesh.next_around(g);
  }
}

}  // namespace waywright::constraint

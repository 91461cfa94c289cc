#pragma once

#include <algorithm>

#include "delaunay/tie_rule.hpp"
#include "delaunay/triangulation.hpp"

namespace waywright::delaunay {

//              left chain
//         q ------ r ------ s              The faces between u and w that the edge u - w crosses leave a cavity. Each
//         of
//       /   \    /   \    /   \            its halves is a polygon over the new edge, triangulated on its own. An edge
//      u - - - - - - - - - - - w           whose two sides lie both in the cavity dangles into it: the chain walks it
//      to
//       \   /    \   /    \   /            and fro, and the polygon is one only in a weak sense. Anglada's choice of
//       the
//         p ------ + ------ +              apex is right for these as well.
//              right chain
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::force_edge(mesh::Vertex u, mesh::Vertex w,
                                                   const std::vector<mesh::HalfEdge>& crossed, mesh::Label label) {
  collect_chains(crossed);
  for (const mesh::Face f : cavity_) mesh_.free_face(f);
  pair_dangling_edges(left_chain_);
  pair_dangling_edges(right_chain_);
  const mesh::HalfEdge left = triangulate(left_chain_, w);
  const mesh::HalfEdge right = triangulate(right_chain_, u);
  mesh_.link(left, right, label);
  remember(left);
  return left;
}

// The left chain runs from u to w, the right one from w to u: each has its polygon on the right of its own way and on
// the left of its base.
template <class Geometry>
void Triangulation<Geometry>::collect_chains(const std::vector<mesh::HalfEdge>& crossed) {
  left_chain_.clear();
  right_chain_.clear();
  cavity_.clear();
  cavity_.push_back(mesh::face(crossed.front()));
  append_to(left_chain_, mesh::next(crossed.front()));
  append_to(right_chain_, mesh::previous(crossed.front()));
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    const mesh::HalfEdge t = mesh_.twin(crossed[i]);
    cavity_.push_back(mesh::face(t));
    const bool is_last = i + 1 == crossed.size();
    if (is_last || crossed[i + 1] == mesh::next(t)) append_to(left_chain_, mesh::previous(t));
    if (is_last || crossed[i + 1] == mesh::previous(t)) append_to(right_chain_, mesh::next(t));
  }
  std::reverse(right_chain_.begin(), right_chain_.end());
}

template <class Geometry>
void Triangulation<Geometry>::append_to(Chain& chain, mesh::HalfEdge inner) {
  ChainEdge edge{};
  edge.from = mesh_.target(inner);
  edge.inner = inner;
  edge.outer = mesh_.twin(inner);
  edge.label = mesh_.label(inner);
  chain.push_back(edge);
}

// Both sides of a dangling edge lie in the same chain, for an edge between the two chains would be crossed.
template <class Geometry>
void Triangulation<Geometry>::pair_dangling_edges(Chain& chain) {
  dangling_.clear();
  for (std::uint32_t i = 0; i < chain.size(); ++i) {
    if (!mesh_.is_alive(mesh::face(chain[i].outer))) dangling_.push_back(i);
  }
  if (dangling_.empty()) return;
  std::sort(dangling_.begin(), dangling_.end(),
            [&](std::uint32_t i, std::uint32_t j) { return chain[i].inner < chain[j].inner; });
  for (const std::uint32_t i : dangling_) {
    const auto partner = std::lower_bound(dangling_.begin(), dangling_.end(), chain[i].outer,
                                          [&](std::uint32_t j, mesh::HalfEdge h) { return chain[j].inner < h; });
    chain[i].partner = *partner;
  }
}

template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::triangulate(Chain& chain, mesh::Vertex end) {
  const auto last = static_cast<std::uint32_t>(chain.size());
  const auto vertex = [&](std::uint32_t i) { return i == last ? end : chain[i].from; };
  mesh::HalfEdge result = mesh::kNoHalfEdge;
  bases_.clear();
  bases_.push_back({0, last, mesh::kNoHalfEdge});
  while (!bases_.empty()) {
    const Base base = bases_.back();
    bases_.pop_back();
    const std::uint32_t apex = delaunay_apex(chain, end, base);
    const mesh::Face f = mesh_.add_face();
    const mesh::HalfEdge h = mesh::first(f);
    mesh_.set_corners(f, vertex(base.from), vertex(base.to), vertex(apex));
    if (base.parent == mesh::kNoHalfEdge) {
      result = h;
    } else {
      mesh_.link(h, base.parent, 0);
    }
    const Base right{apex, base.to, mesh::next(h)};
    const Base left{base.from, apex, mesh::previous(h)};
    for (const Base& side : {right, left}) {
      if (side.to == side.from + 1) {
        close(chain, side.from, side.parent);
      } else {
        bases_.push_back(side);
      }
    }
  }
  return result;
}

// The chain vertex whose circle with the base's ends holds no other vertex of the chain between them. The chain lies on
// the left of the base, for the edges that it crossed went there from beyond it (Anglada).
template <class Geometry>
std::uint32_t Triangulation<Geometry>::delaunay_apex(const Chain& chain, mesh::Vertex end, const Base& base) const {
  if (base.to == base.from + 2) return base.from + 1;
  const mesh::Vertex from = chain[base.from].from;
  const mesh::Vertex to = base.to == chain.size() ? end : chain[base.to].from;
  std::uint32_t apex = base.to;
  for (std::uint32_t i = base.from + 1; i < base.to; ++i) {
    const mesh::Vertex v = chain[i].from;
    if (apex == base.to || circle_holds(from, to, chain[apex].from, v)) apex = i;
  }
  return apex;
}

template <class Geometry>
void Triangulation<Geometry>::close(Chain& chain, std::uint32_t position, mesh::HalfEdge inner) {
  ChainEdge& edge = chain[position];
  edge.inner = inner;
  edge.is_rebuilt = true;
  if (edge.partner == kNotDangling) {
    mesh_.link(inner, edge.outer, edge.label);
  } else if (chain[edge.partner].is_rebuilt) {
    mesh_.link(inner, chain[edge.partner].inner, edge.label);
  }
}

template <class Geometry>
bool Triangulation<Geometry>::circle_holds(mesh::Vertex a, mesh::Vertex b, mesh::Vertex c, mesh::Vertex d) const {
  if (a == d || b == d || c == d) return false;
  return delaunay::circle_holds(geometry_, view(a), view(b), view(c), view(d));
}

}  // namespace waywright::delaunay

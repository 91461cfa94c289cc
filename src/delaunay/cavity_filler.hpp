#pragma once

#include <algorithm>

#include "delaunay/triangulation.hpp"

namespace waywright::delaunay {

//              left chain           The faces that the new edge u - w crosses leave a cavity. The new edge divides it
//         q ------ r ------ s       into two polygons, which are triangulated separately. If both faces of an edge on a
//       /   \    /   \    /   \     polygon's border lie in the cavity, the edge is dangling: the chain runs along it
//      u - - - - - - - - - - - w    in both directions, and the polygon is only weakly simple.
//       \   /    \   /    \   /
//         p ------ + ------ +
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
  const mesh::HalfEdge edge = legalise_cavity() ? mesh_.find(u, w) : left;
  remember(edge);
  return edge;
}

// The left chain runs from u to w, the right chain from w to u. Each polygon lies right of its chain and left of its
// base.
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

// Both half-edges of a dangling edge lie in the same chain, because the new edge crosses every edge between the two
// chains.
template <class Geometry>
void Triangulation<Geometry>::pair_dangling_edges(Chain& chain) {
  dangling_.clear();
  for (std::uint32_t i = 0; i < chain.size(); ++i) {
    if (!mesh_.is_live(mesh::face(chain[i].outer))) dangling_.push_back(i);
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

//          b          Where the chain turns right at b, the triangle a b r is an ear, whichever ears have been cut
//        /   \        before: no vertex of the rest of the polygon lies in the triangle or on a - r. Proof: suppose
//      a ----- r      that such a vertex z comes after r. A crossed edge connects z to the base. This edge cannot leave
//     /         \     the triangle through b - r: b - r is an edge of the chain, or only ears lie behind it, and the
//    u - - - - - w    edge cannot leave these elsewhere. So it leaves through a - r and meets the base before the
//                     crossed edge of r does. But the crossed edges meet the base in the order of the chain.
//
// Hence one pass with a stack cuts the polygon into triangles, like Graham's scan. Flips then make them Delaunay.
// Source: Toussaint and Avis, *On a convex hull algorithm for polygons and its application to triangulation problems*,
// 1982, which triangulates a polygon in this way if all its points are visible from one edge.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::triangulate(Chain& chain, mesh::Vertex end) {
  const auto last = static_cast<std::uint32_t>(chain.size());
  corners_.clear();
  corners_.push_back({chain.front().from, 0, mesh::kNoHalfEdge});
  for (std::uint32_t i = 1; i <= last; ++i) {
    ChainCorner r{i == last ? end : chain[i].from, i - 1, mesh::kNoHalfEdge};
    while (corners_.size() > 1) {
      const ChainCorner& b = corners_.back();
      const ChainCorner& a = corners_[corners_.size() - 2];
      if (orientation(a.vertex, b.vertex, r.vertex) != exact::Sign::negative) break;
      r.base = cut_ear(chain, a.vertex, b, r);
      corners_.pop_back();
    }
    corners_.push_back(r);
  }
  return corners_.back().base;
}

/// Makes the triangle of `a`, `b` and `r`. Returns its half-edge from `a` to `r`, which has no twin yet.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::cut_ear(Chain& chain, mesh::Vertex a, const ChainCorner& b,
                                                const ChainCorner& r) {
  const mesh::Face f = mesh_.add_face();
  const mesh::HalfEdge base = mesh::first(f);
  mesh_.set_corners(f, a, r.vertex, b.vertex);
  const auto join = [&](mesh::HalfEdge inner, const ChainCorner& corner) {
    if (corner.base == mesh::kNoHalfEdge) return close(chain, corner.position, inner);
    mesh_.link(inner, corner.base, 0);
    freed_.push_back(inner);
  };
  join(mesh::next(base), r);
  join(mesh::previous(base), b);
  return base;
}

/// Flips the illegal edges between the chains. Returns whether it had to flip an edge.
///
/// The edges of the chains themselves are always legal, so the faces beyond them stay as they are. Callers of
/// force_edge() may rely on this. Proof: a triangle on an edge of the chain lies in the cavity, where no edge was
/// fixed. Hence the face beyond that edge sees the triangle's apex, and the circle of a Delaunay face contains no
/// vertex that the face sees.
template <class Geometry>
bool Triangulation<Geometry>::legalise_cavity() {
  while (!freed_.empty() && is_legal(freed_.back())) freed_.pop_back();
  if (freed_.empty()) return false;
  legalise_freed();
  return true;
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

}  // namespace waywright::delaunay

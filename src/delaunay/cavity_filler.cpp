#include "delaunay/cavity_filler.hpp"

#include <algorithm>
#include <utility>

#include "delaunay/legality.hpp"

namespace waywright::delaunay {

//              left chain           The faces that the new edge u - w crosses leave a cavity. The new edge divides it
//         q ------ r ------ s       into two polygons, which are triangulated separately. If both faces of an edge on a
//       /   \    /   \    /   \     polygon's border lie in the cavity, the edge is dangling: the chain runs along it
//      u - - - - - - - - - - - w    in both directions, and the polygon is only weakly simple.
//       \   /    \   /    \   /
//         p ------ + ------ +
//              right chain
template <class Mesh>
mesh::HalfEdge CavityFiller::force_edge(const Geometry& geometry, Mesh& mesh, mesh::Vertex u, mesh::Vertex w,
                                        const std::vector<mesh::HalfEdge>& crossed, mesh::Label label) {
  inner_edges_.clear();
  collect_chains(mesh, crossed);
  for (const mesh::Face f : cavity_) mesh.free_face(f);
  pair_dangling_edges(mesh, left_chain_);
  pair_dangling_edges(mesh, right_chain_);
  const mesh::HalfEdge left = triangulate(geometry, mesh, left_chain_, w);
  const mesh::HalfEdge right = triangulate(geometry, mesh, right_chain_, u);
  mesh.link(left, right, label);
  return legalise_cavity(geometry, mesh) ? mesh.find(u, w) : left;
}

// The left chain runs from u to w, the right chain from w to u. Each polygon lies right of its chain and left of its
// base.
template <class Mesh>
void CavityFiller::collect_chains(const Mesh& mesh, const std::vector<mesh::HalfEdge>& crossed) {
  left_chain_.clear();
  right_chain_.clear();
  cavity_.clear();
  cavity_.push_back(mesh::face(crossed.front()));
  append_to(mesh, left_chain_, mesh::next(crossed.front()));
  append_to(mesh, right_chain_, mesh::previous(crossed.front()));
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    const mesh::HalfEdge t = mesh.twin(crossed[i]);
    cavity_.push_back(mesh::face(t));
    const bool is_last = i + 1 == crossed.size();
    if (is_last || crossed[i + 1] == mesh::next(t)) append_to(mesh, left_chain_, mesh::previous(t));
    if (is_last || crossed[i + 1] == mesh::previous(t)) append_to(mesh, right_chain_, mesh::next(t));
  }
  std::reverse(right_chain_.begin(), right_chain_.end());
}

template <class Mesh>
void CavityFiller::append_to(const Mesh& mesh, Chain& chain, mesh::HalfEdge inner) {
  ChainEdge edge{};
  edge.from = mesh.target(inner);
  edge.inner = inner;
  edge.outer = mesh.twin(inner);
  edge.label = mesh.label(inner);
  chain.push_back(edge);
}

// Both half-edges of a dangling edge lie in the same chain, because the new edge crosses every edge between the two
// chains.
template <class Mesh>
void CavityFiller::pair_dangling_edges(const Mesh& mesh, Chain& chain) {
  dangling_.clear();
  for (std::uint32_t i = 0; i < chain.size(); ++i) {
    if (!mesh.is_live(mesh::face(chain[i].outer))) dangling_.push_back(i);
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
//     /         \     the triangle through b - r: b - r is an edge of the chain, or only ears lie beyond it. These
//    u - - - - - w    ears lie between b - r and edges of the chain, which the edge of z does not cross. So this edge
//                     leaves the triangle through a - r and meets the base before the crossed edge of r does. But the
//                     crossed edges meet the base in the order of the chain. If z comes before a, the same is true with
//                     a - b and a instead of b - r and r.
//
// Hence one pass with a stack cuts the polygon into triangles, like Graham's scan. Flips then make them Delaunay. The
// number of flips can be quadratic in the number of edges, so large polygons get their triangles from SegmentCavity.
// Source: Toussaint and Avis, *On a convex hull algorithm for polygons and its application to triangulation problems*,
// 1982, which applies this method to polygons in which all points are visible from one edge.
template <class Mesh>
mesh::HalfEdge CavityFiller::triangulate(const Geometry& geometry, Mesh& mesh, Chain& chain, mesh::Vertex end) {
  const auto orientation = [&](mesh::Vertex p, mesh::Vertex q, mesh::Vertex s) {
    return geometry.orientation(geometry.view(number(p)), geometry.view(number(q)), geometry.view(number(s)));
  };
  if (chain.size() > kLargePolygon) {
    const mesh::HalfEdge base = triangulate_large(geometry, mesh, chain, end);
    if (base != mesh::kNoHalfEdge) return base;
  }
  const auto last = static_cast<std::uint32_t>(chain.size());
  chain_vertices_.clear();
  chain_vertices_.push_back({chain.front().from, 0, mesh::kNoHalfEdge});
  for (std::uint32_t i = 1; i <= last; ++i) {
    ChainVertex r{i == last ? end : chain[i].from, i - 1, mesh::kNoHalfEdge};
    while (chain_vertices_.size() > 1) {
      const ChainVertex& b = chain_vertices_.back();
      const ChainVertex& a = chain_vertices_[chain_vertices_.size() - 2];
      if (orientation(a.vertex, b.vertex, r.vertex) != exact::Sign::negative) break;
      r.base = cut_ear(mesh, chain, a.vertex, b, r);
      chain_vertices_.pop_back();
    }
    chain_vertices_.push_back(r);
  }
  return chain_vertices_.back().base;
}

// SegmentCavity takes the vertices counter-clockwise, and the chain lists them clockwise.
bool CavityFiller::find_triangles(const Geometry& geometry, const Chain& chain, mesh::Vertex end) {
  segment_cavity_.clear();
  const auto add = [&](mesh::Vertex v) { segment_cavity_.add(geometry.view(number(v)), geometry.rounded(number(v))); };
  add(end);
  for (auto edge = chain.rbegin(); edge != chain.rend(); ++edge) add(edge->from);
  return segment_cavity_.triangulate(geometry, triangles_);
}

// SegmentCavity numbers the vertices counter-clockwise, and the chain lists them clockwise. Each triangle of the list
// comes after the triangle on whose edge it lies. So the function makes them in the reverse order.
template <class Mesh>
mesh::HalfEdge CavityFiller::triangulate_large(const Geometry& geometry, Mesh& mesh, Chain& chain, mesh::Vertex end) {
  if (!find_triangles(geometry, chain, end)) return mesh::kNoHalfEdge;
  const auto last = static_cast<std::uint32_t>(chain.size());
  const auto vertex = [&](std::uint32_t i) { return i == last ? end : chain[i].from; };
  bases_.resize(last);
  const auto end_of_piece = [&](std::uint32_t from, std::uint32_t to) {
    return ChainVertex{vertex(to), from, to - from == 1 ? mesh::kNoHalfEdge : bases_[from]};
  };
  for (auto triangle = triangles_.rbegin(); triangle != triangles_.rend(); ++triangle) {
    const std::uint32_t a = last - triangle->to;
    const std::uint32_t b = last - triangle->apex;
    const std::uint32_t r = last - triangle->from;
    bases_[a] = cut_ear(mesh, chain, vertex(a), end_of_piece(a, b), end_of_piece(b, r));
  }
  return bases_[0];
}

/// Makes the triangle of `a`, `b` and `r`. Returns its half-edge from `a` to `r`, which has no twin yet.
template <class Mesh>
mesh::HalfEdge CavityFiller::cut_ear(Mesh& mesh, Chain& chain, mesh::Vertex a, const ChainVertex& b,
                                     const ChainVertex& r) {
  const mesh::Face f = mesh.add_face();
  const mesh::HalfEdge base = mesh::first(f);
  mesh.set_vertices(f, a, r.vertex, b.vertex);
  const auto join = [&](mesh::HalfEdge inner, const ChainVertex& end) {
    if (end.base == mesh::kNoHalfEdge) return link_chain_edge(mesh, chain, end.index, inner);
    mesh.link(inner, end.base, 0);
    inner_edges_.push_back(inner);
  };
  join(mesh::next(base), r);
  join(mesh::previous(base), b);
  return base;
}

/// Flips the illegal edges in `inner_edges_`. Returns whether it had to flip an edge.
///
/// The edges of the chains themselves are always legal, so the faces beyond them stay as they are. Callers of
/// force_edge() may rely on this. Proof: a triangle on an edge of the chain lies in the cavity. No fixed edge
/// crossed it: the crossed edges were free, and any other edge in the cavity lies on the border of a polygon. Hence the
/// face beyond the edge of the chain sees the triangle's apex, and the circle of a Delaunay face contains no vertex
/// that the face sees.
template <class Mesh>
bool CavityFiller::legalise_cavity(const Geometry& geometry, Mesh& mesh) {
  while (!inner_edges_.empty() && is_legal(geometry, mesh, inner_edges_.back())) inner_edges_.pop_back();
  if (inner_edges_.empty()) return false;
  legalise(geometry, mesh, inner_edges_);
  return true;
}

template <class Mesh>
void CavityFiller::link_chain_edge(Mesh& mesh, Chain& chain, std::uint32_t index, mesh::HalfEdge inner) {
  ChainEdge& edge = chain[index];
  edge.inner = inner;
  edge.is_rebuilt = true;
  if (edge.partner == kNotDangling) {
    mesh.link(inner, edge.outer, edge.label);
  } else if (chain[edge.partner].is_rebuilt) {
    mesh.link(inner, chain[edge.partner].inner, edge.label);
  }
}

template mesh::HalfEdge CavityFiller::force_edge(const Geometry&, mesh::TriangleMesh&, mesh::Vertex, mesh::Vertex,
                                                 const std::vector<mesh::HalfEdge>&, mesh::Label);
template mesh::HalfEdge CavityFiller::force_edge(const Geometry&, mesh::UnloggedMesh&, mesh::Vertex, mesh::Vertex,
                                                 const std::vector<mesh::HalfEdge>&, mesh::Label);

bool LocalEdges::force_edge(mesh::Vertex u, mesh::Vertex w, mesh::Label label) {
  if (!is_own(u) || !is_own(w)) return false;
  if (mesh_.has_many_and_more_edges(u, w)) std::swap(u, w);
  const mesh::HalfEdge edge = mesh_.find(u, w);
  if (edge != mesh::kNoHalfEdge) {
    if (mesh_.is_fixed(edge)) return false;
    mesh_.set_label(edge, label);
    return true;
  }
  if (!collect_crossed(u, w)) return false;
  filler_.force_edge(geometry_, mesh_, u, w, crossed_, label);
  return true;
}

mesh::HalfEdge LocalEdges::first_crossed(mesh::Vertex u, mesh::Vertex w) const {
  const auto sign_at = [&](mesh::Vertex v) { return v == ghost_ ? exact::Sign::zero : orientation(u, w, v); };
  const mesh::HalfEdge start = mesh_.outgoing(u);
  mesh::HalfEdge h = start;
  exact::Sign right = sign_at(mesh_.target(h));
  for (std::size_t i = 0; i < kMostEdges; ++i) {
    const exact::Sign left = sign_at(mesh_.apex(h));
    if (right == exact::Sign::negative && left == exact::Sign::positive) return next(h);
    h = mesh_.next_around(h);
    right = left;
    if (h == start) break;
  }
  return mesh::kNoHalfEdge;
}

bool LocalEdges::collect_crossed(mesh::Vertex u, mesh::Vertex w) {
  crossed_.clear();
  mesh::HalfEdge h = first_crossed(u, w);
  if (h == mesh::kNoHalfEdge) return false;
  for (;;) {
    // The code tests the range first: another thread may be changing an edge between two vertices outside the range.
    if (!is_own(mesh_.origin(h)) || !is_own(mesh_.target(h)) || mesh_.is_fixed(h)) return false;
    if (crossed_.size() == kMostCrossed) return false;
    crossed_.push_back(h);
    const mesh::HalfEdge t = mesh_.twin(h);
    const mesh::Vertex apex = mesh_.apex(t);
    if (apex == w) return true;
    if (!is_own(apex)) return false;
    const exact::Sign sign = orientation(u, w, apex);
    if (sign == exact::Sign::zero) return false;
    h = sign == exact::Sign::positive ? next(t) : previous(t);
  }
}

}  // namespace waywright::delaunay

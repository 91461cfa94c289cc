#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "delaunay/legality.hpp"
#include "delaunay/segment_cavity.hpp"
#include "exact/sign.hpp"
#include "memory/count.hpp"
#include "mesh/index.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// Makes a segment between two vertices an edge of a triangulation. The faces that the segment crosses leave a cavity,
/// which this class fills with new faces. The object keeps its scratch between calls.
///
/// `Mesh` is mesh::TriangleMesh or mesh::UnloggedMesh.
template <class Geometry>
class CavityFiller {
 public:
  /// Makes u - w an edge with the label `label`, which is not 0, so the edge is fixed. Fills the cavity of the faces
  /// that u - w crosses with new faces. Returns the half-edge from u to w. All other faces stay as they are. `crossed`
  /// lists the edges that u - w crosses, in order from u to w. Each is a half-edge of the face that is nearer to u, so
  /// it runs from the right of u - w to its left. Requires: all crossed edges are free, and no vertex lies between u
  /// and w. Source: for the cavity, Anglada, *An improved incremental algorithm for constructing restricted Delaunay
  /// triangulations*, 1997.
  template <class Mesh>
  mesh::HalfEdge force_edge(const Geometry& geometry, Mesh& mesh, mesh::Vertex u, mesh::Vertex w,
                            const std::vector<mesh::HalfEdge>& crossed, mesh::Label label);

  void count_memory(MemoryUse& use) const {
    memory::count_spare(use, left_chain_, right_chain_, dangling_, cavity_, chain_vertices_, inner_edges_, triangles_,
                        bases_);
    segment_cavity_.count_memory(use);
  }
  void release() {
    memory::release(left_chain_, right_chain_, dangling_, cavity_, chain_vertices_, inner_edges_, triangles_, bases_);
    segment_cavity_.release();
  }

 private:
  static constexpr std::uint32_t kNotDangling = 0xffffffff;
  // The new edge divides the cavity into two polygons: one on its left, one on its right. The *chain* of a polygon is
  // its border without the new edge.
  static constexpr std::size_t kLargePolygon = 32;  ///< a polygon is large if its chain has more edges than this

  /// An edge in the chain of one of the two polygons. It runs from the vertex `from` to the vertex `from` of the next
  /// edge in the chain.
  struct ChainEdge {
    mesh::Vertex from;
    mesh::HalfEdge inner;  ///< its half-edge in the cavity: first in the old face, later in the new face
    mesh::HalfEdge outer;  ///< the twin of `inner`
    mesh::Label label;
    std::uint32_t partner = kNotDangling;  ///< if `outer` also lies in the cavity: the chain edge of `outer`
    bool is_rebuilt = false;
  };
  using Chain = std::vector<ChainEdge>;

  /// A vertex of a chain at which no ear has been cut off. An edge runs to it from the vertex before it. This edge is
  /// the chain edge `index`, or the half-edge `base` of a new triangle.
  struct ChainVertex {
    mesh::Vertex vertex;
    std::uint32_t index;
    mesh::HalfEdge base;  ///< kNoHalfEdge if the edge is a chain edge
  };

  template <class Mesh>
  void collect_chains(const Mesh& mesh, const std::vector<mesh::HalfEdge>& crossed);
  template <class Mesh>
  static void append_to(const Mesh& mesh, Chain& chain, mesh::HalfEdge inner);
  template <class Mesh>
  void pair_dangling_edges(const Mesh& mesh, Chain& chain);
  /// Cuts a polygon into triangles. The polygon lies left of the base, which runs from the chain's first vertex to its
  /// last one, `end`. Appends the edges between the triangles to `inner_edges_`. Returns the half-edge of the base.
  template <class Mesh>
  mesh::HalfEdge triangulate(const Geometry& geometry, Mesh& mesh, Chain& chain, mesh::Vertex end);
  /// Fills `triangles_` with the triangles of a large polygon. Returns false if SegmentCavity does not triangulate it.
  WAYWRIGHT_NO_INLINE bool find_triangles(const Geometry& geometry, const Chain& chain, mesh::Vertex end);
  /// Does the same as triangulate() for a large polygon. The triangles should then be Delaunay: legalise_cavity() tests
  /// this, and normally flips no edge. Returns kNoHalfEdge, and changes nothing, if SegmentCavity does not triangulate
  /// the polygon.
  template <class Mesh>
  mesh::HalfEdge triangulate_large(const Geometry& geometry, Mesh& mesh, Chain& chain, mesh::Vertex end);
  template <class Mesh>
  WAYWRIGHT_NO_INLINE mesh::HalfEdge cut_ear(Mesh& mesh, Chain& chain, mesh::Vertex a, const ChainVertex& b,
                                             const ChainVertex& r);
  template <class Mesh>
  bool legalise_cavity(const Geometry& geometry, Mesh& mesh);
  /// Links `inner`, the new half-edge of the chain edge `index`, to its twin. If the edge is dangling, waits
  /// until both of its half-edges are new.
  template <class Mesh>
  static void link_chain_edge(Mesh& mesh, Chain& chain, std::uint32_t index, mesh::HalfEdge inner);

  // Scratch.
  Chain left_chain_, right_chain_;
  std::vector<std::uint32_t> dangling_;
  std::vector<mesh::Face> cavity_;
  std::vector<ChainVertex> chain_vertices_;
  std::vector<mesh::HalfEdge> inner_edges_;  ///< the edges that cutting the ears has made, except u - w
  SegmentCavity<Geometry> segment_cavity_;
  std::vector<mesh::TriangleMesh::Triangle> triangles_;
  /// By chain edge, in triangulate_large(): of the new triangles whose base starts at the vertex `from` of this edge,
  /// the base of the last one.
  std::vector<mesh::HalfEdge> bases_;
};

//              left chain           The faces that the new edge u - w crosses leave a cavity. The new edge divides it
//         q ------ r ------ s       into two polygons, which are triangulated separately. If both faces of an edge on a
//       /   \    /   \    /   \     polygon's border lie in the cavity, the edge is dangling: the chain runs along it
//      u - - - - - - - - - - - w    in both directions, and the polygon is only weakly simple.
//       \   /    \   /    \   /
//         p ------ + ------ +
//              right chain
template <class Geometry>
template <class Mesh>
mesh::HalfEdge CavityFiller<Geometry>::force_edge(const Geometry& geometry, Mesh& mesh, mesh::Vertex u, mesh::Vertex w,
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
template <class Geometry>
template <class Mesh>
void CavityFiller<Geometry>::collect_chains(const Mesh& mesh, const std::vector<mesh::HalfEdge>& crossed) {
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

template <class Geometry>
template <class Mesh>
void CavityFiller<Geometry>::append_to(const Mesh& mesh, Chain& chain, mesh::HalfEdge inner) {
  ChainEdge edge{};
  edge.from = mesh.target(inner);
  edge.inner = inner;
  edge.outer = mesh.twin(inner);
  edge.label = mesh.label(inner);
  chain.push_back(edge);
}

// Both half-edges of a dangling edge lie in the same chain, because the new edge crosses every edge between the two
// chains.
template <class Geometry>
template <class Mesh>
void CavityFiller<Geometry>::pair_dangling_edges(const Mesh& mesh, Chain& chain) {
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
template <class Geometry>
template <class Mesh>
mesh::HalfEdge CavityFiller<Geometry>::triangulate(const Geometry& geometry, Mesh& mesh, Chain& chain,
                                                   mesh::Vertex end) {
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
template <class Geometry>
bool CavityFiller<Geometry>::find_triangles(const Geometry& geometry, const Chain& chain, mesh::Vertex end) {
  segment_cavity_.clear();
  const auto add = [&](mesh::Vertex v) { segment_cavity_.add(geometry.view(number(v)), geometry.rounded(number(v))); };
  add(end);
  for (auto edge = chain.rbegin(); edge != chain.rend(); ++edge) add(edge->from);
  return segment_cavity_.triangulate(geometry, triangles_);
}

// SegmentCavity numbers the vertices counter-clockwise, and the chain lists them clockwise. Each triangle of the list
// comes after the triangle on whose edge it lies. So the function makes them in the reverse order.
template <class Geometry>
template <class Mesh>
mesh::HalfEdge CavityFiller<Geometry>::triangulate_large(const Geometry& geometry, Mesh& mesh, Chain& chain,
                                                         mesh::Vertex end) {
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
template <class Geometry>
template <class Mesh>
mesh::HalfEdge CavityFiller<Geometry>::cut_ear(Mesh& mesh, Chain& chain, mesh::Vertex a, const ChainVertex& b,
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
template <class Geometry>
template <class Mesh>
bool CavityFiller<Geometry>::legalise_cavity(const Geometry& geometry, Mesh& mesh) {
  while (!inner_edges_.empty() && is_legal(geometry, mesh, inner_edges_.back())) inner_edges_.pop_back();
  if (inner_edges_.empty()) return false;
  legalise(geometry, mesh, inner_edges_);
  return true;
}

template <class Geometry>
template <class Mesh>
void CavityFiller<Geometry>::link_chain_edge(Mesh& mesh, Chain& chain, std::uint32_t index, mesh::HalfEdge inner) {
  ChainEdge& edge = chain[index];
  edge.inner = inner;
  edge.is_rebuilt = true;
  if (edge.partner == kNotDangling) {
    mesh.link(inner, edge.outer, edge.label);
  } else if (chain[edge.partner].is_rebuilt) {
    mesh.link(inner, chain[edge.partner].inner, edge.label);
  }
}

}  // namespace waywright::delaunay

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/cavity_filler.hpp"
#include "exact/sign.hpp"
#include "mesh/index.hpp"
#include "mesh/unlogged_mesh.hpp"

namespace waywright::delaunay {

/// Makes fixed (constrained) edges between vertices of one range, [begin, end), without an undo log. Several threads
/// can do this in one triangulation at once, each with a range and an object of its own: see mesh::UnloggedMesh.
template <class Geometry>
class LocalEdges {
 public:
  LocalEdges(const Geometry& geometry, mesh::TriangleMesh& mesh, mesh::Vertex ghost, mesh::Vertex begin,
             mesh::Vertex end)
      : geometry_(geometry), mesh_(mesh), ghost_(ghost), begin_(number(begin)), end_(number(end)) {}

  /// Makes u - w an edge with this label, if it is a free edge, or if it crosses only free edges and all vertices of
  /// the faces that it crosses are in the range. Returns whether it has made the edge. It makes no edge if u - w meets
  /// a vertex, a fixed edge or very many edges, or if it starts at a vertex with very many edges: the caller must then
  /// insert the segment with another function.
  bool force_edge(mesh::Vertex u, mesh::Vertex w, mesh::Label label) {
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

 private:
  static constexpr std::size_t kMostEdges = 256;    ///< first_crossed() looks at no more edges of a vertex than this
  static constexpr std::size_t kMostCrossed = 256;  ///< a segment that crosses more edges needs another function

  [[nodiscard]] bool is_own(mesh::Vertex v) const { return begin_ <= number(v) && number(v) < end_; }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex u, mesh::Vertex w, mesh::Vertex v) const {
    return geometry_.orientation(geometry_.view(number(u)), geometry_.view(number(w)), geometry_.view(number(v)));
  }

  /// The first edge that u - w crosses, from the right of u - w to its left. Returns kNoHalfEdge if another vertex lies
  /// on the segment beside u, or if u has very many edges.
  [[nodiscard]] mesh::HalfEdge first_crossed(mesh::Vertex u, mesh::Vertex w) const {
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

  /// Fills `crossed_` with the edges that u - w crosses. Returns false if force_edge() makes no edge for u - w.
  bool collect_crossed(mesh::Vertex u, mesh::Vertex w) {
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

  const Geometry& geometry_;
  mesh::UnloggedMesh mesh_;
  mesh::Vertex ghost_;
  std::uint32_t begin_, end_;
  CavityFiller<Geometry> filler_;
  std::vector<mesh::HalfEdge> crossed_;
};

}  // namespace waywright::delaunay

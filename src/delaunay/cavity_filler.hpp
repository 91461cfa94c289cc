#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "delaunay/legality.hpp"
#include "delaunay/polygon_triangles.hpp"
#include "exact/position.hpp"
#include "memory/count.hpp"
#include "mesh/index.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// Makes a segment between two vertices an edge of a triangulation. The faces that the segment crosses leave a cavity,
/// which this class fills with new faces. The object keeps its scratch between calls.
///
/// `Mesh` is mesh::TriangleMesh or mesh::UnloggedMesh.
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
  SegmentCavity segment_cavity_;
  std::vector<mesh::TriangleMesh::Triangle> triangles_;
  /// By chain edge, in triangulate_large(): of the new triangles whose base starts at the vertex `from` of this edge,
  /// the base of the last one.
  std::vector<mesh::HalfEdge> bases_;
};

/// Makes fixed (constrained) edges between vertices of one range, [begin, end), without an undo log. Several threads
/// can do this in one triangulation at once, each with a range and an object of its own: see mesh::UnloggedMesh.
class LocalEdges {
 public:
  LocalEdges(const Geometry& geometry, mesh::TriangleMesh& mesh, mesh::Vertex ghost, mesh::Vertex begin,
             mesh::Vertex end)
      : geometry_(geometry), mesh_(mesh), ghost_(ghost), begin_(number(begin)), end_(number(end)) {}

  /// Makes u - w an edge with this label, if it is a free edge, or if it crosses only free edges and all vertices of
  /// the faces that it crosses are in the range. Returns whether it has made the edge. It makes no edge if u - w meets
  /// a vertex, a fixed edge or very many edges, or if it starts at a vertex with very many edges: the caller must then
  /// insert the segment with another function.
  bool force_edge(mesh::Vertex u, mesh::Vertex w, mesh::Label label);

 private:
  static constexpr std::size_t kMostEdges = 256;    ///< first_crossed() looks at no more edges of a vertex than this
  static constexpr std::size_t kMostCrossed = 256;  ///< a segment that crosses more edges needs another function

  [[nodiscard]] bool is_own(mesh::Vertex v) const { return begin_ <= number(v) && number(v) < end_; }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex u, mesh::Vertex w, mesh::Vertex v) const {
    return geometry_.orientation(geometry_.view(number(u)), geometry_.view(number(w)), geometry_.view(number(v)));
  }

  /// The first edge that u - w crosses, from the right of u - w to its left. Returns kNoHalfEdge if another vertex lies
  /// on the segment beside u, or if u has very many edges.
  [[nodiscard]] mesh::HalfEdge first_crossed(mesh::Vertex u, mesh::Vertex w) const;
  /// Fills `crossed_` with the edges that u - w crosses. Returns false if force_edge() makes no edge for u - w.
  bool collect_crossed(mesh::Vertex u, mesh::Vertex w);

  const Geometry& geometry_;
  mesh::UnloggedMesh mesh_;
  mesh::Vertex ghost_;
  std::uint32_t begin_, end_;
  CavityFiller filler_;
  std::vector<mesh::HalfEdge> crossed_;
};

}  // namespace waywright::delaunay

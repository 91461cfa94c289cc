#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "delaunay/cavity_filler.hpp"
#include "delaunay/geometry.hpp"
#include "delaunay/legality.hpp"
#include "delaunay/polygon_triangles.hpp"
#include "locate/curve.hpp"
#include "locate/sectors.hpp"
#include "locate/walk.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// A constrained Delaunay triangulation of a closed box, the domain. Fixed edges stay, and every other edge has the
/// empty-circle property. If four vertices are cocircular, the edge between them is the diagonal that contains the
/// first of the four in (x, y) order. This rule is the limit of a perturbation that lowers every point on the lifting
/// paraboloid by an infinitesimal, the first point by far the most. So the vertices and the fixed edges determine
/// exactly one triangulation.
class Triangulation {
 public:
  using View = Geometry::View;

  /// Makes the triangulation of the domain `box`: two triangles. The four edges on its border (bottom, right, top,
  /// left) are fixed with these labels.
  Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels)
      : Triangulation(box, side_labels, locate::sort_along_curve(box, corners_of(box))) {}
  /// Makes the triangulation of the domain `box` with a vertex at each point of `sorted`, all at once. The team runs
  /// `jobs` at the same time. The first four points before the sort were the corners of the domain, in the order of
  /// corners_of(). The constructor takes the points and keys out of `sorted` and leaves the ranks. Source: see
  /// DivideAndConquer.
  Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels, locate::SortedPoints&& sorted,
                const threads::ThreadTeam& team = {}, std::span<const threads::Job> jobs = {});

  /// The corners of the domain `box` as points, counter-clockwise from the first in (x, y) order.
  [[nodiscard]] static std::array<Point, 4> corners_of(const Box& box) {
    return {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
  }
  /// The vertex of the sorted point of this rank.
  [[nodiscard]] static mesh::Vertex vertex_of_rank(std::uint32_t rank) { return mesh::Vertex{rank + 1}; }

  [[nodiscard]] const mesh::TriangleMesh& topology() const { return mesh_; }
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  /// The ghost vertex, which is connected to every vertex on the border of the domain.
  [[nodiscard]] mesh::Vertex ghost() const { return ghost_; }
  /// Whether the half-edge's face is a ghost face, which lies outside the domain.
  [[nodiscard]] bool is_ghost_face(mesh::HalfEdge h) const {
    return mesh_.origin(h) == ghost_ || mesh_.target(h) == ghost_ || mesh_.apex(h) == ghost_;
  }
  /// Whether the face is live and lies in the domain.
  [[nodiscard]] bool is_in_domain(mesh::Face f) const { return mesh_.is_live(f) && !is_ghost_face(mesh::first(f)); }
  /// The corners of the domain as vertices, counter-clockwise from the first in (x, y) order.
  [[nodiscard]] const std::array<mesh::Vertex, 4>& domain_corners() const { return domain_corners_; }

  [[nodiscard]] View view(mesh::Vertex v) const { return geometry_.view(number(v)); }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex a, mesh::Vertex b, mesh::Vertex c) const {
    return geometry_.orientation(view(a), view(b), view(c));
  }
  [[nodiscard]] bool comes_before(mesh::Vertex p, mesh::Vertex q) const {
    return geometry_.order(view(p), view(q)) < 0;
  }

  /// The location of `point`. The second function starts its walk at the face of `start`. Requires: `point` and the
  /// face of `start` lie in the domain.
  [[nodiscard]] locate::Located locate(const Point& point) const;
  [[nodiscard]] locate::Located locate(const Point& point, mesh::HalfEdge start) const;

  /// Starts an operation: roll_back() returns to this state.
  void begin();
  /// Undoes all changes since begin(). Allocates nothing.
  void roll_back();

  /// The result of insert(): the vertex at the point.
  struct Inserted {
    mesh::Vertex vertex;
    bool is_new;
    mesh::HalfEdge split;          ///< if a fixed edge was split: one of its halves, from the vertex; else kNoHalfEdge
    std::size_t tested_edges = 0;  ///< how many edges the insertion has tested
  };
  /// Makes a vertex at `point`, if there is none yet. A new vertex on a fixed edge splits this edge into two that have
  /// the same label. Source: Chen 2009, sections 3.2.2 and 3.2.3.
  Inserted insert(const Point& point);
  /// Does the same as insert(point). `location` is the location of the point.
  Inserted insert(const Point& point, const locate::Located& location);

  /// Splits the fixed edge of `h` at its crossing with the line through `a` and `b`. The fixed edge lies on the line
  /// through `c` and `d`. Returns the new vertex. Requires: `a`, `b`, `c` and `d` are explicit.
  mesh::Vertex insert_crossing(mesh::HalfEdge h, mesh::Vertex a, mesh::Vertex b, mesh::Vertex c, mesh::Vertex d);

  /// Sets the label of the edge of `h`, which makes the edge fixed.
  void fix(mesh::HalfEdge h, mesh::Label label) { mesh_.set_label(h, label); }

  /// Makes the edge of `h` free. The edge may be illegal until legalise_unfixed() has run.
  void unfix_edge(mesh::HalfEdge h);
  /// Flips freed edges, and edges that these flips make illegal, until every free edge is legal again.
  void legalise_unfixed();

  /// The surroundings of a vertex: the half-edges that start there, counter-clockwise, and the indices of those that
  /// are fixed.
  struct Star {
    std::vector<mesh::HalfEdge> spokes;
    std::vector<std::uint32_t> fixed;
  };
  /// The star of `v`. If the vertex has many edges and more than two of them are fixed, the star can be incomplete: it
  /// then has more than two fixed spokes. The result is valid until the next call.
  [[nodiscard]] const Star& star(mesh::Vertex v);
  /// Removes the vertex of a star. The vertex has no fixed edges, or two that lie on one line. Two fixed edges become
  /// one edge with the label of the first. Returns this edge, or kNoHalfEdge if there were no fixed edges. Requires:
  /// the triangulation is Delaunay, the star has not changed, and its vertex is no corner of the domain. Source: Chen
  /// 2009, section 3.4, algorithm 17; for the cavity, Devillers 2011.
  mesh::HalfEdge remove_vertex(const Star& star);
  /// Prefetches the position of `v` and the index of one of its half-edges.
  // Always inlined: GCC otherwise removes the call of a function that only prefetches.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Vertex v) const {
    mesh_.prefetch(v);
    geometry_.prefetch(number(v));
  }
  /// Prefetches the faces that were made together with `v`. It is likely that some of them are still in its star.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_faces_made_with(mesh::Vertex v) const {
    const std::uint32_t end = 2 * number(v);  // the mesh had 2 v - 4 faces before v, if no vertex was ever removed
    if (end < 4 || end > mesh_.face_slots()) return;
    for (std::uint32_t f = end - 4; f < end; ++f) mesh_.prefetch(mesh::first(mesh::Face{f}));
  }
  /// Prefetches what a removal of `v` reads first: the face where star(v) begins, and the sector.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_star(mesh::Vertex v) const {
    mesh_.prefetch(mesh_.outgoing(v));
    sectors_.prefetch(geometry_.rounded(number(v)));
  }

  /// Prefetches the memory that says where a walk to a point starts. The next function returns the vertex at which the
  /// walk probably starts, or kNoVertex.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_start(const Point& point) const { sectors_.prefetch(point); }
  [[nodiscard]] mesh::Vertex probable_start(const Point& point) const {
    const mesh::Vertex v = sectors_.near(sectors_.at(point));
    return v != mesh::kNoVertex && number(v) < mesh_.vertex_slots() ? v : mesh::kNoVertex;
  }

  /// Makes u - w an edge with `label`: see CavityFiller::force_edge().
  mesh::HalfEdge force_edge(mesh::Vertex u, mesh::Vertex w, const std::vector<mesh::HalfEdge>& crossed,
                            mesh::Label label);

  /// Several threads can make fixed edges at once, each with a range of vertices of its own: see LocalEdges. Requires:
  /// make_room_for_labels() has been called, and nobody will call roll_back() before the next begin().
  [[nodiscard]] LocalEdges local_edges(mesh::Vertex begin, mesh::Vertex end) {
    return LocalEdges(geometry_, mesh_, ghost_, begin, end);
  }
  void make_room_for_labels() { mesh_.make_room_for_labels(); }

  /// Whether the edge of `h` has the empty-circle property for its two faces. Requires: the edge is free and lies
  /// inside the domain.
  [[nodiscard]] bool is_legal(mesh::HalfEdge h) const { return delaunay::is_legal(geometry_, mesh_, h); }

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  using Triangle = mesh::TriangleMesh::Triangle;

  static constexpr std::size_t kLongWalk = 16;     ///< after a walk with more steps, an insertion divides a sector
  static constexpr std::size_t kLargeCavity = 32;  ///< a cavity is large if its border has more edges than this
  static constexpr std::size_t kManySpokes = 16;   ///< after this number of spokes, star() looks for a crossing

  mesh::Vertex add_vertex(const Point& point);
  void fix_border(const std::array<mesh::Label, 4>& side_labels);
  /// Prefetches the face beyond an edge. The second function prefetches the position of the apex of this face. Call the
  /// second function some time after the first, when the face is in the cache.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_face_beyond(mesh::HalfEdge h) const { mesh_.prefetch(mesh_.twin(h)); }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_apex_beyond(mesh::HalfEdge h) const {
    geometry_.prefetch(number(mesh_.apex(mesh_.twin(h))));
  }
  /// Flips edges until every edge opposite to a new vertex is legal. `in_doubt_` lists the edges to test; the new
  /// vertex is their apex.
  void legalise_around_apex();
  void remember(mesh::HalfEdge h);
  [[nodiscard]] mesh::HalfEdge hint(const Point& point) const;
  void divide_sector(const Point& point);
  [[nodiscard]] mesh::HalfEdge twin_in_domain(mesh::HalfEdge h) const;

  [[nodiscard]] bool has_crossing(const std::vector<mesh::HalfEdge>& spokes) const;
  mesh::HalfEdge remove_free_vertex(const Star& star);
  mesh::HalfEdge remove_vertex_on_line(const Star& star);
  void collect_cavity(const Star& star, std::size_t from, std::size_t to);
  mesh::HalfEdge refill_cavity();
  [[nodiscard]] Triangle triangle_over(std::uint32_t from, std::uint32_t to) const;
  void free_vertex(mesh::Vertex v, mesh::HalfEdge near);

  mesh::TriangleMesh mesh_;
  Geometry geometry_;
  locate::Sectors sectors_;
  mesh::Vertex ghost_{};
  std::array<mesh::Vertex, 4> domain_corners_{};
  mesh::HalfEdge recent_{};         ///< a half-edge of a face in the domain, near the last change
  mesh::HalfEdge recent_before_{};  ///< the value of `recent_` at the last begin()

  // Scratch.
  std::vector<mesh::HalfEdge> in_doubt_;
  std::vector<mesh::HalfEdge> unfixed_;
  Star star_;
  std::vector<mesh::HalfEdge> clockwise_;
  std::vector<mesh::HalfEdge> cavity_edges_;
  std::vector<View> cavity_positions_;
  std::vector<Triangle> triangles_;
  LargeCavity large_cavity_;
  CavityFiller cavity_filler_;
};

}  // namespace waywright::delaunay

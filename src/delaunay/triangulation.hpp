#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "exact/any_geometry.hpp"
#include "locate/curve.hpp"
#include "locate/sectors.hpp"
#include "locate/walk.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// A constrained Delaunay triangulation of a box: vertices come, fixed edges hold, and every other edge has the
/// empty-circle property. Of four cocircular points the edge is the diagonal through the first of the four in (x, y)
/// order; this is the limit of lowering every point lifted to the paraboloid by an infinitesimal, the first point by
/// far the most, so that vertices and fixed edges leave exactly one triangulation.
///
/// All numbers are Geometry's business: an exact::AnyGeometry; the library uses exact::Geometry.
template <class Geometry>
class Triangulation {
  static_assert(exact::AnyGeometry<Geometry>);

 public:
  using View = typename Geometry::View;

  /// The box cut in two, its sides (bottom, right, top, left) fixed under those labels.
  Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels)
      : Triangulation(box, side_labels, locate::sort_along_curve(box, corners_of(box))) {}
  /// The same with a vertex at each of `sorted`, made all at once. The first four points given to sort were the box's
  /// corners, as corners_of() lists them; its ranks are left alone. Does `jobs` meanwhile. Source: see
  /// DivideAndConquer.
  Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels, locate::SortedPoints&& sorted,
                const threads::Crew& crew = {}, std::span<const threads::Job> jobs = {});

  /// The box's corners, counter-clockwise from its smallest.
  [[nodiscard]] static std::array<Point, 4> corners_of(const Box& box) {
    return {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
  }
  /// The vertex of the sorted point of that rank.
  [[nodiscard]] static mesh::Vertex vertex_of_rank(std::uint32_t rank) { return mesh::Vertex{rank + 1}; }

  [[nodiscard]] const mesh::TriangleMesh& topology() const { return mesh_; }
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  /// The vertex beyond the box, joined to every vertex on its sides.
  [[nodiscard]] mesh::Vertex ghost() const { return ghost_; }
  /// Whether the half-edge's face lies beyond the box.
  [[nodiscard]] bool is_ghost_face(mesh::HalfEdge h) const {
    return mesh_.origin(h) == ghost_ || mesh_.target(h) == ghost_ || mesh_.apex(h) == ghost_;
  }
  /// Whether there is such a face, and it lies in the box.
  [[nodiscard]] bool is_in_box(mesh::Face f) const { return mesh_.is_alive(f) && !is_ghost_face(mesh::first(f)); }
  /// The box's corners, counter-clockwise from its smallest.
  [[nodiscard]] const std::array<mesh::Vertex, 4>& box_corners() const { return box_corners_; }

  [[nodiscard]] View view(mesh::Vertex v) const { return geometry_.view(number(v)); }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex a, mesh::Vertex b, mesh::Vertex c) const {
    return geometry_.orientation(view(a), view(b), view(c));
  }
  [[nodiscard]] bool comes_before(mesh::Vertex p, mesh::Vertex q) const {
    return geometry_.order(view(p), view(q)) < 0;
  }

  /// Where `point`, which lies in the box, is. The second walks from the face of `start`, which is in the box.
  [[nodiscard]] locate::Located locate(const Point& point) const;
  [[nodiscard]] locate::Located locate(const Point& point, mesh::HalfEdge start) const;

  /// Starts an operation: what follows can be taken back to here.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  /// The vertex at `point`, made where there is none yet. On a fixed edge it parts the edge in two that carry its
  /// label. Source: Chen 2009, sections 3.2.2 and 3.2.3.
  struct Inserted {
    mesh::Vertex vertex;
    bool is_new;
    mesh::HalfEdge split;  ///< where a fixed edge was parted: one of its halves, from the vertex; else kNoHalfEdge
  };
  Inserted insert(const Point& point);
  /// The same where it is known already where the point lies.
  Inserted insert(const Point& point, const locate::Located& place);

  /// Parts the fixed edge of `h` at its crossing with the line through `a` and `b`, explicit vertices; the edge lies on
  /// the line through `c` and `d`, explicit too. Returns the new vertex.
  mesh::Vertex insert_crossing(mesh::HalfEdge h, mesh::Vertex a, mesh::Vertex b, mesh::Vertex c, mesh::Vertex d);

  /// Labels the edge of `h`, which holds it fixed.
  void fix(mesh::HalfEdge h, mesh::Label label) { mesh_.set_label(h, label); }

  /// Frees the edge of `h`. Until legalise_freed has run, it need not be Delaunay.
  void free_edge(mesh::HalfEdge h);
  /// Flips freed edges, and what follows from that, until every free edge is legal again.
  void legalise_freed();

  /// What there is around a vertex: the half-edges that start there, counter-clockwise, and the positions among them of
  /// those that are fixed.
  struct Star {
    std::vector<mesh::HalfEdge> spokes;
    std::vector<std::uint32_t> fixed;
  };
  /// The star of `v`, until the next is asked for.
  [[nodiscard]] const Star& star(mesh::Vertex v);
  /// Takes the vertex of a star out: one without fixed edges, or one with two that lie on one line; these then are one
  /// edge, under the first's label. Requires: the triangulation is Delaunay, the star has not changed, its vertex is no
  /// corner of the box. Returns the joined edge, or kNoHalfEdge. Source: Chen 2009, section 3.4, algorithm 17; the
  /// hole, Devillers 2011.
  mesh::HalfEdge remove_vertex(const Star& star);
  /// Has the memory fetched that tells where `v` and its star are, and the faces that were made with it, some of which
  /// are likely to be in the star still; and then what a removal looks at first there: where star(v) begins, and the
  /// sector.
  // GCC drops the call of a function that does nothing but fetch, unless it has inlined it before it knows.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Vertex v) const {
    mesh_.prefetch(v);
    if constexpr (requires { geometry_.prefetch(number(v)); }) geometry_.prefetch(number(v));
  }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_faces_made_with(mesh::Vertex v) const {
    const std::uint32_t end = 2 * number(v);  // so many vertices have 4 faces less, as long as none goes
    if (end < 4 || end > mesh_.face_slots()) return;
    for (std::uint32_t f = end - 4; f < end; ++f) mesh_.prefetch(mesh::first(mesh::Face{f}));
  }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_star(mesh::Vertex v) const {
    mesh_.prefetch(mesh_.outgoing(v));
    sectors_.prefetch(geometry_.nearest(number(v)));
  }

  /// Makes u - w an edge by retriangulating what it crosses, and fixes it under `label`. `crossed` lists the edges
  /// between them in order from u to w, each half-edge in the face on u's side (so that it crosses from the right of
  /// the way to its left); all are free, and no vertex lies between u and w. Returns the half-edge from u to w. Faces
  /// beyond what is crossed stay as they are. Source: the cavity, Anglada, *An improved incremental algorithm for
  /// constructing restricted Delaunay triangulations*, 1997; see force_edge.hpp for how it is filled.
  mesh::HalfEdge force_edge(mesh::Vertex u, mesh::Vertex w, const std::vector<mesh::HalfEdge>& crossed,
                            mesh::Label label);

  /// Whether the edge of `h`, free and inside the box, has the empty-circle property against its two neighbours.
  [[nodiscard]] bool is_legal(mesh::HalfEdge h) const;

  void count_memory(MemoryUse& use) const;
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  using Triangle = mesh::TriangleMesh::Triangle;

  static constexpr std::size_t kLongWalk = 16;
  static constexpr std::uint32_t kNotDangling = 0xffffffff;

  /// An edge of a cavity's border, from `from` towards the next chain edge's.
  struct ChainEdge {
    mesh::Vertex from;
    mesh::HalfEdge inner;  ///< its half-edge in the cavity: of a face about to be freed; later, of the one rebuilt
    mesh::HalfEdge outer;  ///< the twin of that
    mesh::Label label;
    std::uint32_t partner = kNotDangling;  ///< where `outer` lies in the cavity too: the chain edge that it belongs to
    bool is_rebuilt = false;
  };
  using Chain = std::vector<ChainEdge>;

  /// A vertex of a chain whose ear hasn't been cut, and how it is joined to the one before it: by the chain edge at
  /// `position`, or by a triangle's half-edge that runs from there to here.
  struct ChainCorner {
    mesh::Vertex vertex;
    std::uint32_t position;
    mesh::HalfEdge base;  ///< kNoHalfEdge: by the chain edge
  };

  void place_all(std::vector<Point>&& points);
  mesh::Vertex add_vertex(const Point& point);
  void fix_border(const std::array<mesh::Label, 4>& side_labels);
  /// Has what lies beyond an edge fetched from memory: its face; once that is there, the place of its apex.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_face_beyond(mesh::HalfEdge h) const { mesh_.prefetch(mesh_.twin(h)); }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_apex_beyond(mesh::HalfEdge h) const {
    if constexpr (requires { geometry_.prefetch(number(h)); }) geometry_.prefetch(number(mesh_.apex(mesh_.twin(h))));
  }
  /// Flips until every edge opposite to a new vertex is legal; `in_doubt_` lists those to be asked, the vertex their
  /// apex.
  void legalise_around_apex();
  [[nodiscard]] bool is_legal(mesh::HalfEdge h, const View& apex) const;
  /// Not inlined, so that is_legal, which few such ties come to, keeps what it looks at in registers.
  [[nodiscard, gnu::noinline]] bool is_legal_on_circle(mesh::HalfEdge h) const;
  void remember(mesh::HalfEdge h);
  [[nodiscard]] mesh::HalfEdge hint(const Point& point) const;
  void divide_sector(const Point& point);
  [[nodiscard]] mesh::HalfEdge inner_side(mesh::HalfEdge h) const;

  mesh::HalfEdge remove_free_vertex(const Star& star);
  mesh::HalfEdge remove_vertex_on_line(const Star& star);
  void collect_hole(const Star& star, std::size_t from, std::size_t to);
  mesh::HalfEdge refill_hole();
  [[nodiscard]] Triangle triangle_over(std::uint32_t from, std::uint32_t to) const;
  void forget(mesh::Vertex v, mesh::HalfEdge near);

  void collect_chains(const std::vector<mesh::HalfEdge>& crossed);
  void append_to(Chain& chain, mesh::HalfEdge inner);
  void pair_dangling_edges(Chain& chain);
  /// Cuts the polygon on the left of the way from the chain's first vertex to its last, `end`, into triangles, the
  /// edges between which go to `freed_`. Returns the half-edge of that way.
  mesh::HalfEdge triangulate(Chain& chain, mesh::Vertex end);
  mesh::HalfEdge cut_ear(Chain& chain, mesh::Vertex a, const ChainCorner& b, const ChainCorner& r);
  bool legalise_cavity();
  void close(Chain& chain, std::uint32_t position, mesh::HalfEdge inner);

  mesh::TriangleMesh mesh_;
  Geometry geometry_;
  locate::Sectors sectors_;
  mesh::Vertex ghost_{};
  std::array<mesh::Vertex, 4> box_corners_{};
  mesh::HalfEdge recent_{};  ///< a living half-edge of a face in the box, near the last change
  mesh::HalfEdge recent_before_{};

  // Scratch, kept for its memory.
  std::vector<mesh::HalfEdge> in_doubt_;
  std::vector<mesh::HalfEdge> freed_;
  Star star_;
  std::vector<mesh::HalfEdge> clockwise_;
  std::vector<mesh::HalfEdge> hole_sides_;
  std::vector<View> hole_places_;
  std::vector<Triangle> triangles_;
  Chain left_chain_, right_chain_;
  std::vector<std::uint32_t> dangling_;
  std::vector<mesh::Face> cavity_;
  std::vector<ChainCorner> corners_;
};

}  // namespace waywright::delaunay

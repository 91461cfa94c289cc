#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "delaunay/legality.hpp"
#include "exact/position.hpp"
#include "locate/curve.hpp"
#include "mesh/index.hpp"
#include "mesh/triangle_mesh.hpp"
#include "threads/thread_team.hpp"

namespace waywright::delaunay {

/// Computes the Delaunay triangulation of a set of points, with a ghost vertex beyond their convex hull. Axis-parallel
/// lines divide the points recursively into ranges of at most three points. The class triangulates each range. Then, at
/// each line, it merges the two pieces to the left and to the right of the line (or below and above it).
///
/// The triangulation of any m points and the ghost vertex is a sphere of 2 m - 2 faces. So the points [i, j) use the
/// faces from 2 i to 2 j - 3, and a merge at k adds the faces 2 k - 2 and 2 k - 1. The algorithm moves no face and
/// allocates no face.
///
/// Source: Guibas and Stolfi, *Primitives for the manipulation of general subdivisions*, 1985; cuts in both directions:
/// Dwyer, *A faster divide-and-conquer algorithm for constructing Delaunay triangulations*, 1987; ghost faces that
/// become the new faces: Shewchuk, *Triangle*, 1996. There are two differences from these papers. The code cuts the
/// points where the curve divides a square, so it need not search for medians. And it breaks ties (circle_contains()),
/// so the result is unique.
class DivideAndConquer {
 public:
  using HalfEdgeRecord = mesh::TriangleMesh::HalfEdgeRecord;
  using Key = locate::Curve::Key;

  /// The class passes only points to the predicates of `geometry`, never vertices. `points` are distinct and sorted by
  /// their `keys`; points with the same key are in (x, y) order. Point i becomes vertex i + 1. The ghost is vertex 0.
  /// `half_edges` has room for 6 (points.size() - 1) half-edges.
  DivideAndConquer(const Geometry& geometry, std::span<const Point> points, std::span<const Key> keys,
                   std::span<HalfEdgeRecord> half_edges)
      : geometry_(geometry), points_(points), keys_(keys), half_edges_(half_edges) {}

  /// Triangulates all points, and does `jobs` at the same time. Reports how many points are in finished pieces.
  /// Requires: there are at least two points.
  void run(const threads::ThreadTeam& team, std::span<const threads::Job> jobs);

  static constexpr mesh::Vertex kGhost{0};

 private:
  using HalfEdge = mesh::HalfEdge;
  using Vertex = mesh::Vertex;
  using Sign = exact::Sign;
  /// A triangulated range of points. Each edge of its convex hull has a ghost face. The half-edge of this face that is
  /// opposite to the ghost represents the hull edge: it runs clockwise around the piece.
  struct Piece {
    Vertex any{};                       ///< a vertex of the piece
    HalfEdge hull = mesh::kNoHalfEdge;  ///< a hull edge, if the piece has more than one vertex
  };
  /// Whether a cut divides points by x or by y.
  enum class Cut : std::uint8_t { x, y };

  // The state of a merge before its first step and between two steps. `l`, in the left piece, and `r`, in the right
  // piece, are the ends of the uppermost edge between the pieces so far. `base` is the half-edge of this edge from r to
  // l; the face of its twin is still missing. `left` is the hull edge of the left piece that ends at l, and `right` is
  // the hull edge of the right piece that starts at r. If a piece is a single vertex, it has no hull edge. `left_open`
  // and `right_open` are the half-edges between l or r and the ghost above the base; they have no twin yet.
  struct MergeState {
    Vertex l, r;
    HalfEdge base;
    HalfEdge left, right;
    HalfEdge left_open, right_open;
  };

  static constexpr std::size_t kTasksPerThread = 8;
  static constexpr std::uint32_t kSmallestTask = 1024;
  static constexpr std::size_t kLargestTask = 65536;

  [[nodiscard]] const Point& point(Vertex v) const { return points_[number(v) - 1]; }
  [[nodiscard]] Geometry::View view(Vertex v) const { return geometry_.view(point(v)); }
  [[nodiscard]] Sign orientation(Vertex a, Vertex b, Vertex c) const {
    return geometry_.orientation(view(a), view(b), view(c));
  }
  [[nodiscard]] bool circle_contains(Vertex a, Vertex b, Vertex c, Vertex d) const {
    return delaunay::circle_contains(geometry_, view(a), view(b), view(c), view(d));
  }
  [[nodiscard]] bool comes_before(Vertex p, Vertex q, Cut cut) const {
    const Point& a = point(p);
    const Point& b = point(q);
    if (cut == Cut::x) return a.x < b.x || (a.x == b.x && a.y < b.y);
    return a.y < b.y || (a.y == b.y && a.x > b.x);
  }

  [[nodiscard]] HalfEdge twin(HalfEdge h) const { return HalfEdge{half_edges_[number(h)].twin}; }
  [[nodiscard]] Vertex origin(HalfEdge h) const { return half_edges_[number(h)].origin; }
  [[nodiscard]] Vertex target(HalfEdge h) const { return origin(next(h)); }
  void set_origin(HalfEdge h, Vertex v) { half_edges_[number(h)].origin = v; }
  void link(HalfEdge g, HalfEdge h) {
    half_edges_[number(g)].twin = number(h);
    half_edges_[number(h)].twin = number(g);
  }
  HalfEdge make_face(std::uint32_t f, Vertex a, Vertex b, Vertex c) {
    half_edges_[3 * std::size_t{f}].origin = a;
    half_edges_[3 * std::size_t{f} + 1].origin = b;
    half_edges_[3 * std::size_t{f} + 2].origin = c;
    return HalfEdge{3 * f};
  }
  /// The hull edge after `hull`, and the hull edge before it (second function), counter-clockwise around the piece.
  [[nodiscard]] HalfEdge hull_next(HalfEdge hull) const { return previous(twin(previous(hull))); }
  [[nodiscard]] HalfEdge hull_previous(HalfEdge hull) const { return next(twin(next(hull))); }

  /// A range of points that one thread triangulates, and the result.
  struct Task {
    std::uint32_t begin, end;
    Piece piece;
  };
  void list_tasks(std::uint32_t begin, std::uint32_t end, std::uint32_t most);
  Piece merge_tasks(std::uint32_t begin, std::uint32_t end, std::size_t& next_task);

  struct Split {
    std::uint32_t middle;
    Cut cut;
  };
  [[nodiscard]] Split split(std::uint32_t begin, std::uint32_t end) const;
  Piece triangulate(std::uint32_t begin, std::uint32_t end);
  Piece make_edge(std::uint32_t begin);
  Piece make_three(std::uint32_t begin);
  Piece make_triangle(std::uint32_t f, Vertex a, Vertex b, Vertex c);
  Piece make_chain(std::uint32_t f, Vertex a, Vertex b, Vertex c);

  Piece merge(const Piece& left, const Piece& right, std::uint32_t f, Cut cut);
  [[nodiscard]] HalfEdge find_last(HalfEdge hull, Cut cut) const;
  [[nodiscard]] HalfEdge find_first(HalfEdge hull, Cut cut) const;
  [[nodiscard]] MergeState lower_tangent(const Piece& left, const Piece& right, Cut cut) const;
  void make_lower_ghost(MergeState& state, std::uint32_t f);
  void remove_left_edges(MergeState& state, Vertex& candidate);
  void remove_right_edges(MergeState& state, Vertex& candidate);
  void join_left(MergeState& state, Vertex candidate);
  void join_right(MergeState& state, Vertex candidate);

  const Geometry& geometry_;
  std::span<const Point> points_;
  std::span<const Key> keys_;
  std::span<HalfEdgeRecord> half_edges_;
  std::vector<Task> tasks_;
};

}  // namespace waywright::delaunay

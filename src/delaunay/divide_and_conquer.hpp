#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "delaunay/tie_rule.hpp"
#include "exact/sign.hpp"
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
/// points where the curve divides a square, so it need not search for medians. And it breaks ties (tie_rule.hpp), so
/// the result is unique.
template <class Geometry>
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
  [[nodiscard]] typename Geometry::View view(Vertex v) const { return geometry_.view(point(v)); }
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

// The cuts do not depend on the number of threads: each task is a range that the recursion makes in any case.
template <class Geometry>
void DivideAndConquer<Geometry>::run(const threads::ThreadTeam& team, std::span<const threads::Job> jobs) {
  const auto count = static_cast<std::uint32_t>(points_.size());
  const std::size_t most = std::min(kLargestTask, count / (kTasksPerThread * team.threads()));
  tasks_.clear();
  list_tasks(0, count, std::max(kSmallestTask, static_cast<std::uint32_t>(most)));
  std::atomic<std::size_t> done{0};
  team.for_each_index(jobs.size() + tasks_.size(), [&](std::size_t, std::size_t i) {
    if (i < jobs.size()) return jobs[i]();
    Task& task = tasks_[i - jobs.size()];
    task.piece = triangulate(task.begin, task.end);
    done += task.end - task.begin;
    team.report(done);
  });
  std::size_t next_task = 0;
  (void)merge_tasks(0, count, next_task);
}

template <class Geometry>
void DivideAndConquer<Geometry>::list_tasks(std::uint32_t begin, std::uint32_t end, std::uint32_t most) {
  if (end - begin <= most) {
    tasks_.push_back({begin, end, {}});
    return;
  }
  const std::uint32_t middle = split(begin, end).middle;
  list_tasks(begin, middle, most);
  list_tasks(middle, end, most);
}

template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::merge_tasks(std::uint32_t begin,
                                                                                   std::uint32_t end,
                                                                                   std::size_t& next_task) {
  if (tasks_[next_task].end == end) return tasks_[next_task++].piece;
  const auto [middle, cut] = split(begin, end);
  const Piece left = merge_tasks(begin, middle, next_task);
  const Piece right = merge_tasks(middle, end, next_task);
  return merge(left, right, 2 * middle - 2, cut);
}

// The highest bit in which the keys differ divides their squares by a line. If all points lie in one square, they are
// in (x, y) order: an almost vertical line can divide them at any index.
template <class Geometry>
typename DivideAndConquer<Geometry>::Split DivideAndConquer<Geometry>::split(std::uint32_t begin,
                                                                             std::uint32_t end) const {
  const Key differing = keys_[begin] ^ keys_[end - 1];
  if (differing == 0) return {begin + (end - begin) / 2, Cut::x};
  const int bit = 63 - std::countl_zero(differing);
  const Key upper = keys_[end - 1] >> bit << bit;
  const auto first = keys_.begin() + begin;
  const auto found = std::lower_bound(first, keys_.begin() + end, upper);
  return {begin + static_cast<std::uint32_t>(found - first), locate::Curve::is_bit_of_x(bit) ? Cut::x : Cut::y};
}

template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::triangulate(std::uint32_t begin,
                                                                                   std::uint32_t end) {
  const std::uint32_t count = end - begin;
  if (count == 1) return {Vertex{begin + 1}, mesh::kNoHalfEdge};
  if (count == 2) return make_edge(begin);
  if (count == 3) return make_three(begin);
  const auto [middle, cut] = split(begin, end);
  const Piece left = triangulate(begin, middle);
  const Piece right = triangulate(middle, end);
  return merge(left, right, 2 * middle - 2, cut);
}

template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::make_edge(std::uint32_t begin) {
  const Vertex a{begin + 1};
  const Vertex b{begin + 2};
  const HalfEdge ab = make_face(2 * begin, a, b, kGhost);
  const HalfEdge ba = make_face(2 * begin + 1, b, a, kGhost);
  link(ab, ba);
  link(next(ab), previous(ba));
  link(previous(ab), next(ba));
  return {a, ab};
}

template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::make_three(std::uint32_t begin) {
  Vertex a{begin + 1};
  Vertex b{begin + 2};
  Vertex c{begin + 3};
  const Sign sign = orientation(a, b, c);
  if (sign == Sign::positive) return make_triangle(2 * begin, a, b, c);
  if (sign == Sign::negative) return make_triangle(2 * begin, a, c, b);
  if (comes_before(b, a, Cut::x)) std::swap(a, b);
  if (comes_before(c, b, Cut::x)) std::swap(b, c);
  if (comes_before(b, a, Cut::x)) std::swap(a, b);
  return make_chain(2 * begin, a, b, c);
}

template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::make_triangle(std::uint32_t f, Vertex a,
                                                                                     Vertex b, Vertex c) {
  const HalfEdge ab = make_face(f, a, b, c);
  const HalfEdge ba = make_face(f + 1, b, a, kGhost);
  const HalfEdge cb = make_face(f + 2, c, b, kGhost);
  const HalfEdge ac = make_face(f + 3, a, c, kGhost);
  link(ab, ba);
  link(next(ab), cb);
  link(previous(ab), ac);
  link(previous(ba), next(cb));
  link(previous(cb), next(ac));
  link(previous(ac), next(ba));
  return {a, ba};
}

/// Makes the triangulation of three points on a line, which are given in order.
template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::make_chain(std::uint32_t f, Vertex a, Vertex b,
                                                                                  Vertex c) {
  const HalfEdge ab = make_face(f, a, b, kGhost);
  const HalfEdge bc = make_face(f + 1, b, c, kGhost);
  const HalfEdge cb = make_face(f + 2, c, b, kGhost);
  const HalfEdge ba = make_face(f + 3, b, a, kGhost);
  link(ab, ba);
  link(bc, cb);
  link(next(ab), previous(bc));
  link(next(bc), previous(cb));
  link(next(cb), previous(ba));
  link(next(ba), previous(ab));
  return {a, ab};
}

/// The hull edge that starts, counter-clockwise, at the last vertex in the order that the cut uses.
template <class Geometry>
mesh::HalfEdge DivideAndConquer<Geometry>::find_last(HalfEdge hull, Cut cut) const {
  Vertex v = target(hull);
  bool has_advanced = false;
  for (Vertex w = origin(hull); comes_before(v, w, cut); w = origin(hull)) {
    hull = hull_next(hull);
    v = w;
    has_advanced = true;
  }
  if (has_advanced) return hull;
  for (;;) {
    const HalfEdge before = hull_previous(hull);
    const Vertex w = target(before);
    if (!comes_before(v, w, cut)) return hull;
    hull = before;
    v = w;
  }
}

/// The hull edge that ends, counter-clockwise, at the first vertex in the order that the cut uses.
template <class Geometry>
mesh::HalfEdge DivideAndConquer<Geometry>::find_first(HalfEdge hull, Cut cut) const {
  Vertex v = origin(hull);
  bool has_advanced = false;
  for (Vertex w = target(hull); comes_before(w, v, cut); w = target(hull)) {
    hull = hull_previous(hull);
    v = w;
    has_advanced = true;
  }
  if (has_advanced) return hull;
  for (;;) {
    const HalfEdge after = hull_next(hull);
    const Vertex w = origin(after);
    if (!comes_before(w, v, cut)) return hull;
    hull = after;
    v = w;
  }
}

// Finds the lower common tangent of the two pieces. Starts at the two vertices nearest to the cut, and moves down until
// both pieces lie left of the line from l to r, or on it. If several vertices of a piece lie on this line, l (or r) is
// the one nearest to the cut.
template <class Geometry>
typename DivideAndConquer<Geometry>::MergeState DivideAndConquer<Geometry>::lower_tangent(const Piece& left,
                                                                                          const Piece& right,
                                                                                          Cut cut) const {
  MergeState state{left.any, right.any, {}, left.hull, right.hull, {}, {}};
  const bool has_left = left.hull != mesh::kNoHalfEdge;
  const bool has_right = right.hull != mesh::kNoHalfEdge;
  if (has_left) {
    state.left = find_last(left.hull, cut);
    state.l = target(state.left);
  }
  if (has_right) {
    state.right = find_first(right.hull, cut);
    state.r = origin(state.right);
  }
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    if (has_left) {
      const HalfEdge below = hull_previous(state.left);
      if (orientation(state.l, state.r, target(below)) == Sign::negative) {
        state.left = below;
        state.l = target(below);
        has_moved = true;
      }
    }
    if (has_right) {
      const HalfEdge below = hull_next(state.right);
      if (orientation(state.l, state.r, origin(below)) == Sign::negative) {
        state.right = below;
        state.r = origin(below);
        has_moved = true;
      }
    }
  }
  return state;
}

//       ghost       Makes the ghost face below the lower tangent. Its edges l - ghost and ghost - r take two twins from
//      /     \      half-edges of the ghost faces at `left` and `right`. The half-edges that lose their twins are now
//    l ------- r    `left_open` and `right_open`. They have no twin until the upper tangent has a ghost face, too.
//      \     /
//       ghost
template <class Geometry>
void DivideAndConquer<Geometry>::make_lower_ghost(MergeState& state, std::uint32_t f) {
  state.base = make_face(f, state.r, state.l, kGhost);
  const HalfEdge l_to_ghost = next(state.base);
  const HalfEdge ghost_to_r = previous(state.base);
  state.left_open = l_to_ghost;
  state.right_open = ghost_to_r;
  if (state.left != mesh::kNoHalfEdge) {
    state.left_open = next(state.left);
    link(l_to_ghost, twin(state.left_open));
  }
  if (state.right != mesh::kNoHalfEdge) {
    state.right_open = previous(state.right);
    link(ghost_to_r, twin(state.right_open));
  }
}

//          x                  x      Removes the hull edge l - p as long as the circle through l, r and p contains the
//        /   \              / |      vertex x beyond the edge. The face of l, p and x becomes a ghost face, and x
//      p ----- l    ->    p   | l    becomes the candidate. The edge from l to the ghost stays as it is.
//        ghost             ghost
template <class Geometry>
void DivideAndConquer<Geometry>::remove_left_edges(MergeState& state, Vertex& candidate) {
  for (;;) {
    const HalfEdge lp = twin(state.left);
    const HalfEdge xl = previous(lp);
    const Vertex x = origin(xl);
    if (x == kGhost || !circle_contains(state.l, state.r, candidate, x)) return;
    const HalfEdge ghost_to_p = previous(state.left);
    set_origin(state.left, x);
    set_origin(lp, kGhost);
    link(state.left, twin(xl));
    link(lp, twin(ghost_to_p));
    link(ghost_to_p, xl);
    candidate = x;
  }
}

/// Does the same as remove_left_edges() in the right piece, where the hull edge is r - q.
template <class Geometry>
void DivideAndConquer<Geometry>::remove_right_edges(MergeState& state, Vertex& candidate) {
  for (;;) {
    const HalfEdge qr = twin(state.right);
    const HalfEdge rx = next(qr);
    const Vertex x = target(rx);
    if (x == kGhost || !circle_contains(state.l, state.r, candidate, x)) return;
    const HalfEdge q_to_ghost = next(state.right);
    set_origin(q_to_ghost, x);
    set_origin(rx, kGhost);
    link(state.right, twin(rx));
    link(qr, twin(q_to_ghost));
    link(q_to_ghost, rx);
    candidate = x;
  }
}

/// Turns the ghost face at the left hull edge into the face of l, r and the candidate.
template <class Geometry>
void DivideAndConquer<Geometry>::join_left(MergeState& state, Vertex candidate) {
  const HalfEdge lr = next(state.left);
  const HalfEdge up = previous(state.left);
  link(lr, state.base);
  set_origin(up, state.r);
  state.base = up;
  state.l = candidate;
  state.left_open = twin(up);
  state.left = previous(state.left_open);
}

template <class Geometry>
void DivideAndConquer<Geometry>::join_right(MergeState& state, Vertex candidate) {
  const HalfEdge lr = previous(state.right);
  const HalfEdge up = next(state.right);
  link(lr, state.base);
  set_origin(lr, state.l);
  state.base = up;
  state.r = candidate;
  state.right_open = twin(up);
  state.right = next(state.right_open);
}

// Each step finds the face above the base: a circle through the ends of the base grows upwards between the pieces until
// it meets the next vertex of either piece.
template <class Geometry>
typename DivideAndConquer<Geometry>::Piece DivideAndConquer<Geometry>::merge(const Piece& left, const Piece& right,
                                                                             std::uint32_t f, Cut cut) {
  MergeState state = lower_tangent(left, right, cut);
  make_lower_ghost(state, f);
  for (;;) {
    Vertex p = state.left == mesh::kNoHalfEdge ? state.l : origin(state.left);
    Vertex q = state.right == mesh::kNoHalfEdge ? state.r : target(state.right);
    const bool has_p = orientation(state.l, state.r, p) == Sign::positive;
    const bool has_q = orientation(state.l, state.r, q) == Sign::positive;
    if (!has_p && !has_q) break;
    if (has_p) remove_left_edges(state, p);
    if (has_q) remove_right_edges(state, q);
    if (!has_p || (has_q && circle_contains(state.l, state.r, p, q))) {
      join_right(state, q);
    } else {
      join_left(state, p);
    }
  }
  const HalfEdge upper = make_face(f + 1, state.l, state.r, kGhost);
  link(upper, state.base);
  link(next(upper), state.right_open);
  link(previous(upper), state.left_open);
  return {state.l, upper};
}

}  // namespace waywright::delaunay

#include "delaunay/divide_and_conquer.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

namespace waywright::delaunay {

// The cuts do not depend on the number of threads: each task is a range that the recursion makes in any case.
void DivideAndConquer::run(const threads::ThreadTeam& team, std::span<const threads::Job> jobs) {
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

void DivideAndConquer::list_tasks(std::uint32_t begin, std::uint32_t end, std::uint32_t most) {
  if (end - begin <= most) {
    tasks_.push_back({begin, end, {}});
    return;
  }
  const std::uint32_t middle = split(begin, end).middle;
  list_tasks(begin, middle, most);
  list_tasks(middle, end, most);
}

DivideAndConquer::Piece DivideAndConquer::merge_tasks(std::uint32_t begin, std::uint32_t end, std::size_t& next_task) {
  if (tasks_[next_task].end == end) return tasks_[next_task++].piece;
  const auto [middle, cut] = split(begin, end);
  const Piece left = merge_tasks(begin, middle, next_task);
  const Piece right = merge_tasks(middle, end, next_task);
  return merge(left, right, 2 * middle - 2, cut);
}

// The highest bit in which the keys differ divides their squares by a line. If all points lie in one square, they are
// in (x, y) order: an almost vertical line can divide them at any index.
DivideAndConquer::Split DivideAndConquer::split(std::uint32_t begin, std::uint32_t end) const {
  const Key differing = keys_[begin] ^ keys_[end - 1];
  if (differing == 0) return {begin + (end - begin) / 2, Cut::x};
  const int bit = 63 - std::countl_zero(differing);
  const Key upper = keys_[end - 1] >> bit << bit;
  const auto first = keys_.begin() + begin;
  const auto found = std::lower_bound(first, keys_.begin() + end, upper);
  return {begin + static_cast<std::uint32_t>(found - first), locate::Curve::is_bit_of_x(bit) ? Cut::x : Cut::y};
}

DivideAndConquer::Piece DivideAndConquer::triangulate(std::uint32_t begin, std::uint32_t end) {
  const std::uint32_t count = end - begin;
  if (count == 1) return {Vertex{begin + 1}, mesh::kNoHalfEdge};
  if (count == 2) return make_edge(begin);
  if (count == 3) return make_three(begin);
  const auto [middle, cut] = split(begin, end);
  const Piece left = triangulate(begin, middle);
  const Piece right = triangulate(middle, end);
  return merge(left, right, 2 * middle - 2, cut);
}

DivideAndConquer::Piece DivideAndConquer::make_edge(std::uint32_t begin) {
  const Vertex a{begin + 1};
  const Vertex b{begin + 2};
  const HalfEdge ab = make_face(2 * begin, a, b, kGhost);
  const HalfEdge ba = make_face(2 * begin + 1, b, a, kGhost);
  link(ab, ba);
  link(next(ab), previous(ba));
  link(previous(ab), next(ba));
  return {a, ab};
}

DivideAndConquer::Piece DivideAndConquer::make_three(std::uint32_t begin) {
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

DivideAndConquer::Piece DivideAndConquer::make_triangle(std::uint32_t f, Vertex a, Vertex b, Vertex c) {
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
DivideAndConquer::Piece DivideAndConquer::make_chain(std::uint32_t f, Vertex a, Vertex b, Vertex c) {
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
mesh::HalfEdge DivideAndConquer::find_last(HalfEdge hull, Cut cut) const {
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
mesh::HalfEdge DivideAndConquer::find_first(HalfEdge hull, Cut cut) const {
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
DivideAndConquer::MergeState DivideAndConquer::lower_tangent(const Piece& left, const Piece& right, Cut cut) const {
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
void DivideAndConquer::make_lower_ghost(MergeState& state, std::uint32_t f) {
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
void DivideAndConquer::remove_left_edges(MergeState& state, Vertex& candidate) {
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
void DivideAndConquer::remove_right_edges(MergeState& state, Vertex& candidate) {
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
void DivideAndConquer::join_left(MergeState& state, Vertex candidate) {
  const HalfEdge lr = next(state.left);
  const HalfEdge up = previous(state.left);
  link(lr, state.base);
  set_origin(up, state.r);
  state.base = up;
  state.l = candidate;
  state.left_open = twin(up);
  state.left = previous(state.left_open);
}

void DivideAndConquer::join_right(MergeState& state, Vertex candidate) {
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
DivideAndConquer::Piece DivideAndConquer::merge(const Piece& left, const Piece& right, std::uint32_t f, Cut cut) {
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

#include <cmath>
#include <optional>

#include "nav/point_agent.hpp"
#include "path/distance.hpp"
#include "path/optimal_cone.hpp"

// Lower bounds of windows, the windows that cannot belong to a shortest path, and what the search records.

namespace waywright::path {

using exact::Sign;

/// Let E be the origin of `from_end`, which is one of the two half-edges of the window's edge. Returns whether the
/// known path to E, continued along the edge, reaches the other end of the edge sooner than the straight line from the
/// root. By the triangle inequality it then also reaches every position of the edge sooner, so no shortest path comes
/// through the window. "Sooner" means that the difference is larger than the rounding error of a sum of lengths. So of
/// two equally long paths, neither excludes the other. In a bundle, the path to each position leads through the first
/// root, so it is enough to compare with the straight line from there.
bool Optimal::is_dominated_by(const Reached& known, const Node& window, mesh::HalfEdge from_end) const {
  constexpr double kRoundingMargin = 1.0 + 0x1p-40;
  const mesh::Vertex end = mesh_->origin(from_end);
  const Point& other_end = position_of(mesh_->target(from_end));
  const Root& root = roots_[window.first_root()];
  const bool is_sooner = (known.length + distance(position_of(end), other_end)) * kRoundingMargin <
                         root.length + distance(root.point, other_end);
  return is_sooner && are_in_one_wedge(from_end, known.spoke);
}

/// Both half-edges start at one vertex. Returns whether one can go around this vertex from `g` to `h`, in one of the
/// two directions, and meet only edges that the agent can cross (can_cross()). Requires: both are passages, and the
/// vertex has walls.
bool Optimal::are_in_one_wedge(mesh::HalfEdge g, mesh::HalfEdge h) const {
  for (mesh::HalfEdge at = g; can_cross(at); at = mesh_->next_around(at)) {
    if (at == h) return true;
  }
  for (mesh::HalfEdge at = g; can_cross(at); at = mesh_->previous_around(at)) {
    if (at == h) return true;
  }
  return false;
}

/// Returns the root from which a position is visible through `window`, a window or a bundle. The position lies on the
/// edge of the window, or beyond it. For each root after the first, consider the straight continuation of the path
/// beyond this root. It separates the window of this root from the windows of the roots before it. `is_beyond(root)`
/// says whether the position lies beyond this continuation, so that only roots before this root see it. Requires: one
/// of the roots sees the position.
template <class IsBeyond>
std::uint32_t Optimal::find_root(const Node& window, IsBeyond&& is_beyond) const {
  const std::uint32_t first = window.first_root();
  std::uint32_t root = window.last_root();
  while (root != first && is_beyond(roots_[root])) {
    const std::uint32_t jump = roots_[root].jump;
    root = jump > first && is_beyond(roots_[jump]) ? jump : roots_[root].before;
  }
  return root;
}

std::uint32_t Optimal::root_that_sees(const Node& window, const Geometry::View& p) const {
  const Sign beyond = window.left_root < window.right_root ? Sign::positive : Sign::negative;
  return find_root(window, [&](const Root& root) {
    return geometry_->orientation(Geometry::Line(view(roots_[root.before]), view(root)), p) == beyond;
  });
}

/// Returns a lower bound of the length of the paths from `p` to a goal.
double Optimal::bound_from(const Point& p) const {
  return goals_.size() == 1 ? distance(p, goals_.front().point) : 0.0;
}

/// Returns a lower bound, up to rounding, of the length of the paths through the window: with one goal, the length of
/// the path through the window to the goal; with several goals, the length of the path to the window. All numbers are
/// doubles: no decision about left and right depends on the result. If the angle between a bound of the cone and the
/// edge is very small, doubles cannot express where they meet. The function then assumes the least length: with one
/// goal, that the window is the whole edge; with several goals, that the path from the root to the window has length
/// zero.
double Optimal::bound(const Node& window, const Point& left, const Point& right) const {
  if (window.is_bundle()) return bound_of_bundle(window, left, right);
  const Point& a = position_of(mesh_->origin(window.entry));
  const Point& b = position_of(mesh_->target(window.entry));
  const Point& p = roots_[window.left_root].point;
  const Point edge{b.x - a.x, b.y - a.y};
  const double length = roots_[window.left_root].length;
  const bool has_one_goal = goals_.size() == 1;
  const Point q = has_one_goal ? reflect_to_left(a, edge, goals_.front().point) : foot(p, a, edge);
  const Point to_q{q.x - p.x, q.y - p.y};
  const bool passes_left = cross(left, to_q) > 0.0;
  if (!passes_left && !(cross(right, to_q) < 0.0)) return length + distance(p, q);
  const std::optional<Point> end = meeting(p, passes_left ? left : right, a, edge);
  if (has_one_goal) return length + (end ? distance_via_point(p, *end, q) : distance_via_segment(p, a, b, q));
  return end ? length + distance(p, *end) : length;
}

/// Returns a lower bound of the length of the paths through a bundle. The left ray of the bundle bounds its leftmost
/// window on the left. Suppose that the goal lies left of this ray. Then the shortest path through the bundle leads
/// from the first root to the root of the leftmost window, along the left ray to the edge, and from there straight to
/// the goal. From the first root on, it turns only to the left, so it is convex. Every other path from the first root
/// through the bundle to the goal meets the edge farther to the right, and leads around this convex path. So it is
/// longer. If the goal lies right of the right ray of the bundle, the same is true with left and right exchanged. With
/// several goals, the function takes the distance from the first root to the edge.
double Optimal::bound_of_bundle(const Node& window, const Point& left, const Point& right) const {
  const Point& a = position_of(mesh_->origin(window.entry));
  const Point& b = position_of(mesh_->target(window.entry));
  const Point edge = b - a;
  const Root& first = roots_[window.first_root()];
  if (goals_.size() != 1) return first.length + std::sqrt(squared_distance_to_segment(first.point, a, b));
  const Point q = reflect_to_left(a, edge, goals_.front().point);
  const bool passes_left = cross(left, q - roots_[window.left_root].point) > 0.0;
  if (passes_left || cross(right, q - roots_[window.right_root].point) < 0.0) {
    const Root& root = roots_[passes_left ? window.left_root : window.right_root];
    const std::optional<Point> end = meeting(root.point, passes_left ? left : right, a, edge);
    if (end) return root.length + distance_via_point(root.point, *end, q);
    return first.length + distance_via_segment(first.point, a, b, q);
  }
  const double sign = window.left_root < window.right_root ? 1.0 : -1.0;
  const Root& root = roots_[find_root(window, [&](const Root& later) {
    return sign * cross(later.point - roots_[later.before].point, q - later.point) > 0.0;
  })];
  return root.length + distance(root.point, q);
}

/// Records that the search has looked at the face and, if the query wants the windows, records the windows.
void Optimal::record(mesh::Face f, const Node& window) {
  looked_at_->look(f);
  if (windows_ == nullptr) return;
  const bool turns_right = window.left_root < window.right_root;
  Node rest = window;
  while (rest.is_bundle()) {
    Node last = rest;
    const std::uint32_t root = rest.last_root();
    const mesh::Vertex at = roots_[root].vertex;
    (turns_right ? last.left_root : last.right_root) = root;
    (turns_right ? last.left : last.right) = kContinuation;
    record_window(last);
    (turns_right ? rest.right_root : rest.left_root) = roots_[root].before;
    (turns_right ? rest.right : rest.left) = at;
  }
  record_window(rest);
}

void Optimal::record_window(const Node& window) {
  const Cone cone(*this, window);
  const Root& root = roots_[window.left_root];
  const mesh::Vertex left = mesh_->origin(window.entry);
  const mesh::Vertex right = mesh_->target(window.entry);
  const Portal edge{position_of(left), position_of(right)};
  const auto end_of = [&](mesh::Vertex bound, mesh::Vertex end, const Point& direction) {
    const Point along{edge.right.x - edge.left.x, edge.right.y - edge.left.y};
    return bound == end ? position_of(end)
                        : meeting(root.point, direction, edge.left, along).value_or(position_of(end));
  };
  const Portal interval{end_of(window.left, left, cone.left_direction()),
                        end_of(window.right, right, cone.right_direction())};
  const double least = bound(window, cone.left_direction(), cone.right_direction());
  windows_->push_back({root.point, edge, interval, root.length, least});
}

}  // namespace waywright::path

#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "constraint/distances.hpp"

// Lengths in doubles. They serve only two purposes: to choose between paths, and to compute bounds for searches. Exact
// predicates decide whether a position lies left or right of a line. The code uses the square root because it is
// correctly rounded on every machine, unlike std::hypot.

namespace waywright::path {

using constraint::squared_distance_to_segment;

/// If the squared length of an edge is at most this, the edge has no direction in doubles. The two ends of such an edge
/// have the same rounded coordinates, or their rounded coordinates are very close to 0.
inline constexpr double kNoLength = 0x1p-900;

/// Returns `q` if it does not lie to the right of the line through `a` along `edge`, or if `edge` has no direction.
/// Otherwise returns the mirror image of `q` on the left of the line.
[[nodiscard]] inline Point reflect_to_left(const Point& a, const Point& edge, const Point& q) {
  const double doubled_area = cross(edge, {q.x - a.x, q.y - a.y});
  if (!(doubled_area < 0.0)) return q;
  const double squared_length = edge.x * edge.x + edge.y * edge.y;
  if (squared_length <= kNoLength) return q;
  const double scale = 2.0 * doubled_area / squared_length;
  return {q.x + edge.y * scale, q.y - edge.x * scale};
}

/// Returns the point nearest to `p` on the line through `a` along `edge`, or `a` if `edge` has no direction.
[[nodiscard]] inline Point foot(const Point& p, const Point& a, const Point& edge) {
  const double squared_length = edge.x * edge.x + edge.y * edge.y;
  if (squared_length <= kNoLength) return a;
  const double share = ((p.x - a.x) * edge.x + (p.y - a.y) * edge.y) / squared_length;
  return {a.x + share * edge.x, a.y + share * edge.y};
}

/// Returns the point where the ray from `p` in `direction` meets the segment from `a` along `edge`. If the ray misses
/// the segment because of rounding, returns the nearer end. Returns nothing if the ray and the segment are so nearly
/// parallel that rounding could move the point by more than 2^-34 of its distance from `p`.
[[nodiscard]] inline std::optional<Point> meeting(const Point& p, const Point& direction, const Point& a,
                                                  const Point& edge) {
  const double one = direction.x * edge.y;
  const double other = direction.y * edge.x;
  const double across = one - other;
  if (!(std::abs(across) > 0x1p-16 * (std::abs(one) + std::abs(other)))) return std::nullopt;
  const double at = cross(direction, {p.x - a.x, p.y - a.y}) / across;
  const double share = at > 0.0 ? std::min(at, 1.0) : 0.0;
  return Point{a.x + share * edge.x, a.y + share * edge.y};
}

[[nodiscard]] inline double distance_via_point(const Point& p, const Point& between, const Point& q) {
  return distance(p, between) + distance(between, q);
}

/// Returns the length of the shortest path from `p` to `q` that touches the segment from `a` to `b`. If all four points
/// lie on one line, the result is the distance from `p` to `q`.
[[nodiscard]] inline double distance_via_segment(const Point& p, const Point& a, const Point& b, const Point& q) {
  const Point edge{b.x - a.x, b.y - a.y};
  const bool is_right = cross(edge, {p.x - a.x, p.y - a.y}) < 0.0;
  const Point image = is_right ? reflect_to_left(a, edge, q) : reflect_to_left(b, {-edge.x, -edge.y}, q);
  const Point direction{image.x - p.x, image.y - p.y};
  const double a_turn = cross(direction, {a.x - p.x, a.y - p.y});
  const double b_turn = cross(direction, {b.x - p.x, b.y - p.y});
  if ((a_turn >= 0.0 && b_turn <= 0.0) || (a_turn <= 0.0 && b_turn >= 0.0)) return distance(p, image);
  return std::min(distance_via_point(p, a, q), distance_via_point(p, b, q));
}

}  // namespace waywright::path

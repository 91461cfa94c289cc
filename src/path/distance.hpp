#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

// Lengths in doubles. They choose between ways and bound searches; what is on which side is decided elsewhere, exactly.
// Square root is correctly rounded everywhere, which std::hypot is not.

namespace waywright::path {

/// Edges whose squared length is not above this have no direction in doubles. They join vertices that round to one
/// place, or to two next to 0.
inline constexpr double kNoLength = 0x1p-900;

/// `q` where it doesn't lie on the right of the line through `a` along `edge`, or that has no direction; else its
/// mirror image there.
[[nodiscard]] inline Point on_left(const Point& a, const Point& edge, const Point& q) {
  const double side = cross(edge, {q.x - a.x, q.y - a.y});
  if (!(side < 0.0)) return q;
  const double squared_length = edge.x * edge.x + edge.y * edge.y;
  if (squared_length <= kNoLength) return q;
  const double scale = 2.0 * side / squared_length;
  return {q.x + edge.y * scale, q.y - edge.x * scale};
}

/// The point nearest to `p` of the line through `a` along `edge`; `a` where that has no direction.
[[nodiscard]] inline Point foot(const Point& p, const Point& a, const Point& edge) {
  const double squared_length = edge.x * edge.x + edge.y * edge.y;
  if (squared_length <= kNoLength) return a;
  const double share = ((p.x - a.x) * edge.x + (p.y - a.y) * edge.y) / squared_length;
  return {a.x + share * edge.x, a.y + share * edge.y};
}

/// Where the ray from `p` in a direction meets the edge from `a` along `edge`; the edge's nearer end where it hardly
/// does. Nothing where the two are so nearly parallel that rounding could shift the place by more than 2^-34 of its
/// distance from `p`.
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

[[nodiscard]] inline double length_by_way_of(const Point& p, const Point& between, const Point& q) {
  return distance(p, between) + distance(between, q);
}

/// The length of the shortest way from `p` to `q` that touches the segment from `a` to `b`; with all four on a line, of
/// one that touches that.
[[nodiscard]] inline double distance_by_way_of(const Point& p, const Point& a, const Point& b, const Point& q) {
  const Point edge{b.x - a.x, b.y - a.y};
  const bool is_right = cross(edge, {p.x - a.x, p.y - a.y}) < 0.0;
  const Point image = is_right ? on_left(a, edge, q) : on_left(b, {-edge.x, -edge.y}, q);
  const Point way{image.x - p.x, image.y - p.y};
  const double a_turn = cross(way, {a.x - p.x, a.y - p.y});
  const double b_turn = cross(way, {b.x - p.x, b.y - p.y});
  if ((a_turn >= 0.0 && b_turn <= 0.0) || (a_turn <= 0.0 && b_turn >= 0.0)) return distance(p, image);
  return std::min(length_by_way_of(p, a, q), length_by_way_of(p, b, q));
}

}  // namespace waywright::path

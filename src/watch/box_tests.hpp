#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "waywright/path.hpp"
#include "waywright/point.hpp"

#include "base/ieee.hpp"

// Tests, in doubles, of what a watch knows about paths: straight pieces, and the ellipses in which shorter paths lie.

namespace waywright::watch {

inline double largest_coordinate(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// A bound of the rounding errors of positions, distances and boxes near `a` and `b`.
inline double slack_of(const Point& a, const Point& b) {
  return 0x1p-45 * std::max(largest_coordinate(a), largest_coordinate(b));
}

/// Where a straight piece lies in its bounding box: on which diagonal. `none` if it may be anywhere in the box.
enum class Diagonal : std::uint8_t { none, rising, falling };

/// The ends of a diagonal of a box, from left to right.
inline std::array<Point, 2> ends_of(const Box& box, Diagonal diagonal) {
  const bool rises = diagonal == Diagonal::rising;
  return {Point{box.min.x, rises ? box.min.y : box.max.y}, Point{box.max.x, rises ? box.max.y : box.min.y}};
}

/// Returns false only if the box contains no position whose coordinates differ by at most 2 `slack` from a position of
/// the diagonal of `around`. Requires: the boxes overlap.
inline bool may_touch_diagonal(const Box& around, Diagonal diagonal, const Box& box, double slack) {
  if (diagonal == Diagonal::none) return true;
  const auto [from, to] = ends_of(around, diagonal);
  const Point along = to - from;
  const double extent = std::abs(along.x) + std::abs(along.y);
  const double error = extent * (8.0 * slack + 0x1p-48 * (extent + box.width() + box.height()));
  const auto [least, most] =
      std::minmax({cross(along, box.min - from), cross(along, box.max - from),
                   cross(along, Point{box.min.x, box.max.y} - from), cross(along, Point{box.max.x, box.min.y} - from)});
  return least <= error && most >= -error;
}

/// Returns true only if the two segments surely cross, also if each coordinate of their ends is wrong by `slack`. Two
/// segments cross if one end of each segment lies left of the line through the other segment, and the other end lies
/// right of this line.
inline bool surely_cross(const Point& a, const Point& b, const Point& c, const Point& d, double slack) {
  const auto extent = [](const Point& p) { return std::abs(p.x) + std::abs(p.y); };
  const auto are_apart = [&](const Point& from, const Point& along, const Point& p, const Point& q) {
    const Point to_p = p - from;
    const Point to_q = q - from;
    const double error = 8.0 * slack * (extent(along) + extent(to_p) + extent(to_q) + slack);
    const double at_p = cross(along, to_p);
    const double at_q = cross(along, to_q);
    return std::min(at_p, at_q) < -error && std::max(at_p, at_q) > error;
  };
  return are_apart(a, b - a, c, d) && are_apart(c, d - c, a, b);
}

/// Returns whether a segment meets a box. Rounding errors may make the answer wrong.
inline bool probably_meets(const Point& a, const Point& b, const Box& box) {
  if (std::max(a.x, b.x) < box.min.x || std::min(a.x, b.x) > box.max.x) return false;
  if (std::max(a.y, b.y) < box.min.y || std::min(a.y, b.y) > box.max.y) return false;
  const Point along = b - a;
  const Point centre = 0.5 * (box.min + box.max);
  return 2.0 * std::abs(cross(along, centre - a)) <= std::abs(along.x) * box.height() + std::abs(along.y) * box.width();
}

/// The positions from which the sum of the distances to two foci is at most `length`, and all positions that are at
/// most `reach` away from one of these positions.
struct Ellipse {
  Point start;
  Point goal;
  double length = std::numeric_limits<double>::infinity();
  double reach = 0.0;
};

/// Returns whether the box, larger by the reach in each of the four directions, may contain a position of the ellipse.
/// Let a and b be the distances of the larger box from the foci. Let the rest be length^2 - a^2 - b^2. Then a + b <=
/// length if and only if the rest is not negative and the square of 2 a b is at most the square of the rest. The
/// products of four coordinates neither overflow nor underflow. Requires: the length has been multiplied by at least
/// 1 + 2^-40, to cover the rounding errors of the test.
inline bool may_meet(const Ellipse& ellipse, const Box& box) {
  const auto squared_distance = [&](const Point& p) {
    const auto beyond = [&](double least, double most, double at) {
      return std::max(std::max(least - at, at - most) - ellipse.reach, 0.0);
    };
    const double dx = beyond(box.min.x, box.max.x, p.x);
    const double dy = beyond(box.min.y, box.max.y, p.y);
    return dx * dx + dy * dy;
  };
  const double a2 = squared_distance(ellipse.start);
  const double b2 = squared_distance(ellipse.goal);
  const double rest = ellipse.length * ellipse.length - a2 - b2;
  return rest * std::abs(rest) >= 4.0 * a2 * b2;
}

/// A box that contains the ellipse.
inline Box bounds_of(const Ellipse& ellipse) {
  constexpr double kBeyondAllDomains = 2 * kLargestCoordinate;
  if (ellipse.length > kBeyondAllDomains) {
    return {{-kBeyondAllDomains, -kBeyondAllDomains}, {kBeyondAllDomains, kBeyondAllDomains}};
  }
  // Half the extent of the ellipse in one axis, if the foci differ by `other` in the other axis.
  const auto half_extent = [&](double other) {
    return 0.5 * std::sqrt(std::max(ellipse.length - other, 0.0) * (ellipse.length + other));
  };
  const Point& start = ellipse.start;
  const Point& goal = ellipse.goal;
  const Point centre = 0.5 * (start + goal);
  const Point across{half_extent(std::abs(goal.y - start.y)), half_extent(std::abs(goal.x - start.x))};
  return Box{centre - across, centre + across}.expanded(ellipse.reach + slack_of(start, goal));
}

/// Returns the ellipse that contains each shorter path. If the search has moved an end, the ellipse also contains each
/// position that is nearer to the end in the query than the moved end is. Suppose that the search has moved the start
/// from `s` to `t`, by the distance d. If a position p is nearer to `s` than `t` is, then p is at most d away from `s`,
/// and at most d + d + length away from the goal. So the sum of the two distances is at most the length of the path
/// plus 3 d, and this is Ellipse::length.
inline Ellipse ellipse_of(const Path& path) {
  const bool has_points = !path.points.empty();
  if (path.status != PathStatus::found || (!has_points && path.pieces.empty())) return {};
  Ellipse ellipse;
  ellipse.start = has_points ? path.points.front() : path.pieces.front().from;
  ellipse.goal = has_points ? path.points.back() : path.pieces.back().to;
  double moved = 0.0;
  const auto move_back = [&](Point& end, const MovedEnd& moved_end) {
    moved += distance(moved_end.from, moved_end.to);
    end = moved_end.from;
  };
  if (path.moved_start) move_back(ellipse.start, *path.moved_start);
  if (path.moved_goal) move_back(ellipse.goal, *path.moved_goal);
  // The length is a sum of rounded lengths. The last term covers the rounding of up to 4 million turns.
  const double largest = std::max(largest_coordinate(ellipse.start), largest_coordinate(ellipse.goal));
  ellipse.length = path.length + 3.0 * moved + 0x1p-30 * (path.length + largest);
  ellipse.reach = path.agent.radius * (1.0 + 0x1p-30);
  return ellipse;
}

}  // namespace waywright::watch

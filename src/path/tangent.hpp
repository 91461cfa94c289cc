#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/doubles.hpp"

// Tangents to circles, and angles, in doubles. They use only operations that IEEE 754 rounds correctly (also the square
// root), never the functions of the C library, whose results differ between machines.

namespace waywright::path {

/// The direction in which a path turns around a vertex, as a factor. The cross product of two directions of a path,
/// times this factor, is positive if the path turns in this direction.
inline constexpr int kTurnLeft = 1;
inline constexpr int kTurnRight = -1;
inline constexpr int kNoTurn = 0;

/// A circle around a vertex, which a path touches, and the direction in which the path turns around it. If the path
/// turns left, the circle's centre is on the left of the path. The struct also stores the start or the goal of a path,
/// which is no pivot: then the circle has the radius 0, and `turn` is kNoTurn.
struct Pivot {
  Point centre;
  int turn = kNoTurn;  ///< kTurnLeft, kTurnRight or kNoTurn
};

/// A straight line in a direction (a vector of length 1) that touches two pivots.
struct Tangent {
  Point direction;
  double length = 0.0;  ///< between the touching positions on the two pivots
};

[[nodiscard]] inline Point left_of(const Point& direction) { return {-direction.y, direction.x}; }

/// Returns the squared distance of two points minus the square of `across`. The result is precise even if these two
/// numbers are nearly equal: its square root decides in which direction a disc passes between two vertices where it
/// just fits.
[[nodiscard]] inline double squared_distance_minus(const Point& p, const Point& q, double across) {
  const Point between = q - p;
  const double squared = squared_length(between);
  const double square = squared - across * across;
  if (!(std::abs(square) < 0x1p-10 * squared)) return square;
  const exact::Twofold x = exact::subtract_exactly(q.x, p.x);
  const exact::Twofold y = exact::subtract_exactly(q.y, p.y);
  const exact::Twofold xx = exact::multiply_exactly(x.rounded, x.rounded);
  const exact::Twofold yy = exact::multiply_exactly(y.rounded, y.rounded);
  const exact::Twofold rr = exact::multiply_exactly(across, across);
  // Of the three squares, the largest is nearly the sum of the other two or equal to one of them.
  const exact::Twofold larger = xx.rounded > yy.rounded ? xx : yy;
  const exact::Twofold smaller = xx.rounded > yy.rounded ? yy : xx;
  const exact::Twofold rest = exact::subtract_exactly(larger.rounded, rr.rounded);
  const exact::Twofold sum = exact::subtract_exactly(rest.rounded, -smaller.rounded);
  return sum.rounded + (sum.error + rest.error + larger.error + smaller.error - rr.error +
                        2.0 * (x.rounded * x.error + y.rounded * y.error));
}

/// Where two circles touch, rounding may make squared_distance_minus() negative. If it is less than this share of the
/// squared distance between the centres, the circles overlap.
inline constexpr double kLeastSquare = -0x1p-40;

/// Returns the line that touches `from` and then `to`. Returns nothing if there is none: the circles overlap, and the
/// line would have to pass between them.
[[nodiscard]] inline std::optional<Tangent> tangent(const Pivot& from, const Pivot& to, double radius) {
  const Point between = to.centre - from.centre;
  const double squared = squared_length(between);
  const double across = (to.turn - from.turn) * radius;
  const double square = squared_distance_minus(from.centre, to.centre, across);
  if (!(square >= kLeastSquare * squared) || squared == 0.0) return std::nullopt;
  const double along = std::sqrt(std::max(square, 0.0));
  return Tangent{
      {(along * between.x + across * between.y) / squared, (along * between.y - across * between.x) / squared}, along};
}

/// Returns the position at which a path in this direction touches a pivot.
[[nodiscard]] inline Point touching_position(const Pivot& pivot, const Point& direction, double radius) {
  const double distance = pivot.turn * radius;
  return {pivot.centre.x + distance * direction.y, pivot.centre.y - distance * direction.x};
}

/// Returns the arc tangent of `ratio`, which is 0 to 1: halves the angle three times, then sums the power series.
[[nodiscard]] inline double small_arc_tangent(double ratio) {
  for (int i = 0; i < 3; ++i) ratio /= 1.0 + std::sqrt(1.0 + ratio * ratio);
  const double square = ratio * ratio;
  double sum = 0.0;
  for (int n = 19; n >= 1; n -= 2) sum = 1.0 / n - square * sum;
  return 8.0 * ratio * sum;
}

inline constexpr double kPi = 0x1.921fb54442d18p+1;

/// Returns the angle of the vector (x, y), -pi to pi, as std::atan2 does, but the same on every machine.
[[nodiscard]] inline double angle_of(const Point& v) {
  const double x = std::abs(v.x);
  const double y = std::abs(v.y);
  if (x == 0.0 && y == 0.0) return 0.0;
  double angle = y <= x ? small_arc_tangent(y / x) : kPi / 2 - small_arc_tangent(x / y);
  if (v.x < 0.0) angle = kPi - angle;
  return v.y < 0.0 ? -angle : angle;
}

/// Returns the angle, 0 to 2 pi, of a turn from direction `a` to direction `b`: to the left if `turn` is
/// kTurnLeft, to the right if it is kTurnRight.
[[nodiscard]] inline double turning_angle(const Point& a, const Point& b, int turn) {
  const double angle = angle_of({dot(a, b), turn * cross(a, b)});
  return angle < 0.0 ? angle + 2 * kPi : angle;
}

/// Returns a number from 0 to 4 that grows with turning_angle(a, b, turn) and costs less.
[[nodiscard]] inline double turning_order(const Point& a, const Point& b, int turn) {
  const double x = dot(a, b);
  const double y = turn * cross(a, b);
  const double share = x / (std::abs(x) + std::abs(y));
  return y >= 0.0 ? 1.0 - share : 3.0 + share;
}

}  // namespace waywright::path

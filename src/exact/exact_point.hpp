#pragma once

#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::exact {

/// Coordinates in range: finite, and either 0 or of magnitude 2^-100 to 2^100. Every such double is a multiple of
/// 2^-152, so differences and products of up to four of them neither overflow nor underflow.
inline constexpr double kLargestCoordinate = 0x1p100;
inline constexpr double kSmallestCoordinate = 0x1p-100;

[[nodiscard]] inline bool in_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return coordinate == 0.0 || (magnitude >= kSmallestCoordinate && magnitude <= kLargestCoordinate);
}

[[nodiscard]] inline bool in_range(const Point& point) { return in_range(point.x) && in_range(point.y); }

/// Where the line through `a` and `b` meets the line through `c` and `d`: four explicit points, never constructed ones,
/// so that the degree of no predicate grows with the history. The lines are not parallel.
struct Crossing {
  Point a, b, c, d;
};

/// A point as the predicates see it. Explicit: `crossing` is null and (x, y) is the point. Constructed: the point is
/// the crossing's, (x, y) each of its coordinates rounded to the nearest double.
///
/// A crossing whose coordinates happen to be doubles in range is kept as an explicit point; so an explicit and a
/// constructed point are never equal, and equal points have equal (x, y).
struct ExactPoint {
  double x = 0.0;
  double y = 0.0;
  const Crossing* crossing = nullptr;

  [[nodiscard]] bool is_explicit() const { return crossing == nullptr; }
};

[[nodiscard]] inline ExactPoint explicit_point(const Point& point) { return {point.x, point.y, nullptr}; }

}  // namespace waywright::exact

#pragma once

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::exact {

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

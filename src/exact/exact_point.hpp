#pragma once

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::exact {

/// The point where the line through `a` and `b` meets the line through `c` and `d`. These four points are always
/// explicit, never constructed, so the degree of the predicates does not grow with the number of operations. Requires:
/// the lines are not parallel.
struct Crossing {
  Point a, b, c, d;
};

/// A point in the form that the predicates take. An explicit point has no `crossing` (null) and is (x, y). A
/// constructed point is the crossing, and x and y are its coordinates, each rounded to the nearest double.
///
/// The library stores a crossing whose coordinates are doubles in range as an explicit point. Hence an explicit and a
/// constructed point are never equal. Equal points have equal (x, y).
struct ExactPoint {
  double x = 0.0;
  double y = 0.0;
  const Crossing* crossing = nullptr;

  [[nodiscard]] bool is_explicit() const { return crossing == nullptr; }
};

[[nodiscard]] inline ExactPoint explicit_point(const Point& point) { return {point.x, point.y, nullptr}; }

}  // namespace waywright::exact

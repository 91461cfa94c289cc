#pragma once

#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::clearance {

/// Bounds of a distance.
struct DistanceBounds {
  double least;
  double most;
};

/// Returns bounds of the distance from (0, 0) to the segment that starts at `from` and runs along the vector `along`.
/// `from` and `along` are rounded differences of points. Each coordinate of these points may be wrong by `rounding`.
[[nodiscard]] inline DistanceBounds bound_distance(const Point& from, const Point& along, double rounding) {
  constexpr double kUnit = 0x1p-48;  // 32 times the unit of rounding: more than the errors of these formulas
  const double squared_length = along.x * along.x + along.y * along.y;
  const double dot = -(from.x * along.x + from.y * along.y);
  const double share = dot <= 0.0 ? 0.0 : dot >= squared_length ? 1.0 : dot / squared_length;
  const double x = from.x + share * along.x;
  const double y = from.y + share * along.y;
  const double extent = std::abs(from.x) + std::abs(from.y) + std::abs(along.x) + std::abs(along.y);
  const double slack = kUnit * extent + 4.0 * rounding;
  const double distance = std::sqrt(x * x + y * y);
  return {distance - slack, distance + slack};
}

}  // namespace waywright::clearance

#pragma once

#include <algorithm>

#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "exact/filter.hpp"

namespace waywright::constraint {

/// Returns the square of the distance from `p` to the segment from `a` to `b`, in doubles.
[[nodiscard]] inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = squared_length(along);
  const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return squared_length(p - lerp(a, b, share));
}

/// Returns a bound of the difference between a coordinate of a vertex and the rounded coordinate. It is 0 if all
/// vertices are explicit.
[[nodiscard]] inline double largest_rounding(const ConstrainedTriangulation& triangulation) {
  if (!triangulation.triangulation().geometry().has_constructed()) return 0.0;
  return 0x1p-50 * exact::filter::largest_magnitude(triangulation.domain());
}

}  // namespace waywright::constraint

#pragma once

#include <algorithm>

#include "waywright/point.hpp"

namespace waywright::constraint {

/// Returns the square of the distance from `p` to the segment from `a` to `b`, in doubles.
[[nodiscard]] inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = squared_length(along);
  const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return squared_length(p - lerp(a, b, share));
}

}  // namespace waywright::constraint

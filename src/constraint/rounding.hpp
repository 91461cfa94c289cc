#pragma once

#include "constraint/exact_triangulation.hpp"
#include "exact/filter.hpp"

namespace waywright::constraint {

/// Returns a bound of the difference between a coordinate of a vertex and the rounded coordinate. It is 0 if all
/// vertices are explicit.
[[nodiscard]] inline double largest_rounding(const ExactTriangulation& triangulation) {
  if (!triangulation.triangulation().geometry().has_constructed()) return 0.0;
  return 0x1p-50 * exact::filter::largest_magnitude(triangulation.domain());
}

}  // namespace waywright::constraint

#pragma once

#include <string>

#include "waywright/point.hpp"

#include "exact/exact_point.hpp"

namespace waywright::exact {

/// A crossing's coordinates, each rounded to the nearest double (ties to even).
struct RoundedCrossing {
  Point nearest;
  bool is_exact = false;  ///< `nearest` is the crossing itself, and in range
};

/// Requires: the crossing's two lines are not parallel, its points in range.
[[nodiscard]] RoundedCrossing round_to_nearest(const Crossing& crossing);

/// "XNUM XDEN YNUM YDEN": the point as reduced fractions, denominators positive.
[[nodiscard]] std::string to_fractions(const ExactPoint& point);

}  // namespace waywright::exact

#pragma once

#include <cmath>
#include <limits>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::exact {

/// Returns the next number above `value` (below it, if `direction` is negative) among those that `Number` can express
/// and that is_in_range() accepts. Returns `value` itself if there is none. Requires: is_in_range(value), `Number` can
/// express it, and `direction` is not 0.
template <class Number>
[[nodiscard]] double next_coordinate(double value, double direction) {
  const auto smallest = std::copysign(kSmallestCoordinate, direction);
  if (value == 0.0) return smallest;
  const Number limit = std::copysign(std::numeric_limits<Number>::max(), static_cast<Number>(direction));
  const double next = static_cast<double>(std::nextafter(static_cast<Number>(value), limit));
  if (std::abs(next) < kSmallestCoordinate) return 0.0;
  return is_in_range(next) ? next : value;
}

}  // namespace waywright::exact

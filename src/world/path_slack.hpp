#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright {

inline double largest_coordinate(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// A bound of the rounding errors of positions, distances and boxes near `a` and `b`.
inline double slack_of(const Point& a, const Point& b) {
  return 0x1p-45 * std::max(largest_coordinate(a), largest_coordinate(b));
}

}  // namespace waywright

#pragma once

#include <algorithm>
#include <cmath>

#include "base/ieee.hpp"

namespace waywright::base {

/// A box as four numbers.
struct Bounds {
  double min_x = 0.0;
  double min_y = 0.0;
  double max_x = 0.0;
  double max_y = 0.0;
};

/// Returns the bounds of a domain for input without a domain. `box` is the bounding box of the input. The result is
/// this box, enlarged in each of the four directions by an eighth of its larger extent, but at least by 1. Each bound
/// is then rounded outwards to a multiple of a power of two, so that it has few digits. No bound lies beyond
/// +-`largest`.
inline Bounds domain_bounds(const Bounds& box, double largest) {
  const double extent = std::max(box.max_x - box.min_x, box.max_y - box.min_y);
  const double size =
      std::max({std::fabs(box.min_x), std::fabs(box.min_y), std::fabs(box.max_x), std::fabs(box.max_y)});
  // Far from the origin, rounding would remove a margin of 1. There the least margin depends on the distance of
  // neighbouring doubles.
  const double margin = std::max({1.0, extent / 8.0, std::ldexp(size, -48)});
  const double unit = std::ldexp(1.0, std::max(0, std::ilogb(margin) - 1));
  const auto below = [&](double low) { return std::max(std::floor((low - margin) / unit) * unit, -largest); };
  const auto above = [&](double high) { return std::min(std::ceil((high + margin) / unit) * unit, largest); };
  return {below(box.min_x), below(box.min_y), above(box.max_x), above(box.max_y)};
}

}  // namespace waywright::base

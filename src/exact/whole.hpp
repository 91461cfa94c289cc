#pragma once

#include <cmath>

#include "base/ieee.hpp"

namespace waywright::exact {

/// Returns 0 for every whole number below 2^52. If the result is 0, the value is a whole number.
[[nodiscard]] inline double fraction(double value) {
  constexpr double kNoFraction = 0x1p52;  // no double from here on has a fraction
  const double magnitude = std::abs(value);
  return magnitude - ((magnitude + kNoFraction) - kNoFraction);
}

/// Whether the value is surely a whole number. For magnitudes below 2^52 the answer is exact.
///
/// A sum, difference or product of whole numbers is a whole number. If its rounded value is less than 2^53, it was
/// therefore not rounded at all.
[[nodiscard]] inline bool is_whole(double value) { return fraction(value) == 0.0; }

}  // namespace waywright::exact

#pragma once

#include <cmath>

#include "base/ieee.hpp"

namespace waywright::exact {

/// 0 of whole numbers only, and of all those below 2^52.
[[nodiscard]] inline double fraction(double value) {
  constexpr double kNoFraction = 0x1p52;  // no double from here on has one
  const double magnitude = std::abs(value);
  return magnitude - ((magnitude + kNoFraction) - kNoFraction);
}

/// Whether the value is surely a whole number. Below 2^52, also whether it is one.
///
/// A sum, difference or product of whole numbers is one too. So where it is rounded to less than 2^53, it wasn't
/// rounded at all.
[[nodiscard]] inline bool is_whole(double value) { return fraction(value) == 0.0; }

}  // namespace waywright::exact

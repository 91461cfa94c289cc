#pragma once

#include <cstdint>

#include "base/bit_cast.hpp"
#include "base/ieee.hpp"

namespace waywright::exact {

/// Returns 2^exponent. Requires: the result is a normal number.
[[nodiscard]] inline double power_of_two(int exponent) {
  return base::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Returns the exponent of the largest power of two that is not above `value`. Requires: `value` is positive and
/// normal.
[[nodiscard]] inline int exponent_of(double value) {
  return static_cast<int>(base::bit_cast<std::uint64_t>(value) >> 52) - 1023;
}

}  // namespace waywright::exact

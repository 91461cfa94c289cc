#pragma once

#include <cstddef>
#include <limits>

namespace waywright::path {

/// Returns a + b, or the largest number if the sum is larger.
[[nodiscard]] constexpr std::size_t saturating_add(std::size_t a, std::size_t b) {
  return b > std::numeric_limits<std::size_t>::max() - a ? std::numeric_limits<std::size_t>::max() : a + b;
}

}  // namespace waywright::path

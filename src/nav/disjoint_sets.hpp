#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

// Disjoint sets of the numbers below n, stored as trees: `sets[i]` is the parent of i, or i itself if i is a root. The
// root of a tree is the smallest number of the set.
// Source: Galler and Fischer, *An improved equivalence algorithm*, CACM 1964.

namespace waywright::nav {

/// Returns the root of the set of `i`. Halves the way to it.
[[nodiscard]] inline std::uint32_t root_of(std::span<std::uint32_t> sets, std::uint32_t i) {
  while (sets[i] != i) i = sets[i] = sets[sets[i]];
  return i;
}

/// Unites the sets of `i` and `j`.
inline void unite(std::span<std::uint32_t> sets, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t a = root_of(sets, i);
  const std::uint32_t b = root_of(sets, j);
  sets[std::max(a, b)] = std::min(a, b);
}

}  // namespace waywright::nav

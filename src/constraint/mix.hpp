#pragma once

#include <cstdint>

namespace waywright::constraint {

/// A bijection in which every bit of the result depends on every bit of `z`: the finaliser of SplitMix64. Source:
/// Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace waywright::constraint

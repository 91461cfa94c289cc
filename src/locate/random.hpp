#pragma once

#include <cstdint>

#include "waywright/point.hpp"

#include "base/bit_cast.hpp"

namespace waywright::locate {

/// The random numbers of one walk. The seed is the point that the walk searches for, never a clock or a former search.
/// Source: Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014 (SplitMix64).
class Random {
 public:
  explicit Random(const Point& seed)
      : state_(base::bit_cast<std::uint64_t>(seed.x) * 0x9e3779b97f4a7c15u ^ base::bit_cast<std::uint64_t>(seed.y)) {}

  [[nodiscard]] bool coin() {
    if (left_ == 0) refill();
    const bool heads = (bits_ & 1) != 0;
    bits_ >>= 1;
    --left_;
    return heads;
  }

  /// A number from 0 to count - 1. The remainder makes some numbers more likely than others, but far too little to
  /// matter for the choice of a hint. Requires: `count` is not 0.
  [[nodiscard]] std::uint32_t below(std::uint32_t count) {
    refill();
    left_ = 0;
    return static_cast<std::uint32_t>(bits_ % count);
  }

 private:
  void refill() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    bits_ = z ^ (z >> 31);
    left_ = 64;
  }

  std::uint64_t state_;
  std::uint64_t bits_ = 0;
  int left_ = 0;
};

}  // namespace waywright::locate

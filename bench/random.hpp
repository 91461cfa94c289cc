#pragma once

#include <cstddef>
#include <cstdint>

namespace waywright::bench {

/// Random numbers that are the same on every machine; the distributions of the standard library are not.
/// Source: Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014 (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// Returns 0 to count - 1. The bias of the remainder is far below the precision of a benchmark.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

  /// Returns a whole number from `low` to `high`, both included, as a coordinate.
  double between(std::int64_t low, std::int64_t high) {
    return static_cast<double>(low + static_cast<std::int64_t>(below(static_cast<std::size_t>(high - low + 1))));
  }

  /// Returns a multiple of 2^-53 with 0 <= x < 1.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace waywright::bench

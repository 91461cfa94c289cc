#pragma once

#include <cstddef>
#include <cstdint>

namespace waywright::test {

/// Random numbers that are the same on every platform; the distributions of the standard library are not. SplitMix64
/// (Steele, Lea and Flood 2014).
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

  /// Returns 0 to count - 1. The distribution is practically uniform for the small counts of tests.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

  /// Returns `low` to `high`, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const std::uint64_t count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + next() % count);
  }

  bool chance(std::uint64_t percent) { return next() % 100 < percent; }

 private:
  std::uint64_t state_;
};

}  // namespace waywright::test

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "waywright/point.hpp"

#include "exact/power_of_two.hpp"
#include "exact/twofold.hpp"

namespace waywright::exact {

/// A vector in units of a lattice.
struct LatticeVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// A few explicit positions as vectors from a common origin, in whole units of the coarsest lattice that contains all
/// of them. The unit is a power of two, which the caller need not know. The class therefore works equally for integers,
/// multiples of 1/8 and numbers with a few decimals, anywhere in the plane.
///
/// The exact difference of two doubles is the sum of two doubles: the rounded difference and its rounding error (Dekker
/// 1971; Shewchuk 1997, theorem 7). Both stay exact if they are multiplied by a power of two. find_lattice() multiplies
/// them by the largest suitable power and tests whether they are integers.
template <std::size_t kMost>
class Offsets {
 public:
  /// No offset is larger than 2^kLargestBits. So the difference of two offsets is at most 2^(kLargestBits + 1).
  static constexpr int kLargestBits = 61;

  explicit Offsets(const Point& origin) : origin_(origin) {}

  void add(const Point& point) {
    differences_[count_] = subtract(point.x, origin_.x);
    differences_[count_ + 1] = subtract(point.y, origin_.y);
    count_ += 2;
  }
  /// Adds a length, as the offset (length, 0). Requires: `length` is not negative.
  void add_length(double length) {
    differences_[count_] = {length, 0.0};
    differences_[count_ + 1] = {};
    largest_ = std::max(largest_, length);
    count_ += 2;
  }

  /// Finds the lattice. Returns false if the points have no lattice in whose units their offsets are small enough.
  [[nodiscard]] bool find_lattice() {
    if (largest_ == 0.0) {
      values_.fill(0);
      return true;
    }
    const int shift = kLargestBits - 1 - exponent_of(largest_);
    const double scale = power_of_two(shift);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double rounded = differences_[i].rounded * scale;
      const double error = differences_[i].error * scale;
      const auto whole = static_cast<std::int64_t>(rounded);
      const auto rest = static_cast<std::int64_t>(error);
      if (static_cast<double>(whole) != rounded || static_cast<double>(rest) != error) return false;
      values_[i] = whole + rest;
      bits |= static_cast<std::uint64_t>(values_[i] < 0 ? -values_[i] : values_[i]);
    }
    const int zeros = std::countr_zero(bits);
    for (std::size_t i = 0; i < count_; ++i) values_[i] >>= zeros;
    bits_ = static_cast<int>(std::bit_width(bits)) - zeros;
    unit_exponent_ = zeros - shift;
    return true;
  }

  /// The offset of point `i`, in the order of add(). Requires: find_lattice() has returned true.
  [[nodiscard]] LatticeVector operator[](std::size_t i) const { return {values_[2 * i], values_[2 * i + 1]}; }
  /// Every offset is smaller than 2^bits(), which is at most kLargestBits + 1.
  [[nodiscard]] int bits() const { return bits_; }
  /// The lattice's unit is 2^unit_exponent().
  [[nodiscard]] int unit_exponent() const { return unit_exponent_; }

 private:
  [[nodiscard]] Twofold subtract(double a, double b) {
    const Twofold difference = subtract_exactly(a, b);
    largest_ = std::max(largest_, std::abs(difference.rounded));
    return difference;
  }

  Point origin_;
  double largest_ = 0.0;
  std::size_t count_ = 0;
  int bits_ = 0;
  int unit_exponent_ = 0;
  std::array<Twofold, 2 * kMost> differences_;
  std::array<std::int64_t, 2 * kMost> values_;
};

}  // namespace waywright::exact

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "waywright/point.hpp"

#include "exact/doubles.hpp"
#include "exact/wide_integer.hpp"

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
    const std::optional<Unit> unit = find_unit<1>(0, largest_);
    if (!unit) return false;
    bits_ = unit->bits;
    x_exponent_ = y_exponent_ = unit->exponent;
    return true;
  }
  /// As find_lattice(), but if there is no such lattice, finds one with a unit for each axis. So points that are very
  /// close to each other on one axis have a lattice, too. For an answer that does not change if one axis is stretched.
  [[nodiscard]] bool find_any_lattice() { return find_lattice() || find_lattice_by_axis(); }

  /// The offset of point `i`, in the order of add(). Requires: the points have a lattice.
  [[nodiscard]] LatticeVector operator[](std::size_t i) const { return {values_[2 * i], values_[2 * i + 1]}; }
  /// Every offset is smaller than 2^bits(), which is at most kLargestBits + 1.
  [[nodiscard]] int bits() const { return bits_; }
  /// The units of the x and y coordinates are 2^x_exponent() and 2^y_exponent().
  [[nodiscard]] int x_exponent() const { return x_exponent_; }
  [[nodiscard]] int y_exponent() const { return y_exponent_; }

 private:
  /// The largest offset in units is smaller than 2^bits, and the unit is 2^exponent.
  struct Unit {
    int bits = 0;
    int exponent = 0;
  };

  [[nodiscard]] Twofold subtract(double a, double b) {
    const Twofold difference = subtract_exactly(a, b);
    largest_ = std::max(largest_, std::abs(difference.rounded));
    return difference;
  }

  /// Writes every kStep-th coordinate in units, from the first on. Returns nothing if there is no suitable unit.
  template <std::size_t kStep>
  [[nodiscard]] std::optional<Unit> find_unit(std::size_t first, double largest) {
    if (largest == 0.0) {
      for (std::size_t i = first; i < count_; i += kStep) values_[i] = 0;
      return Unit{};
    }
    const int shift = kLargestBits - 1 - exponent_of(largest);
    const double scale = power_of_two(shift);
    std::uint64_t bits = 0;
    for (std::size_t i = first; i < count_; i += kStep) {
      const double rounded = differences_[i].rounded * scale;
      const double error = differences_[i].error * scale;
      const auto whole = static_cast<std::int64_t>(rounded);
      const auto rest = static_cast<std::int64_t>(error);
      if (static_cast<double>(whole) != rounded || static_cast<double>(rest) != error) return std::nullopt;
      values_[i] = whole + rest;
      bits |= static_cast<std::uint64_t>(values_[i] < 0 ? -values_[i] : values_[i]);
    }
    const int zeros = std::countr_zero(bits);
    for (std::size_t i = first; i < count_; i += kStep) values_[i] >>= zeros;
    return Unit{static_cast<int>(std::bit_width(bits)) - zeros, zeros - shift};
  }

  [[nodiscard]] bool find_lattice_by_axis() {
    std::array<double, 2> largest{};
    for (std::size_t i = 0; i < count_; ++i)
      largest[i % 2] = std::max(largest[i % 2], std::abs(differences_[i].rounded));
    const std::optional<Unit> x = find_unit<2>(0, largest[0]);
    if (!x) return false;
    const std::optional<Unit> y = find_unit<2>(1, largest[1]);
    if (!y) return false;
    bits_ = std::max(x->bits, y->bits);
    x_exponent_ = x->exponent;
    y_exponent_ = y->exponent;
    return true;
  }

  Point origin_;
  double largest_ = 0.0;
  std::size_t count_ = 0;
  int bits_ = 0;
  int x_exponent_ = 0;
  int y_exponent_ = 0;
  std::array<Twofold, 2 * kMost> differences_;
  std::array<std::int64_t, 2 * kMost> values_;
};

/// Offsets that are smaller than 2^29 differ by less than 2^30. With such offsets, the denominator of a crossing fits
/// one limb.
inline constexpr int kNarrowBits = 29;

/// The point (x / w, y / w) in units of a lattice, w > 0; the denominator has kW limbs. One limb is enough if
/// coordinates differ by at most 2^30, two limbs if they differ by at most 2^62: for differences of at most 2^b, w is
/// at most 2^(2b + 1), and x and y are less than 2^(3b + 2).
template <std::size_t kW>
struct LatticePoint {
  WideInteger<kW + 1> x, y;
  WideInteger<kW> w;
};

template <std::size_t kW>
[[nodiscard]] constexpr LatticePoint<kW> lattice_point(const LatticeVector& p) {
  return {p.x, p.y, 1};
}

// The point a + t (b - a) lies on the line through c and d if t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
template <std::size_t kW>
[[nodiscard]] constexpr LatticePoint<kW> lattice_crossing(const LatticeVector& a, const LatticeVector& b,
                                                          const LatticeVector& c, const LatticeVector& d) {
  const auto minus = [](const LatticeVector& p, const LatticeVector& q) -> LatticeVector {
    return {p.x - q.x, p.y - q.y};
  };
  using Coordinate = WideInteger<1>;
  const auto cross = [](const LatticeVector& u, const LatticeVector& v) {
    const WideInteger<2> product = Coordinate(u.x) * Coordinate(v.y) - Coordinate(u.y) * Coordinate(v.x);
    return product.resize<kW>();
  };
  const LatticeVector ab = minus(b, a);
  const LatticeVector cd = minus(d, c);
  WideInteger<kW> w = cross(ab, cd);
  WideInteger<kW> t = cross(minus(c, a), cd);
  if (w.is_negative()) {
    w = -w;
    t = -t;
  }
  return {w * Coordinate(a.x) + t * Coordinate(ab.x), w * Coordinate(a.y) + t * Coordinate(ab.y), w};
}

}  // namespace waywright::exact

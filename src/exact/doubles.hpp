#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "base/ieee.hpp"

namespace waywright::exact {

/// A number as the sum of two doubles: the rounded value and its error.
struct Twofold {
  double rounded = 0.0;
  double error = 0.0;
};

/// The exact difference of two doubles. Source: Dekker, *A floating-point technique for extending the available
/// precision*, 1971; Shewchuk 1997, theorem 7.
[[nodiscard]] inline Twofold subtract_exactly(double a, double b) {
  const double rounded = a - b;
  const double b_virtual = a - rounded;
  const double a_virtual = rounded + b_virtual;
  return {rounded, (b_virtual - b) + (a - a_virtual)};
}

/// The exact product of two doubles. Requires: neither it nor its error overflows or underflows. Source: Dekker 1971.
[[nodiscard]] inline Twofold multiply_exactly(double a, double b) {
  const auto split = [](double value) -> Twofold {
    const double shifted = 0x1.0000002p27 * value;
    const double high = shifted - (shifted - value);
    return {high, value - high};
  };
  const double product = a * b;
  const auto [a_high, a_low] = split(a);
  const auto [b_high, b_low] = split(b);
  return {product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

/// The cross product (b - a) x (p - a), with a relative error of a few units in the last place, unless it is nearly
/// 2^-100 times as small as its two terms. Requires: the points are in range.
[[nodiscard]] inline double precise_cross(const Point& a, const Point& b, const Point& p) {
  const auto multiply = [](const Twofold& u, const Twofold& v) -> Twofold {
    const Twofold product = multiply_exactly(u.rounded, v.rounded);
    return {product.rounded, product.error + (u.rounded * v.error + u.error * v.rounded)};
  };
  const Twofold first = multiply(subtract_exactly(b.x, a.x), subtract_exactly(p.y, a.y));
  const Twofold second = multiply(subtract_exactly(b.y, a.y), subtract_exactly(p.x, a.x));
  const Twofold difference = subtract_exactly(first.rounded, second.rounded);
  return difference.rounded + (difference.error + (first.error - second.error));
}

/// Returns 2^exponent. Requires: the result is a normal number.
[[nodiscard]] inline double power_of_two(int exponent) {
  return base::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Returns the exponent of the largest power of two that is not above `value`. Requires: `value` is positive and
/// normal.
[[nodiscard]] inline int exponent_of(double value) {
  return static_cast<int>(base::bit_cast<std::uint64_t>(value) >> 52) - 1023;
}

/// Returns 0 for every whole number below 2^52. If the result is 0, the value is a whole number.
[[nodiscard]] inline double fraction(double value) {
  constexpr double kNoFraction = 0x1p52;  // no double from here on has a fraction
  const double magnitude = std::abs(value);
  return magnitude - ((magnitude + kNoFraction) - kNoFraction);
}

/// Whether the value is surely a whole number. For magnitudes below 2^52 the answer is exact.
///
/// A sum, difference or product of whole numbers is a whole number. If its rounded value is less than 2^53, it was
/// therefore not rounded at all.
[[nodiscard]] inline bool is_whole(double value) { return fraction(value) == 0.0; }

/// Returns the next number above `value` (below it, if `direction` is negative) among those that `Number` can express
/// and that is_in_range() accepts. Returns `value` itself if there is none. Requires: is_in_range(value), `Number` can
/// express it, and `direction` is not 0.
template <class Number>
[[nodiscard]] double next_coordinate(double value, double direction) {
  const auto smallest = std::copysign(kSmallestCoordinate, direction);
  if (value == 0.0) return smallest;
  const Number limit = std::copysign(std::numeric_limits<Number>::max(), static_cast<Number>(direction));
  const double next = static_cast<double>(std::nextafter(static_cast<Number>(value), limit));
  if (std::abs(next) < kSmallestCoordinate) return 0.0;
  return is_in_range(next) ? next : value;
}

}  // namespace waywright::exact

#pragma once

#include "waywright/point.hpp"

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

}  // namespace waywright::exact

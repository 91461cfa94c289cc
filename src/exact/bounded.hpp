#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/ieee.hpp"
#include "exact/filter.hpp"
#include "exact/sign.hpp"

namespace waywright::exact {

/// A double with a bound of its error, which each operation computes: the exact number differs from `value` by at most
/// `error`. Unlike Rounded it has a square root, and formulas of any degree may use it.
///
/// Notation: u = 2^-53. An operation whose operands are exact loses at most u times its result, unless the result
/// underflows. Each function below adds up the errors of the operands and of the operation, in up to seven operations
/// that round. The factor kGrowth, 1 + 2^-49, covers their rounding. A product that underflows loses at most 2^-1074,
/// in the value or in a term of the error; filter::kUnderflow covers this. If the error overflows or is not a number,
/// the sign is not sure.
struct Bounded {
  double value = 0.0;
  double error = 0.0;

  [[nodiscard]] friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double sum = a.value + b.value;
    return {sum, (a.error + b.error + filter::kHalfUlp * std::abs(sum)) * kGrowth};
  }
  [[nodiscard]] friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + Bounded{-b.value, b.error}; }
  [[nodiscard]] friend Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }
  [[nodiscard]] friend Bounded operator*(const Bounded& a, const Bounded& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double product = a.value * b.value;
    const double from_factors = std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error;
    return {product, (from_factors + filter::kHalfUlp * std::abs(product) + filter::kUnderflow) * kGrowth};
  }

  /// Whether the exact number is surely 0.
  [[nodiscard]] bool is_zero() const { return value == 0.0 && error == 0.0; }

 private:
  static constexpr double kGrowth = 1.0 + 0x1p-49;
  friend Bounded square_root(const Bounded& a);
};

/// The exact difference of two doubles, p - q.
[[nodiscard]] inline Bounded bounded_difference(double p, double q) {
  const double difference = p - q;
  return {difference, filter::kHalfUlp * std::abs(difference)};
}

/// The square root. Requires: the exact number is not negative.
///
/// Let v be the value and e its error. If v > 2 e, the roots of v and of the exact number differ by at most e /
/// sqrt(v). Otherwise both roots lie between 0 and sqrt(v + e).
[[nodiscard]] inline Bounded square_root(const Bounded& a) {
  if (a.is_zero()) return {};
  const double root = std::sqrt(std::max(a.value, 0.0));
  if (a.value > 2.0 * a.error) return {root, (a.error / root + filter::kHalfUlp * root) * Bounded::kGrowth};
  return {root, std::sqrt(std::max(a.value, 0.0) + a.error) * Bounded::kGrowth};
}

/// The sign of the exact number, or nothing if the error could hide it.
[[nodiscard]] inline std::optional<Sign> sign_if_sure(const Bounded& number) {
  if (number.value > number.error) return Sign::positive;
  if (-number.value > number.error) return Sign::negative;
  if (number.is_zero()) return Sign::zero;
  return std::nullopt;
}

}  // namespace waywright::exact

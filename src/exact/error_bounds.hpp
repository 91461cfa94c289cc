#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/ieee.hpp"
#include "exact/filter.hpp"
#include "exact/position.hpp"

// Doubles that carry a proven error bound, for polynomials in differences of coordinates. The compiler derives the
// bound from the formula. Notation: u = 2^-53.
//
// Let a formula consist of differences of coordinates, sums, differences and products. Multiplied out, it is a sum of
// monomials. A computed difference of coordinates is the exact one times (1 + e) with |e| <= u. Each later operation
// multiplies every monomial of its result by one more factor of the form (1 + e). So the computed value is the sum of
// the exact monomials, each times a product of at most k factors (1 + e). The template parameter kRoundings is this k:
//   for a difference of coordinates: 1;
//   for a product: the sum of the k of both factors, plus 1;
//   for a sum or difference: the larger k of its two terms, plus 1.
// Let m be the sum of the magnitudes of the monomials. Then the error is at most ((1 + u)^k - 1) m. The member
// `magnitude` is m, computed by the same operations, so that it is at least (1 - u)^k m. So the error is at most
//   ((1 + u)^k - 1) / (1 - u)^k magnitude <= (k + 2 k^2 u) u magnitude for k <= 1000,
// which is less than the computed (k + 1) u magnitude.
//
// Underflow. kDegree says that the value is a multiple of 2^(-152 kDegree). It is 1 for differences of coordinates in
// range (point.hpp), and the degrees of factors add up. Rounding keeps a multiple of a power of two a multiple, unless
// the result is subnormal. So up to degree 6 all values are 0 or at least 2^-912: nothing underflows, not even the
// error bound, and a magnitude of 0 proves that the value is 0. Values of degree 7 or 8 are products of smaller
// degrees, or sums of a few of these, and are not multiplied again (the code asserts this). Each of these products
// loses at most 2^-1074 by underflow, in the value and in the magnitude, and sums lose nothing by underflow. So the
// code trusts the sign of such a value only if it exceeds the bound by 2^-1000.
//
// Crossings. The stored coordinate of a crossing is the exact one times (1 + e) with |e| <= u, because it is rounded to
// nearest (and not subnormal, see below). The subtraction of a coordinate multiplies it by one more factor. So k is 2,
// and the difference has two monomials: the two exact coordinates. For the degree, an exact coordinate of a crossing is
// a fraction (homogeneous.hpp). Its numerator is 0 or at least 2^-456, because it is a sum of products of three
// multiples of 2^-152. Its denominator is a cross product of two differences, at most 2^203. So the coordinate is 0 or
// at least 2^-659, the stored one is a multiple of 2^-711, and the difference has degree 5.
//
// Overflow. Differences of coordinates in range are at most 2^101, so values of degree 8 with a few terms are less than
// 2^900. A coordinate of a crossing is less than 2^610: it is a + t b / w, with a coordinate a, a cross product t and a
// difference b, and w is at least 2^-304. Its differences are multiplied by one difference of coordinates only.

namespace waywright::exact {

/// A double with a bound on its error.
template <int kRoundings, int kDegree>
struct Rounded {
  static_assert(kRoundings <= 1000 && kDegree <= 8);
  double value;
  double magnitude;
};

/// A double without an error: a coordinate.
struct ExactDouble {
  double value;

  [[nodiscard]] friend Rounded<1, 1> operator-(const ExactDouble& a, const ExactDouble& b) {
    const double difference = a.value - b.value;
    return {difference, std::abs(difference)};
  }
};

/// A coordinate of a crossing, rounded to the nearest double.
struct NearestDouble {
  double value;

  [[nodiscard]] friend Rounded<2, 5> operator-(const NearestDouble& a, const ExactDouble& b) {
    return {a.value - b.value, std::abs(a.value) + std::abs(b.value)};
  }
};

template <int kA, int kDegreeA, int kB, int kDegreeB>
[[nodiscard]] Rounded<std::max(kA, kB) + 1, std::max(kDegreeA, kDegreeB)> operator+(const Rounded<kA, kDegreeA>& a,
                                                                                    const Rounded<kB, kDegreeB>& b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}

template <int kA, int kDegreeA, int kB, int kDegreeB>
[[nodiscard]] Rounded<std::max(kA, kB) + 1, std::max(kDegreeA, kDegreeB)> operator-(const Rounded<kA, kDegreeA>& a,
                                                                                    const Rounded<kB, kDegreeB>& b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}

template <int kA, int kDegreeA, int kB, int kDegreeB>
[[nodiscard]] Rounded<kA + kB + 1, kDegreeA + kDegreeB> operator*(const Rounded<kA, kDegreeA>& a,
                                                                  const Rounded<kB, kDegreeB>& b) {
  static_assert(kDegreeA <= 6 && kDegreeB <= 6, "a product that may have underflowed is not multiplied again");
  return {a.value * b.value, a.magnitude * b.magnitude};
}

/// The sign of the exact value, or nothing if the error could hide it.
template <int kRoundings, int kDegree>
[[nodiscard]] std::optional<Sign> sign_if_sure(const Rounded<kRoundings, kDegree>& number) {
  constexpr bool kMayUnderflow = kDegree > 6;
  const double error =
      (kRoundings + 1) * filter::kHalfUlp * number.magnitude + (kMayUnderflow ? filter::kUnderflow : 0.0);
  if (number.value > error) return Sign::positive;
  if (-number.value > error) return Sign::negative;
  if (!kMayUnderflow && number.magnitude == 0.0) return Sign::zero;
  return std::nullopt;
}

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

#include "exact/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "exact/doubles.hpp"
#include "exact/homogeneous.hpp"
#include "exact/offsets.hpp"
#include "exact/position.hpp"
#include "exact/wide_integer.hpp"

namespace waywright::exact {

namespace {

struct IntegerPoint {
  Integer x, y;
};

IntegerPoint to_integers(const Point& point, int lattice_exponent) {
  return {to_integer(point.x, lattice_exponent), to_integer(point.y, lattice_exponent)};
}

IntegerPoint operator-(const IntegerPoint& p, const IntegerPoint& q) { return {p.x - q.x, p.y - q.y}; }

Integer cross(const IntegerPoint& u, const IntegerPoint& v) { return u.x * v.y - u.y * v.x; }

}  // namespace

// The point a + t (b - a) lies on the line through c and d if t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
Homogeneous to_homogeneous(const Crossing& crossing, int lattice_exponent) {
  const IntegerPoint a = to_integers(crossing.ab.a, lattice_exponent);
  const IntegerPoint c = to_integers(crossing.cd.a, lattice_exponent);
  const IntegerPoint ab = to_integers(crossing.ab.b, lattice_exponent) - a;
  const IntegerPoint cd = to_integers(crossing.cd.b, lattice_exponent) - c;
  Integer w = cross(ab, cd);
  Integer t = cross(c - a, cd);
  if (w < 0) {
    w = -w;
    t = -t;
  }
  return {a.x * w + t * ab.x, a.y * w + t * ab.y, w};
}

Homogeneous to_homogeneous(const ExactPosition& point, int lattice_exponent) {
  if (!point.is_explicit()) return to_homogeneous(point.crossing(), lattice_exponent);
  return {to_integer(point.x, lattice_exponent), to_integer(point.y, lattice_exponent), Integer{1}};
}

namespace {

struct RoundedNumber {
  double nearest = 0.0;
  bool is_exact = true;
};

/// The leading 55 or 56 bits of a quotient; the whole quotient if the division leaves no remainder.
struct Quotient {
  std::uint64_t bits;
  bool has_remainder;
};

// Sets the last of at least 55 bits if the division left a remainder. The bits then are the 53 bits that a double
// keeps, the bit that decides the rounding, and a sticky bit: the conversion to double rounds them like the exact
// quotient. Results are at least 2^-700, so none is subnormal.
RoundedNumber round(const Quotient& quotient, int exponent, bool is_negative) {
  const std::uint64_t bits = quotient.bits | (quotient.has_remainder ? 1 : 0);
  const auto rounded = static_cast<double>(bits);
  const bool is_exact = !quotient.has_remainder && static_cast<std::uint64_t>(rounded) == bits;
  const double nearest = rounded * power_of_two(exponent);
  return {is_negative ? -nearest : nearest, is_exact};
}

/// The number of bits by which to shift the numerator for a quotient of 55 or 56 bits. If it is negative: shift the
/// denominator by its absolute value instead.
int shift_for(int numerator_bits, int denominator_bits) { return 55 + denominator_bits - numerator_bits; }

RoundedNumber round_quotient(const Integer& numerator, const Integer& denominator, int exponent) {
  if (numerator == 0) return {};
  const Integer magnitude = abs(numerator);
  const int shift = shift_for(static_cast<int>(msb(magnitude)), static_cast<int>(msb(denominator)));
  Integer quotient;
  Integer remainder;
  if (shift >= 0) {
    divide_qr(Integer(magnitude << static_cast<unsigned>(shift)), denominator, quotient, remainder);
  } else {
    divide_qr(magnitude, Integer(denominator << static_cast<unsigned>(-shift)), quotient, remainder);
  }
  return round({static_cast<std::uint64_t>(quotient), remainder != 0}, exponent - shift, numerator < 0);
}

/// Guesses the quotient in doubles and corrects the guess by the remainder. Requires: both numbers are non-negative,
/// the quotient is less than 2^57.
template <std::size_t kLimbs>
Quotient divide(const WideInteger<kLimbs>& numerator, const WideInteger<kLimbs>& denominator) {
  const double divisor = denominator.approximate();
  auto quotient = static_cast<std::int64_t>(numerator.approximate() / divisor);
  const auto times = [&](std::int64_t factor) {
    return (WideInteger<1>(factor) * denominator).template resize<kLimbs>();
  };
  WideInteger<kLimbs> remainder = numerator - times(quotient);
  const auto missed = static_cast<std::int64_t>(remainder.approximate() / divisor);
  quotient += missed;
  remainder -= times(missed);
  for (; remainder.is_negative(); --quotient) remainder += denominator;
  for (; !(remainder - denominator).is_negative(); ++quotient) remainder -= denominator;
  return {static_cast<std::uint64_t>(quotient), remainder.sign() != Sign::zero};
}

// A shifted numerator has at most 56 bits more than the denominator. It fits, because coordinates have one limb more
// than denominators.
template <std::size_t kW>
RoundedNumber round_quotient(const WideInteger<kW + 1>& numerator, const WideInteger<kW>& denominator, int exponent) {
  if (numerator.sign() == Sign::zero) return {};
  const WideInteger<kW + 1> magnitude = numerator.is_negative() ? -numerator : numerator;
  const auto divisor = denominator.template resize<kW + 1>();
  const int shift = shift_for(magnitude.bit_width(), denominator.bit_width());
  const Quotient quotient = shift >= 0 ? divide(magnitude << shift, divisor) : divide(magnitude, divisor << -shift);
  return round(quotient, exponent - shift, numerator.is_negative());
}

/// Rounds both coordinates. Works with every type of integers that has round_quotient().
template <class Number, class Denominator>
RoundedCrossing round_both(const Number& x, const Number& y, const Denominator& w, int x_exponent, int y_exponent) {
  const RoundedNumber rounded_x = round_quotient(x, w, x_exponent);
  const RoundedNumber rounded_y = round_quotient(y, w, y_exponent);
  const Point nearest{rounded_x.nearest, rounded_y.nearest};
  return {nearest, rounded_x.is_exact && rounded_y.is_exact && is_in_range(nearest)};
}

template <std::size_t kW>
RoundedCrossing round_on(const Offsets<4>& corners) {
  const LatticePoint<kW> point = lattice_crossing<kW>(corners[0], corners[1], corners[2], corners[3]);
  return round_both(point.x, point.y, point.w, corners.x_exponent(), corners.y_exponent());
}

std::string to_fraction(Integer numerator, Integer denominator, int exponent) {
  if (exponent >= 0) {
    numerator <<= static_cast<unsigned>(exponent);
  } else {
    denominator <<= static_cast<unsigned>(-exponent);
  }
  const Integer divisor = gcd(numerator, denominator);
  return Integer(numerator / divisor).str() + ' ' + Integer(denominator / divisor).str();
}

}  // namespace

namespace doubles {

namespace {

constexpr double kLargestExact = 0x1p53;

bool are_whole(const Crossing& crossing) {
  Point fractions{};
  for (const Point& p : {crossing.ab.a, crossing.ab.b, crossing.cd.a, crossing.cd.b}) {
    fractions.x += std::abs(fraction(p.x));
    fractions.y += std::abs(fraction(p.y));
  }
  return fractions.x + fractions.y == 0.0;
}

/// Whether the rounded quotient equals the exact quotient.
bool is_quotient(double rounded, double numerator, double denominator) {
  const Twofold product = multiply_exactly(rounded, denominator);
  return product.rounded == numerator && product.error == 0.0;
}

double magnitude(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

}  // namespace

// All numbers here are whole, so a number below 2^53 was not rounded (see is_whole). It is enough to test the results.
// A number that is only a factor of a product needs no test of its own. There are three cases: the number is 0; its
// absolute value is at most the absolute value of the product; or the other factor is 0, and then the rounding of the
// number has no effect. The numerators and w are exact, so IEEE division rounds their quotients correctly.
std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing) {
  const auto& [a, b] = crossing.ab;
  const auto& [c, d] = crossing.cd;
  if (!are_whole(crossing)) return std::nullopt;
  const Point ab{b.x - a.x, b.y - a.y};
  const Point ac{c.x - a.x, c.y - a.y};
  const Point cd{d.x - c.x, d.y - c.y};
  const Point w_terms{ab.x * cd.y, ab.y * cd.x};
  const Point t_terms{ac.x * cd.y, ac.y * cd.x};
  const double w = w_terms.x - w_terms.y;
  const double t = t_terms.x - t_terms.y;
  const Point bases{a.x * w, a.y * w};
  const Point steps{t * ab.x, t * ab.y};
  const Point numerator{bases.x + steps.x, bases.y + steps.y};
  const double largest =
      std::max(std::max(std::max(magnitude(w_terms), magnitude(t_terms)), std::max(magnitude(bases), magnitude(steps))),
               std::max(magnitude(numerator), std::abs(w)));
  if (!(largest < kLargestExact)) return std::nullopt;
  const Point nearest{numerator.x / w + 0.0, numerator.y / w + 0.0};  // adding 0 changes -0 into 0
  const bool is_exact = is_quotient(nearest.x, numerator.x, w) && is_quotient(nearest.y, numerator.y, w);
  return RoundedCrossing{nearest, is_exact};
}

}  // namespace doubles

namespace lattice {

std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing) {
  Offsets<4> corners({0.0, 0.0});
  for (const Point& end : {crossing.ab.a, crossing.ab.b, crossing.cd.a, crossing.cd.b}) corners.add(end);
  if (!corners.find_any_lattice()) return std::nullopt;
  return corners.bits() <= kNarrowBits ? round_on<1>(corners) : round_on<2>(corners);
}

}  // namespace lattice

namespace integers {

RoundedCrossing round_to_nearest(const Crossing& crossing) {
  LatticeExponent lattice;
  lattice.include(crossing);
  const Homogeneous point = to_homogeneous(crossing, lattice.value());
  return round_both(point.x, point.y, point.w, lattice.value(), lattice.value());
}

}  // namespace integers

Point round_to_nearest(const Homogeneous& point, int lattice_exponent) {
  return round_both(point.x, point.y, point.w, lattice_exponent, lattice_exponent).nearest;
}

RoundedCrossing detail::round_other_to_nearest(const Crossing& crossing) {
  if (const auto rounded = doubles::round_to_nearest(crossing)) {
    ++counts.crossing.doubles;
    return *rounded;
  }
  if (const auto rounded = lattice::round_to_nearest(crossing)) {
    ++counts.crossing.lattice;
    return *rounded;
  }
  ++counts.crossing.integers;
  return integers::round_to_nearest(crossing);
}

std::string to_fractions(const ExactPosition& point) {
  LatticeExponent lattice;
  lattice.include(point);
  const Homogeneous exact = to_homogeneous(point, lattice.value());
  return to_fraction(exact.x, exact.w, lattice.value()) + ' ' + to_fraction(exact.y, exact.w, lattice.value());
}

}  // namespace waywright::exact

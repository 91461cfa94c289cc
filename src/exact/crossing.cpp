#include "exact/crossing.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "exact/homogeneous.hpp"

namespace waywright::exact {

namespace {

struct RoundedNumber {
  double nearest = 0.0;
  bool is_exact = true;
};

// A quotient of at least 55 bits, its last bit set where the division left a remainder, rounds as the true value does:
// the 53 bits kept, the one that decides, and a sticky one. Results are at least 2^-700, so none is subnormal.
RoundedNumber round_quotient(const Integer& numerator, const Integer& denominator, int exponent) {
  if (numerator == 0) return {};
  const Integer magnitude = abs(numerator);
  const int shift = 55 + static_cast<int>(msb(denominator)) - static_cast<int>(msb(magnitude));
  Integer quotient;
  Integer remainder;
  if (shift >= 0) {
    divide_qr(Integer(magnitude << static_cast<unsigned>(shift)), denominator, quotient, remainder);
  } else {
    divide_qr(magnitude, Integer(denominator << static_cast<unsigned>(-shift)), quotient, remainder);
  }
  auto bits = static_cast<std::uint64_t>(quotient);
  if (remainder != 0) bits |= 1;
  const auto rounded = static_cast<double>(bits);
  const bool is_exact = remainder == 0 && static_cast<std::uint64_t>(rounded) == bits;
  const double nearest = std::ldexp(rounded, exponent - shift);
  return {numerator < 0 ? -nearest : nearest, is_exact};
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

RoundedCrossing round_to_nearest(const Crossing& crossing) {
  LatticeExponent lattice;
  lattice.include(crossing);
  const Homogeneous point = to_homogeneous(crossing, lattice.value());
  const RoundedNumber x = round_quotient(point.x, point.w, lattice.value());
  const RoundedNumber y = round_quotient(point.y, point.w, lattice.value());
  const Point nearest{x.nearest, y.nearest};
  return {nearest, x.is_exact && y.is_exact && in_range(nearest)};
}

std::string to_fractions(const ExactPoint& point) {
  LatticeExponent lattice;
  lattice.include(point);
  const Homogeneous exact = to_homogeneous(point, lattice.value());
  return to_fraction(exact.x, exact.w, lattice.value()) + ' ' + to_fraction(exact.y, exact.w, lattice.value());
}

}  // namespace waywright::exact

#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

#include "base/compiler.hpp"
#include "exact/position.hpp"

namespace waywright::exact {

/// An integer of arbitrary precision. It uses no expression templates, so `auto` and the operator ?: have the type
/// Integer.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// A double, written as mantissa * 2^exponent. The mantissa is odd, or 0 for 0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

/// Requires: `value` is finite and not subnormal.
[[nodiscard]] inline Dyadic to_dyadic(double value) {
  if (value == 0.0) return {};
  const auto bits = base::bit_cast<std::uint64_t>(value);
  const auto fraction = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
  const int zeros = std::countr_zero(fraction);
  const auto magnitude = static_cast<std::int64_t>(fraction >> zeros);
  const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1075 + zeros;
  return {value < 0 ? -magnitude : magnitude, exponent};
}

/// The exponent of the coarsest lattice that contains all coordinates passed to include(): the largest power of two of
/// which all of them are multiples.
class LatticeExponent {
 public:
  void include(double value) {
    if (value != 0.0) exponent_ = std::min(exponent_, to_dyadic(value).exponent);
  }
  void include(const Point& point) {
    include(point.x);
    include(point.y);
  }
  void include(const ExactPosition& point) {
    if (point.is_explicit()) {
      include(Point{point.x, point.y});
    } else {
      include(*point.ab);
      include(*point.cd);
    }
  }
  void include(const PointPair& points) {
    include(points.a);
    include(points.b);
  }
  void include(const Crossing& crossing) {
    include(crossing.ab);
    include(crossing.cd);
  }
  [[nodiscard]] int value() const { return exponent_ == kNothingSeen ? 0 : exponent_; }

 private:
  static constexpr int kNothingSeen = std::numeric_limits<int>::max();
  int exponent_ = kNothingSeen;
};

/// The point (x / w, y / w), with w > 0. The unit is 2^lattice_exponent, where `lattice_exponent` is the argument of
/// the function that has made the object.
struct Homogeneous {
  Integer x, y, w;
};

/// Requires: `value` is a multiple of 2^lattice_exponent.
[[nodiscard]] inline Integer to_integer(double value, int lattice_exponent) {
  const Dyadic dyadic = to_dyadic(value);
  if (dyadic.mantissa == 0) return Integer{0};
  return Integer{dyadic.mantissa} << static_cast<unsigned>(dyadic.exponent - lattice_exponent);
}

[[nodiscard]] Homogeneous to_homogeneous(const Crossing& crossing, int lattice_exponent);
[[nodiscard]] Homogeneous to_homogeneous(const ExactPosition& point, int lattice_exponent);

/// Rounds each coordinate to the nearest double. Requires: no result is subnormal.
[[nodiscard]] Point round_to_nearest(const Homogeneous& point, int lattice_exponent);

/// An integer of at most kBits bits. It lies on the stack, so it allocates nothing. Requires: no result has more bits.
template <unsigned kBits>
using StackInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<kBits, kBits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// Requires: the number is a multiple of 2^lattice_exponent.
template <unsigned kBits>
[[nodiscard]] StackInteger<kBits> to_stack_integer(const Dyadic& number, int lattice_exponent) {
  if (number.mantissa == 0) return StackInteger<kBits>{0};
  return StackInteger<kBits>{number.mantissa} << static_cast<unsigned>(number.exponent - lattice_exponent);
}

}  // namespace waywright::exact

#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/gap.hpp"
#include "exact/homogeneous.hpp"

namespace waywright::exact {

namespace {

/// An integer on the stack. An offset between coordinates in range has at most 253 bits on their lattice, so the square
/// of the length of a gap is a fraction with at most 1,014 bits above and 507 bits below.
using StackInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<2048, 2048, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

StackInteger to_stack_integer(double value, int lattice_exponent) {
  const Dyadic dyadic = to_dyadic(value);
  if (dyadic.mantissa == 0) return StackInteger{0};
  return StackInteger{dyadic.mantissa} << static_cast<unsigned>(dyadic.exponent - lattice_exponent);
}

/// The square of the length of a gap: above / below, in units of 2^(2 exponent).
class SquaredLength {
 public:
  explicit SquaredLength(const Gap& gap) {
    LatticeExponent lattice;
    for (const Point& point : {gap.from, gap.a, gap.b}) lattice.include(point);
    exponent_ = lattice.value();
    const auto difference = [&](double p, double q) {
      return StackInteger{to_stack_integer(p, exponent_) - to_stack_integer(q, exponent_)};
    };
    const StackInteger x = difference(gap.a.x, gap.from.x);
    const StackInteger y = difference(gap.a.y, gap.from.y);
    if (!gap.has_foot()) {
      above_ = x * x + y * y;
      below_ = 1;
      return;
    }
    const StackInteger ab_x = difference(gap.b.x, gap.a.x);
    const StackInteger ab_y = difference(gap.b.y, gap.a.y);
    const StackInteger area = x * ab_y - y * ab_x;
    above_ = area * area;
    below_ = ab_x * ab_x + ab_y * ab_y;
  }

  /// Whether the diameter of a disc is larger than the length. Requires: the radius is half the length up to a few
  /// ulps. So the two sides of the comparison have about the same number of bits.
  [[nodiscard]] bool is_less_than_diameter(double radius) const {
    const Dyadic dyadic = to_dyadic(radius);
    const StackInteger squared_mantissa = StackInteger{dyadic.mantissa} * StackInteger{dyadic.mantissa};
    const int shift = 2 * (exponent_ - dyadic.exponent - 1);
    if (shift >= 0) return StackInteger{above_ << static_cast<unsigned>(shift)} < squared_mantissa * below_;
    return above_ < StackInteger{(squared_mantissa * below_) << static_cast<unsigned>(-shift)};
  }

 private:
  int exponent_ = 0;
  StackInteger above_;
  StackInteger below_;
};

}  // namespace

double largest_radius(const Gap& gap) {
  const SquaredLength squared_length(gap);
  double radius = 0.5 * length(gap);
  while (squared_length.is_less_than_diameter(radius)) radius = std::nextafter(radius, 0.0);
  for (;;) {
    const double larger = std::nextafter(radius, std::numeric_limits<double>::infinity());
    if (squared_length.is_less_than_diameter(larger)) return radius;
    radius = larger;
  }
}

}  // namespace waywright::exact

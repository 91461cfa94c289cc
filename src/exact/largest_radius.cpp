#include <cmath>
#include <limits>

#include "exact/gap.hpp"
#include "exact/homogeneous.hpp"
#include "exact/stack_integer.hpp"

namespace waywright::exact {

namespace {

/// An offset between coordinates in range has at most 253 bits on their lattice, so the square of the length of a gap
/// is a fraction with at most 1,014 bits above and 507 bits below.
using Length = StackInteger<2048>;

/// The square of the length of a gap: above / below, in units of 2^(2 exponent).
class SquaredLength {
 public:
  explicit SquaredLength(const Gap& gap) {
    LatticeExponent lattice;
    for (const Point& point : {gap.from, gap.a, gap.b}) lattice.include(point);
    exponent_ = lattice.value();
    const auto difference = [&](double p, double q) {
      return Length{to_stack_integer<2048>(to_dyadic(p), exponent_) - to_stack_integer<2048>(to_dyadic(q), exponent_)};
    };
    const Length x = difference(gap.a.x, gap.from.x);
    const Length y = difference(gap.a.y, gap.from.y);
    if (!gap.has_foot()) {
      above_ = x * x + y * y;
      below_ = 1;
      return;
    }
    const Length ab_x = difference(gap.b.x, gap.a.x);
    const Length ab_y = difference(gap.b.y, gap.a.y);
    const Length area = x * ab_y - y * ab_x;
    above_ = area * area;
    below_ = ab_x * ab_x + ab_y * ab_y;
  }

  /// Whether the diameter of a disc is larger than the length. Requires: the radius is half the length up to a few
  /// ulps. So the two numbers that it compares have about the same number of bits.
  [[nodiscard]] bool is_less_than_diameter(double radius) const {
    const Dyadic dyadic = to_dyadic(radius);
    const Length squared_mantissa = Length{dyadic.mantissa} * Length{dyadic.mantissa};
    const int shift = 2 * (exponent_ - dyadic.exponent - 1);
    if (shift >= 0) return Length{above_ << static_cast<unsigned>(shift)} < squared_mantissa * below_;
    return above_ < Length{(squared_mantissa * below_) << static_cast<unsigned>(-shift)};
  }

 private:
  int exponent_ = 0;
  Length above_;
  Length below_;
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

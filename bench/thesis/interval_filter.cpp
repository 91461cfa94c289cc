// A separate source, because it is compiled with -frounding-math, which must not apply to inline functions elsewhere.
#include "thesis/interval_filter.hpp"

#include <boost/numeric/interval.hpp>

namespace waywright::bench {
namespace {

// Sets the rounding mode to upwards once for each question, not once for each operation: the fast method of Boost.
using Checked = boost::numeric::interval<double>;
using Rounding = Checked::traits_type::rounding;
using Interval = boost::numeric::interval_lib::unprotect<Checked>::type;

struct Offset {
  Interval x;
  Interval y;
};

Interval interval(const Bounds& bounds) { return {bounds.low, bounds.high}; }

Offset difference(const BoundedPoint& p, const BoundedPoint& q) {
  return {interval(p.x) - interval(q.x), interval(p.y) - interval(q.y)};
}

Interval determinant(const Offset& p, const Offset& q) { return p.x * q.y - q.x * p.y; }

Interval lift(const Offset& p) { return square(p.x) + square(p.y); }

std::optional<exact::Sign> sign(const Interval& value) {
  if (value.lower() > 0.0) return exact::Sign::positive;
  if (value.upper() < 0.0) return exact::Sign::negative;
  if (value.lower() == 0.0 && value.upper() == 0.0) return exact::Sign::zero;
  return std::nullopt;
}

}  // namespace

std::optional<exact::Sign> orientation(const BoundedPoint& a, const BoundedPoint& b, const BoundedPoint& c) {
  const Rounding upwards;
  return sign(determinant(difference(a, c), difference(b, c)));
}

std::optional<exact::Sign> in_circle(const BoundedPoint& a, const BoundedPoint& b, const BoundedPoint& c,
                                     const BoundedPoint& d) {
  const Rounding upwards;
  const Offset ad = difference(a, d);
  const Offset bd = difference(b, d);
  const Offset cd = difference(c, d);
  return sign(lift(ad) * determinant(bd, cd) + lift(bd) * determinant(cd, ad) + lift(cd) * determinant(ad, bd));
}

}  // namespace waywright::bench

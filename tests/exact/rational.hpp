#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/position.hpp"

/// Plain rationals and the textbook formulas. Tests compare the predicates with them.
namespace waywright::test {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x, y;
};

inline RationalPoint rational(const Point& p) { return {Rational(p.x), Rational(p.y)}; }

inline RationalPoint rational(const exact::ExactPosition& p) {
  if (p.is_explicit()) return rational(Point{p.x, p.y});
  // Cramer's rule on the equations n . p = k of the two lines.
  const RationalPoint pa = rational(p.ab->a), pb = rational(p.ab->b), pc = rational(p.cd->a), pd = rational(p.cd->b);
  const Rational n1x = pa.y - pb.y, n1y = pb.x - pa.x, k1 = n1x * pa.x + n1y * pa.y;
  const Rational n2x = pc.y - pd.y, n2y = pd.x - pc.x, k2 = n2x * pc.x + n2y * pc.y;
  const Rational determinant = n1x * n2y - n2x * n1y;
  return {(k1 * n2y - k2 * n1y) / determinant, (n1x * k2 - n2x * k1) / determinant};
}

inline exact::Sign sign_of_rational(const Rational& value) {
  return value > 0 ? exact::Sign::positive : value < 0 ? exact::Sign::negative : exact::Sign::zero;
}

inline exact::Sign rational_orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return sign_of_rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The 4 x 4 determinant of (x, y, x^2 + y^2, 1), expanded along the column of x^2 + y^2.
inline exact::Sign rational_in_circle(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                                      const RationalPoint& d) {
  const auto lift = [](const RationalPoint& p) -> Rational { return p.x * p.x + p.y * p.y; };
  const auto area = [](const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) -> Rational {
    return p.x * (q.y - r.y) + q.x * (r.y - p.y) + r.x * (p.y - q.y);
  };
  const Rational determinant =
      lift(a) * area(b, c, d) - lift(b) * area(a, c, d) + lift(c) * area(a, b, d) - lift(d) * area(a, b, c);
  return sign_of_rational(determinant);
}

/// The centre of the circle through three points that lie on no line: Cramer's rule on 2 (b - a) . centre = b^2 - a^2
/// and 2 (c - a) . centre = c^2 - a^2.
inline RationalPoint centre_of_circle(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  const auto square = [](const RationalPoint& p) -> Rational { return p.x * p.x + p.y * p.y; };
  const Rational bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Rational k1 = square(b) - square(a), k2 = square(c) - square(a), determinant = 2 * (bx * cy - by * cx);
  return {(k1 * cy - k2 * by) / determinant, (bx * k2 - cx * k1) / determinant};
}

inline exact::Sign rational_order(const RationalPoint& p, const RationalPoint& q) {
  return p.x != q.x ? sign_of_rational(p.x - q.x) : sign_of_rational(p.y - q.y);
}

}  // namespace waywright::test

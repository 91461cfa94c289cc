#include "thesis/rational_arithmetic.hpp"

#include <utility>

namespace waywright::bench {
namespace {

RationalPoint difference(const RationalPoint& p, const RationalPoint& q) { return {p.x - q.x, p.y - q.y}; }

mpq_class determinant(const RationalPoint& p, const RationalPoint& q) { return p.x * q.y - q.x * p.y; }

mpq_class lift(const RationalPoint& p) { return p.x * p.x + p.y * p.y; }

std::strong_ordering ordering(int comparison) { return comparison <=> 0; }

}  // namespace

exact::Sign orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return exact::sign_of(sgn(determinant(difference(a, c), difference(b, c))));
}

exact::Sign in_circle(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint ad = difference(a, d);
  const RationalPoint bd = difference(b, d);
  const RationalPoint cd = difference(c, d);
  const mpq_class whole =
      lift(ad) * determinant(bd, cd) + lift(bd) * determinant(cd, ad) + lift(cd) * determinant(ad, bd);
  return exact::sign_of(sgn(whole));
}

std::strong_ordering order(const RationalPoint& p, const RationalPoint& q) {
  const auto by_x = ordering(cmp(p.x, q.x));
  return by_x != 0 ? by_x : ordering(cmp(p.y, q.y));
}

RationalPoint crossing(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint ab = difference(b, a);
  const RationalPoint cd = difference(d, c);
  const mpq_class along = determinant(difference(c, a), cd) / determinant(ab, cd);
  return {a.x + along * ab.x, a.y + along * ab.y};
}

RationalArithmetic::Position RationalArithmetic::crossing(const Position& a, const Position& b, const Position& c,
                                                          const Position& d) {
  RationalPoint position = bench::crossing(a.exact, b.exact, c.exact, d.exact);
  const Point rounded = {position.x.get_d(), position.y.get_d()};
  return {std::move(position), rounded};
}

}  // namespace waywright::bench

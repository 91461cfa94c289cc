#include "exact/gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "exact/formula.hpp"
#include "exact/homogeneous.hpp"
#include "exact/integer.hpp"
#include "exact/power_of_two.hpp"
#include "exact/twofold.hpp"

namespace waywright::exact {

namespace formula {

namespace {

/// The denominator of a fraction that is a whole number.
struct One {
  template <class Number>
  friend Number operator*(const Number& number, One /*one*/) {
    return number;
  }
};

/// A fraction; its denominator is positive.
template <class Numerator, class Denominator>
struct Fraction {
  Numerator numerator;
  Denominator denominator;
};
template <class Numerator, class Denominator>
Fraction<Numerator, Denominator> fraction_of(const Numerator& numerator, const Denominator& denominator) {
  return {numerator, denominator};
}

template <class P, class Q>
std::optional<Sign> compare_fractions(const P& p, const Q& q) {
  return sign_if_sure(p.numerator * q.denominator - q.numerator * p.denominator);
}

/// The square of the distance from u to the line through a and b: (ab x ua)^2 / |ab|^2.
template <class Coordinate>
auto squared_distance_to_line(const Site<Coordinate>& u, const Site<Coordinate>& a, const Site<Coordinate>& b) {
  const auto ab = b - a;
  const auto area = cross_product(ab, a - u);
  return fraction_of(area * area, square(ab));
}

/// The square of the length of a gap.
template <bool kHasFoot, class Coordinate>
auto squared_length_of(const Site<Coordinate>& from, const Site<Coordinate>& a, const Site<Coordinate>& b) {
  if constexpr (kHasFoot) {
    return squared_distance_to_line(from, a, b);
  } else {
    return fraction_of(square(a - from), One{});
  }
}

/// Calls compare() with the square of the distance from c to the segment from a to b, and returns its result. If a
/// equals b, the first product is 0.
template <class Coordinate, class Compare>
std::optional<Sign> with_squared_distance(const Site<Coordinate>& c, const Site<Coordinate>& a,
                                          const Site<Coordinate>& b, const Compare& compare) {
  const auto ab = b - a;
  const auto after_a = sign_if_sure(dot_product(ab, c - a));
  if (!after_a) return std::nullopt;
  if (*after_a != Sign::positive) return compare(fraction_of(square(c - a), One{}));
  const auto before_b = sign_if_sure(dot_product(ab, b - c));
  if (!before_b) return std::nullopt;
  if (*before_b != Sign::positive) return compare(fraction_of(square(c - b), One{}));
  return compare(squared_distance_to_line(c, a, b));
}

struct DotFormula {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<Sign> answer(const Sites<Coordinate, 4>& sites) {
    const auto& [p, q, a, b] = sites;
    return sign_if_sure(dot_product(q - p, b - a));
  }
};

template <bool kHasFoot>
struct CompareToDiameter {
  static constexpr bool kHasRadius = true;
  template <class Coordinate, class Radius>
  static std::optional<Sign> answer(const Sites<Coordinate, kHasFoot ? 3 : 2>& sites, const Radius& radius) {
    const auto diameter = radius + radius;
    const auto limit = fraction_of(diameter * diameter, One{});
    return compare_fractions(squared_length_of<kHasFoot>(sites.front(), sites[1], sites.back()), limit);
  }
};

template <bool kFirstHasFoot, bool kSecondHasFoot>
struct CompareLengths {
  static constexpr bool kHasRadius = false;
  static constexpr std::size_t kFirst = kFirstHasFoot ? 3 : 2;
  template <class Coordinate>
  static std::optional<Sign> answer(const Sites<Coordinate, kFirst + (kSecondHasFoot ? 3 : 2)>& sites) {
    return compare_fractions(squared_length_of<kFirstHasFoot>(sites.front(), sites[1], sites[kFirst - 1]),
                             squared_length_of<kSecondHasFoot>(sites[kFirst], sites[kFirst + 1], sites.back()));
  }
};

struct CompareDistance {
  static constexpr bool kHasRadius = true;
  template <class Coordinate, class Radius>
  static std::optional<Sign> answer(const Sites<Coordinate, 3>& sites, const Radius& radius) {
    const auto& [c, a, b] = sites;
    return with_squared_distance(
        c, a, b, [&](const auto& squared) { return compare_fractions(squared, fraction_of(radius * radius, One{})); });
  }
};

struct CompareDistances {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<Sign> answer(const Sites<Coordinate, 5>& sites) {
    const auto& [c, a1, b1, a2, b2] = sites;
    return with_squared_distance(c, a1, b1, [&, &o = c, &a = a2, &b = b2](const auto& first) {
      return with_squared_distance(o, a, b, [&](const auto& second) { return compare_fractions(first, second); });
    });
  }
};

/// Replaces a radius by another one for which every comparison of this file has the same result: a length that is not 0
/// is between 2^-406 and 2^102. (An area is 0 or at least 2^-304, and the line has at most the length 2^101.5.)
constexpr double kSmallestRadius = 0x1p-500;
constexpr double kLargestRadius = 0x1p103;
double bounded(double radius) { return radius == 0.0 ? 0.0 : std::clamp(radius, kSmallestRadius, kLargestRadius); }

/// The numbers of a gap with a foot, on the common lattice of its points: ab, M = |ab|^2 and X = ab x (a - from).
struct IntegerFoot {
  explicit IntegerFoot(const Gap& gap) {
    LatticeExponent lattice;
    for (const Point& point : {gap.from, gap.a, gap.b}) lattice.include(point);
    exponent = lattice.value();
    const auto site = [&](const Point& p) {
      return Site<Integer>{to_integer(p.x, exponent), to_integer(p.y, exponent)};
    };
    from = site(gap.from);
    const Site<Integer> a = site(gap.a);
    ab = site(gap.b) - a;
    m = square(ab);
    x = cross_product(ab, a - from);
  }

  int exponent;
  Site<Integer> from;
  Vector<Integer> ab;
  Integer m;
  Integer x;
};

/// The exact vector from p to q.
Vector<Twofold> subtract_exactly(const Point& q, const Point& p) {
  return {exact::subtract_exactly(q.x, p.x), exact::subtract_exactly(q.y, p.y)};
}

/// Returns p q - r s, up to two units of relative error 2^-53. Returns nothing if too much cancels. Requires: the
/// numbers are differences of coordinates.
///
/// The exact result is the difference of the rounded products, which is again a Twofold, and a rest: the errors of the
/// products, and products with an error as a factor. Each of the additions and products that compute the rest loses at
/// most 2^-53 of the sum of the magnitudes of the terms.
std::optional<double> determinant(const Twofold& p, const Twofold& q, const Twofold& r, const Twofold& s) {
  const Twofold pq = multiply_exactly(p.rounded, q.rounded);
  const Twofold rs = multiply_exactly(r.rounded, s.rounded);
  const Twofold difference = exact::subtract_exactly(pq.rounded, rs.rounded);
  const std::array terms{difference.error,
                         pq.error,
                         -rs.error,
                         p.rounded * q.error,
                         p.error * q.rounded,
                         p.error * q.error,
                         -r.rounded * s.error,
                         -r.error * s.rounded,
                         -r.error * s.error};
  double rest = 0.0;
  double magnitude = 0.0;
  for (const double term : terms) {
    rest += term;
    magnitude += std::abs(term);
  }
  const double result = difference.rounded + rest;
  if (16.0 * magnitude > std::abs(result)) return std::nullopt;
  return result;
}

/// The numbers M and X of a gap with a foot, as for IntegerFoot: up to a few ulps.
struct DoubleFoot {
  explicit DoubleFoot(const Gap& gap) {
    const auto ab = subtract_exactly(gap.b, gap.a);
    const auto from_a = subtract_exactly(gap.a, gap.from);
    m = ab.x.rounded * ab.x.rounded + ab.y.rounded * ab.y.rounded;
    if (const auto sure = determinant(ab.x, from_a.y, ab.y, from_a.x)) {
      x = *sure;
    } else {
      const IntegerFoot foot(gap);
      x = foot.x.convert_to<double>() * power_of_two(2 * foot.exponent);
    }
  }

  double m;
  double x;
};

// The formula for each predicate. `Run` says what to do with it: Decide or AskEachStage.

template <class Run>
auto run_compare_to_diameter(const Gap& gap, double radius) {
  const double limit = bounded(radius);
  if (!gap.has_foot()) return Run::template run<CompareToDiameter<false>>(std::array{gap.from, gap.a}, limit);
  return Run::template run<CompareToDiameter<true>>(std::array{gap.from, gap.a, gap.b}, limit);
}

template <class Run>
auto run_compare_lengths(const Gap& p, const Gap& q) {
  if (p.has_foot()) {
    if (q.has_foot()) {
      return Run::template run<CompareLengths<true, true>>(std::array{p.from, p.a, p.b, q.from, q.a, q.b});
    }
    return Run::template run<CompareLengths<true, false>>(std::array{p.from, p.a, p.b, q.from, q.a});
  }
  if (q.has_foot()) {
    return Run::template run<CompareLengths<false, true>>(std::array{p.from, p.a, q.from, q.a, q.b});
  }
  return Run::template run<CompareLengths<false, false>>(std::array{p.from, p.a, q.from, q.a});
}

template <class Run>
auto run_compare_distance(const Point& c, const Point& a, const Point& b, double radius) {
  return Run::template run<CompareDistance>(std::array{c, a, b}, bounded(radius));
}

template <class Run>
auto run_compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2, const Point& b2) {
  return Run::template run<CompareDistances>(std::array{c, a1, b1, a2, b2});
}

}  // namespace

}  // namespace formula

Sign detail::finer_dot(const Point& p, const Point& q, const Point& a, const Point& b) {
  return formula::decide_in_integers<formula::DotFormula>(std::array{p, q, a, b}, 0.0);
}

Sign detail::finer_dot(const Point& p, const Crossing& q, const Point& a, const Point& b) {
  LatticeExponent lattice;
  for (const Point& point : {p, a, b}) lattice.include(point);
  lattice.include(q);
  const int exponent = lattice.value();
  const auto site = [&](const Point& point) {
    return formula::Site<Integer>{to_integer(point.x, exponent), to_integer(point.y, exponent)};
  };
  const auto [x, y, w] = to_homogeneous(q, exponent);
  const auto from = site(p);
  return sign_of(dot_product(formula::vector<Integer>(x - from.x * w, y - from.y * w), site(b) - site(a)));
}

// All vectors start at w. If D is the other end of the diameter, then D . x = x^2 and D . y = y^2. With n = x^2 y - y^2
// x, n . D = 0, and D = (n.y, -n.x) / (x x y). So n points to the left of D, and the sign is that of n . z.
Sign side_of_diameter(const Point& w, const ExactPosition& x, const ExactPosition& y, const ExactPosition& z) {
  LatticeExponent lattice;
  lattice.include(w);
  for (const ExactPosition* const point : {&x, &y, &z}) lattice.include(*point);
  const int exponent = lattice.value();
  const Integer w_x = to_integer(w.x, exponent);
  const Integer w_y = to_integer(w.y, exponent);
  const auto from_w = [&](const ExactPosition& point) {
    const Homogeneous p = to_homogeneous(point, exponent);
    return Homogeneous{p.x - w_x * p.w, p.y - w_y * p.w, p.w};
  };
  const auto product = [](const Homogeneous& p, const Homogeneous& q) { return Integer{p.x * q.x + p.y * q.y}; };
  const Homogeneous to_x = from_w(x);
  const Homogeneous to_y = from_w(y);
  const Homogeneous to_z = from_w(z);
  return sign_of(product(to_x, to_x) * product(to_y, to_z) * to_y.w -
                 product(to_y, to_y) * product(to_x, to_z) * to_x.w);
}

std::strong_ordering compare_to_diameter(const Gap& gap, double radius) {
  return order_of(formula::run_compare_to_diameter<formula::Decide>(gap, radius));
}

std::strong_ordering compare_lengths(const Gap& p, const Gap& q) {
  return order_of(formula::run_compare_lengths<formula::Decide>(p, q));
}

std::strong_ordering compare_distance(const Point& c, const Point& a, const Point& b, double radius) {
  return order_of(formula::run_compare_distance<formula::Decide>(c, a, b, radius));
}

std::strong_ordering compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                       const Point& b2) {
  return order_of(formula::run_compare_distances<formula::Decide>(c, a1, b1, a2, b2));
}

double length(const Gap& gap) {
  if (!gap.has_foot()) return waywright::distance(gap.from, gap.a);
  const formula::DoubleFoot foot(gap);
  return std::abs(foot.x) / std::sqrt(foot.m);
}

// The foot is from + W with W = (X / M) (-ab.y, ab.x). If W nearly cancels a coordinate of `from`, the foot is computed
// in integers.
Point end_of(const Gap& gap) {
  if (!gap.has_foot()) return gap.a;
  if (gap.a.x == gap.b.x) return {gap.a.x, gap.from.y};
  if (gap.a.y == gap.b.y) return {gap.from.x, gap.a.y};
  const formula::DoubleFoot foot(gap);
  const double factor = foot.x / foot.m;
  const Point step = {factor * (gap.a.y - gap.b.y), factor * (gap.b.x - gap.a.x)};
  const Point result = gap.from + step;
  const auto is_sure = [](double sum, double term) { return std::abs(sum) >= std::abs(term); };
  if (is_sure(result.x, step.x) && is_sure(result.y, step.y)) return result;
  const auto& [exponent, from, ab, m, x] = formula::IntegerFoot(gap);
  return round_to_nearest(Homogeneous{from.x * m - x * ab.y, from.y * m + x * ab.x, m}, exponent);
}

namespace stages {

StageAnswers<Sign> dot(const Point& p, const Point& q, const Point& a, const Point& b) {
  return formula::AskEachStage::run<formula::DotFormula>(std::array{p, q, a, b});
}
StageAnswers<Sign> dot(const Point& p, const ExactPosition& q, const Point& a, const Point& b) {
  if (q.is_explicit()) return dot(p, Point{q.x, q.y}, a, b);
  StageAnswers<Sign> answers;
  answers.doubles = detail::dot_in_doubles(p, NearestDouble{q.x}, NearestDouble{q.y}, a, b);
  answers.integers = detail::finer_dot(p, q.crossing(), a, b);
  return answers;
}
StageAnswers<Sign> compare_to_diameter(const Gap& gap, double radius) {
  return formula::run_compare_to_diameter<formula::AskEachStage>(gap, radius);
}
StageAnswers<Sign> compare_lengths(const Gap& p, const Gap& q) {
  return formula::run_compare_lengths<formula::AskEachStage>(p, q);
}
StageAnswers<Sign> compare_distance(const Point& c, const Point& a, const Point& b, double radius) {
  return formula::run_compare_distance<formula::AskEachStage>(c, a, b, radius);
}
StageAnswers<Sign> compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                     const Point& b2) {
  return formula::run_compare_distances<formula::AskEachStage>(c, a1, b1, a2, b2);
}

}  // namespace stages

}  // namespace waywright::exact

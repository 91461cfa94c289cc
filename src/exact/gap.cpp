#include "exact/gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "base/ieee.hpp"
#include "exact/doubles.hpp"
#include "exact/error_bounds.hpp"
#include "exact/homogeneous.hpp"
#include "exact/offsets.hpp"
#include "exact/position.hpp"
#include "exact/wide_integer.hpp"

// The predicates for clearance: the numbers of their stages, their formulas, and the disc over a gap.
//
// The stages of the predicates. Each predicate is one formula: a type with a function template
// answer() over the numbers of a stage: ExactDouble and Rounded, SizedInteger or Integer. A formula gets the points,
// and the radius if there is one. It returns nothing if the error of the doubles could hide a sign.

namespace waywright::exact {

namespace formula {

namespace {

[[nodiscard]] std::optional<Sign> sign_if_sure(const Integer& number) { return sign_of(number); }

/// A point in the numbers of a stage.
template <class Coordinate>
struct Site {
  Coordinate x, y;
};
template <class Coordinate, std::size_t kCount>
using Sites = std::array<Site<Coordinate>, kCount>;

template <class Number>
struct Vector {
  Number x, y;
};
template <class Number>
Vector<Number> vector(const Number& x, const Number& y) {
  return {x, y};
}

template <class Coordinate>
auto operator-(const Site<Coordinate>& p, const Site<Coordinate>& q) {
  return vector(p.x - q.x, p.y - q.y);
}
template <class Number>
auto operator+(const Vector<Number>& p, const Vector<Number>& q) {
  return vector(p.x + q.x, p.y + q.y);
}
template <class P, class Q>
auto dot_product(const Vector<P>& p, const Vector<Q>& q) {
  return p.x * q.x + p.y * q.y;
}
template <class P, class Q>
auto cross_product(const Vector<P>& p, const Vector<Q>& q) {
  return p.x * q.y - p.y * q.x;
}
template <class Number>
auto square(const Vector<Number>& p) {
  return dot_product(p, p);
}

// The stages. Each returns the answer of a formula, or nothing.

template <class Formula, class Coordinate, std::size_t kCount, class Radius>
auto answer_of(const Sites<Coordinate, kCount>& sites, [[maybe_unused]] const Radius& radius) {
  if constexpr (Formula::kHasRadius) {
    return Formula::answer(sites, radius);
  } else {
    return Formula::answer(sites);
  }
}

/// A radius that is 0, or at least this large, is a multiple of 2^-304. So the filter can treat it as a value of degree
/// 2.
constexpr double kSmallestFilterRadius = 0x1p-250;
template <class Formula, std::size_t kCount>
WAYWRIGHT_ALWAYS_INLINE auto in_doubles(const std::array<Point, kCount>& points, double radius)
    -> decltype(answer_of<Formula>(Sites<ExactDouble, kCount>{}, Rounded<0, 2>{})) {
  if (Formula::kHasRadius && radius != 0.0 && radius < kSmallestFilterRadius) return std::nullopt;
  Sites<ExactDouble, kCount> sites;
  for (std::size_t i = 0; i < kCount; ++i) sites[i] = {{points[i].x}, {points[i].y}};
  return answer_of<Formula>(sites, Rounded<0, 2>{radius, radius});
}

/// The type of the answers of a formula.
template <class Formula, std::size_t kCount>
using AnswerOf = decltype(answer_of<Formula>(Sites<Integer, kCount>{}, Integer{}));

/// The bits of an offset in each size of the integers of fixed width. With the first size, the formulas compute
/// products of four offsets in 64 bits. With the second size, they compute products of two offsets in 64 bits.
constexpr int kSmallOffsetBits = 13;
constexpr int kNarrowOffsetBits = 29;
constexpr int kWideOffsetBits = 60;

/// The points as vectors from the first one, and the radius. Requires: all magnitudes are below 2^kBits.
template <int kBits, std::size_t kCount>
struct SizedQuestion {
  Sites<SizedInteger<kBits>, kCount> sites;
  SizedInteger<kBits> radius;
};

/// Answers without a search for the lattice if two conditions hold: all numbers are multiples of one unit (1, or 2^-10
/// in a formula with a radius), and all offsets are below 2^kBits units. If many distances in a world are equal, the
/// two conditions nearly always hold.
template <class Formula, std::size_t kCount>
AnswerOf<Formula, kCount> in_known_units(const std::array<Point, kCount>& points, double radius) {
  // Formulas with a radius multiply at most four offsets. So each offset can have more bits, and the unit can be
  // smaller.
  constexpr int kBits = Formula::kHasRadius ? kNarrowOffsetBits : kSmallOffsetBits;
  constexpr double kUnitsPerOne = Formula::kHasRadius ? 0x1p10 : 1.0;
  constexpr double kLimit = std::int64_t{1} << kBits;
  const Point origin = points[0] * kUnitsPerOne;
  const double units_of_radius = radius * kUnitsPerOne;
  std::array<Point, kCount> offsets;
  double fractions = std::abs(fraction(origin.x)) + std::abs(fraction(origin.y)) + std::abs(fraction(units_of_radius));
  double largest = units_of_radius;
  for (std::size_t i = 1; i < kCount; ++i) {
    const Point position = points[i] * kUnitsPerOne;
    fractions += std::abs(fraction(position.x)) + std::abs(fraction(position.y));
    offsets[i] = position - origin;
    largest = std::max(largest, std::max(std::abs(offsets[i].x), std::abs(offsets[i].y)));
  }
  if (!(fractions == 0.0 && largest < kLimit)) return std::nullopt;
  const auto sized = [](double units) { return SizedInteger<kBits>(static_cast<std::int64_t>(units)); };
  Sites<SizedInteger<kBits>, kCount> sites;
  for (std::size_t i = 1; i < kCount; ++i) sites[i] = {sized(offsets[i].x), sized(offsets[i].y)};
  return answer_of<Formula>(sites, sized(units_of_radius));
}

/// The points as offsets from the first one, and the radius, on their common lattice.
template <class Formula, std::size_t kCount>
class OnLattice {
 public:
  OnLattice(const std::array<Point, kCount>& points, double radius) : offsets_(points[0]) {
    for (std::size_t i = 1; i < kCount; ++i) offsets_.add(points[i]);
    if constexpr (Formula::kHasRadius) offsets_.add_length(radius);
    has_lattice_ = offsets_.find_lattice();
  }

  [[nodiscard]] AnswerOf<Formula, kCount> answer() const {
    if (const auto answer = answer_in<kSmallOffsetBits>()) return answer;
    if (const auto answer = answer_in<kNarrowOffsetBits>()) return answer;
    return answer_in<kWideOffsetBits>();
  }

  /// Returns nothing if there is no lattice, or if an offset has more than kBits bits.
  template <int kBits>
  [[nodiscard]] AnswerOf<Formula, kCount> answer_in() const {
    if (!has_lattice_ || offsets_.bits() > kBits) return std::nullopt;
    using Number = SizedInteger<kBits>;
    Sites<Number, kCount> sites;
    for (std::size_t i = 1; i < kCount; ++i) {
      const LatticeVector offset = offsets_[i - 1];
      sites[i] = {Number(offset.x), Number(offset.y)};
    }
    return answer_of<Formula>(sites, Number(Formula::kHasRadius ? offsets_[kCount - 1].x : 0));
  }

 private:
  Offsets<kCount> offsets_;
  bool has_lattice_;
};

template <class Formula, std::size_t kCount>
AnswerOf<Formula, kCount> in_integers(const std::array<Point, kCount>& points, double radius) {
  LatticeExponent lattice;
  for (const Point& point : points) lattice.include(point);
  lattice.include(radius);
  const int exponent = lattice.value();
  Sites<Integer, kCount> sites;
  for (std::size_t i = 0; i < kCount; ++i) {
    sites[i] = {to_integer(points[i].x, exponent), to_integer(points[i].y, exponent)};
  }
  return answer_of<Formula>(sites, to_integer(radius, exponent));
}

/// Runs the stages after the doubles, one after the other.
template <class Formula, std::size_t kCount>
WAYWRIGHT_NO_INLINE auto decide_in_integers(const std::array<Point, kCount>& points, double radius) {
  if (const auto answer = in_known_units<Formula>(points, radius)) return *answer;
  if (const auto answer = OnLattice<Formula, kCount>(points, radius).answer()) return *answer;
  return *in_integers<Formula>(points, radius);
}

/// Decides a predicate: a type that a call of select() in the functions below chooses.
struct Decide {
  template <class Formula, std::size_t kCount>
  static auto run(const std::array<Point, kCount>& points, double radius = 0.0) {
    if (const auto answer = in_doubles<Formula>(points, radius)) return *answer;
    return decide_in_integers<Formula>(points, radius);
  }
};

/// Asks each stage alone.
struct AskEachStage {
  template <class Formula, std::size_t kCount>
  static auto run(const std::array<Point, kCount>& points, double radius = 0.0) {
    const OnLattice<Formula, kCount> on_lattice(points, radius);
    using Answer = typename AnswerOf<Formula, kCount>::value_type;
    return StageAnswers<Answer>{in_doubles<Formula>(points, radius),
                                in_known_units<Formula>(points, radius),
                                on_lattice.template answer_in<kSmallOffsetBits>(),
                                on_lattice.template answer_in<kNarrowOffsetBits>(),
                                on_lattice.template answer_in<kWideOffsetBits>(),
                                in_integers<Formula>(points, radius)};
  }
};

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

namespace formula {

namespace {

// The disc whose diameter is the gap from u to v contains a position P if f(P) = (P - u) . (P - v) <= 0. On the
// segment, P = c + t (d - c), and f is a quadratic function of t, strictly convex unless c = d. With C = c - u, W = v -
// u and E = d - c:
//   f(0) = C . (C - W), f'(0) = E . (2 C - W), and similarly at t = 1.
// The least value of f is the product of the distances of the line cd from u and v, with signs, less the square of half
// of the projection of W on the line: min f = (E x C) (E x (C - W)) / |E|^2 - (E . W)^2 / (4 |E|^2). (The centre of the
// disc has the distance |E x (2 C - W)| / (2 |E|) from the line, and the radius is |W| / 2. Lagrange's identity
// |E|^2 |W|^2 = (E x W)^2 + (E . W)^2 gives the formula.)
//
// The ends of the gap do not count, and f is 0 there. So the formula must know for each position with f = 0 whether it
// is u or v:
//   c and d: each disc below has a number for this, which is 0 only at u and v.
//   The position with the least value, if this is 0: the line cd is a tangent, and it touches the circle there. If this
//   position is u or v, then the line is perpendicular to the gap, so E . W = 0. Conversely, if E . W = 0, then one of
//   the distances is 0 because min f = 0: the line contains u or v.
// If u = v, all three conditions hold, and no position counts.
//
// A disc has the members
//   value(P): a positive multiple of f(P);
//   off_ends(P): 0 if P is u or v, not 0 for other positions P with f(P) = 0;
//   slope(P): a positive multiple of the derivative of f at P, which is c or d;
//   least(): a positive multiple of the least value of f on the line cd;
//   along(): 0 if and only if E . W = 0.

/// The disc of a gap between two points.
template <class Coordinate>
struct DiscToPoint {
  using Position = Site<Coordinate>;
  Position u, v, c, d;

  [[nodiscard]] auto value(const Position& p) const { return dot_product(p - u, p - v); }
  [[nodiscard]] auto off_ends(const Position& p) const { return square(p - u) * square(p - v); }
  [[nodiscard]] auto slope(const Position& p) const { return dot_product(d - c, (p - u) + (p - v)); }
  [[nodiscard]] auto least() const {
    const auto from_u = cross_product(d - c, c - u);
    const auto from_v = cross_product(d - c, c - v);
    const auto projection = along();
    return (from_u + from_u) * (from_v + from_v) - projection * projection;
  }
  [[nodiscard]] auto along() const { return dot_product(d - c, v - u); }
};

/// The disc of a gap to the foot of the perpendicular on the line through a and b. With D = b - a, M = |D|^2 and
/// X = D x (a - u), the foot is v = u + W with W = (X / M) (-D.y, D.x). So for every vector V:
///   V . W = (X / M) (D x V),  V x W = (X / M) (D . V).
/// The values and slopes of f are multiplied by M, and its least value by 4 |E|^2 M^2.
///
/// At a position P with f(P) = 0, let V = P - u. If D . V = 0, then P lies on the line through u and v, so it is one of
/// them. Both have D . V = 0.
template <class Coordinate>
class DiscToFoot {
 public:
  using Position = Site<Coordinate>;

  DiscToFoot(const Position& u, const Position& a, const Position& b, const Position& c, const Position& d)
      : u_(u), c_(c), ab_(b - a), cd_(d - c), m_(square(ab_)), x_(cross_product(ab_, a - u)) {}

  [[nodiscard]] auto value(const Position& p) const {
    const auto from_u = p - u_;
    return m_ * square(from_u) - x_ * cross_product(ab_, from_u);
  }
  [[nodiscard]] auto off_ends(const Position& p) const { return dot_product(ab_, p - u_); }
  [[nodiscard]] auto slope(const Position& p) const {
    const auto from_u = p - u_;
    return m_ * dot_product(cd_, from_u + from_u) - along();
  }
  [[nodiscard]] auto least() const {
    const auto from_u = cross_product(cd_, c_ - u_);
    const auto from_v = m_ * from_u - x_ * dot_product(ab_, cd_);
    const auto projection = along();
    return ((m_ + m_) * (from_u + from_u)) * from_v - projection * projection;
  }
  [[nodiscard]] auto along() const { return x_ * cross_product(ab_, cd_); }

 private:
  using Difference = decltype(std::declval<Position>() - std::declval<Position>());
  using Product = decltype(square(std::declval<Difference>()));

  Position u_, c_;
  Difference ab_, cd_;
  Product m_, x_;
};

/// Whether the disc contains a position that is neither u nor v. `sign` is the sign of f at this position. Calls
/// off_ends() only if f is 0.
template <class OffEnds>
std::optional<bool> is_touch(const std::optional<Sign>& sign, const OffEnds& off_ends) {
  if (!sign) return std::nullopt;
  if (*sign != Sign::zero) return *sign == Sign::negative;
  const std::optional<Sign> off = sign_if_sure(off_ends());
  if (!off) return std::nullopt;
  return *off != Sign::zero;
}

/// Whether the disc contains a position of the segment other than u and v.
template <class Disc>
std::optional<bool> touches_segment(const Disc& disc, const typename Disc::Position& c,
                                    const typename Disc::Position& d) {
  const auto touches_at = [&](const auto& p) {
    return is_touch(sign_if_sure(disc.value(p)), [&] { return disc.off_ends(p); });
  };
  const std::optional<bool> at_c = touches_at(c);
  if (at_c && *at_c) return true;
  const std::optional<bool> at_d = touches_at(d);
  if (at_d && *at_d) return true;
  // Here, if at_c is known, then f(0) >= 0, and the disc contains c only if this is u or v. If f does not fall at c,
  // then f is positive elsewhere. The same holds at d.
  const std::optional<Sign> slope_at_c = sign_if_sure(disc.slope(c));
  if (slope_at_c && *slope_at_c != Sign::negative) return at_c;
  const std::optional<Sign> slope_at_d = sign_if_sure(disc.slope(d));
  if (slope_at_d && *slope_at_d != Sign::positive) return at_d;
  if (!slope_at_c || !slope_at_d) return std::nullopt;
  // The least value on the line lies between c and d. If it is positive, the answer does not depend on at_c and at_d.
  return is_touch(sign_if_sure(disc.least()), [&] { return disc.along(); });
}

struct TouchesToPoint {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 4>& sites) {
    const auto& [u, v, c, d] = sites;
    return touches_segment(DiscToPoint<Coordinate>{u, v, c, d}, c, d);
  }
};

struct TouchesToFoot {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 5>& sites) {
    const auto& [u, a, b, c, d] = sites;
    return touches_segment(DiscToFoot<Coordinate>(u, a, b, c, d), c, d);
  }
};

template <class Run>
auto run_touches(const Gap& gap, const Point& c, const Point& d) {
  if (!gap.has_foot()) return Run::template run<TouchesToPoint>(std::array{gap.from, gap.a, c, d});
  return Run::template run<TouchesToFoot>(std::array{gap.from, gap.a, gap.b, c, d});
}

}  // namespace

}  // namespace formula

bool touches(const Gap& gap, const Point& c, const Point& d) {
  // The line through a and b touches the disc at the foot only. The filter could not decide this tie.
  const auto is_on_line = [&](const Point& p) { return p == gap.a || p == gap.b; };
  if (gap.has_foot() && is_on_line(c) && is_on_line(d)) return false;
  return formula::run_touches<formula::Decide>(gap, c, d);
}

StageAnswers<bool> stages::touches(const Gap& gap, const Point& c, const Point& d) {
  return formula::run_touches<formula::AskEachStage>(gap, c, d);
}

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

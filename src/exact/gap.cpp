#include "exact/gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/compiler.hpp"
#include "exact/homogeneous.hpp"
#include "exact/integer.hpp"
#include "exact/offsets.hpp"
#include "exact/power_of_two.hpp"
#include "exact/sized_integer.hpp"
#include "exact/twofold.hpp"
#include "exact/whole.hpp"

namespace waywright::exact {

namespace {

// Each predicate is one formula, a function template over the numbers of a stage: ExactDouble and Rounded, SizedInteger
// or Integer. A formula gets the points, and the radius if there is one. It returns nothing if the error of the doubles
// could hide a sign.

std::optional<Sign> sign_if_sure(const Integer& number) { return sign_of(number); }

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

/// Whether the segment from c to d has a position other than u and v where f <= 0. The arguments return positive
/// multiples of numbers about f (see below): `start` and `end` of f at c and d, the slopes of the derivative of f
/// there, `lowest` of the least value of f on the line through c and d. `c_off_gap` and `d_off_gap` return 0 if c or d
/// lies on the line through u and v. `along` returns 0 if the segment is perpendicular to the gap.
///
/// Each of them is called only as far as needed.
template <class Start, class End, class COffGap, class DOffGap, class SlopeAtStart, class SlopeAtEnd, class Lowest,
          class Along>
std::optional<bool> touches_between(const Start& start, const End& end, const COffGap& c_off_gap,
                                    const DOffGap& d_off_gap, const SlopeAtStart& slope_at_start,
                                    const SlopeAtEnd& slope_at_end, const Lowest& lowest, const Along& along) {
  // Where f is 0, a position on the line through u and v is u or v.
  const auto touches_at = [](const auto& value, const auto& off_gap) -> std::optional<bool> {
    const std::optional<Sign> sign = sign_if_sure(value());
    if (!sign) return std::nullopt;
    if (*sign != Sign::zero) return *sign == Sign::negative;
    const std::optional<Sign> off = sign_if_sure(off_gap());
    if (!off) return std::nullopt;
    return *off != Sign::zero;
  };
  const std::optional<bool> at_start = touches_at(start, c_off_gap);
  if (at_start && *at_start) return true;
  const std::optional<bool> at_end = touches_at(end, d_off_gap);
  if (at_end && *at_end) return true;
  // f is strictly convex unless c equals d.
  const std::optional<Sign> falls = sign_if_sure(slope_at_start());
  if (falls && *falls != Sign::negative) return at_start;
  const std::optional<Sign> rises = sign_if_sure(slope_at_end());
  if (rises && *rises != Sign::positive) return at_end;
  if (!falls || !rises) return std::nullopt;
  const std::optional<Sign> least = sign_if_sure(lowest());
  if (!least) return std::nullopt;
  if (*least != Sign::zero) return *least == Sign::negative;
  const std::optional<Sign> slanted = sign_if_sure(along());
  if (!slanted) return std::nullopt;
  return *slanted != Sign::zero;
}

struct DotFormula {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<Sign> answer(const Sites<Coordinate, 4>& sites) {
    const auto& [p, q, a, b] = sites;
    return sign_if_sure(dot_product(q - p, b - a));
  }
};

// A point P lies in the open disc with the diameter from u to v if f = (P - u) . (P - v) < 0. On the segment,
// P = c + t (d - c), and f is a quadratic function of t. With C = c - u, W = v - u and E = d - c:
//   f(0) = C . (C - W), f'(0) = E . (2 C - W), and similarly at t = 1.
// The least value of f is the product of the distances of the line cd from u and v, with signs, less the square of half
// of W's component along the line: min f = (E x C) (E x (C - W)) / |E|^2 - (E . W)^2 / (4 |E|^2). (The centre of the
// disc has the distance |E x (2 C - W)| / (2 |E|) from the line, and the radius is |W| / 2. Lagrange's identity
// |E|^2 |W|^2 = (E x W)^2 + (E . W)^2 gives the formula.)
struct TouchesToPoint {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 4>& sites) {
    const auto& [u, v, c, d] = sites;
    const auto uc = c - u;
    const auto vc = c - v;
    const auto ud = d - u;
    const auto vd = d - v;
    const auto cd = d - c;
    const auto uv = v - u;
    const auto lowest = [&] {
      const auto from_u = cross_product(cd, uc);
      const auto from_v = cross_product(cd, vc);
      const auto along = dot_product(cd, uv);
      return (from_u + from_u) * (from_v + from_v) - along * along;
    };
    return touches_between([&] { return dot_product(uc, vc); }, [&] { return dot_product(ud, vd); },
                           [&] { return cross_product(uv, uc); }, [&] { return cross_product(uv, ud); },
                           [&] { return dot_product(cd, uc + vc); }, [&] { return dot_product(cd, ud + vd); }, lowest,
                           [&] { return dot_product(cd, uv); });
  }
};

// The same for a gap to the foot of the perpendicular on the line through a and b. With D = b - a, M = |D|^2 and
// X = D x (a - u), the foot is v = u + W with W = (X / M) (-D.y, D.x). So for every vector V:
//   V . W = (X / M) (D x V),  V x W = (X / M) (D . V).
// The values and slopes of f are multiplied by M, and its least value by 4 |E|^2 M^2.
struct TouchesToFoot {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 5>& sites) {
    const auto& [u, a, b, c, d] = sites;
    const auto ab = b - a;
    const auto uc = c - u;
    const auto ud = d - u;
    const auto cd = d - c;
    const auto m = square(ab);
    const auto x = cross_product(ab, a - u);
    const auto value = [&](const auto& from_u) { return m * square(from_u) - x * cross_product(ab, from_u); };
    const auto slope = [&](const auto& from_u) {
      return m * dot_product(cd, from_u + from_u) - x * cross_product(ab, cd);
    };
    const auto lowest = [&] {
      const auto from_u = cross_product(cd, uc);
      const auto from_v = m * from_u - x * dot_product(ab, cd);
      const auto along = x * cross_product(ab, cd);
      return ((m + m) * (from_u + from_u)) * from_v - along * along;
    };
    return touches_between([&] { return value(uc); }, [&] { return value(ud); }, [&] { return dot_product(ab, uc); },
                           [&] { return dot_product(ab, ud); }, [&] { return slope(uc); }, [&] { return slope(ud); },
                           lowest, [&] { return x * cross_product(ab, cd); });
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

// The stages. Each returns the answer of a formula, or nothing.

template <class Formula, class Coordinate, std::size_t kCount, class Radius>
auto answer_of(const Sites<Coordinate, kCount>& sites, [[maybe_unused]] const Radius& radius) {
  if constexpr (Formula::kHasRadius) {
    return Formula::answer(sites, radius);
  } else {
    return Formula::answer(sites);
  }
}

/// Between these bounds, the filter can compute with a radius as with a value of degree 2: it is a multiple of 2^-304.
constexpr double kSmallestFilterRadius = 0x1p-250;
/// Replaces a radius by another one for which every comparison of this file has the same result: a length that is not 0
/// is between 2^-406 and 2^102. (An area is 0 or at least 2^-304, and the line has at most the length 2^101.5.)
constexpr double kSmallestRadius = 0x1p-500;
constexpr double kLargestRadius = 0x1p103;
double bounded(double radius) { return radius == 0.0 ? 0.0 : std::clamp(radius, kSmallestRadius, kLargestRadius); }

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
/// products of four offsets in 64 bits. With the second size, these are products of two offsets.
constexpr int kSmallOffsetBits = 13;
constexpr int kNarrowOffsetBits = 29;
constexpr int kWideOffsetBits = 60;

/// The points as vectors from the first one, and the radius. Requires: all magnitudes are below 2^kBits.
template <int kBits, std::size_t kCount>
struct SizedQuestion {
  Sites<SizedInteger<kBits>, kCount> sites;
  SizedInteger<kBits> radius;
};

/// Answers without a search for the lattice if all numbers are multiples of kUnit, and less than 2^kBits units from one
/// another. These are by far the most common numbers of which many distances are equal.
template <class Formula, std::size_t kCount>
AnswerOf<Formula, kCount> in_known_units(const std::array<Point, kCount>& points, double radius) {
  // Formulas with a radius multiply at most four offsets, so that they have more bits for the units.
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

bool has_foot(const Gap& gap) { return gap.a != gap.b; }

// The formula for each predicate. `Run` says what to do with it: Decide or AskEachStage.

template <class Run>
auto run_touches(const Gap& gap, const Point& c, const Point& d) {
  if (!has_foot(gap)) return Run::template run<TouchesToPoint>(std::array{gap.from, gap.a, c, d});
  return Run::template run<TouchesToFoot>(std::array{gap.from, gap.a, gap.b, c, d});
}

template <class Run>
auto run_compare_to_diameter(const Gap& gap, double radius) {
  const double limit = bounded(radius);
  if (!has_foot(gap)) return Run::template run<CompareToDiameter<false>>(std::array{gap.from, gap.a}, limit);
  return Run::template run<CompareToDiameter<true>>(std::array{gap.from, gap.a, gap.b}, limit);
}

template <class Run>
auto run_compare_lengths(const Gap& p, const Gap& q) {
  if (has_foot(p)) {
    if (has_foot(q)) {
      return Run::template run<CompareLengths<true, true>>(std::array{p.from, p.a, p.b, q.from, q.a, q.b});
    }
    return Run::template run<CompareLengths<true, false>>(std::array{p.from, p.a, p.b, q.from, q.a});
  }
  if (has_foot(q)) {
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

Sign detail::finer_dot(const Point& p, const Point& q, const Point& a, const Point& b) {
  return decide_in_integers<DotFormula>(std::array{p, q, a, b}, 0.0);
}

Sign detail::dot_in_integers(const Point& p, const ExactPoint& q, const Point& a, const Point& b) {
  LatticeExponent lattice;
  for (const Point& point : {p, a, b}) lattice.include(point);
  lattice.include(q);
  const int exponent = lattice.value();
  const auto site = [&](const Point& point) {
    return Site<Integer>{to_integer(point.x, exponent), to_integer(point.y, exponent)};
  };
  const Homogeneous at = to_homogeneous(q, exponent);
  const Site<Integer> from = site(p);
  const Vector<Integer> pq = {at.x - from.x * at.w, at.y - from.y * at.w};
  return sign_of(Integer(dot_product(pq, site(b) - site(a))));
}

bool touches(const Gap& gap, const Point& c, const Point& d) { return run_touches<Decide>(gap, c, d); }

std::strong_ordering compare_to_diameter(const Gap& gap, double radius) {
  return order_of(run_compare_to_diameter<Decide>(gap, radius));
}

std::strong_ordering compare_lengths(const Gap& p, const Gap& q) { return order_of(run_compare_lengths<Decide>(p, q)); }

std::strong_ordering compare_distance(const Point& c, const Point& a, const Point& b, double radius) {
  return order_of(run_compare_distance<Decide>(c, a, b, radius));
}

std::strong_ordering compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                       const Point& b2) {
  return order_of(run_compare_distances<Decide>(c, a1, b1, a2, b2));
}

double length(const Gap& gap) {
  if (!has_foot(gap)) return waywright::distance(gap.from, gap.a);
  const DoubleFoot foot(gap);
  return std::abs(foot.x) / std::sqrt(foot.m);
}

double largest_radius(const Gap& gap) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double radius = 0.5 * length(gap);
  while (compare_to_diameter(gap, radius) < 0) radius = std::nextafter(radius, 0.0);
  for (;;) {
    const double larger = std::nextafter(radius, kInfinity);
    if (compare_to_diameter(gap, larger) < 0) return radius;
    radius = larger;
  }
}

// The foot is from + W with W = (X / M) (-ab.y, ab.x). If W nearly cancels a coordinate of `from`, the foot is computed
// in integers.
Point end(const Gap& gap) {
  if (!has_foot(gap)) return gap.a;
  if (gap.a.x == gap.b.x) return {gap.a.x, gap.from.y};
  if (gap.a.y == gap.b.y) return {gap.from.x, gap.a.y};
  const DoubleFoot foot(gap);
  const double factor = foot.x / foot.m;
  const Point step = {factor * (gap.a.y - gap.b.y), factor * (gap.b.x - gap.a.x)};
  const Point result = gap.from + step;
  const auto is_sure = [](double sum, double term) { return std::abs(sum) >= std::abs(term); };
  if (is_sure(result.x, step.x) && is_sure(result.y, step.y)) return result;
  const auto& [exponent, from, ab, m, x] = IntegerFoot(gap);
  return round_to_nearest(Homogeneous{from.x * m - x * ab.y, from.y * m + x * ab.x, m}, exponent);
}

namespace stages {

StageAnswers<Sign> dot(const Point& p, const Point& q, const Point& a, const Point& b) {
  return AskEachStage::run<DotFormula>(std::array{p, q, a, b});
}
StageAnswers<bool> touches(const Gap& gap, const Point& c, const Point& d) {
  return run_touches<AskEachStage>(gap, c, d);
}
StageAnswers<Sign> compare_to_diameter(const Gap& gap, double radius) {
  return run_compare_to_diameter<AskEachStage>(gap, radius);
}
StageAnswers<Sign> compare_lengths(const Gap& p, const Gap& q) { return run_compare_lengths<AskEachStage>(p, q); }
StageAnswers<Sign> compare_distance(const Point& c, const Point& a, const Point& b, double radius) {
  return run_compare_distance<AskEachStage>(c, a, b, radius);
}
StageAnswers<Sign> compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                     const Point& b2) {
  return run_compare_distances<AskEachStage>(c, a1, b1, a2, b2);
}

}  // namespace stages

}  // namespace waywright::exact

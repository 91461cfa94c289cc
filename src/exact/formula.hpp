#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "base/ieee.hpp"
#include "exact/gap.hpp"
#include "exact/homogeneous.hpp"
#include "exact/integer.hpp"
#include "exact/offsets.hpp"
#include "exact/rounded.hpp"
#include "exact/sign.hpp"
#include "exact/sized_integer.hpp"
#include "exact/whole.hpp"

// The stages of the predicates for clearance (gap.hpp). Each predicate is one formula: a type with a function template
// answer() over the numbers of a stage: ExactDouble and Rounded, SizedInteger or Integer. A formula gets the points,
// and the radius if there is one. It returns nothing if the error of the doubles could hide a sign.

namespace waywright::exact::formula {

[[nodiscard]] inline std::optional<Sign> sign_if_sure(const Integer& number) { return sign_of(number); }

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
inline constexpr double kSmallestFilterRadius = 0x1p-250;
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
inline constexpr int kSmallOffsetBits = 13;
inline constexpr int kNarrowOffsetBits = 29;
inline constexpr int kWideOffsetBits = 60;

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

}  // namespace waywright::exact::formula

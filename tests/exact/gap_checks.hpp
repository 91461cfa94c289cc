#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "exact/gap.hpp"
#include "exact/rational.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

/// What the tests of the predicates for clearance share: the oracle, random points, and checks of all stages.

namespace waywright::exact {

inline void PrintTo(const Gap& gap, std::ostream* out) {
  *out << std::hexfloat << "from (" << gap.from.x << ", " << gap.from.y << ") to a (" << gap.a.x << ", " << gap.a.y
       << ") b (" << gap.b.x << ", " << gap.b.y << ")";
}

}  // namespace waywright::exact

namespace waywright::test {

using exact::Gap;
using exact::Sign;
using exact::StageAnswers;

// The oracle: rationals, straight from the definitions.

inline RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) { return {p.x - q.x, p.y - q.y}; }
inline Rational rational_dot(const RationalPoint& p, const RationalPoint& q) { return p.x * q.x + p.y * q.y; }
inline Rational squared(const RationalPoint& p) { return rational_dot(p, p); }

/// The point a + t (b - a).
inline RationalPoint along(const RationalPoint& a, const RationalPoint& b, const Rational& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The parameter of the foot of the perpendicular from p on the line through a and b; 0 if a equals b.
inline Rational foot_parameter(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const Rational length = squared(b - a);
  return length == 0 ? Rational(0) : Rational(rational_dot(p - a, b - a) / length);
}

inline RationalPoint rational_end(const Gap& gap) {
  const RationalPoint a = rational(gap.a), b = rational(gap.b);
  return along(a, b, foot_parameter(rational(gap.from), a, b));
}
inline Rational squared_length(const Gap& gap) { return squared(rational_end(gap) - rational(gap.from)); }

inline Rational squared_distance(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const Rational t = foot_parameter(p, a, b);
  return squared(along(a, b, t < 0 ? Rational(0) : t > 1 ? Rational(1) : t) - p);
}

inline Sign compare_rationals(const Rational& p, const Rational& q) { return sign_of_rational(p - q); }
inline Rational square_of(double value) { return Rational(value) * Rational(value); }

// Random points.

enum class Kind : unsigned char {
  tiny_lattice,
  small_whole,
  whole,
  large_whole,
  huge_whole,
  decimals,
  quarters,
  unit,
  far_away,
  smallest,
  largest,
  mixed
};
inline constexpr std::array kKinds = {Kind::tiny_lattice, Kind::small_whole, Kind::whole,    Kind::large_whole,
                                      Kind::huge_whole,   Kind::decimals,    Kind::quarters, Kind::unit,
                                      Kind::far_away,     Kind::smallest,    Kind::largest,  Kind::mixed};

class Source {
 public:
  Source(Kind kind, std::uint64_t seed) : kind_(kind), random_(seed + 1000 * static_cast<std::uint64_t>(kind)) {}

  Random& random() { return random_; }
  double whole(std::int64_t most) { return static_cast<double>(random_.between(-most, most)); }

  double coordinate() {
    switch (kind_) {
      case Kind::tiny_lattice:
        return whole(3);
      case Kind::small_whole:
        return whole(12);
      case Kind::whole:
        return whole(4000);
      case Kind::large_whole:
        return whole(std::int64_t{1} << 27);
      case Kind::huge_whole:
        return whole(std::int64_t{1} << 52);
      case Kind::decimals:
        return whole(50) * 0.1;
      case Kind::quarters:
        return whole(400) * 0.25;
      case Kind::unit:
        return whole(std::int64_t{1} << 53) * 0x1p-53;
      case Kind::far_away:
        return 0x1p40 + whole(64) * 0x1p-10;
      case Kind::smallest:
        return whole(9) * kSmallestCoordinate;
      case Kind::largest:
        return whole(std::int64_t{1} << 10) * (kLargestCoordinate * 0x1p-10);
      case Kind::mixed:
        break;
    }
    const auto mantissa = whole(std::int64_t{1} << random_.between(1, 53));
    const double value = std::ldexp(mantissa, static_cast<int>(random_.between(-152, 47)));
    return is_in_range(value) ? value : 0.0;
  }

  /// A point. It often has a coordinate of an earlier point, or is an earlier point.
  Point point() {
    Point result = {coordinate(), coordinate()};
    const Point& other = earlier_[random_.below(earlier_.size())];
    const std::size_t choice = random_.below(10);
    if (choice < 2) result.x = other.x;
    if (choice == 1 || choice == 2) result.y = other.y;
    earlier_[random_.below(earlier_.size())] = result;
    return result;
  }
  Gap gap() {
    Gap result = {point(), point(), point()};
    if (random_.chance(40)) result.b = result.a;
    return result;
  }
  /// A radius near the length, or of another kind.
  double radius(double length) {
    switch (random_.below(9)) {
      case 0:
        return 0.0;
      case 1:
        return std::numeric_limits<double>::denorm_min();
      case 2:
        return std::numeric_limits<double>::max();
      case 3:
        return std::ldexp(1.0 + std::abs(whole(1000)), static_cast<int>(random_.between(-1074, 900)));
      case 4:
        return std::abs(coordinate());
      case 5:
        return std::nextafter(length, std::numeric_limits<double>::infinity());
      case 6:
        return std::nextafter(length, 0.0);
      default:
        return length;
    }
  }

 private:
  Kind kind_;
  Random random_;
  std::array<Point, 6> earlier_{};
};

// The checks.

/// How often each stage answered.
struct Answered {
  int doubles = 0, whole = 0, small = 0, narrow = 0, wide = 0, calls = 0;
};

template <class Answer>
void expect_stages(const StageAnswers<Answer>& answers, Answer expected, Answered& answered) {
  answered.calls += 1;
  const auto check = [&](const std::optional<Answer>& answer, int& count, std::string_view stage) {
    if (!answer) return;
    count += 1;
    EXPECT_EQ(*answer, expected) << stage;
  };
  check(answers.doubles, answered.doubles, "doubles");
  check(answers.whole, answered.whole, "whole");
  check(answers.small, answered.small, "small");
  check(answers.narrow, answered.narrow, "narrow");
  check(answers.wide, answered.wide, "wide");
  ASSERT_TRUE(answers.integers.has_value());
  EXPECT_EQ(*answers.integers, expected) << "integers";
}

/// Random coordinates and lengths that include the largest ones below 2^bits.
class LargestOffsets {
 public:
  explicit LargestOffsets(int bits) {
    const double largest = std::ldexp(1.0 - 0x1p-53, bits);
    choices_ = {0.0, 1.0, bits < 53 ? std::floor(largest) : largest, std::ldexp(1.0, bits - 1), 2.0};
  }
  double length() { return choices_[random_.below(5)]; }
  Point point() { return {length(), length()}; }

 private:
  std::array<double, 5> choices_{};
  Random random_{9};
};

/// Calls check(source, answered) with a source of the largest offsets of each size of the integers of fixed width. The
/// stage of this size must always answer.
template <class Check>
void check_largest_offsets(int calls, Check&& check) {
  for (const int bits : {13, 29, 60}) {
    Answered answered;
    LargestOffsets source(bits);
    for (int i = 0; i < calls && !testing::Test::HasFailure(); ++i) check(source, answered);
    EXPECT_EQ(bits == 13 ? answered.small : bits == 29 ? answered.narrow : answered.wide, answered.calls) << bits;
  }
}

using Symmetry = std::function<Point(const Point&)>;
inline const std::array<Symmetry, 7>& symmetries() {
  static const std::array<Symmetry, 7> kAll = {
      [](const Point& p) { return Point{-p.x, p.y}; },  [](const Point& p) { return Point{p.x, -p.y}; },
      [](const Point& p) { return Point{-p.x, -p.y}; }, [](const Point& p) { return Point{p.y, p.x}; },
      [](const Point& p) { return Point{-p.y, p.x}; },  [](const Point& p) { return Point{p.y, -p.x}; },
      [](const Point& p) { return Point{-p.y, -p.x}; }};
  return kAll;
}
inline Gap moved(const Gap& gap, const Symmetry& move) { return {move(gap.from), move(gap.a), move(gap.b)}; }
inline Gap reversed(const Gap& gap) { return {gap.from, gap.b, gap.a}; }

/// The fixture of tests with random points of each kind.
class Gaps : public testing::TestWithParam<Kind> {
 protected:
  const int kCalls = case_count(400, 4);
  Source source_{GetParam(), 1};
  Answered answered_;
  Point point() { return source_.point(); }
  void expect_all_stages_of_whole_numbers() const {
    EXPECT_GT(answered_.calls, 0);
    if (GetParam() > Kind::whole) return;
    EXPECT_EQ(answered_.whole, answered_.calls);
    EXPECT_EQ(answered_.small, answered_.calls);
    EXPECT_EQ(answered_.narrow, answered_.calls);
    EXPECT_EQ(answered_.wide, answered_.calls);
  }
};

inline std::string kind_of_test(const testing::TestParamInfo<Kind>& kind) {
  constexpr std::array<const char*, kKinds.size()> kNames = {"TinyLattice", "SmallWhole", "Whole",    "LargeWhole",
                                                             "HugeWhole",   "Decimals",   "Quarters", "Unit",
                                                             "FarAway",     "Smallest",   "Largest",  "Mixed"};
  return kNames.at(static_cast<std::size_t>(kind.param));
}

// Constructed ties.

/// Pythagorean triples.
inline constexpr std::array<std::array<double, 3>, 6> kTriples = {
    {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {-20, 21, 29}, {7, -24, 25}, {0, 1, 1}}};

/// The scales and origins of constructed ties, so that different stages decide them. All points are exact.
struct Frame {
  double scale;
  Point origin;
  [[nodiscard]] Point at(double x, double y) const { return {origin.x + scale * x, origin.y + scale * y}; }
};
inline constexpr std::array<Frame, 8> kFrames = {{{1, {0, 0}},
                                                  {1, {200, -700}},
                                                  {0x1p-8, {3, 5}},
                                                  {3, {0x1p26, 0x1p25}},
                                                  {0x1p20, {0, 0x1p30}},
                                                  {0x1p36, {-0x1p70, 0}},
                                                  {0x1p-100, {0, 0}},
                                                  {0x1p80, {0x1p90, -0x1p85}}}};

inline double above(double value) { return std::nextafter(value, std::numeric_limits<double>::infinity()); }
inline double below(double value) { return std::nextafter(value, 0.0); }

}  // namespace waywright::test

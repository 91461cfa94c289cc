#include "exact/gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "exact/rational.hpp"
#include "support/random.hpp"

namespace waywright::exact {

static void PrintTo(const Gap& gap, std::ostream* out) {
  *out << std::hexfloat << "from (" << gap.from.x << ", " << gap.from.y << ") to a (" << gap.a.x << ", " << gap.a.y
       << ") b (" << gap.b.x << ", " << gap.b.y << ")";
}

}  // namespace waywright::exact

namespace waywright::test {

namespace {

using exact::Gap;
using exact::Sign;
using exact::StageAnswers;

// The oracle: rationals, straight from the definitions.

RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) { return {p.x - q.x, p.y - q.y}; }
Rational rational_dot(const RationalPoint& p, const RationalPoint& q) { return p.x * q.x + p.y * q.y; }
Rational squared(const RationalPoint& p) { return rational_dot(p, p); }

/// The point a + t (b - a).
RationalPoint along(const RationalPoint& a, const RationalPoint& b, const Rational& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The parameter of the foot of the perpendicular from p on the line through a and b; 0 if a equals b.
Rational foot_parameter(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const Rational length = squared(b - a);
  return length == 0 ? Rational(0) : Rational(rational_dot(p - a, b - a) / length);
}

RationalPoint rational_end(const Gap& gap) {
  const RationalPoint a = rational(gap.a), b = rational(gap.b);
  return along(a, b, foot_parameter(rational(gap.from), a, b));
}
Rational squared_length(const Gap& gap) { return squared(rational_end(gap) - rational(gap.from)); }

Rational squared_distance(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const Rational t = foot_parameter(p, a, b);
  return squared(along(a, b, t < 0 ? Rational(0) : t > 1 ? Rational(1) : t) - p);
}

/// Whether a position of the segment from c to d lies in the closed disc around the middle of the gap, and is no end of
/// the gap.
bool rational_touches(const Gap& gap, const Point& c, const Point& d) {
  const RationalPoint u = rational(gap.from), v = rational_end(gap), p = rational(c), q = rational(d);
  const RationalPoint middle = along(u, v, Rational(1, 2));
  const Rational radius = squared(v - u) / 4;
  const Rational t = std::clamp(foot_parameter(middle, p, q), Rational(0), Rational(1));
  const RationalPoint nearest = along(p, q, t);
  const Rational distance = squared(nearest - middle);
  if (distance > radius) return false;
  const auto equal = [](const RationalPoint& a, const RationalPoint& b) { return a.x == b.x && a.y == b.y; };
  return distance < radius || !(equal(nearest, u) || equal(nearest, v));
}

Sign compare_rationals(const Rational& p, const Rational& q) { return sign_of_rational(p - q); }
Rational square_of(double value) { return Rational(value) * Rational(value); }

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
constexpr std::array kKinds = {Kind::tiny_lattice, Kind::small_whole, Kind::whole,    Kind::large_whole,
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
  ASSERT_TRUE(answers.any.has_value());
  EXPECT_EQ(*answers.any, expected) << "any";
}

using Symmetry = std::function<Point(const Point&)>;
const std::array<Symmetry, 7>& symmetries() {
  static const std::array<Symmetry, 7> kAll = {
      [](const Point& p) { return Point{-p.x, p.y}; },  [](const Point& p) { return Point{p.x, -p.y}; },
      [](const Point& p) { return Point{-p.x, -p.y}; }, [](const Point& p) { return Point{p.y, p.x}; },
      [](const Point& p) { return Point{-p.y, p.x}; },  [](const Point& p) { return Point{p.y, -p.x}; },
      [](const Point& p) { return Point{-p.y, -p.x}; }};
  return kAll;
}
Gap moved(const Gap& gap, const Symmetry& move) { return {move(gap.from), move(gap.a), move(gap.b)}; }
Gap reversed(const Gap& gap) { return {gap.from, gap.b, gap.a}; }

bool check_touches(const Gap& gap, const Point& c, const Point& d, Answered& answered) {
  const bool expected = rational_touches(gap, c, d);
  EXPECT_EQ(exact::touches(gap, c, d), expected);
  EXPECT_EQ(exact::touches(gap, d, c), expected);
  EXPECT_EQ(exact::touches(reversed(gap), c, d), expected);
  if (gap.a == gap.b) {
    EXPECT_EQ(exact::touches({gap.a, gap.from, gap.from}, c, d), expected);
  }
  for (const Symmetry& move : symmetries()) EXPECT_EQ(exact::touches(moved(gap, move), move(c), move(d)), expected);
  expect_stages(exact::stages::touches(gap, c, d), expected, answered);
  return expected;
}

Sign check_diameter(const Gap& gap, double radius, Answered& answered) {
  const Sign expected = compare_rationals(squared_length(gap), 4 * square_of(radius));
  const auto order = exact::order_of(expected);
  EXPECT_EQ(exact::compare_to_diameter(gap, radius), order);
  EXPECT_EQ(exact::compare_to_diameter(reversed(gap), radius), order);
  for (const Symmetry& move : symmetries()) EXPECT_EQ(exact::compare_to_diameter(moved(gap, move), radius), order);
  expect_stages(exact::stages::compare_to_diameter(gap, radius), expected, answered);
  return expected;
}

Sign check_lengths(const Gap& p, const Gap& q, Answered& answered) {
  const Sign expected = compare_rationals(squared_length(p), squared_length(q));
  const auto order = exact::order_of(expected);
  EXPECT_EQ(exact::compare_lengths(p, q), order);
  EXPECT_EQ(exact::compare_lengths(q, p), exact::order_of(-expected));
  EXPECT_EQ(exact::compare_lengths(reversed(p), q), order);
  for (const Symmetry& move : symmetries()) EXPECT_EQ(exact::compare_lengths(moved(p, move), moved(q, move)), order);
  expect_stages(exact::stages::compare_lengths(p, q), expected, answered);
  return expected;
}

Sign check_distance(const Point& c, const Point& a, const Point& b, double radius, Answered& answered) {
  const Sign expected = compare_rationals(squared_distance(rational(c), rational(a), rational(b)), square_of(radius));
  const auto order = exact::order_of(expected);
  EXPECT_EQ(exact::compare_distance(c, a, b, radius), order);
  EXPECT_EQ(exact::compare_distance(c, b, a, radius), order);
  for (const Symmetry& move : symmetries()) {
    EXPECT_EQ(exact::compare_distance(move(c), move(a), move(b), radius), order);
  }
  expect_stages(exact::stages::compare_distance(c, a, b, radius), expected, answered);
  return expected;
}

Sign check_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2, const Point& b2,
                     Answered& answered) {
  const Sign expected = compare_rationals(squared_distance(rational(c), rational(a1), rational(b1)),
                                          squared_distance(rational(c), rational(a2), rational(b2)));
  const auto order = exact::order_of(expected);
  EXPECT_EQ(exact::compare_distances(c, a1, b1, a2, b2), order);
  EXPECT_EQ(exact::compare_distances(c, b1, a1, a2, b2), order);
  EXPECT_EQ(exact::compare_distances(c, a1, b1, b2, a2), order);
  EXPECT_EQ(exact::compare_distances(c, a2, b2, a1, b1), exact::order_of(-expected));
  for (const Symmetry& move : symmetries()) {
    EXPECT_EQ(exact::compare_distances(move(c), move(a1), move(b1), move(a2), move(b2)), order);
  }
  expect_stages(exact::stages::compare_distances(c, a1, b1, a2, b2), expected, answered);
  return expected;
}

Sign check_dot(const Point& p, const Point& q, const Point& a, const Point& b, Answered& answered) {
  const Sign expected = sign_of_rational(rational_dot(rational(q) - rational(p), rational(b) - rational(a)));
  EXPECT_EQ(exact::dot(p, q, a, b), expected);
  EXPECT_EQ(exact::dot(a, b, p, q), expected);
  EXPECT_EQ(exact::dot(q, p, a, b), -expected);
  EXPECT_EQ(exact::dot(p, q, b, a), -expected);
  for (const Symmetry& move : symmetries()) EXPECT_EQ(exact::dot(move(p), move(q), move(a), move(b)), expected);
  expect_stages(exact::stages::dot(p, q, a, b), expected, answered);
  return expected;
}

class Gaps : public testing::TestWithParam<Kind> {
 protected:
  static constexpr int kCalls = 400;
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
std::string kind_of_test(const testing::TestParamInfo<Kind>& kind) {
  constexpr std::array<const char*, kKinds.size()> kNames = {"TinyLattice", "SmallWhole", "Whole",    "LargeWhole",
                                                             "HugeWhole",   "Decimals",   "Quarters", "Unit",
                                                             "FarAway",     "Smallest",   "Largest",  "Mixed"};
  return kNames.at(static_cast<std::size_t>(kind.param));
}
INSTANTIATE_TEST_SUITE_P(Kinds, Gaps, testing::ValuesIn(kKinds), kind_of_test);

TEST_P(Gaps, DotAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) check_dot(point(), point(), point(), point(), answered_);
  expect_all_stages_of_whole_numbers();
}

TEST_P(Gaps, TouchesAgreesWithRationals) {
  int meet = 0;
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap gap = source_.gap();
    meet += check_touches(gap, point(), point(), answered_) ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << testing::PrintToString(gap);
  }
  EXPECT_GT(meet, kCalls / 10);
  EXPECT_LT(meet, kCalls);
  expect_all_stages_of_whole_numbers();
}

TEST_P(Gaps, CompareToDiameterAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap gap = source_.gap();
    const double radius = source_.radius(exact::length(gap) / 2);
    check_diameter(gap, radius, answered_);
    ASSERT_FALSE(HasFailure()) << testing::PrintToString(gap) << ", radius " << std::hexfloat << radius;
  }
}

TEST_P(Gaps, CompareLengthsAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) check_lengths(source_.gap(), source_.gap(), answered_);
  expect_all_stages_of_whole_numbers();
}

TEST_P(Gaps, CompareDistanceAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap segment = source_.gap();
    const Gap to_line = segment;
    const double length = source_.random().chance(50) ? exact::length(to_line) : distance(segment.from, segment.a);
    check_distance(segment.from, segment.a, segment.b, source_.radius(length), answered_);
    ASSERT_FALSE(HasFailure()) << testing::PrintToString(segment);
  }
}

TEST_P(Gaps, CompareDistancesAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap first = source_.gap(), second = source_.gap();
    check_distances(first.from, first.a, first.b, second.a, second.b, answered_);
  }
  expect_all_stages_of_whole_numbers();
}

TEST_P(Gaps, LengthAndEndAreNearTheRationals) {
  const auto is_near = [](double value, const Rational& exact_value, const Rational& ulps) {
    return abs(Rational(value) - exact_value) <= ulps * abs(exact_value) / Rational(0x1p52);
  };
  for (int i = 0; i < kCalls; ++i) {
    const Gap gap = source_.gap();
    const double length = exact::length(gap);
    ASSERT_TRUE(
        is_near(length, Rational(length) == 0 ? Rational(0) : Rational(squared_length(gap) / Rational(length)), 8))
        << testing::PrintToString(gap);
    ASSERT_EQ(length == 0.0, squared_length(gap) == 0);
    const RationalPoint expected = rational_end(gap);
    const Point end = exact::end(gap);
    ASSERT_TRUE(is_near(end.x, expected.x, 8)) << testing::PrintToString(gap);
    ASSERT_TRUE(is_near(end.y, expected.y, 8)) << testing::PrintToString(gap);
  }
}

/// Points with the largest offsets of each size of the integers of fixed width.
TEST(GapSizes, LargestOffsetsFit) {
  Random random(9);
  for (const int bits : {13, 29, 60}) {
    Answered answered;
    const double largest = std::ldexp(1.0 - 0x1p-53, bits);
    const std::array<double, 5> choices = {0.0, 1.0, bits < 53 ? std::floor(largest) : largest,
                                           std::ldexp(1.0, bits - 1), 2.0};
    const auto point = [&] { return Point{choices[random.below(5)], choices[random.below(5)]}; };
    for (int i = 0; i < 600 && !testing::Test::HasFailure(); ++i) {
      const Gap p = {point(), point(), point()}, q = {point(), point(), point()};
      check_touches(p, q.from, q.a, answered);
      check_lengths(p, q, answered);
      check_distances(p.from, p.a, p.b, q.a, q.b, answered);
      check_dot(p.from, p.a, q.from, q.a, answered);
      check_diameter(p, choices[random.below(5)], answered);
      check_distance(p.from, p.a, p.b, choices[random.below(5)], answered);
    }
    EXPECT_EQ(bits == 13 ? answered.small : bits == 29 ? answered.narrow : answered.wide, answered.calls) << bits;
  }
}

// Constructed ties.

/// Pythagorean triples.
constexpr std::array<std::array<double, 3>, 6> kTriples = {
    {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {-20, 21, 29}, {7, -24, 25}, {0, 1, 1}}};

/// The scales and origins of constructed ties, so that different stages decide them. All points are exact.
struct Frame {
  double scale;
  Point origin;
  [[nodiscard]] Point at(double x, double y) const { return {origin.x + scale * x, origin.y + scale * y}; }
};
constexpr std::array<Frame, 8> kFrames = {{{1, {0, 0}},
                                           {1, {200, -700}},
                                           {0x1p-8, {3, 5}},
                                           {3, {0x1p26, 0x1p25}},
                                           {0x1p20, {0, 0x1p30}},
                                           {0x1p36, {-0x1p70, 0}},
                                           {0x1p-100, {0, 0}},
                                           {0x1p80, {0x1p90, -0x1p85}}}};

double above(double value) { return std::nextafter(value, std::numeric_limits<double>::infinity()); }
double below(double value) { return std::nextafter(value, 0.0); }

TEST(GapTies, LengthEqualToTheDiameter) {
  Answered answered;
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, z] : kTriples) {
      const Point u = frame.at(0, 0), v = frame.at(2 * x, 2 * y);
      // The line through v with the direction (-y, x) is perpendicular to the gap.
      const Gap to_foot = {u, frame.at(2 * x - 3 * y, 2 * y + 3 * x), frame.at(2 * x - 5 * y, 2 * y + 5 * x)};
      for (const Gap& gap : {Gap{u, v, v}, to_foot}) {
        const double radius = frame.scale * z;
        EXPECT_EQ(check_diameter(gap, radius, answered), Sign::zero);
        EXPECT_EQ(check_diameter(gap, above(radius), answered), Sign::negative);
        EXPECT_EQ(check_diameter(gap, below(radius), answered), Sign::positive);
      }
      EXPECT_EQ(check_lengths(Gap{u, v, v}, to_foot, answered), Sign::zero);
    }
  }
}

TEST(GapTies, DistanceEqualToTheRadius) {
  Answered answered;
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, z] : kTriples) {
      const Point c = frame.at(0, 0);
      const double radius = frame.scale * z;
      // Each segment is at the distance z: at a foot, at an end beyond which the foot lies, at an end that is the foot.
      const std::array<Gap, 4> segments = {{{c, frame.at(x - y, y + x), frame.at(x + 2 * y, y - 2 * x)},
                                            {c, frame.at(x, y), frame.at(3 * x - y, 3 * y + x)},
                                            {c, frame.at(x, y), frame.at(x - y, y + x)},
                                            {c, frame.at(x, y), frame.at(x, y)}}};
      for (const auto& [from, a, b] : segments) {
        EXPECT_EQ(check_distance(c, a, b, radius, answered), Sign::zero);
        EXPECT_EQ(check_distance(c, a, b, above(radius), answered), Sign::negative);
        EXPECT_EQ(check_distance(c, a, b, below(radius), answered), Sign::positive);
        for (const auto& [other_from, other_a, other_b] : segments) {
          EXPECT_EQ(check_distances(c, a, b, other_a, other_b, answered), Sign::zero);
        }
        EXPECT_EQ(check_distances(c, a, b, c, c, answered), Sign::positive);
        const Point nudged = {above(a.x), a.y};
        if (!is_in_range(nudged)) continue;
        check_distances(c, nudged, b, segments[0].a, segments[0].b, answered);
        check_distance(c, nudged, b, radius, answered);
      }
    }
  }
}

/// A segment on a tangent of the disc, or with an end on its circle.
TEST(GapTies, TangentsOfTheDisc) {
  Answered answered;
  Random random(5);
  const auto whole = [&](std::int64_t most) { return static_cast<double>(random.between(-most, most)); };
  for (const Frame& frame : kFrames) {
    for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
      const Point direction = {whole(4), whole(4)};
      const Point other = {whole(3), whole(3)};
      if (direction == Point{} || other == Point{}) continue;
      // The projection of `w` on `direction` lies on the circle with the diameter from 0 to w.
      const Point w = squared_length(direction) * other;
      const Point z = dot(direction, other) * direction;
      const Point tangent = {w.y - 2 * z.y, 2 * z.x - w.x};
      const auto at = [&](const Point& p) { return frame.at(p.x, p.y); };
      const Point across = {-w.y, w.x};
      const Point u = at({}), v = at(w);
      const Gap to_foot = {u, at(w + across * 2), at(w - across)};
      const bool is_met = z != Point{} && z != w;
      for (const Gap& gap : {Gap{u, v, v}, to_foot}) {
        const Point c = at(z - tangent), d = at(z + tangent * 2);
        EXPECT_EQ(check_touches(gap, c, d, answered), is_met);
        EXPECT_EQ(check_touches(gap, at(z), at(z), answered), is_met);
        EXPECT_EQ(check_touches(gap, at(z), d, answered), is_met);
        check_touches(gap, at(z), at(w - z), answered);
        for (const double x : {above(c.x), below(c.x)}) {
          if (!is_in_range(x)) continue;
          check_touches(gap, {x, c.y}, d, answered);
          check_touches(gap, at(z), {x, c.y}, answered);
        }
        check_touches(gap, u, c, answered);
        check_touches(gap, v, d, answered);
        check_touches(gap, u, u, answered);
      }
    }
  }
  EXPECT_GT(answered.small, 0);
  EXPECT_GT(answered.doubles, 0);
  EXPECT_LT(answered.doubles, answered.calls);
}

/// Ties that only integers of any size can decide: no lattice of 64 bits contains the points.
TEST(GapTies, OfMixedScales) {
  Answered answered;
  const Point u = {0, 0};
  for (const auto& [x, y, z] : kTriples) {
    const Point v = Point{x, y} * 0x1p90;
    const Point c = Point{y, -x} * 0x1p-60;
    const Point d = Point{-y, x} * 0x1p80;
    EXPECT_FALSE(check_touches({u, v, v}, c, d, answered));  // the segment touches the disc at u
    EXPECT_EQ(check_dot(u, v, c, d, answered), Sign::zero);
    EXPECT_EQ(check_diameter({u, c, d}, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter({u, c, d}, std::numeric_limits<double>::denorm_min(), answered), Sign::negative);
    EXPECT_EQ(check_distance(u, c, d, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_lengths({u, c, d}, {v, v, v}, answered), Sign::zero);
    EXPECT_EQ(check_distances(u, c, d, u, v, answered), Sign::zero);
    EXPECT_EQ(exact::length({u, c, d}), 0.0);
    EXPECT_EQ(exact::end({u, c, d}), u);
  }
  EXPECT_EQ(answered.wide, 0);
}

TEST(GapTies, RightAngles) {
  Answered answered;
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, z] : kTriples) {
      const Point p = frame.at(1, 1), q = frame.at(1 + x, 1 + y), a = frame.at(2, 0), b = frame.at(2 - 3 * y, 3 * x);
      check_dot(p, q, a, b, answered);
      check_dot(p, q, a, {above(b.x), b.y}, answered);
      check_dot(p, q, a, {b.x, below(b.y)}, answered);
    }
  }
  EXPECT_EQ(exact::dot({1, 1}, Point{4, 5}, {2, 0}, {-10, 9}), Sign::zero);
}

TEST(GapTies, EmptyGaps) {
  Answered answered;
  const Point u = {2, 2};
  for (const Gap& gap : {Gap{u, u, u}, Gap{u, {0, 0}, {5, 5}}, Gap{u, u, {7, 1}}}) {
    EXPECT_FALSE(check_touches(gap, u, u, answered));
    EXPECT_FALSE(check_touches(gap, {0, 2}, {5, 2}, answered));
    EXPECT_EQ(check_diameter(gap, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter(gap, -0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter(gap, std::numeric_limits<double>::denorm_min(), answered), Sign::negative);
    EXPECT_EQ(check_diameter(gap, std::numeric_limits<double>::max(), answered), Sign::negative);
    EXPECT_EQ(exact::length(gap), 0.0);
    EXPECT_EQ(exact::end(gap), u);
  }
}

TEST(GapTies, EndsOfGapsParallelToAnAxisAreExact) {
  EXPECT_EQ(exact::end({{0.1, 0.7}, {0.3, -1}, {0.3, 5}}), (Point{0.3, 0.7}));
  EXPECT_EQ(exact::end({{0.1, 0.7}, {-5, 0.2}, {9, 0.2}}), (Point{0.1, 0.2}));
  EXPECT_EQ(exact::end({{2, 0}, {-1, -1}, {5, 5}}), (Point{1, 1}));
  EXPECT_EQ(exact::end({{1, -1}, {-2, -2}, {5, 5}}), (Point{0, 0}));
  EXPECT_EQ(exact::length({{3, 4}, {0, 0}, {0, 0}}), 5.0);
}

}  // namespace
}  // namespace waywright::test

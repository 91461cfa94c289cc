#include "exact/gap.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact/gap_checks.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Kinds, Gaps, testing::ValuesIn(kKinds), kind_of_test);

TEST_P(Gaps, DotAgreesWithRationals) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) check_dot(point(), point(), point(), point(), answered_);
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
    const Point end = exact::end_of(gap);
    ASSERT_TRUE(is_near(end.x, expected.x, 8)) << testing::PrintToString(gap);
    ASSERT_TRUE(is_near(end.y, expected.y, 8)) << testing::PrintToString(gap);
  }
}

TEST_P(Gaps, LargestRadiusAgreesWithComparisons) {
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap gap = source_.gap();
    if (squared_length(gap) == 0) continue;
    const double radius = exact::largest_radius(gap);
    EXPECT_TRUE(exact::compare_to_diameter(gap, radius) >= 0);
    EXPECT_TRUE(exact::compare_to_diameter(gap, std::nextafter(radius, 2 * radius)) < 0);
  }
}

TEST(GapSizes, LargestOffsetsFit) {
  check_largest_offsets(600, [](LargestOffsets& source, Answered& answered) {
    const Gap p = {source.point(), source.point(), source.point()};
    const Gap q = {source.point(), source.point(), source.point()};
    check_lengths(p, q, answered);
    check_distances(p.from, p.a, p.b, q.a, q.b, answered);
    check_dot(p.from, p.a, q.from, q.a, answered);
    check_diameter(p, source.length(), answered);
    check_distance(p.from, p.a, p.b, source.length(), answered);
  });
}

// Constructed ties.

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

/// Ties that only integers of any size can decide: no lattice of 64 bits contains the points.
TEST(GapTies, OfMixedScales) {
  Answered answered;
  const Point u = {0, 0};
  for (const auto& [x, y, z] : kTriples) {
    const Point v = Point{x, y} * 0x1p90;
    const Point c = Point{y, -x} * 0x1p-60;
    const Point d = Point{-y, x} * 0x1p80;
    EXPECT_EQ(check_dot(u, v, c, d, answered), Sign::zero);
    EXPECT_EQ(check_diameter({u, c, d}, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter({u, c, d}, std::numeric_limits<double>::denorm_min(), answered), Sign::negative);
    EXPECT_EQ(check_distance(u, c, d, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_lengths({u, c, d}, {v, v, v}, answered), Sign::zero);
    EXPECT_EQ(check_distances(u, c, d, u, v, answered), Sign::zero);
    EXPECT_EQ(exact::length({u, c, d}), 0.0);
    EXPECT_EQ(exact::end_of({u, c, d}), u);
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

// dot() with crossings.

/// Moves a crossing. The coordinates stay the nearest doubles, because symmetries commute with rounding.
struct MovedCrossing {
  MovedCrossing(const exact::ExactPosition& p, const Symmetry& move) {
    const Point nearest = move({p.x, p.y});
    point = exact::explicit_position(nearest);
    if (p.is_explicit()) return;
    crossing = {move(p.ab->a), move(p.ab->b), move(p.cd->a), move(p.cd->b)};
    point = {nearest.x, nearest.y, &crossing};
  }
  MovedCrossing(const MovedCrossing&) = delete;
  MovedCrossing& operator=(const MovedCrossing&) = delete;

  exact::Crossing crossing{};
  exact::ExactPosition point;
};

Sign check_exact_dot(const Point& p, const exact::ExactPosition& q, const Point& a, const Point& b,
                     Answered& answered) {
  const Sign expected = sign_of_rational(rational_dot(rational(q) - rational(p), rational(b) - rational(a)));
  EXPECT_EQ(exact::dot(p, q, a, b), expected);
  EXPECT_EQ(exact::dot(p, q, b, a), -expected);
  for (const Symmetry& move : symmetries()) {
    EXPECT_EQ(exact::dot(move(p), MovedCrossing(q, move).point, move(a), move(b)), expected);
  }
  if (q.is_explicit()) {
    EXPECT_EQ(exact::dot(p, Point{q.x, q.y}, a, b), expected);
  }
  expect_stages(exact::stages::dot(p, q, a, b), expected, answered);
  return expected;
}

class ExactDots : public testing::TestWithParam<PointSource::Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ExactDots,
                         testing::Values(PointSource::Kind::small_lattice, PointSource::Kind::large_integers,
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes),
                         [](const auto& kind) { return kind_name(kind); });

TEST_P(ExactDots, AgreeWithRationals) {
  PointSource source(GetParam(), 3);
  Answered answered;
  const auto point = [&] {
    for (;;) {
      if (const Point result = source.point(); is_in_range(result)) return result;
    }
  };
  for (int i = 0; i < case_count(1500, 6) && !HasFailure(); ++i) {
    const exact::ExactPosition q = source.any();
    const Point nearest = {q.x, q.y};
    if (q.is_explicit() && !is_in_range(nearest)) continue;
    const Point p = point(), a = point(), b = point();
    check_exact_dot(p, q, a, b, answered);
    // Near ties: p is the rounded crossing, or a neighbour of it, or differs from it perpendicularly to the direction.
    const Point step = {a.y - b.y, b.x - a.x};
    for (const Point& near : {nearest, Point{above(q.x), q.y}, {q.x, below(q.y)}, nearest + step, nearest - step * 3}) {
      if (is_in_range(near)) check_exact_dot(near, q, a, b, answered);
    }
    check_exact_dot(p, q, a, a, answered);
  }
  EXPECT_GT(answered.doubles, answered.calls / 4);
  EXPECT_LT(answered.doubles, answered.calls);
}

/// Right angles at a line of the crossing: the direction is perpendicular to the line, and p is a point of the line.
TEST(ExactDotTies, RightAnglesAtALine) {
  Answered answered;
  Random random(4);
  const auto whole = [&] { return static_cast<double>(random.between(-9, 9)); };
  for (const Frame& frame : kFrames) {
    int crossings = 0;
    for (int i = 0; i < case_count(200, 3) && !testing::Test::HasFailure(); ++i) {
      const Point from = {whole(), whole()}, along = {whole(), whole()}, other = {whole(), whole()},
                  across = {whole(), whole()}, away = {whole(), whole()};
      if (cross(along, across) == 0) continue;
      const auto at = [&](const Point& point) { return frame.at(point.x, point.y); };
      const exact::Crossing crossing = {at(from), at(from + along), at(other), at(other + across)};
      const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
      if (rounded.is_exact) continue;
      crossings += 1;
      const exact::ExactPosition q = {rounded.nearest.x, rounded.nearest.y, &crossing};
      const Point a = at(away), b = at(away + Point{-along.y, along.x} * 2);
      for (const Point& p : {at(from), at(from + along), at(from - along * 5)}) {
        EXPECT_EQ(check_exact_dot(p, q, a, b, answered), Sign::zero);
        for (const Point& near : {Point{above(b.x), b.y}, {b.x, below(b.y)}}) {
          if (is_in_range(near)) check_exact_dot(p, q, a, near, answered);
        }
        for (const Point& near : {Point{below(p.x), p.y}, {p.x, above(p.y)}}) {
          if (is_in_range(near)) check_exact_dot(near, q, a, b, answered);
        }
      }
    }
    EXPECT_GT(crossings, case_count(50, 3));
  }
  EXPECT_GT(answered.doubles, 0);
}

/// Crossings much nearer to 0 than any coordinate, and far outside the range of coordinates.
TEST(ExactDotTies, CrossingsOutOfRange) {
  Answered answered;
  const double tiny = kSmallestCoordinate, huge = kLargestCoordinate, tiny_step = std::ldexp(1.0, -152);
  // Nearly parallel lines through points around 0.
  const std::array<exact::Crossing, 3> crossings = {
      exact::Crossing{{-huge, -tiny}, {huge, tiny + tiny_step}, {-huge, tiny}, {huge, -tiny}},
      exact::Crossing{{0, tiny}, {tiny, tiny}, {0, 0}, {huge, tiny_step + tiny}},
      exact::Crossing{{0, 0}, {huge, tiny}, {tiny, huge}, {3 * tiny, -huge}}};
  for (const exact::Crossing& crossing : crossings) {
    const exact::RoundedCrossing rounded = exact::integers::round_to_nearest(crossing);
    ASSERT_FALSE(rounded.is_exact);
    const exact::ExactPosition q = {rounded.nearest.x, rounded.nearest.y, &crossing};
    const std::array<Point, 7> points = {
        {{0, 0}, {tiny, 0}, {0, -tiny}, {huge, huge}, {-huge, tiny}, {tiny, tiny + tiny_step}, {1, -3}}};
    for (const Point& p : points) {
      for (const Point& a : points) {
        for (const Point& b : points) check_exact_dot(p, q, a, b, answered);
      }
    }
  }
  EXPECT_GT(answered.doubles, 0);
}

TEST(GapTies, EmptyGaps) {
  Answered answered;
  const Point u = {2, 2};
  for (const Gap& gap : {Gap{u, u, u}, Gap{u, {0, 0}, {5, 5}}, Gap{u, u, {7, 1}}}) {
    EXPECT_EQ(check_diameter(gap, 0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter(gap, -0.0, answered), Sign::zero);
    EXPECT_EQ(check_diameter(gap, std::numeric_limits<double>::denorm_min(), answered), Sign::negative);
    EXPECT_EQ(check_diameter(gap, std::numeric_limits<double>::max(), answered), Sign::negative);
    EXPECT_EQ(exact::length(gap), 0.0);
    EXPECT_EQ(exact::end_of(gap), u);
  }
}

TEST(GapTies, EndsOfGapsParallelToAnAxisAreExact) {
  EXPECT_EQ(exact::end_of({{0.1, 0.7}, {0.3, -1}, {0.3, 5}}), (Point{0.3, 0.7}));
  EXPECT_EQ(exact::end_of({{0.1, 0.7}, {-5, 0.2}, {9, 0.2}}), (Point{0.1, 0.2}));
  EXPECT_EQ(exact::end_of({{2, 0}, {-1, -1}, {5, 5}}), (Point{1, 1}));
  EXPECT_EQ(exact::end_of({{1, -1}, {-2, -2}, {5, 5}}), (Point{0, 0}));
  EXPECT_EQ(exact::length({{3, 4}, {0, 0}, {0, 0}}), 5.0);
}

}  // namespace
}  // namespace waywright::test

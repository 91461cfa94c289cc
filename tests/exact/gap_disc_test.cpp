#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "exact/gap.hpp"
#include "exact/gap_checks.hpp"
#include "exact/rational.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

// Tests of touches().

namespace waywright::test {
namespace {

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

class Discs : public Gaps {};
INSTANTIATE_TEST_SUITE_P(Kinds, Discs, testing::ValuesIn(kKinds), kind_of_test);

TEST_P(Discs, TouchesAgreesWithRationals) {
  int touch = 0;
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const Gap gap = source_.gap();
    touch += check_touches(gap, point(), point(), answered_) ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << testing::PrintToString(gap);
  }
  EXPECT_GT(touch, kCalls / 10);
  EXPECT_LT(touch, kCalls);
  expect_all_stages_of_whole_numbers();
}

Point turned(const Point& p) { return {-p.y, p.x}; }

/// Segments with an end at a point of the gap. Many of them are perpendicular to the gap or lie on the line of the
/// foot, up to rounding errors.
TEST_P(Discs, TouchesAgreesWithRationalsAtTheEndsOfTheGap) {
  for (int i = 0; i < kCalls / 8 && !HasFailure(); ++i) {
    const Gap gap = source_.gap();
    const Point direction = gap.a == gap.b ? gap.a - gap.from : turned(gap.b - gap.a);
    for (const Point& c : {gap.from, gap.a, gap.b, exact::end_of(gap)}) {
      for (const Point& d : {c, point(), gap.from, gap.a, gap.b, c + turned(direction), c - turned(direction),
                             c + direction, c - direction * 0.5}) {
        if (!is_in_range(c) || !is_in_range(d)) continue;
        check_touches(gap, c, d, answered_);
        ASSERT_FALSE(HasFailure()) << testing::PrintToString(gap);
        if (const Point past = c - (d - c); is_in_range(past)) check_touches(gap, past, d, answered_);
      }
    }
  }
  EXPECT_GT(answered_.doubles, 0);
  EXPECT_LT(answered_.doubles, answered_.calls);
}

TEST(DiscSizes, LargestOffsetsFit) {
  check_largest_offsets(case_count(2000), [](LargestOffsets& source, Answered& answered) {
    const Gap gap = {source.point(), source.point(), source.point()};
    check_touches(gap, source.point(), source.point(), answered);
  });
}

/// A segment on a tangent of the disc, or with an end on its circle.
TEST(DiscTies, Tangents) {
  Answered answered;
  Random random(5);
  const auto whole = [&](std::int64_t most) { return static_cast<double>(random.between(-most, most)); };
  for (const Frame& frame : kFrames) {
    for (int i = 0; i < case_count(60, 4) && !testing::Test::HasFailure(); ++i) {
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
      const bool counts = z != Point{} && z != w;
      for (const Gap& gap : {Gap{u, v, v}, to_foot}) {
        const Point c = at(z - tangent), d = at(z + tangent * 2);
        EXPECT_EQ(check_touches(gap, c, d, answered), counts);
        EXPECT_EQ(check_touches(gap, at(z), at(z), answered), counts);
        EXPECT_EQ(check_touches(gap, at(z), d, answered), counts);
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

/// The gap from (0, 0) to (2 x, 2 y), in three forms with a foot besides the plain one.
std::array<Gap, 4> gaps_along(const Frame& frame, double x, double y) {
  const Point u = frame.at(0, 0), v = frame.at(2 * x, 2 * y), before = frame.at(2 * x - y, 2 * y + x),
              after = frame.at(2 * x + 3 * y, 2 * y - 3 * x), further = frame.at(2 * x + 5 * y, 2 * y - 5 * x);
  return {{{u, v, v}, {u, before, after}, {u, v, after}, {u, after, further}}};
}

/// All segments between positions at which the answer may change.
TEST(DiscTies, SegmentsBetweenSpecialPositions) {
  Answered answered;
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, z] : kTriples) {
      // With (0, 0) and (2 x, 2 y) as u and v: u, v and the middle; corners of rectangles about the disc, on which the
      // ends of perpendiculars and the points of tangency lie; positions on the line of the gap.
      std::vector<Point> points;
      for (const double along : {-1, 0, 1, 2, 3}) {
        for (const double across : {-2, -1, 0, 1, 2}) {
          points.push_back(frame.at(along * x - across * y, along * y + across * x));
        }
      }
      // The corners of the axis-parallel rectangle with the gap as its diagonal lie on the circle.
      points.push_back(frame.at(2 * x, 0));
      points.push_back(frame.at(0, 2 * y));
      const std::array<Gap, 4> gaps = gaps_along(frame, x, y);
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i; j < points.size() && !testing::Test::HasFailure(); ++j) {
          if (is_quick() && (i + j) % 5 != 0) continue;
          const bool plain = check_touches(gaps[0], points[i], points[j], answered);
          const Gap& other = gaps[1 + (i + j) % 3];
          EXPECT_EQ(check_touches(other, points[i], points[j], answered), plain) << testing::PrintToString(other);
        }
      }
    }
  }
  EXPECT_GT(answered.whole, 0);
  EXPECT_GT(answered.small, answered.whole);
  EXPECT_GT(answered.wide, answered.narrow / 2);
  EXPECT_LT(answered.doubles, answered.calls);
}

/// Segments through an end of the gap, perpendicular to the gap: exactly, or off by the last digit of a coordinate.
TEST(DiscTies, PerpendicularsAtTheEnds) {
  Answered answered;
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, z] : kTriples) {
      for (const Gap& gap : gaps_along(frame, x, y)) {
        for (const double along : {0, 2}) {
          const auto at = [&, x = x, y = y](double across) {
            return frame.at(along * x - across * y, along * y + across * x);
          };
          for (const auto& [first, last] : {std::pair{-1.0, 1.0}, {-3.0, 0.0}, {0.0, 2.0}, {0.0, 0.0}, {1.0, 3.0}}) {
            const Point c = at(first), d = at(last);
            EXPECT_FALSE(check_touches(gap, c, d, answered)) << testing::PrintToString(gap);
            for (const Point& near :
                 {Point{above(d.x), d.y}, {below(d.x), d.y}, {d.x, above(d.y)}, {d.x, below(d.y)}}) {
              if (is_in_range(near)) check_touches(gap, c, near, answered);
            }
          }
        }
      }
    }
  }
}

TEST(DiscTies, FewExamples) {
  const Point u = {0, 0}, v = {4, 0};
  for (const Gap& gap : {Gap{u, v, v}, Gap{u, {4, -1}, {4, 3}}, Gap{u, {4, 2}, {4, 3}}, Gap{u, v, {4, 3}}}) {
    EXPECT_TRUE(exact::touches(gap, u, v));
    EXPECT_FALSE(exact::touches(gap, u, u));
    EXPECT_FALSE(exact::touches(gap, v, v));
    EXPECT_TRUE(exact::touches(gap, {2, 2}, {2, 2}));    // on the circle
    EXPECT_TRUE(exact::touches(gap, {1, 2}, {9, 2}));    // on a tangent
    EXPECT_FALSE(exact::touches(gap, {3, 2}, {9, 2}));   // beside the position where the tangent touches
    EXPECT_FALSE(exact::touches(gap, {4, -1}, {4, 1}));  // on the line of the foot
    EXPECT_FALSE(exact::touches(gap, {0, -1}, {0, 1}));  // on the tangent at u
    EXPECT_FALSE(exact::touches(gap, v, {5, 7}));        // away from v
    EXPECT_TRUE(exact::touches(gap, v, {3.9375, 9}));    // into the disc
    EXPECT_TRUE(exact::touches(gap, {5, 1}, {3, -1}));   // through v
    EXPECT_FALSE(exact::touches(gap, {5, 1}, {4.5, -1}));
    EXPECT_FALSE(exact::touches(gap, {-3, 0}, u));
    EXPECT_TRUE(exact::touches(gap, {-3, 0}, {1, 0}));
    EXPECT_TRUE(exact::touches(gap, {-9, 0}, {9, 0}));
  }
}

/// Ties on no lattice of 64 bits, which only integers of any size can decide; and others on large lattices.
TEST(DiscTies, OfMixedScales) {
  Answered without_lattice, on_lattice;
  const Point u = {0, 0};
  for (const auto& [x, y, z] : kTriples) {
    const Point v = Point{x, y} * 0x1p90;
    const Point c = Point{y, -x} * 0x1p-60;
    const Point d = Point{-y, x} * 0x1p80;
    const Gap to_foot = {u, v, v + Point{-y, x} * 0x1p88};
    for (const Gap& gap : {Gap{u, v, v}, to_foot}) {
      EXPECT_FALSE(check_touches(gap, c, d, without_lattice));  // on the tangent at u
      EXPECT_FALSE(check_touches(gap, u, d, on_lattice));
      EXPECT_TRUE(check_touches(gap, c, d + v * 0x1p-40, without_lattice));
      EXPECT_TRUE(check_touches(gap, u, d + v * 0x1p-40, on_lattice));
      EXPECT_FALSE(check_touches(gap, u, d - v * 0x1p-40, on_lattice));
      EXPECT_FALSE(check_touches(gap, v + d, v - d, on_lattice));
      EXPECT_TRUE(check_touches(gap, v + d, c, without_lattice));
    }
  }
  EXPECT_EQ(without_lattice.wide, 0);
}

/// No position counts if the ends of the gap are equal.
TEST(DiscTies, EmptyGaps) {
  Answered answered;
  const Point u = {2, 2};
  for (const Gap& gap : {Gap{u, u, u}, Gap{u, {0, 0}, {5, 5}}, Gap{u, u, {7, 1}}}) {
    for (const auto& [c, d] : {std::pair{u, u}, {{0, 2}, {5, 2}}, {{0, 0}, {5, 5}}, {u, {7, 1}}, {{1, 2}, {3, 5}}}) {
      EXPECT_FALSE(check_touches(gap, c, d, answered));
    }
  }
}

}  // namespace
}  // namespace waywright::test

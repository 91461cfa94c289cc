#include "exact/predicates.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "exact/crossing.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"
#include "exact/stage_agreement.hpp"
#include "support/case_count.hpp"
#include "support/data_folder.hpp"

namespace waywright::test {

namespace {

using exact::Crossing;
using exact::ExactPosition;
using exact::Sign;

class Predicates : public testing::TestWithParam<PointSource::Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, Predicates,
                         testing::Values(PointSource::Kind::small_lattice, PointSource::Kind::large_integers,
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes),
                         kind_name);

/// Returns whether `bounded` is the sign `expected`, or zero, which says that the bound cannot decide the sign.
bool is_open_or(Sign expected, Sign bounded) { return bounded == Sign::zero || bounded == expected; }

TEST_P(Predicates, OrientationAgreesWithRationals) {
  PointSource source(GetParam(), 1);
  for (int i = 0; i < case_count(1500); ++i) {
    const ExactPosition a = source.any(), b = source.any(), c = source.any();
    const Sign expected = rational_orientation(rational(a), rational(b), rational(c));
    ASSERT_EQ(exact::orientation(a, b, c), expected) << "call " << i;
    ASSERT_EQ(exact::integers::orientation(a, b, c), expected) << "call " << i;
    ASSERT_EQ(exact::filter::fine::orientation(a, b, c).value_or(expected), expected) << "call " << i;
    ASSERT_TRUE(is_open_or(expected, exact::filter::coarse::orientation(a, b, c))) << "call " << i;
    ASSERT_TRUE(is_open_or(expected, orientation_in_box(a, b, c))) << "call " << i;
    ASSERT_EQ(exact::orientation(b, a, c), -expected);
    ASSERT_EQ(exact::orientation(a, c, b), -expected);
    ASSERT_EQ(exact::orientation(b, c, a), expected);
  }
}

TEST_P(Predicates, InCircleAgreesWithRationals) {
  PointSource source(GetParam(), 2);
  for (int i = 0; i < case_count(1000); ++i) {
    const ExactPosition a = source.any(), b = source.any(), c = source.any(), d = source.any();
    const Sign expected = rational_in_circle(rational(a), rational(b), rational(c), rational(d));
    ASSERT_EQ(exact::in_circle(a, b, c, d), expected) << "call " << i;
    ASSERT_EQ(exact::integers::in_circle(a, b, c, d), expected) << "call " << i;
    ASSERT_EQ(exact::filter::fine::in_circle(a, b, c, d).value_or(expected), expected) << "call " << i;
    ASSERT_EQ(exact::any_origin::in_circle(a, b, c, d).value_or(expected), expected) << "call " << i;
    ASSERT_TRUE(is_open_or(expected, coarse_in_circle(a, b, c, d))) << "call " << i;
    ASSERT_TRUE(is_open_or(expected, in_circle_in_box(a, b, c, d))) << "call " << i;
    ASSERT_EQ(exact::lattice::whole_in_circle(a, b, c, d).value_or(expected), expected) << "call " << i;
    ASSERT_EQ(exact::in_circle(b, c, a, d), expected);
    ASSERT_EQ(exact::in_circle(b, a, c, d), -expected);
    ASSERT_EQ(exact::in_circle(a, b, d, c), -expected);
  }
}

TEST_P(Predicates, OrderAgreesWithRationals) {
  PointSource source(GetParam(), 3);
  for (int i = 0; i < case_count(2000); ++i) {
    const ExactPosition p = source.any(), q = source.random().chance(20) ? p : source.any();
    const Sign expected = rational_order(rational(p), rational(q));
    ASSERT_EQ(exact::compare(p, q) < 0, expected == Sign::negative);
    ASSERT_EQ(exact::compare(p, q) == 0, expected == Sign::zero);
    ASSERT_EQ(exact::compare(q, p) > 0, expected == Sign::negative);
  }
}

// Points within a few ulps of a line and of a circle. The filter cannot decide most of these, and must never give a
// wrong sign.
TEST(Filter, IsNeverWrongNextToZero) {
  Random random(4);
  int undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto nudge = [&] { return static_cast<double>(random.between(-2, 2)) * 0x1p-52; };
    const double t = static_cast<double>(random.between(0, 1 << 20)) * 0x1p-20;
    const ExactPosition a{0.1, 0.1}, b{0.9, 0.9}, c{t + nudge(), t + nudge()};
    const auto filtered = exact::filter::fine::orientation(a, b, c);
    if (!filtered) {
      ++undecided;
    } else {
      ASSERT_EQ(*filtered, rational_orientation(rational(a), rational(b), rational(c)));
    }
    const ExactPosition d{0.6 + nudge(), 0.8 + nudge()};
    const ExactPosition east{1.0, nudge()}, north{nudge(), 1.0}, west{-1.0, nudge()};
    const auto circled = exact::filter::fine::in_circle(east, north, west, d);
    if (circled) {
      ASSERT_EQ(*circled, rational_in_circle(rational(east), rational(north), rational(west), rational(d)));
    }
  }
  EXPECT_GT(undecided, 0);
}

TEST(Filter, DecidesPlainCasesAlone) {
  const ExactPosition a{0, 0}, b{4, 0}, c{0, 4};
  EXPECT_EQ(exact::filter::fine::orientation(a, b, c), Sign::positive);
  EXPECT_EQ(exact::filter::fine::orientation(a, b, ExactPosition{9, 0}), Sign::zero);
  EXPECT_EQ(exact::filter::fine::in_circle(a, b, c, ExactPosition{1, 1}), Sign::positive);
  EXPECT_EQ(exact::filter::fine::in_circle(a, b, c, ExactPosition{9, 9}), Sign::negative);
}

TEST(Filter, DecidesPlainCasesByItsCoarseBounds) {
  const ExactPosition a{0, 0}, b{4, 0}, c{0, 4};
  EXPECT_EQ(exact::filter::coarse::orientation(a, b, c), Sign::positive);
  EXPECT_EQ(exact::filter::coarse::orientation(b, a, c), Sign::negative);
  EXPECT_EQ(exact::filter::coarse::orientation(a, b, ExactPosition{9, 0}), Sign::zero);
  EXPECT_EQ(orientation_in_box(a, b, c), Sign::positive);
  EXPECT_EQ(orientation_in_box(a, b, ExactPosition{9, 0}), Sign::zero);
  EXPECT_EQ(coarse_in_circle(a, b, c, ExactPosition{1, 1}), Sign::positive);
  EXPECT_EQ(in_circle_in_box(a, b, c, ExactPosition{1, 1}), Sign::positive);
  EXPECT_EQ(coarse_in_circle(a, b, c, ExactPosition{9, 9}), Sign::negative);
  EXPECT_EQ(in_circle_in_box(a, b, c, ExactPosition{9, 9}), Sign::negative);
  EXPECT_EQ(coarse_in_circle(a, b, c, ExactPosition{4, 4}), Sign::zero);
  EXPECT_EQ(in_circle_in_box(a, b, c, ExactPosition{4, 4}), Sign::zero);
}

// Points a metre apart, thousands of kilometres from the origin, as in survey data.
TEST(Filter, DecidesPointsFarFromTheOriginByItsCoarseBounds) {
  const ExactPosition a{4500000.25, 5300000.5}, b{4500001.25, 5300000.5}, c{4500000.25, 5300001.75};
  EXPECT_EQ(exact::filter::coarse::orientation(a, b, c), Sign::positive);
  EXPECT_EQ(orientation_in_box(a, b, c), Sign::positive);
  EXPECT_EQ(coarse_in_circle(a, b, c, ExactPosition{4500000.5, 5300000.75}), Sign::positive);
  EXPECT_EQ(in_circle_in_box(a, b, c, ExactPosition{4500000.5, 5300000.75}), Sign::positive);
}

// Crossings of walls that nearly lie on the x axis: the errors of their y coordinates are as small as these
// coordinates.
TEST(Filter, DecidesFlatCasesOfCrossings) {
  const Crossing low{{0, 0x1p-40}, {1, 0x3p-40}, {0, 0x5p-40}, {1, 0x2p-40}};
  const Crossing high{{0, 0x2p-40}, {1, 0x4p-40}, {0, 0x7p-40}, {1, 0x3p-40}};
  const auto at = [](const Crossing& crossing) -> ExactPosition {
    const Point nearest = exact::integers::round_to_nearest(crossing).nearest;
    return {nearest.x, nearest.y, &crossing};
  };
  // low lies at x = 4/5 and high at x = 5/6. In units of 2^-40, their heights are 13/5 and 11/3.
  const ExactPosition a{0.25, 0x1p-40}, b{0.75, 0x9p-40};
  for (const bool is_steep : {false, true}) {
    const auto turned = [&](const ExactPosition& p) { return is_steep ? ExactPosition{p.y, p.x} : p; };
    const auto turned_crossing = [&](const Crossing& c) -> Crossing {
      const auto turn = [&](const Point& p) { return is_steep ? Point{p.y, p.x} : p; };
      return {turn(c.ab.a), turn(c.ab.b), turn(c.cd.a), turn(c.cd.b)};
    };
    const Crossing low_turned = turned_crossing(low), high_turned = turned_crossing(high);
    const ExactPosition p = at(low_turned), q = at(high_turned), from = turned(a), to = turned(b);
    EXPECT_EQ(exact::filter::fine::orientation(from, p, q), exact::integers::orientation(from, p, q));
    EXPECT_EQ(exact::filter::fine::orientation(from, p, q), is_steep ? Sign::negative : Sign::positive);
    EXPECT_EQ(exact::filter::fine::in_circle(from, p, q, to), exact::integers::in_circle(from, p, q, to));
  }
}

// Two points 2^-45 apart, and two points far from them: (1, 2^-45) lies inside the circle through (1, 0), (2, -1) and
// the crossing, because the centre of this circle lies above the x axis, near (2.25, 0.25).
TEST(Filter, DecidesTwoClosePointsByTheRightOrigin) {
  const Crossing crossing{{0, 0}, {9, 3}, {0, 2}, {7, 0}};  // at (42/13, 14/13)
  const Point nearest = exact::integers::round_to_nearest(crossing).nearest;
  std::array<ExactPosition, 4> points = {{{1, 0}, {2, -1}, {nearest.x, nearest.y, &crossing}, {1, 0x1p-45}}};
  for (int i = 0; i < 4; ++i) {
    const auto& [a, b, c, d] = points;
    const Sign right = exact::integers::in_circle(a, b, c, d);
    EXPECT_EQ(right, i % 2 == 0 ? Sign::positive : Sign::negative);
    EXPECT_EQ(exact::any_origin::in_circle(a, b, c, d), right);
    std::rotate(points.begin(), points.begin() + 1, points.end());
  }
}

TEST(Rectangle, IsRecognisedByItsCornersInAnyOrder) {
  std::array<ExactPosition, 4> corners = {{{0.1, 0.3}, {0.7, 0.3}, {0.7, 0.9}, {0.1, 0.9}}};
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  do {
    const auto corner = [&](std::size_t i) { return corners[order[i]]; };
    EXPECT_TRUE(exact::filter::is_rectangle(corner(0), corner(1), corner(2), corner(3)));
    for (std::size_t moved = 0; moved < 4; ++moved) {
      std::array<ExactPosition, 4> others = {corner(0), corner(1), corner(2), corner(3)};
      (order[0] % 2 == 0 ? others[moved].x : others[moved].y) = 0.5;
      EXPECT_FALSE(exact::filter::is_rectangle(others[0], others[1], others[2], others[3]));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(WholeNumbers, AcceptOnlyWhatFits) {
  // The corners of a square lie on one circle. For a side of s, the squares of the offsets add up to 4 s^2.
  const auto corner = [](double side, double x, double y) { return ExactPosition{side * x, side * y}; };
  const auto ask = [&](double side) {
    return exact::lattice::whole_in_circle(corner(side, 0, 0), corner(side, 1, 0), corner(side, 1, 1),
                                           corner(side, 0, 1));
  };
  EXPECT_EQ(ask(3), Sign::zero);
  EXPECT_EQ(ask(16384), Sign::zero);
  EXPECT_EQ(ask(16385), std::nullopt);
  EXPECT_EQ(ask(0.5), std::nullopt);
  const auto ask_far_out = [](double x) {
    return exact::lattice::whole_in_circle({x, 0}, {x + 2, 0}, {x + 2, 2}, {x, 2});
  };
  EXPECT_EQ(ask_far_out(0x1p52), Sign::zero);
  EXPECT_EQ(ask_far_out(0x1p51 + 0.5), std::nullopt);
  EXPECT_EQ(ask_far_out(-0x1p51 - 0.5), std::nullopt);
  EXPECT_EQ(exact::lattice::whole_in_circle({0, 0}, {9, 0}, {9, 9}, {1, 8}), Sign::positive);
}

TEST(Constructed, LiesOnBothItsLinesAndIsNoDouble) {
  // The lines y = x / 3 and y = 2 - 2 x / 7 meet at (42/13, 14/13).
  const Point a{0, 0}, b{9, 3}, c{0, 2}, d{7, 0};
  const exact::Crossing crossing{a, b, c, d};
  const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
  EXPECT_FALSE(rounded.is_exact);
  const ExactPosition p{rounded.nearest.x, rounded.nearest.y, &crossing};
  EXPECT_EQ(exact::orientation(exact::explicit_position(a), exact::explicit_position(b), p), Sign::zero);
  EXPECT_EQ(exact::orientation(p, exact::explicit_position(d), exact::explicit_position(c)), Sign::zero);
  EXPECT_NE(exact::compare(p, ExactPosition{p.x, p.y}), std::strong_ordering::equal);
}

TEST(Constructed, OnePositionHasOneValueWhateverPairMadeIt) {
  // (42/13, 14/13) again, as the crossing of two other segments.
  const exact::Crossing first{{0, 0}, {9, 3}, {0, 2}, {7, 0}};
  const exact::Crossing second{{3, 1}, {-6, -2}, {14, -2}, {-7, 4}};
  const exact::RoundedCrossing p = exact::round_to_nearest(first);
  const exact::RoundedCrossing q = exact::round_to_nearest(second);
  EXPECT_EQ(p.nearest, q.nearest);
  const ExactPosition one{p.nearest.x, p.nearest.y, &first};
  const ExactPosition other{q.nearest.x, q.nearest.y, &second};
  EXPECT_EQ(exact::compare(one, other), std::strong_ordering::equal);
  EXPECT_EQ(exact::to_fractions(one), "42 13 14 13");
  EXPECT_EQ(exact::to_fractions(other), "42 13 14 13");
}

// 1,000 lines each of input that is nearly degenerate, as in Shewchuk's examples. Skipped where the real data is
// absent.
TEST(RealData, SignsOfNastyPredicates) {
  const std::filesystem::path folder = data_folder() / "nasty" / "predicates";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  std::size_t lines = 0;
  const auto read = [&](std::ifstream& file, std::span<ExactPosition> points, int& expected) {
    int id = 0;
    if (!(file >> id)) return false;
    for (ExactPosition& point : points) file >> point.x >> point.y;
    file >> expected;
    ++lines;
    return true;
  };
  int expected = 0;
  std::array<ExactPosition, 4> p;
  std::ifstream orientations(folder / "orient2d.txt");
  while (read(orientations, std::span(p).first(3), expected)) {
    ASSERT_EQ(static_cast<int>(exact::orientation(p[0], p[1], p[2])), expected) << "orient2d, line " << lines;
    ASSERT_EQ(static_cast<int>(exact::integers::orientation(p[0], p[1], p[2])), expected);
  }
  std::ifstream circles(folder / "incircle.txt");
  while (read(circles, p, expected)) {
    ASSERT_EQ(static_cast<int>(exact::in_circle(p[0], p[1], p[2], p[3])), expected) << "incircle, line " << lines;
    ASSERT_EQ(static_cast<int>(exact::integers::in_circle(p[0], p[1], p[2], p[3])), expected);
  }
  EXPECT_EQ(lines, 2000U);
}

}  // namespace
}  // namespace waywright::test

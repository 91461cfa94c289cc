#include "exact/crossing.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact/geometry.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"

namespace waywright::test {
namespace {

/// Whether no double is nearer to `value` than `rounded`, and of two as near, `rounded` is the even one.
bool is_nearest(double rounded, const Rational& value) {
  const Rational error = abs(Rational(Rational(rounded) - value));
  const auto is_even = [](double v) { return (std::bit_cast<std::uint64_t>(v) & 1) == 0; };
  for (const double direction : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    const Rational other = abs(Rational(Rational(std::nextafter(rounded, direction)) - value));
    if (other < error || (other == error && !is_even(rounded))) return false;
  }
  return true;
}

class Rounding : public testing::TestWithParam<PointSource::Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, Rounding,
                         testing::Values(PointSource::Kind::small_lattice, PointSource::Kind::large_integers,
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes));

TEST_P(Rounding, IsToNearest) {
  PointSource source(GetParam(), 5);
  for (int i = 0; i < 1500; ++i) {
    const exact::ExactPoint p = source.any();
    if (p.is_explicit()) continue;
    const RationalPoint value = rational(p);
    ASSERT_TRUE(is_nearest(p.x, value.x)) << p.x << " is not nearest to " << value.x;
    ASSERT_TRUE(is_nearest(p.y, value.y)) << p.y << " is not nearest to " << value.y;
  }
}

TEST(Rounding, TiesGoToEven) {
  // On the line y = 2^53 + 1 + x, at x = 0: halfway between 2^53, even in its last bit, and 2^53 + 2.
  const exact::Crossing between{{-1, 0x1p53}, {1, 0x1p53 + 2}, {0, 0}, {0, 1}};
  EXPECT_EQ(exact::round_to_nearest(between).nearest, (Point{0, 0x1p53}));
  EXPECT_FALSE(exact::round_to_nearest(between).is_exact);
  // At 2^53 + 3, halfway between 2^53 + 2 and 2^53 + 4: now the larger is even.
  const exact::Crossing above{{-1, 0x1p53 + 2}, {1, 0x1p53 + 4}, {0, 0}, {0, 1}};
  EXPECT_EQ(exact::round_to_nearest(above).nearest, (Point{0, 0x1p53 + 4}));
}

TEST(Rounding, PlacesNearerToZeroThanTheRangeStayConstructed) {
  const exact::Crossing crossing{{-0x1p60, -0x1p-60}, {0x1p60, 0x1p-60}, {0x1p-60, -1}, {0x1p-60, 1}};
  const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
  EXPECT_EQ(rounded.nearest, (Point{0x1p-60, 0x1p-180}));
  EXPECT_FALSE(rounded.is_exact);
}

TEST(Fractions, AreReduced) {
  EXPECT_EQ(exact::to_fractions(exact::ExactPoint{0.5, -6}), "1 2 -6 1");
  EXPECT_EQ(exact::to_fractions(exact::ExactPoint{0, 0x1p60}), "0 1 1152921504606846976 1");
  // y = x / 3 and y = 1 - x / 3 meet in (3/2, 1/2); y = x / 7 and x = 1 in (1, 1/7).
  const exact::Crossing halves{{0, 0}, {3, 1}, {0, 1}, {3, 0}};
  EXPECT_EQ(exact::to_fractions(exact::ExactPoint{1.5, 0.5, &halves}), "3 2 1 2");
  const exact::Crossing sevenths{{0, 0}, {7, 1}, {1, -1}, {1, 4}};
  EXPECT_EQ(exact::to_fractions(exact::ExactPoint{1.0, 1.0 / 7, &sevenths}), "1 1 1 7");
}

TEST(Geometry, CrossingsThatAreDoublesBecomeExplicit) {
  exact::Geometry geometry;
  geometry.place(0, {0, 0});
  geometry.place(1, {2, 2});
  geometry.place(2, {0, 2});
  geometry.place(3, {2, 0});
  geometry.place(4, {3, 0});
  geometry.place_crossing(5, 0, 1, 2, 3);
  EXPECT_TRUE(geometry.view(5).is_explicit());
  EXPECT_EQ(geometry.nearest(5), (Point{1, 1}));
  geometry.place_crossing(6, 0, 1, 2, 4);
  EXPECT_FALSE(geometry.view(6).is_explicit());
  EXPECT_EQ(geometry.nearest(6), (Point{1.2, 1.2}));
  geometry.clear(6);
  geometry.place_crossing(7, 1, 0, 4, 2);
  EXPECT_EQ(exact::to_fractions(geometry.view(7)), "6 5 6 5");
}

}  // namespace
}  // namespace waywright::test

#include "exact/crossing.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "exact/geometry.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"
#include "exact/stage_agreement.hpp"

namespace waywright::test {
namespace {

/// Returns whether no double is nearer to `value` than `rounded`, and whether `rounded` is even where another double is
/// equally near.
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
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes),
                         kind_name);

TEST_P(Rounding, IsToNearest) {
  PointSource source(GetParam(), 5);
  for (int i = 0; i < 1500; ++i) {
    const exact::ExactPosition p = source.any();
    if (p.is_explicit()) continue;
    const RationalPoint value = rational(p);
    ASSERT_TRUE(is_nearest(p.x, value.x)) << p.x << " is not nearest to " << value.x;
    ASSERT_TRUE(is_nearest(p.y, value.y)) << p.y << " is not nearest to " << value.y;
  }
}

// All stages must return the same bits. A result that is exactly a double must be reported as exact by all of them.
TEST_P(Rounding, IsTheSameInEveryStage) {
  PointSource source(GetParam(), 6);
  int in_doubles = 0;
  for (int i = 0; i < 3000; ++i) {
    const exact::ExactPosition p = source.any();
    if (p.is_explicit()) continue;
    const exact::Crossing crossing = p.crossing();
    const exact::RoundedCrossing right = exact::integers::round_to_nearest(crossing);
    const auto agrees = [&](const std::optional<exact::RoundedCrossing>& other) {
      return !other ||
             (std::bit_cast<std::uint64_t>(other->nearest.x) == std::bit_cast<std::uint64_t>(right.nearest.x) &&
              std::bit_cast<std::uint64_t>(other->nearest.y) == std::bit_cast<std::uint64_t>(right.nearest.y) &&
              other->is_exact == right.is_exact);
    };
    in_doubles += exact::doubles::round_to_nearest(crossing) ? 1 : 0;
    ASSERT_TRUE(agrees(exact::doubles::round_to_nearest(crossing))) << "call " << i;
    ASSERT_TRUE(agrees(exact::lattice::round_to_nearest(crossing))) << "call " << i;
  }
  const bool is_small = GetParam() == PointSource::Kind::small_lattice;
  EXPECT_GT(in_doubles, is_small ? 100 : -1);
}

// Offsets from 2^8 to 2^20: some products are below 2^53 and some above, where doubles no longer represent every whole
// number.
TEST(Rounding, OfWholeNumbersIsTheSameInEveryStage) {
  Random random(7);
  int in_doubles = 0;
  constexpr int kCalls = 20000;
  for (int i = 0; i < kCalls; ++i) {
    const std::int64_t reach = std::int64_t{1} << random.between(8, 20);
    const auto point = [&] {
      const auto x = static_cast<double>(random.between(-reach, reach));
      return Point{x, static_cast<double>(random.between(-reach, reach))};
    };
    const exact::Crossing crossing{point(), point(), point(), point()};
    const auto& [a, b] = crossing.ab;
    const auto& [c, d] = crossing.cd;
    if ((b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x)) continue;  // parallel: whole numbers below 2^53
    const auto rounded = exact::doubles::round_to_nearest(crossing);
    if (!rounded) continue;
    ++in_doubles;
    const exact::RoundedCrossing right = exact::integers::round_to_nearest(crossing);
    ASSERT_EQ(rounded->nearest, right.nearest) << "call " << i;
    ASSERT_EQ(rounded->is_exact, right.is_exact) << "call " << i;
  }
  EXPECT_GT(in_doubles, kCalls / 4);
  EXPECT_LT(in_doubles, kCalls);
}

// Mixes coordinates of all sizes, zeros and halves. Some differences and products are rounded, and are then multiplied
// by zero or by a large number.
TEST(Rounding, OfNumbersOfAllSizesIsTheSameInEveryStage) {
  Random random(8);
  int in_doubles = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto coordinate = [&] {
      const std::int64_t reach = std::int64_t{1} << random.between(0, 55);
      const auto whole = static_cast<double>(random.chance(30) ? 0 : random.between(-reach, reach));
      return random.chance(3) ? whole + 0.5 : whole;
    };
    const auto point = [&] {
      const double x = coordinate();
      return Point{x, coordinate()};
    };
    const exact::Crossing crossing{point(), point(), point(), point()};
    const auto rounded = exact::doubles::round_to_nearest(crossing);
    if (!rounded) continue;
    const RationalPoint a = rational(crossing.ab.a), b = rational(crossing.ab.b);
    const RationalPoint c = rational(crossing.cd.a), d = rational(crossing.cd.b);
    if ((b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x)) continue;  // parallel
    ++in_doubles;
    const exact::RoundedCrossing right = exact::integers::round_to_nearest(crossing);
    ASSERT_EQ(rounded->nearest, right.nearest) << "call " << i;
    ASSERT_EQ(rounded->is_exact, right.is_exact) << "call " << i;
  }
  EXPECT_GT(in_doubles, 1000);
}

// In these cases all values up to the numerators are below 2^53, except one sum, 2^54 - 3, in the first case and one
// product in the second.
TEST(Rounding, SeesEachNumberThatWasRounded) {
  const exact::Crossing one_sum{{0, 0}, {1, 1}, {0, 1}, {-0x1p53 + 2, 0x1p53}};
  EXPECT_EQ(exact::doubles::round_to_nearest(one_sum), std::nullopt);
  EXPECT_FALSE(exact::round_to_nearest(one_sum).is_exact);  // (2^53 - 2) / (2^54 - 3), not a half
  const exact::Crossing one_product{{0, 0}, {-5, -8}, {1, 5}, {517451740691950, 2587258703459758}};
  EXPECT_EQ(exact::doubles::round_to_nearest(one_product), std::nullopt);
  EXPECT_EQ(exact::round_to_nearest(one_product).nearest, exact::integers::round_to_nearest(one_product).nearest);
}

TEST(Rounding, TiesGoToEven) {
  // On the line y = 2^53 + 1 + x, at x = 0. The crossing is halfway between 2^53, which is even in its last bit, and
  // 2^53 + 2.
  const exact::Crossing between{{-1, 0x1p53}, {1, 0x1p53 + 2}, {0, 0}, {0, 1}};
  EXPECT_EQ(exact::round_to_nearest(between).nearest, (Point{0, 0x1p53}));
  EXPECT_FALSE(exact::round_to_nearest(between).is_exact);
  // At 2^53 + 3, halfway between 2^53 + 2 and 2^53 + 4: now the larger one is even.
  const exact::Crossing above{{-1, 0x1p53 + 2}, {1, 0x1p53 + 4}, {0, 0}, {0, 1}};
  EXPECT_EQ(exact::round_to_nearest(above).nearest, (Point{0, 0x1p53 + 4}));
}

TEST(Rounding, PositionsNearerToZeroThanTheRangeStayConstructed) {
  const exact::Crossing crossing{{-0x1p60, -0x1p-60}, {0x1p60, 0x1p-60}, {0x1p-60, -1}, {0x1p-60, 1}};
  const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
  EXPECT_EQ(rounded.nearest, (Point{0x1p-60, 0x1p-180}));
  EXPECT_FALSE(rounded.is_exact);
}

TEST(Fractions, AreReduced) {
  EXPECT_EQ(exact::to_fractions(exact::ExactPosition{0.5, -6}), "1 2 -6 1");
  EXPECT_EQ(exact::to_fractions(exact::ExactPosition{0, 0x1p60}), "0 1 1152921504606846976 1");
  // y = x / 3 and y = 1 - x / 3 meet at (3/2, 1/2). y = x / 7 and x = 1 meet at (1, 1/7).
  const exact::Crossing halves{{0, 0}, {3, 1}, {0, 1}, {3, 0}};
  EXPECT_EQ(exact::to_fractions(exact::ExactPosition{1.5, 0.5, &halves}), "3 2 1 2");
  const exact::Crossing sevenths{{0, 0}, {7, 1}, {1, -1}, {1, 4}};
  EXPECT_EQ(exact::to_fractions(exact::ExactPosition{1.0, 1.0 / 7, &sevenths}), "1 1 1 7");
}

// A wall from (0, 0) to (1, 3) crosses the wall at y = 1 at x = 1/3. The nearest double is a little less than 1/3. With
// a corner at that double, the quadrilateral to the right is a rectangle only in doubles.
TEST(Geometry, AsksNoConstructedVertexByItsDoubles) {
  const double rounded = 1.0 / 3.0;
  ASSERT_LT(Rational(rounded), Rational(1) / 3);
  exact::Geometry geometry(Box{{0, 0}, {8, 8}});
  std::uint32_t count = 0;
  const auto add = [&](double x, double y) {
    geometry.set_position(count, {x, y});
    return count++;
  };
  const std::array<std::uint32_t, 5> corners = {add(rounded, 0), add(1, 0), add(1, 1), add(rounded, 1),
                                                add(rounded, 0.5)};
  const auto view = [&](std::size_t i) { return geometry.view(corners[i]); };
  EXPECT_EQ(geometry.in_circle(view(0), view(1), view(2), view(3)), exact::Sign::zero);
  EXPECT_EQ(geometry.order(view(3), view(4)), std::strong_ordering::greater);
  EXPECT_EQ(geometry.orientation(view(0), view(4), view(3)), exact::Sign::zero);

  const std::array<std::uint32_t, 4> ends = {add(0, 0), add(1, 3), add(0, 1), add(8, 1)};
  const std::uint32_t made = count++;
  geometry.set_crossing(made, ends[0], ends[1], ends[2], ends[3]);
  const exact::Geometry::View crossing = geometry.view(made);
  ASSERT_FALSE(geometry.is_explicit(made));
  ASSERT_EQ(crossing.x, rounded);
  EXPECT_EQ(geometry.in_circle(view(0), view(1), view(2), crossing), exact::Sign::positive) << "a little inside";
  EXPECT_EQ(geometry.in_circle(view(0), view(1), view(2), view(3)), exact::Sign::zero) << "as before";
  EXPECT_EQ(geometry.orientation(view(0), view(4), crossing), exact::Sign::negative) << "a little on the right";
  EXPECT_EQ(geometry.orientation({view(0), view(4)}, crossing), exact::Sign::negative) << "the same";
  EXPECT_EQ(geometry.orientation(view(0), view(4), view(3)), exact::Sign::zero) << "as before";
  EXPECT_EQ(geometry.order(crossing, view(3)), std::strong_ordering::greater);
  EXPECT_EQ(geometry.order(crossing, geometry.view(Point{rounded, 2})), std::strong_ordering::greater) << "by x";
  const std::uint32_t above = add(rounded, 2);
  EXPECT_EQ(geometry.order(geometry.view(above), geometry.view(corners[3])), std::strong_ordering::greater);
}

// Tests all triples of the points of a small lattice and the crossings of lines between them. Many triples are
// collinear.
TEST(Geometry, DecidesOrientationsAndSidesOfLines) {
  exact::Geometry geometry(Box{{-4, -4}, {4, 4}});
  std::vector<RationalPoint> positions;
  std::array<std::size_t, 3> signs = {0, 0, 0};
  NearMisses source(NearMiss::crossings, 7);
  std::uint32_t count = 0;
  while (positions.size() < 40) {
    const exact::ExactPosition point = source.any();
    if (std::abs(point.x) > 4.0 || std::abs(point.y) > 4.0) continue;
    positions.push_back(rational(point));
    if (point.is_explicit()) {
      geometry.set_position(count++, {point.x, point.y});
      continue;
    }
    for (const Point& end : {point.ab->a, point.ab->b, point.cd->a, point.cd->b}) {
      geometry.set_position(count++, end);
      positions.insert(positions.end() - 1, rational(end));
    }
    geometry.set_crossing(count, count - 4, count - 3, count - 2, count - 1);
    ++count;
  }
  ASSERT_EQ(count, positions.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = 0; b < count; ++b) {
      const exact::Geometry::Line line(geometry.view(a), geometry.view(b));
      for (std::uint32_t c = 0; c < count; ++c) {
        const exact::Sign expected = rational_orientation(positions[a], positions[b], positions[c]);
        ++signs[expected == exact::Sign::negative ? 0 : expected == exact::Sign::zero ? 1 : 2];
        ASSERT_EQ(geometry.orientation(geometry.view(a), geometry.view(b), geometry.view(c)), expected);
        ASSERT_EQ(geometry.orientation(line, geometry.view(c)), expected);
      }
    }
  }
  for (const std::size_t sign : signs) EXPECT_GT(sign, 5000U);
}

// Triangles with sides parallel to the axes, so small that the error bound of the box cannot decide their orientation.
TEST(Geometry, DistinguishesTinyTrianglesFromTies) {
  const exact::Geometry geometry(Box{{-4, -4}, {4, 4}});
  const std::array<Point, 6> points = {{{0, 0}, {0x1p-60, 0}, {0, 0x1p-60}, {0x1p-60, 0x1p-60}, {0, 3}, {3, 0x1p-60}}};
  for (const Point& a : points) {
    for (const Point& b : points) {
      for (const Point& c : points) {
        EXPECT_EQ(geometry.orientation(exact::Geometry::view(a), exact::Geometry::view(b), exact::Geometry::view(c)),
                  rational_orientation(rational(a), rational(b), rational(c)));
      }
    }
  }
}

TEST(Geometry, CrossingsThatAreDoublesBecomeExplicit) {
  exact::Geometry geometry(Box{{0, 0}, {4, 4}});
  geometry.set_position(0, {0, 0});
  geometry.set_position(1, {2, 2});
  geometry.set_position(2, {0, 2});
  geometry.set_position(3, {2, 0});
  geometry.set_position(4, {3, 0});
  geometry.set_crossing(5, 0, 1, 2, 3);
  EXPECT_TRUE(geometry.is_explicit(5));
  EXPECT_EQ(geometry.rounded(5), (Point{1, 1}));
  geometry.set_crossing(6, 0, 1, 2, 4);
  EXPECT_FALSE(geometry.is_explicit(6));
  EXPECT_EQ(geometry.rounded(6), (Point{1.2, 1.2}));
  geometry.clear(6);
  geometry.set_crossing(7, 1, 0, 4, 2);
  EXPECT_EQ(exact::to_fractions(geometry.exact(7)), "6 5 6 5");
}

}  // namespace
}  // namespace waywright::test

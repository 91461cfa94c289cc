#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>

#include <gtest/gtest.h>

#include "exact/crossing.hpp"
#include "exact/homogeneous.hpp"
#include "exact/offsets.hpp"
#include "exact/predicates.hpp"
#include "exact/rational.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using exact::Crossing;
using exact::ExactPosition;
using exact::Integer;
using exact::Sign;

/// Points on a lattice: offsets of up to 2^bits from `centre` in both directions, in units of 2^unit. Often at the
/// limits of their range.
struct LatticeKind {
  int bits;
  int unit;
  double centre;
};

class LatticeSource {
 public:
  LatticeSource(const LatticeKind& kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  double coordinate() {
    const std::int64_t reach = (std::int64_t{1} << kind_.bits) - 1;
    const std::int64_t offset = random_.chance(40) ? (random_.chance(50) ? reach : -reach) - random_.between(-3, 3)
                                                   : random_.between(-reach, reach);
    return kind_.centre + std::ldexp(static_cast<double>(std::clamp(offset, -reach, reach)), kind_.unit);
  }
  Point point() { return {coordinate(), coordinate()}; }

  ExactPosition constructed() {
    for (;;) {
      const Crossing crossing{point(), point(), point(), point()};
      const auto& [a, b] = crossing.ab;
      const auto& [c, d] = crossing.cd;
      const ExactPosition from{0, 0}, ab{b.x - a.x, b.y - a.y}, cd{d.x - c.x, d.y - c.y};
      if (exact::integers::orientation(ab, cd, from) == Sign::zero) continue;
      const exact::RoundedCrossing rounded = exact::integers::round_to_nearest(crossing);
      if (rounded.is_exact) continue;
      crossings_.push_back(crossing);
      return {rounded.nearest.x, rounded.nearest.y, &crossings_.back()};
    }
  }
  ExactPosition any() { return random_.chance(50) ? constructed() : exact::explicit_position(point()); }
  Random& random() { return random_; }

 private:
  LatticeKind kind_;
  Random random_;
  std::deque<Crossing> crossings_;
};

class Lattice : public testing::TestWithParam<LatticeKind> {};

// A difference of two of these points has one bit more than an offset from the centre. Doubles near 2^20 keep 32 bits
// after the binary point, down to 2^-32; near 0 they keep all 53 bits.
INSTANTIATE_TEST_SUITE_P(Kinds, Lattice,
                         testing::Values(LatticeKind{2, 0, 0}, LatticeKind{13, 0, 0}, LatticeKind{28, 0, 0},
                                         LatticeKind{28, -60, 0}, LatticeKind{28, 72, 0}, LatticeKind{28, -24, 0x1p28},
                                         LatticeKind{29, 0, 0}, LatticeKind{30, 0, 0}, LatticeKind{52, -40, 0}),
                         [](const auto& test) {
                           const LatticeKind& kind = test.param;
                           return std::to_string(kind.bits) + "BitsTimesTwoToThe" + (kind.unit < 0 ? "Minus" : "") +
                                  std::to_string(std::abs(kind.unit)) + (kind.centre != 0 ? "OffCentre" : "");
                         });

TEST_P(Lattice, AgreesWithIntegersOfAnySize) {
  LatticeSource source(GetParam(), 1);
  for (int i = 0; i < 1500; ++i) {
    const ExactPosition a = source.any(), b = source.any(), c = source.any(), d = source.any();
    ASSERT_EQ(exact::lattice::orientation(a, b, c), exact::integers::orientation(a, b, c)) << "call " << i;
    ASSERT_EQ(exact::lattice::in_circle(a, b, c, d), exact::integers::in_circle(a, b, c, d)) << "call " << i;
    ASSERT_EQ(exact::lattice::compare(a, b), exact::integers::compare(a, b)) << "call " << i;
    ASSERT_EQ(exact::lattice::compare(a, a), std::strong_ordering::equal);
  }
}

TEST_P(Lattice, AgreesOnExplicitPoints) {
  LatticeSource source(GetParam(), 2);
  for (int i = 0; i < 3000; ++i) {
    const Point p[] = {source.point(), source.point(), source.point(), source.point()};
    const ExactPosition a{p[0].x, p[0].y}, b{p[1].x, p[1].y}, c{p[2].x, p[2].y}, d{p[3].x, p[3].y};
    ASSERT_EQ(exact::lattice::orientation(a, b, c), exact::integers::orientation(a, b, c)) << "call " << i;
    ASSERT_EQ(exact::lattice::in_circle(a, b, c, d), exact::integers::in_circle(a, b, c, d)) << "call " << i;
  }
}

TEST_P(Lattice, RoundsCrossingsAsIntegersOfAnySizeDo) {
  LatticeSource source(GetParam(), 3);
  for (int i = 0; i < 3000; ++i) {
    const ExactPosition p = source.constructed();
    const auto rounded = exact::lattice::round_to_nearest(p.crossing());
    if (GetParam().centre != 0 && !rounded) continue;
    ASSERT_TRUE(rounded.has_value());
    ASSERT_EQ(rounded->nearest, (Point{p.x, p.y})) << "call " << i;
    ASSERT_FALSE(rounded->is_exact);
  }
}

// A thousand crossings on one line, and the line's ends. Every answer is zero, and integers alone find it.
TEST_P(Lattice, FindsPointsOnALine) {
  LatticeSource source(GetParam(), 4);
  const Point a = source.point(), b = source.point();
  for (int i = 0; i < 300; ++i) {
    ExactPosition p = source.constructed();
    const auto& [c, d] = *p.cd;
    const Crossing on_line{a, b, c, d};
    const ExactPosition from{0, 0}, ab{b.x - a.x, b.y - a.y};
    const ExactPosition cd{d.x - c.x, d.y - c.y};
    if (exact::integers::orientation(ab, cd, from) == Sign::zero) continue;
    const Point nearest = exact::round_to_nearest(on_line).nearest;
    p = {nearest.x, nearest.y, &on_line};
    ASSERT_EQ(exact::lattice::orientation(exact::explicit_position(a), exact::explicit_position(b), p), Sign::zero);
  }
}

TEST(LatticeStage, KnowsCirclesOfIntegersAndOfDecimals) {
  // (±1, ±7), (±7, ±1) and (±5, ±5) lie on one circle. If one point moves in or out by a unit of 2^-40, it leaves the
  // circle.
  const ExactPosition a{7, 1}, b{-5, 5}, c{-1, -7}, d{5, -5};
  EXPECT_EQ(exact::lattice::in_circle(a, b, c, d), Sign::zero);
  EXPECT_EQ(exact::lattice::in_circle(a, b, c, ExactPosition{5 - 0x1p-40, -5}), Sign::positive);
  EXPECT_EQ(exact::lattice::in_circle(a, b, c, ExactPosition{5 + 0x1p-40, -5}), Sign::negative);
  // The doubles nearest to 0.1, 0.2 and 0.3 are not these numbers. Still the corners of the square lie on one circle.
  const ExactPosition low{0.1, 0.2}, right{0.3, 0.2}, high{0.3, 0.7}, left{0.1, 0.7};
  EXPECT_EQ(exact::lattice::in_circle(low, right, high, left), Sign::zero);
  EXPECT_EQ(exact::lattice::orientation(ExactPosition{0.1, 0.1}, ExactPosition{0.2, 0.2}, ExactPosition{0.3, 0.3}),
            Sign::zero);
  // The double 0.3 is below 3 times the double 0.1, so (0.3, 0.1 + 0.2) lies above the line x = y.
  EXPECT_EQ(
      exact::lattice::orientation(ExactPosition{0.1, 0.1}, ExactPosition{0.2, 0.2}, ExactPosition{0.3, 0.1 + 0.2}),
      Sign::positive);
}

TEST(LatticeStage, LeavesTheRestToIntegersOfAnySize) {
  const ExactPosition a{0, 0}, b{4, 0}, c{4, 4};
  const ExactPosition fine{0x1p-60, 1}, far{0x1p62, 0};
  EXPECT_EQ(exact::lattice::orientation(a, b, fine), std::nullopt);
  EXPECT_EQ(exact::lattice::in_circle(fine, b, c, a), std::nullopt);
  EXPECT_EQ(exact::lattice::in_circle(a, b, ExactPosition{4.5, 4}, far), std::nullopt);
  const Crossing crossing{{0, 0}, {9, 3}, {0, 0x1p-60}, {7, 0}};
  EXPECT_EQ(exact::lattice::compare(ExactPosition{0, 0, &crossing}, a), std::nullopt);
  EXPECT_EQ(exact::lattice::round_to_nearest(crossing), std::nullopt);
}

TEST(Offsets, FindTheCoarsestLattice) {
  exact::Offsets<3> offsets({1000.5, -3});
  offsets.add({1006.5, -3});
  offsets.add({1000.5, 9});
  ASSERT_TRUE(offsets.find_lattice());
  EXPECT_EQ(offsets.x_exponent(), 1);
  EXPECT_EQ(offsets.bits(), 3);
  EXPECT_EQ(offsets[0].x, 3);
  EXPECT_EQ(offsets[0].y, 0);
  EXPECT_EQ(offsets[1].x, 0);
  EXPECT_EQ(offsets[1].y, 6);
}

TEST(Offsets, AreExactWhereTheDifferenceOfDoublesIsNot) {
  exact::Offsets<1> offsets({0.1, 0});
  offsets.add({1024, 0});
  // 0.1 is 3602879701896397 / 2^55, and 1024 is 2^65 / 2^55.
  ASSERT_FALSE(offsets.find_lattice());
  exact::Offsets<1> nearer({0.1, 0});
  nearer.add({16, 0});
  ASSERT_TRUE(nearer.find_lattice());
  EXPECT_EQ(nearer.x_exponent(), -55);
  EXPECT_EQ(nearer[0].x, (std::int64_t{1} << 59) - 3602879701896397);
}

TEST(Offsets, OfOnePointAreZero) {
  exact::Offsets<2> offsets({0.1, 7});
  offsets.add({0.1, 7});
  offsets.add({0.1, 7});
  ASSERT_TRUE(offsets.find_lattice());
  EXPECT_EQ(offsets[1].x, 0);
  EXPECT_EQ(offsets[1].y, 0);
}

TEST(Offsets, FindAUnitForEachAxis) {
  exact::Offsets<2> offsets({0, 0x1p-80});
  offsets.add({6, 0x3p-80});
  offsets.add({9, -0x7p-80});
  ASSERT_FALSE(offsets.find_lattice());
  ASSERT_TRUE(offsets.find_any_lattice());
  EXPECT_EQ(offsets.x_exponent(), 0);
  EXPECT_EQ(offsets.y_exponent(), -79);
  EXPECT_EQ(offsets.bits(), 4);
  EXPECT_EQ(offsets[0].x, 6);
  EXPECT_EQ(offsets[0].y, 1);
  EXPECT_EQ(offsets[1].x, 9);
  EXPECT_EQ(offsets[1].y, -4);
}

TEST(Offsets, FindAUnitIfAllAreEqualOnOneAxis) {
  exact::Offsets<2> offsets({0.25, 7});
  offsets.add({0x1p70, 7});
  offsets.add({0.25, 7});
  EXPECT_FALSE(offsets.find_any_lattice());
  exact::Offsets<2> equal({0x1p-80, 7});
  equal.add({0x3p-80, 7});
  ASSERT_TRUE(equal.find_any_lattice());
  EXPECT_EQ(equal[0].x, 1);
  EXPECT_EQ(equal[0].y, 0);
}

/// Points of whole coordinates of up to 2^bits, with all y coordinates times 2^-70, or with all x coordinates if
/// `is_steep`.
class ThinSource {
 public:
  ThinSource(int bits, bool is_steep) : source_({bits, 0, 0}, 6), is_steep_(is_steep) {}

  Point point() {
    const Point p = source_.point();
    return is_steep_ ? Point{p.x * 0x1p-70, p.y} : Point{p.x, p.y * 0x1p-70};
  }
  ExactPosition any() {
    if (source_.random().chance(50)) return exact::explicit_position(point());
    for (;;) {
      const Crossing crossing{point(), point(), point(), point()};
      const auto& [a, b] = crossing.ab;
      const auto& [c, d] = crossing.cd;
      if ((b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x)) continue;
      const exact::RoundedCrossing rounded = exact::integers::round_to_nearest(crossing);
      if (rounded.is_exact) continue;
      crossings_.push_back(crossing);
      return {rounded.nearest.x, rounded.nearest.y, &crossings_.back()};
    }
  }

 private:
  LatticeSource source_;
  bool is_steep_;
  std::deque<Crossing> crossings_;
};

TEST(LatticeStage, HasAUnitForEachAxisIfStretchingAnAxisChangesNoAnswer) {
  for (const int bits : {13, 28, 51}) {
    for (const bool is_steep : {false, true}) {
      ThinSource source(bits, is_steep);
      for (int i = 0; i < 1000; ++i) {
        const ExactPosition a = source.any(), b = source.any(), c = source.any();
        ASSERT_EQ(exact::lattice::orientation(a, b, c), exact::integers::orientation(a, b, c)) << "call " << i;
        ASSERT_EQ(exact::lattice::compare(a, b), exact::integers::compare(a, b)) << "call " << i;
        if (a.is_explicit()) continue;
        const auto rounded = exact::lattice::round_to_nearest(a.crossing());
        ASSERT_TRUE(rounded.has_value());
        ASSERT_EQ(rounded->nearest, (Point{a.x, a.y})) << "call " << i;
        ASSERT_FALSE(rounded->is_exact);
      }
    }
  }
}

// The squares of the distances depend on both axes, so an in-circle test needs one unit for both.
TEST(LatticeStage, HasOneUnitForInCircles) {
  const ExactPosition a{0, 0}, b{8, 0}, c{8, 0x1p-70}, d{0, 0x1p-70};
  EXPECT_EQ(exact::lattice::in_circle(a, b, c, d), std::nullopt);
  EXPECT_EQ(exact::lattice::orientation(a, b, c), Sign::positive);
}

/// The largest sizes, in bits, of the determinants of constructed points over extreme draws.
struct Widths {
  unsigned denominator = 0, coordinate = 0, orientation = 0, in_circle = 0;
};

Widths worst_widths(int bits) {
  LatticeSource source({bits - 1, 0, 0}, 5);
  const auto width = [](const Integer& value) { return value == 0 ? 0 : msb(Integer(abs(value))) + 1; };
  Widths worst;
  for (int i = 0; i < 20000; ++i) {
    std::array<exact::Homogeneous, 4> p;
    for (exact::Homogeneous& point : p) {
      point = exact::to_homogeneous(source.constructed(), 0);
      worst.denominator = std::max(worst.denominator, width(point.w));
      worst.coordinate = std::max({worst.coordinate, width(point.x), width(point.y)});
    }
    const auto minor = [&](std::size_t j, std::size_t k) { return Integer(p[j].x * p[k].y - p[k].x * p[j].y); };
    const Integer turn = p[0].w * minor(1, 2) - p[1].w * minor(0, 2) + p[2].w * minor(0, 1);
    worst.orientation = std::max(worst.orientation, width(turn));
    Integer circle = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = j + 1; k < 4; ++k) {
        const std::size_t m = j == 0 ? (k == 1 ? 2 : 1) : 0;
        const std::size_t n = 6 - j - k - m;
        const auto lift = [&](std::size_t v) { return Integer(p[v].x * p[v].x + p[v].y * p[v].y); };
        const Integer rest = lift(m) * p[n].w * p[n].w - lift(n) * p[m].w * p[m].w;
        circle += ((j + k) % 2 == 1 ? 1 : -1) * p[j].w * p[k].w * minor(j, k) * rest;
      }
    }
    worst.in_circle = std::max(worst.in_circle, width(circle));
  }
  return worst;
}

// For differences of up to 2^b, predicates.hpp allows denominators of 2 b + 1 bits, coordinates of 3 b + 2 bits, and
// determinants of 8 b + 8 and 20 b + 18 bits.
TEST(LatticeStage, KeepsWithinItsBits) {
  for (const int bits : {30, 53}) {
    const Widths worst = worst_widths(bits);
    const auto b = static_cast<unsigned>(bits);
    EXPECT_LE(worst.denominator, 2 * b + 2);
    EXPECT_LE(worst.coordinate, 3 * b + 2);
    EXPECT_LE(worst.orientation, 8 * b + 8);
    EXPECT_LE(worst.in_circle, 20 * b + 18);
    // The draws are extreme: the largest sizes come near to the limits.
    EXPECT_GE(worst.denominator, 2 * b);
    EXPECT_GE(worst.coordinate, 3 * b - 2);
    EXPECT_GE(worst.orientation, 8 * b - 2);
    EXPECT_GE(worst.in_circle, 20 * b - 6);
  }
  EXPECT_LT(8 * 30 + 8, 5 * 64);
  EXPECT_LT(20 * 30 + 18, 12 * 64);
  EXPECT_LT(8 * 62 + 8, 8 * 64);
  EXPECT_LT(20 * 62 + 18, 20 * 64);
}

}  // namespace
}  // namespace waywright::test

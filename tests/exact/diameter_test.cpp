#include <array>

#include <gtest/gtest.h>

#include "exact/gap.hpp"
#include "exact/gap_checks.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"
#include "support/case_count.hpp"

namespace waywright::test {
namespace {

Sign expected_side(const Point& w, const exact::ExactPosition& x, const exact::ExactPosition& y,
                   const exact::ExactPosition& z) {
  return rational_orientation(rational(w), centre_of_circle(rational(w), rational(x), rational(y)), rational(z));
}

/// Compares the predicate with the oracle, if the three points of the circle are counter-clockwise.
void check_side(const Point& w, const exact::ExactPosition& x, const exact::ExactPosition& y,
                const exact::ExactPosition& z) {
  const Sign turn = rational_orientation(rational(w), rational(x), rational(y));
  if (turn == Sign::zero) return;
  const auto& [right, left] = turn == Sign::positive ? std::array{x, y} : std::array{y, x};
  EXPECT_EQ(exact::side_of_diameter(w, right, left, z), expected_side(w, right, left, z));
}

class SidesOfDiameters : public testing::TestWithParam<PointSource::Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, SidesOfDiameters,
                         testing::Values(PointSource::Kind::small_lattice, PointSource::Kind::large_integers,
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes),
                         [](const auto& kind) { return kind_name(kind); });

TEST_P(SidesOfDiameters, AgreeWithRationals) {
  PointSource source(GetParam(), 5);
  for (int i = 0; i < case_count(400) && !HasFailure(); ++i) {
    const Point w = source.point();
    if (!is_in_range(w)) continue;
    std::array<exact::ExactPosition, 3> points;
    bool are_in_range = true;
    for (exact::ExactPosition& point : points) {
      point = source.any();
      are_in_range = are_in_range && (!point.is_explicit() || is_in_range(Point{point.x, point.y}));
    }
    if (!are_in_range) continue;
    check_side(w, points[0], points[1], points[2]);
    check_side(w, points[0], points[1], points[0]);
    check_side(w, points[0], points[1], points[1]);
  }
}

TEST(SidesOfDiameters, IsZeroOppositeToACornerOfARectangle) {
  const auto corner = [](double x, double y) { return exact::explicit_position({x, y}); };
  EXPECT_EQ(exact::side_of_diameter({1, 1}, corner(4, 2), corner(-1, 7), corner(2, 8)), Sign::zero);
  EXPECT_EQ(exact::side_of_diameter({1, 1}, corner(4, 2), corner(-1, 7), corner(2, 9)), Sign::positive);
  EXPECT_EQ(exact::side_of_diameter({1, 1}, corner(4, 2), corner(-1, 7), corner(2, 7)), Sign::negative);
}

}  // namespace
}  // namespace waywright::test

#include "locate/curve.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

using locate::Curve;
using locate::sort_along_curve;
using locate::SortedPoints;

// Each bit of a key selects a half: first the left or right half in x, then the lower or upper half of that in y, and
// so on.
TEST(Curve, KeysEncodeHalvesOfHalves) {
  const Curve curve({{-8, 0}, {8, 16}});
  EXPECT_EQ(curve.key({-8, 0}), 0U);
  EXPECT_EQ(curve.key({0, 0}), 1ULL << 63);
  EXPECT_EQ(curve.key({-8, 8}), 1ULL << 62);
  EXPECT_EQ(curve.key({-4, 0}), 1ULL << 61);
  EXPECT_EQ(curve.key({-8, 4}), 1ULL << 60);
  EXPECT_EQ(curve.key({4, 12}), 0xfULL << 60);
  EXPECT_EQ(curve.key({8, 16}), ~0ULL) << "the border belongs to the last square";
  EXPECT_TRUE(Curve::is_bit_of_x(63));
  EXPECT_FALSE(Curve::is_bit_of_x(62));
}

TEST(Curve, CellsAreSquareInAnyBox) {
  const Curve curve({{0, 0}, {16, 1}});
  EXPECT_EQ(curve.key({8, 0}), 1ULL << 63);
  EXPECT_EQ(curve.key({0, 0.5}), 1ULL << 54) << "the half of y is a thirty-second of x's extent";
}

void expect_sorted(const Box& box, const std::vector<Point>& points, std::size_t threads) {
  const SortedPoints sorted = sort_along_curve(box, points, threads::ThreadTeam(threads, {}));
  const Curve curve(box);
  ASSERT_EQ(sorted.keys.size(), sorted.points.size());
  ASSERT_EQ(sorted.ranks.size(), points.size());
  std::vector<bool> is_named(sorted.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(sorted.points[sorted.ranks[i]], points[i]);
    is_named[sorted.ranks[i]] = true;
  }
  EXPECT_EQ(std::count(is_named.begin(), is_named.end(), false), 0);
  for (std::size_t i = 0; i < sorted.points.size(); ++i) {
    ASSERT_EQ(sorted.keys[i], curve.key(sorted.points[i]));
    if (i == 0) continue;
    const Point& p = sorted.points[i - 1];
    const Point& q = sorted.points[i];
    const bool is_before = sorted.keys[i - 1] != sorted.keys[i] ? sorted.keys[i - 1] < sorted.keys[i]
                           : p.x != q.x                         ? p.x < q.x
                                                                : p.y < q.y;
    ASSERT_TRUE(is_before) << "at " << i;
  }
}

// Few and many points: spread out, so close together that few bits separate them, in one square, and repeated.
TEST(Curve, SortsByKeyThenByCoordinatesEachPointOnce) {
  Random random(3);
  for (const std::size_t count : {0U, 1U, 2U, 50U, 5000U}) {
    for (const double extent : {1.0, 0x1p-20, 0x1p-40}) {
      std::vector<Point> points;
      for (std::size_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(random.below(64)) / 64;
        const double y = static_cast<double>(random.below(64)) / 64;
        points.push_back({0.25 + x * extent / 2, 0.5 + y * extent / 2});
      }
      for (const std::size_t threads : {1U, 4U}) expect_sorted({{0, 0}, {1, 1}}, points, threads);
    }
  }
}

}  // namespace
}  // namespace waywright::test

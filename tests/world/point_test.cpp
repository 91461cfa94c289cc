#include "waywright/point.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

constexpr Point kA{3, 4};
constexpr Point kB{-1, 2};

static_assert(kA + kB == Point{2, 6});
static_assert(kA - kB == Point{4, 2});
static_assert(-kA == Point{-3, -4});
static_assert(kA * 2 == Point{6, 8} && 2 * kA == Point{6, 8});
static_assert(kA / 2 == Point{1.5, 2});
static_assert(dot(kA, kB) == 5);
static_assert(cross(Point{1, 0}, Point{0, 1}) == 1 && cross(Point{0, 1}, Point{1, 0}) == -1 && cross(kA, 2 * kA) == 0);
static_assert(squared_length(kA) == 25);
static_assert(lerp(kA, kB, 0) == kA && lerp(kA, kB, 1) == kB && lerp(kA, kB, 0.5) == Point{1, 3});
static_assert(comes_before({1, 9}, {2, 0}) && comes_before({1, 1}, {1, 2}) && !comes_before(kA, kA));

TEST(Point, ChangesInPlace) {
  Point p = kA;
  p += kB;
  EXPECT_EQ(p, (Point{2, 6}));
  p -= {1, 1};
  EXPECT_EQ(p, (Point{1, 5}));
  p *= 4;
  EXPECT_EQ(p, (Point{4, 20}));
  p /= 8;
  EXPECT_EQ(p, (Point{0.5, 2.5}));
  // The argument is a coordinate of the point itself.
  p *= p.x;
  EXPECT_EQ(p, (Point{0.25, 1.25}));
}

TEST(Point, HasALength) {
  EXPECT_EQ(length(kA), 5);
  EXPECT_EQ(distance(kA, kA), 0);
  EXPECT_EQ(distance({1, 1}, {-2, 5}), 5);
}

TEST(Point, EndsOfLerpAreExact) {
  const Point a{0.1, 1e20};
  const Point b{0.7, -3};
  EXPECT_EQ(lerp(a, b, 0), a);
  EXPECT_EQ(lerp(a, b, 1), b);
}

TEST(Point, SortsByXThenY) {
  std::vector<Point> points{{2, 1}, {1, 5}, {1, -5}, {0, 9}};
  std::sort(points.begin(), points.end(), comes_before);
  EXPECT_EQ(points, (std::vector<Point>{{0, 9}, {1, -5}, {1, 5}, {2, 1}}));
}

TEST(Point, HashesEqualPointsAlike) {
  EXPECT_EQ(std::hash<Point>{}({0.0, 1}), std::hash<Point>{}({-0.0, 1}));
  std::unordered_set<std::size_t> hashes;
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 30; ++y) hashes.insert(std::hash<Point>{}({static_cast<double>(x), static_cast<double>(y)}));
  }
  EXPECT_EQ(hashes.size(), 900U);
}

TEST(Point, HasAText) {
  EXPECT_EQ(to_string(Point{0.1, -2}), "(0.1, -2)");
  EXPECT_EQ(to_string(Point{-0.0, 1e300}), "(0, 1e+300)");
}

int count_of(PointSpan points) { return static_cast<int>(points.size()); }

TEST(PointSpan, IsMadeFromWhatHoldsPoints) {
  const std::vector<Point> list{{1, 2}, {3, 4}};
  const std::array<Point, 3> array{};
  std::vector<Point> changing = list;
  EXPECT_EQ(count_of(list), 2);
  EXPECT_EQ(count_of(array), 3);
  EXPECT_EQ(count_of(changing), 2);
  EXPECT_EQ(count_of(std::span<const Point>(list).first(1)), 1);
  EXPECT_EQ(count_of(std::span<Point>(changing)), 2);
  EXPECT_EQ(count_of({{1, 2}, {3, 4}, {5, 6}}), 3);
  EXPECT_EQ(count_of({{1, 2}, {3, 4}}), 2);
  EXPECT_EQ(count_of({{1, 2}}), 1);
  EXPECT_EQ(count_of({}), 0);
}

TEST(PointSpan, ComparesByPointsAndBecomesAVector) {
  const std::vector<Point> list{{1, 2}, {3, 4}};
  const PointSpan span = list;
  const std::vector<Point> copy = span;
  EXPECT_EQ(span, copy);
  EXPECT_EQ(copy, span);
  EXPECT_EQ(span, PointSpan(copy));
  EXPECT_NE(span, (std::vector<Point>{{1, 2}}));
  EXPECT_NE(span, (std::vector<Point>{{1, 2}, {3, 5}}));
}

constexpr Box kTall{{1, 2}, {5, 10}};
static_assert(kTall.width() == 4 && kTall.height() == 8 && kTall.centre() == Point{3, 6});
static_assert(kTall.contains({1, 2}) && kTall.contains({5, 10}) && kTall.contains({3, 6}));
static_assert(!kTall.contains({0.5, 6}) && !kTall.contains({5.5, 6}) && !kTall.contains({3, 1}) &&
              !kTall.contains({3, 11}));
static_assert(kTall.overlaps({{5, 10}, {6, 11}}) && kTall.overlaps({{0, 0}, {9, 20}}) && kTall.overlaps(kTall));
static_assert(!kTall.overlaps({{5.5, 2}, {6, 10}}) && !kTall.overlaps({{-1, 2}, {0.5, 10}}));
static_assert(!kTall.overlaps({{1, 10.5}, {5, 11}}) && !kTall.overlaps({{1, 0}, {5, 1}}));
static_assert(kTall.expanded(1) == Box{{0, 1}, {6, 11}});

TEST(Box, GrowsToWhatItIsToContain) {
  Box box = kTall;
  box.expand({3, 3});
  EXPECT_EQ(box, kTall);
  box.expand({0, 12});
  EXPECT_EQ(box, (Box{{0, 2}, {5, 12}}));
  box.expand({7, -1});
  EXPECT_EQ(box, (Box{{0, -1}, {7, 12}}));
  EXPECT_EQ(Box::bounding({{3, 4}, {1, 8}, {2, -1}}), (Box{{1, -1}, {3, 8}}));
  EXPECT_EQ(Box::bounding({{3, 4}}), (Box{{3, 4}, {3, 4}}));
}

}  // namespace
}  // namespace waywright::test

#include "path/distance.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

TEST(Distance, WhatLiesOnTheRightIsMirrored) {
  EXPECT_EQ(path::reflect_to_left({0, 1}, {2, 0}, {1, 3}), (Point{1, 3}));
  EXPECT_EQ(path::reflect_to_left({0, 1}, {2, 0}, {5, 1}), (Point{5, 1})) << "on the line";
  EXPECT_EQ(path::reflect_to_left({0, 1}, {2, 0}, {1, -1}), (Point{1, 3}));
  EXPECT_EQ(path::reflect_to_left({0, 1}, {-2, 0}, {1, 3}), (Point{1, -1}));
  EXPECT_EQ(path::reflect_to_left({1, 0}, {1, 1}, {2, 0}), (Point{1, 1}));
}

TEST(Distance, FootsAreSquareToTheLine) {
  EXPECT_EQ(path::foot({3, 4}, {1, 0}, {2, 0}), (Point{3, 0}));
  EXPECT_EQ(path::foot({0, 2}, {0, 0}, {4, 4}), (Point{1, 1}));
}

// Two vertices may round to the same point or, near 0, to two points that are too close for a square of their distance.
// The library takes both edges as a point.
TEST(Distance, AnEdgeWithoutLengthIsAPoint) {
  for (const Point& edge : {Point{0, 0}, Point{1e-200, 0}, Point{0, -1e-160}, Point{1e-140, 1e-140}}) {
    EXPECT_EQ(path::foot({3, 4}, {1, 2}, edge), (Point{1, 2}));
    EXPECT_EQ(path::reflect_to_left({1, 2}, edge, {3, 1}), (Point{3, 1}));
    EXPECT_EQ(path::reflect_to_left({1, 2}, edge, {-3, 1}), (Point{-3, 1}));
  }
  EXPECT_EQ(path::foot({3, 4}, {0, 0}, {1e-130, 0}), (Point{3, 0}));
  EXPECT_EQ(path::reflect_to_left({0, 0}, {1e-130, 0}, {3, -4}), (Point{3, 4}));
}

TEST(Distance, TheShortestPathViaAnEdgeIsStraightOrTurnsAtItsEnd) {
  const Point a{2, 0};
  const Point b{2, 4};
  for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
    EXPECT_DOUBLE_EQ(path::distance_via_segment({0, 2}, one, other, {4, 2}), 4.0);
    EXPECT_DOUBLE_EQ(path::distance_via_segment({0, 1}, one, other, {0, 1}), 4.0) << "there and back";
    EXPECT_DOUBLE_EQ(path::distance_via_segment({-1, 8}, one, other, {5, 8}), 10.0) << "by the upper end";
    EXPECT_DOUBLE_EQ(path::distance_via_segment({2, -3}, one, other, {2, 1}), 4.0) << "along it";
  }
}

}  // namespace
}  // namespace waywright::test

#include "clearance/changed_walls.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

using clearance::ChangedWalls;

/// Boxes from left to right, some wide and some narrow, in an order that is not sorted.
std::vector<Box> many_boxes() {
  std::vector<Box> boxes;
  for (int i = 0; i < 50; ++i) {
    const double x = i * 37 % 50 * 10.0;
    boxes.push_back({{x, 0.0}, {x + (i % 7 == 0 ? 90.0 : 2.0), 5.0}});
  }
  return boxes;
}

TEST(ChangedWalls, FindsEachBoxThatMeetsARange) {
  ChangedWalls changed;
  for (const Box& box : many_boxes()) changed.add(box);
  changed.sort();
  ASSERT_FALSE(changed.are_all());
  for (double low = -20.0; low < 620.0; low += 3.0) {
    const auto found = changed.boxes_between(low, low + 8.0);
    for (const Box& box : many_boxes()) {
      if (box.max.x < low || box.min.x > low + 7.9) continue;
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const Box& other) { return other.min.x <= box.min.x && other.max.x >= box.max.x; }))
          << low << " " << box.min.x;
    }
    EXPECT_LT(found.size(), 25U) << low;
  }
}

TEST(ChangedWalls, OneBoxReplacesTwoThatAreNearlyTheSame) {
  ChangedWalls changed;
  changed.add({{3.0, 1.0}, {43.0, 41.0}});
  changed.add({{500.0, 0.0}, {540.0, 40.0}});
  changed.add({{0.0, 0.0}, {40.0, 40.0}});
  changed.sort();
  const auto boxes = changed.boxes_between(-1000.0, 1000.0);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes[0].min, (Point{0.0, 0.0}));
  EXPECT_EQ(boxes[0].max, (Point{43.0, 41.0}));
}

TEST(ChangedWalls, AnyWallMayHaveChangedAfterVeryManyBoxes) {
  ChangedWalls changed;
  for (int i = 0; i < 20'000; ++i) changed.add({{i * 10.0, 0.0}, {i * 10.0 + 1.0, 1.0}});
  EXPECT_TRUE(changed.are_all());
  changed.clear();
  EXPECT_FALSE(changed.are_all());
}

}  // namespace
}  // namespace waywright::test

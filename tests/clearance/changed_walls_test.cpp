#include "clearance/changed_walls.hpp"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

using clearance::ChangedWalls;

/// Returns whether one of the changed walls meets the box, and counts the tests in `tests`.
bool meets_any(const ChangedWalls& changed, const Box& box, std::size_t& tests) {
  return changed.is_any([&](const Box& other) {
    ++tests;
    return other.overlaps(box);
  });
}

TEST(ChangedWalls, FindsEachBoxWithFewTests) {
  // Small boxes in a town of 40 x 40, and two boxes that are as wide and as high as the town.
  std::vector<Box> boxes = {{{0.0, 5.5}, {400.0, 6.0}}, {{5.5, 0.0}, {6.0, 400.0}}};
  for (int i = 0; i < 1600; ++i) {
    const int place = i * 37 % 1600;
    const Point min{10.0 * (place % 40), 10.0 * (place / 40)};
    boxes.push_back({min, {min.x + 2.0, min.y + 2.0}});
  }
  ChangedWalls changed;
  for (const Box& box : boxes) changed.add(box);
  changed.make_tree();
  ASSERT_FALSE(changed.are_all());
  std::size_t found = 0;
  for (double x = -20.0; x < 420.0; x += 7.0) {
    for (double y = -20.0; y < 420.0; y += 7.0) {
      const Box asked{{x, y}, {x + 4.0, y + 4.0}};
      bool is_expected = false;
      for (const Box& box : boxes) is_expected = is_expected || box.overlaps(asked);
      std::size_t tests = 0;
      EXPECT_EQ(meets_any(changed, asked, tests), is_expected) << x << " " << y;
      EXPECT_LT(tests, 150U) << x << " " << y;
      found += is_expected ? 1 : 0;
    }
  }
  EXPECT_GT(found, 500U);
  EXPECT_LT(found, 3000U);
}

TEST(ChangedWalls, OneBoxReplacesTwoThatAreNearlyTheSame) {
  ChangedWalls changed;
  changed.add({{3.0, 1.0}, {43.0, 41.0}});
  changed.add({{500.0, 0.0}, {540.0, 40.0}});
  changed.add({{0.0, 0.0}, {40.0, 40.0}});
  changed.make_tree();
  std::vector<Box> boxes;
  EXPECT_FALSE(changed.is_any([&](const Box& box) {
    boxes.push_back(box);
    return false;
  }));
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

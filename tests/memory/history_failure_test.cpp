#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_watch.hpp"
#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"
#include "watch/box_grid.hpp"

// Memory runs out in a rewind, an attempt, a mark, an update of watched paths, or in the tree of their boxes.

namespace waywright::test {
namespace {

/// A world with two ticks: the first with half of the items of a random scene, the second with the other half.
struct TwoTicks {
  TwoTicks(Flavour flavour, std::uint64_t seed)
      : scene(random_scene(flavour, seed, 14)), world(World::create(scene.domain, {.keep_bridges = true}).value()) {
    world.keep_history(3);
    const std::size_t half = scene.items.size() / 2;
    for (std::size_t i = 0; i < half; ++i) world.insert(scene.items[i].shape).value();
    first_dump = world.dump();
    first = world.mark();
    std::vector<Change> changes;
    for (std::size_t i = half; i < scene.items.size(); ++i) changes.push_back(Change::insert(scene.items[i].shape));
    changes.push_back(Change::remove(1));
    changes.push_back(Change::replace(2, scene.items[0].shape));
    world.apply(changes).value();
    second_dump = world.dump();
    second = world.mark();
  }

  Scene scene;
  World world;
  std::string first_dump;
  std::string second_dump;
  std::uint64_t first = 0;
  std::uint64_t second = 0;
};

class HistoryFailure : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, HistoryFailure, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

TEST_P(HistoryFailure, ARewindThatFailsChangesNothing) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    std::size_t failures = 0;
    for (std::size_t n = 1;; ++n, ++failures) {
      TwoTicks ticks(GetParam(), seed);
      World& world = ticks.world;
      const bool is_through = gets_through(n, [&] { world.rewind(ticks.first).value(); });
      ASSERT_EQ(world.dump(), is_through ? ticks.first_dump : ticks.second_dump) << "allocation " << n;
      ASSERT_EQ(world.validate().fault, "") << "allocation " << n;
      if (is_through) break;
      ASSERT_TRUE(world.rewind(ticks.second).ok());
      ASSERT_TRUE(world.rewind(ticks.first).ok());
      ASSERT_EQ(world.dump(), ticks.first_dump) << "the second time, after allocation " << n << " failed";
    }
    EXPECT_GT(failures, 10U);
  }
}

// The history must not contain the changes of an operation that failed.
TEST_P(HistoryFailure, AnOperationThatFailsLeavesTheHistory) {
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    TwoTicks ticks(GetParam(), 2);
    World& world = ticks.world;
    world.shrink_to_fit();
    const std::vector<Change> changes{Change::remove(3), Change::replace(4, ticks.scene.items[5].shape),
                                      Change::insert(ticks.scene.items[6].shape)};
    const bool is_through = gets_through(n, [&] { world.apply(changes).value(); });
    if (!is_through) world.remove(5).value();
    ASSERT_TRUE(world.rewind(ticks.second).ok());
    ASSERT_EQ(world.dump(), ticks.second_dump) << "allocation " << n;
    if (is_through) break;
  }
  EXPECT_GT(failures, 10U);
}

TEST_P(HistoryFailure, AnAttemptThatFailsChangesNothing) {
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    TwoTicks ticks(GetParam(), 3);
    World& world = ticks.world;
    const std::vector<Change> changes{Change::remove(3), Change::replace(4, ticks.scene.items[5].shape),
                                      Change::insert(ticks.scene.items[6].shape)};
    const bool is_through = gets_through(n, [&] {
      const std::size_t used = world.attempt(changes, [](const World&) { return allocation_count(); }).value();
      EXPECT_EQ(allocation_count(), used) << "taking the changes back allocates nothing";
    });
    ASSERT_EQ(world.dump(), ticks.second_dump) << "allocation " << n;
    ASSERT_EQ(world.validate().fault, "") << "allocation " << n;
    if (is_through) break;
    world.remove(5).value();
    ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 10U);
}

TEST(HistoryFailureOf, MarksAllocateNothingWhenTheHistoryIsWarm) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.keep_history(16);
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  std::vector<Shape> shapes;
  for (int i = 0; i < 8; ++i) shapes.push_back(Shape::rectangle({{10.0 + i, 10}, {20.0 + i, 20}}));
  const auto run = [&] {
    for (std::size_t i = 0; i < 4096; ++i) {
      world.mark();
      world.replace(box, shapes[i % 8]).value();
    }
  };
  run();
  const std::size_t before = allocation_count();
  run();
  EXPECT_EQ(allocation_count(), before);
}

TEST(HistoryFailureOf, AWatchedPathIsAddedOrNot) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert(Shape::rectangle({{40, 40}, {60, 60}})).value();
  const Path path = world.find_path({.start = {10, 50}, .goal = {90, 51}}).value();
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    PathWatch watch(world);
    const bool is_through = gets_through(n, [&] { watch.add(1, path); });
    ASSERT_EQ(watch.size(), is_through ? 1U : 0U) << "allocation " << n;
    if (is_through) break;
    watch.add(1, path);
    ASSERT_EQ(watch.size(), 1U) << "after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 4U);
}

TEST(HistoryFailureOf, AnUpdateOfWatchedPathsCanBeRepeated) {
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = World::create({{0, 0}, {100, 100}}).value();
    world.insert(Shape::rectangle({{40, 40}, {60, 60}})).value();
    PathWatch watch(world);
    for (std::uint64_t i = 0; i < 20; ++i) {
      const auto y = 1.0 + 5.0 * static_cast<double>(i);
      watch.add(i, world.find_path({.start = {10, y}, .goal = {90, y}}).value());
    }
    world.remove(1).value();
    world.insert_segment({30, 0}, {30, 90}).value();
    PathChanges expected;
    for (std::uint64_t i = 0; i < 18; ++i) expected.blocked.push_back(i);
    expected.may_be_too_long = {8, 9, 10, 11};
    PathChanges changes;
    const bool is_through = gets_through(n, [&] { watch.update(world, changes); });
    if (!is_through) {
      ASSERT_EQ(changes, PathChanges{}) << "after allocation " << n << " failed";
      watch.update(world, changes);
    }
    ASSERT_EQ(changes, expected) << "allocation " << n;
    const std::size_t before = allocation_count();
    world.insert_segment({31, 0}, {31, 90}).value();
    const std::size_t after_operation = allocation_count();
    watch.update(world, changes);
    ASSERT_EQ(allocation_count(), after_operation) << "a warm update allocates nothing; before: " << before;
    if (is_through) break;
  }
  EXPECT_GT(failures, 2U);
}

TEST(BoxGridFailure, AnInsertionThatFailsChangesNothing) {
  const Box domain{{0, 0}, {4096, 4096}};
  const auto box_at = [](double x) { return Box{{x, x}, {x + 0.5, x + 0.5}}; };
  std::size_t failures = 0;
  for (std::size_t failing = 1;; ++failing) {
    watch::BoxGrid<int> grid(domain);
    static_cast<void>(grid.insert(box_at(1), 1));
    watch::BoxGrid<int>::Handle second = 0;
    const bool is_through = gets_through(failing, [&] { second = grid.insert(box_at(4000), 2); });
    int sum = 0;
    const auto add = [&](int value, const Box&) { sum += value; };
    grid.for_each_overlapping(domain, add);
    ASSERT_EQ(sum, is_through ? 3 : 1) << "allocation " << failing;
    if (is_through) grid.remove(second);
    static_cast<void>(grid.insert(box_at(4000), 5));
    sum = 0;
    grid.for_each_overlapping(domain, add);
    ASSERT_EQ(sum, 6) << "allocation " << failing;
    if (is_through) break;
    ++failures;
  }
  EXPECT_GT(failures, 2U);
}

}  // namespace
}  // namespace waywright::test

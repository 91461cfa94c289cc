#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

std::vector<Point> row(std::size_t count, double y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({static_cast<double>(i % 97) + 1, y + static_cast<double>(i / 97)});
  return points;
}

TEST(RewindOf, ABulkLoadEmptiesTheWorld) {
  World world = world_of_hundred();
  world.keep_history(2);
  const std::uint64_t tick = world.mark();
  const std::string before = world.dump();
  world.insert_points(row(500, 2)).value();
  EXPECT_LT(world.memory().history, 200U) << "ids that count up take memory only once";
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.insert_point({5, 5}).value(), ItemId{1});
  EXPECT_EQ(world.validate().fault, "");
}

// The mesh that is built anew contains the items that stay.
TEST(RewindOf, MostOfAWorldKeepsTheRest) {
  World world = world_of_hundred();
  world.keep_history(2);
  world.insert(Shape::rectangle({{10, 10}, {20, 20}}), 7).value();
  world.insert_segment({50, 50}, {50, 50}, 9).value();
  const std::uint64_t tick = world.mark();
  const std::string before = world.dump();
  const std::uint64_t version = world.version();
  world.replace(7, Shape::rectangle({{10, 10}, {30, 20}})).value();
  world.insert_points(row(500, 30)).value();
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.shape(9).value(), Shape::segment({50, 50}, {50, 50}));
  EXPECT_EQ(world.version(), version + 3);
  EXPECT_EQ(world.insert_point({5, 5}).value(), ItemId{10});
  EXPECT_EQ(world.validate().fault, "");
}

TEST(RewindOf, ARemovedBulkLoadBringsItBack) {
  World world = world_of_hundred();
  world.insert_points(row(500, 2)).value();
  const std::string before = world.dump();
  world.keep_history(2);
  const std::uint64_t tick = world.mark();
  std::vector<Change> changes;
  for (const ItemId id : world.item_ids()) changes.push_back(Change::remove(id));
  world.apply(changes).value();
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.validate().fault, "");
}

TEST(RewindOf, ATickCanBeRepeated) {
  World world = world_of_hundred();
  world.keep_history(10);
  const std::uint64_t tick = world.mark();
  const ItemsHash before = world.items_hash();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(world.insert_segment({10, 10}, {20, 30.0 + i}).value(), ItemId{1});
    EXPECT_EQ(world.mark(), tick + 1);
    world.rewind(tick).value();
    EXPECT_EQ(world.items_hash(), before);
  }
}

TEST(RewindOf, AnUnknownTickIsRefused) {
  World world = world_of_hundred();
  EXPECT_EQ(world.rewind(1).error().code, ErrorCode::no_history);
  world.keep_history(3);
  EXPECT_EQ(world.rewind(1).error().code, ErrorCode::unknown_tick);
  for (int i = 0; i < 5; ++i) world.mark();
  EXPECT_EQ(world.rewind(0).error().code, ErrorCode::unknown_tick);
  EXPECT_EQ(world.rewind(2).error().code, ErrorCode::old_tick);
  EXPECT_EQ(world.rewind(2).error().index, 2U);
  EXPECT_EQ(world.rewind(6).error().code, ErrorCode::unknown_tick);
  EXPECT_TRUE(world.rewind(4).ok());
  EXPECT_EQ(world.rewind(5).error().code, ErrorCode::unknown_tick);
  EXPECT_TRUE(world.rewind(3).ok());
  EXPECT_EQ(world.version(), 2U) << "a refused rewind is no operation";
  world.keep_history(0);
  EXPECT_EQ(world.rewind(3).error().code, ErrorCode::no_history);
  EXPECT_EQ(world.memory().history, 0U);
  world.keep_history(1);
  EXPECT_EQ(world.rewind(3).error().code, ErrorCode::old_tick);
  EXPECT_EQ(world.mark(), 4U);
}

// An item that has moved away and back is not touched, so no path is affected.
TEST(RewindOf, AnItemThatIsWhereItWasChangesNothing) {
  World world = world_of_hundred();
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  const Shape short_wall = Shape::segment({70, 70}, {70, 70});
  const ItemId wall = world.insert(short_wall).value();
  world.keep_history(1);
  const std::uint64_t tick = world.mark();
  world.replace(wall, Shape::segment({70, 70}, {80, 70})).value();
  world.replace(wall, short_wall).value();
  world.replace(box, Shape::rectangle({{40, 10}, {50, 20}})).value();
  world.replace(box, Shape::rectangle({{10, 10}, {20, 20}})).value();
  const std::uint64_t before = world.version();
  world.rewind(tick).value();
  EXPECT_TRUE(world.changes_since(before)->empty());
  EXPECT_EQ(world.version(), before + 1);
}

TEST(RewindOf, AWorldAffectsThePathsThatItTouches) {
  World world = world_of_hundred();
  world.insert_segment({50, 20}, {50, 80}, 1).value();
  world.keep_history(1);
  const std::uint64_t tick = world.mark();
  world.remove(1).value();
  const Path path = world.find_path({.start = {40, 50}, .goal = {60, 50}}).value();
  PathSearch search;
  search.begin(world, {.start = {40, 50}, .goal = {60, 51}}).value();
  const std::uint64_t before = world.version();
  world.rewind(tick).value();
  EXPECT_TRUE(world.is_affected(path, before));
  while (!search.step(1).value()) continue;
  EXPECT_EQ(search.path().points.size(), 3U);
}

TEST(RewindOf, HistoryForgetsOldTicksAndTheirMemory) {
  World world = world_of_hundred();
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  world.keep_history(4);
  std::size_t largest = 0;
  for (int i = 0; i < 1000; ++i) {
    world.mark();
    for (int k = 0; k < 3; ++k) world.replace(box, Shape::rectangle({{10.0 + k, 10}, {20.0 + k, 20}})).value();
    largest = std::max(largest, world.memory().history);
  }
  EXPECT_LT(largest, 4000U);
}

}  // namespace
}  // namespace waywright::test

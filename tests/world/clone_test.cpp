#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

namespace waywright {
namespace {

constexpr Box kTen{{0, 0}, {10, 10}};

World world_with_a_wall() {
  World world = World::create(kTen).value();
  world.insert_segment({4, 0}, {4, 7}, 5).value();
  return world;
}

TEST(Clone, OutlivesTheWorld) {
  auto world = std::make_unique<World>(world_with_a_wall());
  const World copy = world->clone();
  const MeshHash hash = world->mesh_hash();
  world.reset();
  EXPECT_EQ(copy.mesh_hash(), hash);
  EXPECT_TRUE(copy.find_path({.start = {1, 1}, .goal = {7, 1}}).ok());
  EXPECT_EQ(copy.validate().fault, "");
}

TEST(Clone, ChoosesTheSameIds) {
  World world = world_with_a_wall();
  world.reserve_ids(90).value();
  World copy = world.clone();
  EXPECT_EQ(copy.insert_point({1, 1}).value(), ItemId{91});
  EXPECT_EQ(world.insert_point({2, 2}).value(), ItemId{91});
}

TEST(Clone, KnowsTheChangesOfTheWorld) {
  World world = World::create(kTen).value();
  const std::vector<Point> points = {{1, 1}, {7, 1}};
  const std::vector<Point> far = {{1, 9}, {2, 9}};
  world.insert_segment({4, 0}, {4, 7}, 5).value();
  const World copy = world.clone();
  EXPECT_EQ(copy.version(), 1U);
  EXPECT_TRUE(copy.is_affected(points, 0));
  EXPECT_FALSE(copy.is_affected(far, 0));
  EXPECT_FALSE(copy.is_affected(points, 1));
}

TEST(Clone, DoesNotDisturbASearchOfTheWorld) {
  World world = world_with_a_wall();
  PathSearch search;
  ASSERT_TRUE(search.begin(world, {.start = {1, 1}, .goal = {7, 1}}).ok());
  {
    World copy = world.clone();
    copy.insert_segment({2, 0}, {2, 10}, 6).value();
  }
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.restarts(), 0U);
  EXPECT_EQ(search.path().length, world.find_path({.start = {1, 1}, .goal = {7, 1}}).value().length);
}

TEST(Clone, HasNoSpareMemory) {
  World world = World::create(kTen).value();
  for (int i = 0; i < 1000; ++i) world.insert_point({i / 128.0, i % 37 / 4.0}).value();
  EXPECT_LT(world.clone().memory().total(), world.memory().total());
}

TEST(ReserveIds, RefusesWhatIsNoId) {
  World world = World::create(kTen).value();
  EXPECT_EQ(world.largest_id_seen(), ItemId{});
  EXPECT_EQ(world.reserve_ids({}).error().code, ErrorCode::bad_id);
  EXPECT_EQ(world.reserve_ids(-1).error().code, ErrorCode::bad_id);
  EXPECT_EQ(world.largest_id_seen(), ItemId{});
}

TEST(ReserveIds, OnlyRaisesTheNextId) {
  World world = World::create(kTen).value();
  world.reserve_ids(9).value();
  world.reserve_ids(4).value();
  EXPECT_EQ(world.largest_id_seen(), ItemId{9});
  EXPECT_EQ(world.version(), 0U);
  EXPECT_EQ(world.insert_point({1, 1}, 3).value(), ItemId{3});
  EXPECT_EQ(world.insert_point({2, 1}).value(), ItemId{10});
  world.reserve_ids(ItemId::kLargest).value();
  EXPECT_EQ(world.insert_point({3, 1}).error().code, ErrorCode::bad_id);
}

TEST(Options, AreTheOptionsOfCreate) {
  for (const bool abstraction : {false, true}) {
    for (const bool bridges : {false, true}) {
      const World world = World::create(kTen, {.keep_abstraction = abstraction, .keep_bridges = bridges}).value();
      EXPECT_EQ(world.options().keep_abstraction, abstraction);
      EXPECT_EQ(world.options().keep_bridges, bridges);
    }
  }
}

}  // namespace
}  // namespace waywright

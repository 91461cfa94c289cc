#include <cstddef>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/path_watch.hpp"
#include "waywright/world.hpp"

#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

// Many boxes: the world drops the oldest while replicas lag behind.
TEST(Snapshot, KnowsTheChangesOfTheWorld) {
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  const ItemId id = world.insert(Shape::rectangle({{1, 1}, {2, 2}})).value();
  std::vector<WorldSnapshot> held;
  for (int i = 0; i < 6000; ++i) {
    const double x = 1 + i % 900;
    world.replace(id, Shape::rectangle({{x, 1}, {x + 1, 2}})).value();
    if (i % 70 == 0) held.push_back(world.publish());
    if (i % 170 == 0) held.erase(held.begin());
    if (held.empty() || held.back().version() != world.version()) continue;
    for (std::uint64_t since = 0; since < world.version(); since += 1 + world.version() / 9) {
      const auto expected = world.changes_since(since);
      const auto found = held.back()->changes_since(since);
      ASSERT_EQ(found.has_value(), expected.has_value()) << i;
      if (!expected) continue;
      ASSERT_EQ(found->size(), expected->size()) << i << " since " << since;
      for (std::size_t k = 0; k < found->size(); ++k) {
        ASSERT_EQ((*found)[k].version, (*expected)[k].version);
        ASSERT_EQ((*found)[k].box, (*expected)[k].box);
      }
    }
  }
}

TEST(Snapshot, IsTheSameUntilSomethingChanges) {
  World world = World::create(kTen).value();
  const WorldSnapshot first = world.publish();
  EXPECT_EQ(world.publish(), first);
  world.reserve_ids(7).value();
  const WorldSnapshot second = world.publish();
  EXPECT_FALSE(second == first);
  EXPECT_EQ(first->largest_id_seen(), ItemId{});
  EXPECT_EQ(second->largest_id_seen(), ItemId{7});
}

TEST(Snapshot, UsesTheMemoryOfReleasedSnapshotsAgain) {
  World world = World::create(kTen).value();
  const World* first = nullptr;
  for (int i = 0; i < 5; ++i) {
    world.insert_point({1.0 + i, 1}).value();
    const WorldSnapshot snapshot = world.publish();
    if (first == nullptr) first = &*snapshot;
    EXPECT_EQ(&*snapshot, first);
    EXPECT_EQ(snapshot->item_count(), static_cast<std::size_t>(i + 1));
  }
}

TEST(Snapshot, OutlivesTheWorld) {
  WorldSnapshot snapshot;
  EXPECT_FALSE(snapshot);
  {
    World world = World::create(kTen).value();
    world.insert_segment({4, 0}, {4, 7}, 5).value();
    snapshot = world.publish();
  }
  std::thread([copy = std::move(snapshot)] {
    EXPECT_TRUE(copy->contains(5));
    EXPECT_EQ(copy->validate().fault, "");
  }).join();
  EXPECT_FALSE(snapshot);  // NOLINT: a handle that was moved from is empty
}

TEST(Snapshot, ClonesIntoAWorldWithoutHistory) {
  World world = World::create(kTen).value();
  world.keep_history(3);
  world.mark();
  world.insert_point({1, 1}).value();
  World copy = world.publish()->clone();
  EXPECT_EQ(copy.insert_point({2, 2}).value(), ItemId{2});
  EXPECT_EQ(copy.rewind(1).error().code, ErrorCode::no_history);
  EXPECT_TRUE(world.rewind(1).ok());
}

TEST(Snapshot, EndsASearchWhenItsMemoryIsUsedAgain) {
  World world = World::create(kTen).value();
  world.insert_segment({4, 0}, {4, 7}).value();
  WorldSnapshot snapshot = world.publish();
  PathSearch search;
  search.begin(*snapshot, {.start = {1, 1}, .goal = {7, 1}}).value();
  snapshot.release();
  world.insert_segment({5, 0}, {5, 7}).value();
  snapshot = world.publish();
  EXPECT_EQ(search.step(1).error().code, ErrorCode::world_gone);
}

TEST(Snapshot, LetsAWatchReadOneAfterTheOther) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  PathWatch watch(*world.publish());
  watch.add(1, world.find_path({.start = {10, 50}, .goal = {90, 50}}).value());
  PathChanges changes;
  for (int i = 0; i < 4; ++i) {
    world.insert(Shape::rectangle({{20.0 + 10 * i, 60}, {21.0 + 10 * i, 61}})).value();
    watch.update(*world.publish(), changes);
    EXPECT_TRUE(changes.blocked.empty());
  }
  world.insert(Shape::rectangle({{40, 40}, {60, 60}})).value();
  watch.update(*world.publish(), changes);
  EXPECT_EQ(changes.blocked, std::vector<std::uint64_t>{1});
}

TEST(Snapshot, LeavesNoMemoryAfterShrinking) {
  World world = World::create(kTen).value();
  for (int i = 0; i < 500; ++i) world.insert_point({i / 64.0, i % 37 / 4.0}).value();
  world.shrink_to_fit();
  const std::size_t before = world.memory().total();
  static_cast<void>(world.publish());
  EXPECT_GT(world.memory().total(), before + before / 2);
  world.shrink_to_fit();
  EXPECT_LE(world.memory().total(), before);
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
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

TEST(SnapshotOfATick, IsTheWorldOfThatTick) {
  World world = World::create(kTen, {.keep_bridges = true}).value();
  world.keep_history(4);
  world.insert_segment({1, 1}, {5, 5}).value();
  const std::uint64_t tick = world.mark();
  const World then = world.clone();
  const Path path = world.find_path({.start = {1, 3}, .goal = {3, 1}}).value();
  world.replace(1, Shape::segment({2, 6}, {6, 2})).value();
  world.insert_polygon({{7, 7}, {9, 7}, {8, 9}}).value();
  world.reserve_ids(70).value();
  const World now = world.clone();
  const WorldSnapshot snapshot = world.publish(tick).value();
  EXPECT_EQ(snapshot->dump(), then.dump());
  EXPECT_EQ(snapshot->items(), then.items());
  EXPECT_EQ(snapshot->largest_id_seen(), then.largest_id_seen());
  EXPECT_EQ(snapshot->version(), then.version());
  EXPECT_EQ(snapshot.version(), then.version());
  EXPECT_EQ(snapshot->find_path({.start = {1, 3}, .goal = {3, 1}}).value().points, path.points);
  EXPECT_EQ(snapshot->changes_since(0)->size(), 1U);
  EXPECT_EQ(world.dump(), now.dump());
  EXPECT_EQ(world.version(), now.version());
  EXPECT_EQ(world.largest_id_seen(), now.largest_id_seen());
  EXPECT_TRUE(world.rewind(tick).ok());  // the world still has the tick
}

// After the snapshot of a far tick, those of near ticks use one replica again: only few items differ between them.
TEST(SnapshotOfATick, CostsLittleAfterThatOfAFarTick) {
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  world.keep_history(200);
  for (int i = 0; i < 200; ++i) {
    world.insert_point({1.0 + i, 1}).value();
    world.mark();
  }
  static_cast<void>(world.publish(1).value());
  const World* replica = nullptr;
  for (std::uint64_t tick = 199; tick > 150; --tick) {
    const WorldSnapshot snapshot = world.publish(tick).value();
    EXPECT_EQ(snapshot->item_count(), tick);
    if (replica == nullptr) replica = &*snapshot;
    EXPECT_EQ(&*snapshot, replica) << tick;
  }
}

TEST(SnapshotOfATick, NeedsAKnownTick) {
  World world = World::create(kTen).value();
  EXPECT_EQ(world.publish(1).error().code, ErrorCode::no_history);
  world.keep_history(1);
  EXPECT_EQ(world.publish(1).error().code, ErrorCode::unknown_tick);
  EXPECT_EQ(world.publish(0).error().code, ErrorCode::unknown_tick);
  world.mark();
  world.mark();
  EXPECT_EQ(world.publish(1).error().code, ErrorCode::old_tick);
  EXPECT_EQ(world.publish(1).error().index, 1U);
  EXPECT_TRUE(world.publish(2).ok());
}

TEST(SnapshotOfATick, IsSharedByItsReaders) {
  World world = World::create(kTen).value();
  world.keep_history(2);
  const WorldSnapshot present = world.publish();
  const std::uint64_t tick = world.mark();
  EXPECT_EQ(world.publish(tick).value(), present);
  world.insert_point({1, 1}).value();
  const WorldSnapshot past = world.publish(tick).value();
  EXPECT_EQ(past, present);
  EXPECT_EQ(world.publish(tick).value(), past);
  EXPECT_EQ(past->item_count(), 0U);
}

// A lag-compensating server: in each tick it publishes the present and the world of eight ticks ago.
TEST(SnapshotOfATick, UsesTheMemoryOfReleasedSnapshotsAgain) {
  World world = World::create(kTen).value();
  world.keep_history(8);
  std::vector<const World*> seen;
  for (int i = 0; i < 40; ++i) {
    const std::uint64_t tick = world.mark();
    world.insert_point({1.0 + 0.1 * i, 1}).value();
    const WorldSnapshot present = world.publish();
    const WorldSnapshot past = world.publish(std::max<std::uint64_t>(tick, 8) - 7).value();
    ASSERT_EQ(present->item_count(), std::size_t(i) + 1);
    ASSERT_EQ(past->item_count(), std::size_t(std::max(i - 7, 0)));
    for (const World* const each : {&*present, &*past}) {
      if (std::find(seen.begin(), seen.end(), each) == seen.end()) seen.push_back(each);
    }
  }
  EXPECT_LE(seen.size(), 4U);
}

TEST(SnapshotOfATick, IsFreedWhenOnlyThePresentIsPublished) {
  World world = World::create(kTen).value();
  world.keep_history(10);
  for (int i = 0; i < 10; ++i) {
    world.mark();
    world.insert_point({1.0 + 0.1 * i, 1}).value();
  }
  std::vector<WorldSnapshot> held;
  for (std::uint64_t tick = 1; tick <= 10; ++tick) held.push_back(world.publish(tick).value());
  held.clear();
  for (int i = 0; i < 20; ++i) {
    world.insert_point({1.0 + 0.1 * i, 2}).value();
    static_cast<void>(world.publish());
  }
  EXPECT_LT(world.memory().spare, 8 * world.clone().memory().total());
}

// The world has forgotten the boxes up to the tick, so the snapshot has no boxes.
TEST(SnapshotOfATick, HasOnlyTheBoxesThatTheWorldStillHas) {
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  world.keep_history(1);
  const ItemId id = world.insert(Shape::rectangle({{1, 1}, {2, 2}})).value();
  const std::uint64_t tick = world.mark();
  const Path path = world.find_path({.start = {0, 1.5}, .goal = {3, 1.5}}).value();
  for (int i = 0; i < 6000; ++i) {
    const double x = 1 + i % 900;
    world.replace(id, Shape::rectangle({{x, 1}, {x + 1, 2}})).value();
  }
  const WorldSnapshot past = world.publish(tick).value();
  EXPECT_EQ(past->version(), 1U);
  EXPECT_FALSE(past->changes_since(0).has_value());
  EXPECT_TRUE(past->changes_since(1)->empty());
  EXPECT_FALSE(past->is_affected(path, 1));
  EXPECT_TRUE(past->is_affected(path, 0));
}

// The copy goes back by an operation, which makes it forget its oldest boxes. The world still has them.
TEST(SnapshotOfATick, HasTheLastBoxesHoweverManyTheWorldHas) {
  World world = World::create(kTen).value();
  world.keep_history(3);
  world.insert(Shape::rectangle({{1, 1}, {2, 2}}), 1).value();
  for (int i = 0; i < 4500; ++i) {
    const std::uint64_t tick = world.mark();
    world.replace(1, Shape::rectangle({{1.0 + i % 8, 1}, {2.0 + i % 8, 2}})).value();
    if (i < 1000) continue;
    world.shrink_to_fit();  // so that the snapshot needs a copy
    const WorldSnapshot past = world.publish(tick - 1).value();
    const auto boxes = past->changes_since(past.version() - 500);
    ASSERT_TRUE(boxes.has_value()) << i;
    ASSERT_EQ(boxes->size(), 1000U) << i;
    ASSERT_EQ(boxes->back().version, past.version()) << i;
  }
}

// A watch that reads an older world than before cannot use the changed boxes, and looks at all paths.
TEST(SnapshotOfATick, LetsAWatchGoBack) {
  World world = World::create(kTen).value();
  world.keep_history(1);
  PathWatch watch(world);
  world.insert_segment({5, 0}, {5, 8}, 1).value();
  const std::uint64_t tick = world.mark();
  world.remove(1).value();
  PathChanges changes;
  watch.update(world, changes);
  watch.add(7, world.find_path({.start = {1, 1}, .goal = {9, 1}}).value());
  const WorldSnapshot past = world.publish(tick).value();
  EXPECT_FALSE(past->changes_since(world.version()).has_value());
  watch.update(*past, changes);
  EXPECT_EQ(changes.blocked, std::vector<std::uint64_t>{7});
  watch.update(world, changes);
  EXPECT_TRUE(changes.blocked.empty());
}

// A rewind takes back a change that a replica has repeated. Then the record of changed items overflows, so the replica
// can no longer follow the world. A snapshot of the tick makes the record reach back farther than the replica, but the
// record still lacks the change.
TEST(SnapshotOfATick, DoesNotReviveAReplicaThatIsTooOld) {
  World world = World::create(kTen).value();
  world.keep_history(1);
  world.insert_segment({1, 1}, {2, 2}, 1).value();
  const std::uint64_t tick = world.mark();
  world.insert_segment({3, 1}, {4, 2}, 2).value();
  WorldSnapshot other_branch = world.publish();
  world.rewind(tick).value();
  for (int i = 0; i < 3000; ++i) world.insert_point({1.0 + i * 0x1p-10, 5}).value();
  world.rewind(tick).value();
  WorldSnapshot past = world.publish(tick).value();
  EXPECT_EQ(past->item_count(), 1U);
  other_branch.release();
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(world.publish()->dump(), world.dump()) << i;
    ASSERT_EQ(world.publish(tick).value()->item_count(), 1U) << i;
    if (i == 2) past.release();
    world.insert_point({1.0 + i, 6}).value();
  }
}

// Two combs with k teeth swap their places. If a replica moves them one after the other, they cross k^2 times.
TEST(Snapshot, MakesNoCrossingsThatTheWorldNeverHad) {
  const auto comb = [](double left, bool is_vertical) {
    std::vector<Point> points;
    for (int i = 0; i < 200; ++i) {
      const double along = 100 + 4.0 * i;
      const double across = i % 2 == 0 ? 50.0 : 950.0;
      points.push_back(is_vertical ? Point{left + along, across} : Point{left + across, along});
    }
    return Shape::polyline(points);
  };
  World world = World::create({{0, 0}, {3000, 1000}}).value();
  world.keep_history(2);
  world.insert(comb(0, true), 1).value();
  world.insert(comb(1500, false), 2).value();
  const auto swap = [&](bool is_back) {
    world.remove(2).value();
    world.replace(1, comb(is_back ? 0 : 1500, true)).value();
    world.insert(comb(is_back ? 1500 : 0, false), 2).value();
  };
  const std::size_t most = 8 * world.memory().total();
  static_cast<void>(world.publish());
  const std::uint64_t first = world.mark();
  swap(false);
  EXPECT_LT(world.publish()->memory().total(), most);
  static_cast<void>(world.publish(first).value());
  const std::uint64_t second = world.mark();
  const std::string dump = world.dump();
  swap(true);
  const WorldSnapshot past = world.publish(second).value();
  EXPECT_LT(past->memory().total(), most);
  EXPECT_EQ(past->dump(), dump);
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

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "memory/arena.hpp"
#include "support/random_scenes.hpp"
#include "support/world_internals.hpp"

// Memory runs out while a world makes a snapshot.

namespace waywright::test {
namespace {

class SnapshotFailure : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, SnapshotFailure, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

/// Half of the items of a random scene. The rest comes in later changes.
World first_half(const Scene& scene) {
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  for (std::size_t i = 0; i < scene.items.size() / 2; ++i) world.insert(scene.items[i].shape).value();
  return world;
}

void change(World& world, const Scene& scene) {
  std::vector<Change> changes;
  for (std::size_t i = scene.items.size() / 2; i < scene.items.size(); ++i) {
    changes.push_back(Change::insert(scene.items[i].shape));
  }
  changes.push_back(Change::remove(1));
  changes.push_back(Change::replace(2, scene.items[0].shape));
  world.apply(changes).value();
}

void expect_equal(const World& snapshot, const World& world, std::size_t n) {
  ASSERT_EQ(snapshot.dump(), world.dump()) << "allocation " << n;
  ASSERT_EQ(snapshot.version(), world.version()) << "allocation " << n;
  ASSERT_EQ(snapshot.validate().fault, "") << "allocation " << n;
}

/// Fails each allocation of the second publish(). If `is_held`, it makes a copy; otherwise it uses the first one again.
void check_failures(const Scene& scene, bool is_held) {
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = first_half(scene);
    WorldSnapshot first = world.publish();
    const std::string first_dump = first->dump();
    if (!is_held) first.release();
    change(world, scene);
    const std::string dump = world.dump();
    WorldSnapshot second;
    const bool is_through = gets_through(n, [&] { second = world.publish(); });
    ASSERT_EQ(static_cast<bool>(second), is_through);
    ASSERT_EQ(world.dump(), dump);
    if (is_held) {
      ASSERT_EQ(first->dump(), first_dump);
    }
    if (!is_through) {
      world.remove(3).value();
      second = world.publish();
    }
    ASSERT_NO_FATAL_FAILURE(expect_equal(*second, world, n));
    if (is_through) break;
  }
  EXPECT_GT(failures, 5U);
}

TEST_P(SnapshotFailure, OfACopyChangesNothing) { check_failures(random_scene(GetParam(), 1, 14), true); }

TEST_P(SnapshotFailure, OfAReusedCopyCanBeRepeated) { check_failures(random_scene(GetParam(), 2, 14), false); }

/// Fails each allocation of a call that makes a replica with shared pages: of the present, or of a tick. If `has_base`,
/// the base exists already. Otherwise the call makes it.
void check_failures_of_shared_pages(const Scene& scene, bool has_base, bool of_a_tick) {
  if (memory::Arena::make(1) == nullptr) GTEST_SKIP() << "this system does not share pages";
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = first_half(scene);
    WorldInternals::share_pages(world);
    world.keep_history(8);
    std::vector<WorldSnapshot> held;
    std::vector<std::string> dumps;
    const auto hold = [&](WorldSnapshot snapshot) {
      dumps.push_back(snapshot->dump());
      held.push_back(std::move(snapshot));
    };
    for (std::size_t i = 0; has_base && i < 2; ++i) {
      world.replace(3, scene.items[i].shape).value();
      const std::uint64_t tick = world.mark();
      hold(of_a_tick ? world.publish(tick).value() : world.publish());
    }
    world.remove(4).value();  // few changes: the base is not too old
    const std::uint64_t tick = world.mark();
    const World then = world.clone();
    if (of_a_tick) world.replace(3, scene.items[2].shape).value();
    const World& expected = of_a_tick ? then : world;
    const std::size_t before = WorldInternals::sharing_replicas(world);
    ASSERT_EQ(before, held.size());
    const auto publish = [&] { return of_a_tick ? world.publish(tick).value() : world.publish(); };
    WorldSnapshot next;
    const bool is_through = gets_through(n, [&] { next = publish(); });
    ASSERT_EQ(static_cast<bool>(next), is_through);
    if (!is_through) next = publish();
    ASSERT_EQ(WorldInternals::sharing_replicas(world), before + 1);
    ASSERT_NO_FATAL_FAILURE(expect_equal(*next, expected, n));
    for (std::size_t i = 0; i < held.size(); ++i) ASSERT_EQ(held[i]->dump(), dumps[i]) << "allocation " << n;
    if (is_through) break;
  }
  EXPECT_GT(failures, 5U);
}

TEST_P(SnapshotFailure, OfABaseAndAReplicaThatSharesItsPagesChangesNothing) {
  check_failures_of_shared_pages(random_scene(GetParam(), 7, 14), false, false);
}

TEST_P(SnapshotFailure, OfAReplicaThatSharesPagesChangesNothing) {
  check_failures_of_shared_pages(random_scene(GetParam(), 8, 14), true, false);
}

TEST_P(SnapshotFailure, OfATickWithSharedPagesChangesNothing) {
  check_failures_of_shared_pages(random_scene(GetParam(), 9, 14), true, true);
}

/// Fails each allocation of a call that publishes a tick. If `is_held`, the call makes a copy. Otherwise it uses again
/// a replica of the present or, if `is_late`, one that is older than the tick.
void check_failures_of_a_tick(const Scene& scene, bool is_held, bool is_late) {
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = first_half(scene);
    world.keep_history(2);
    WorldSnapshot first;
    if (is_late) first = world.publish();
    world.insert(scene.items.back().shape).value();
    const std::uint64_t tick = world.mark();
    const World then = world.clone();
    change(world, scene);
    if (!is_late) first = world.publish();
    const std::string first_dump = first->dump();
    if (!is_held) first.release();
    const std::string dump = world.dump();
    WorldSnapshot past;
    const bool is_through = gets_through(n, [&] { past = world.publish(tick).value(); });
    ASSERT_EQ(static_cast<bool>(past), is_through);
    ASSERT_EQ(world.dump(), dump);
    if (is_held) {
      ASSERT_EQ(first->dump(), first_dump);
    }
    if (n % 2 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_equal(*world.publish(), world, n));
    }
    past = world.publish(tick).value();
    ASSERT_NO_FATAL_FAILURE(expect_equal(*past, then, n));
    ASSERT_NO_FATAL_FAILURE(expect_equal(*world.publish(), world, n));
    if (is_through) break;
  }
  EXPECT_GT(failures, 5U);
}

TEST_P(SnapshotFailure, OfATickThatNeedsACopyChangesNothing) {
  check_failures_of_a_tick(random_scene(GetParam(), 4, 14), true, false);
}

TEST_P(SnapshotFailure, OfATickCanBeRepeatedInAReplicaOfThePresent) {
  check_failures_of_a_tick(random_scene(GetParam(), 5, 14), false, false);
}

TEST_P(SnapshotFailure, OfATickCanBeRepeatedInAnOlderReplica) {
  check_failures_of_a_tick(random_scene(GetParam(), 6, 14), false, true);
}

// The record of changed items grows inside operations.
TEST_P(SnapshotFailure, OfAnOperationThatIsRecordedChangesNothing) {
  const Scene scene = random_scene(GetParam(), 3, 14);
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = first_half(scene);
    static_cast<void>(world.publish());
    const std::string dump = world.dump();
    const bool is_through = gets_through(n, [&] { change(world, scene); });
    if (!is_through) {
      ASSERT_EQ(world.dump(), dump) << "allocation " << n;
      ASSERT_NO_FATAL_FAILURE(expect_equal(*world.publish(), world, n));
      world.remove(3).value();
    }
    ASSERT_NO_FATAL_FAILURE(expect_equal(*world.publish(), world, n));
    if (is_through) break;
  }
  EXPECT_GT(failures, 5U);
}

TEST(SnapshotFailureOf, SnapshotsAllocateNothingWhenTheReplicasAreWarm) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  std::vector<Shape> shapes;
  for (int i = 0; i < 8; ++i) shapes.push_back(Shape::rectangle({{10.0 + i, 10}, {20.0 + i, 20}}));
  WorldSnapshot latest;
  const auto run = [&] {
    for (std::size_t i = 0; i < 6000; ++i) {
      world.replace(box, shapes[i % 8]).value();
      latest = world.publish();
    }
  };
  run();
  const std::size_t before = allocation_count();
  run();
  EXPECT_EQ(allocation_count(), before);
}

TEST(SnapshotFailureOf, SnapshotsAreFreedWhenNothingRefersToThem) {
  const std::ptrdiff_t before = live_allocations();
  {
    std::vector<WorldSnapshot> held;
    {
      World world = World::create({{0, 0}, {100, 100}}).value();
      for (int i = 0; i < 40; ++i) {
        world.insert_point({1.0 + i, 1}).value();
        held.push_back(world.publish());
        if (i % 3 == 0) held.erase(held.begin());
      }
    }
    const WorldSnapshot copy = held.front();
  }
  EXPECT_EQ(live_allocations(), before);
}

}  // namespace
}  // namespace waywright::test

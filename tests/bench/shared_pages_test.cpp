#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"
#include "waywright/world_snapshot.hpp"

#include "memory/arena.hpp"
#include "physical_memory.hpp"
#include "support/world_internals.hpp"
#include "town.hpp"

// Snapshots of a large world share pages of memory if readers hold many of them.

namespace waywright::test {
namespace {

using bench::physical_memory;
using bench::Town;

bool can_share_pages() { return memory::Arena::make(1) != nullptr; }

// The first three snapshots and the base of the others are copies of the world. Each further snapshot takes memory only
// for the pages that its changes since the base touch, about 23 of 4096 bytes for each change.
TEST(SharedPages, TakeMemoryForWhatHasChanged) {
  if (!can_share_pages() || physical_memory() == 0) GTEST_SKIP() << "this system does not share pages";
  Town town(40'000);
  ASSERT_GT(town.world().memory().total(), std::size_t{4} << 20);
  std::vector<WorldSnapshot> held;
  std::size_t before = 0;
  for (int i = 0; i < 14; ++i) {
    town.world().apply({town.random_move()}).value();
    held.push_back(town.world().publish());
    if (i == 3) before = physical_memory();
  }
  EXPECT_EQ(WorldInternals::sharing_replicas(town.world()), 11U);
  EXPECT_LT(physical_memory(), before + 10 * town.world().memory().total() / 3)
      << "10 snapshots take more than 10 / 3 clones";
}

// The pool makes several bases, and then no longer uses the replicas of the old ones.
TEST(SharedPages, AreSharedAsLongAsReadersHoldManySnapshots) {
  if (!can_share_pages()) GTEST_SKIP() << "this system does not share pages";
  Town town(40'000);
  std::vector<WorldSnapshot> held;
  for (int i = 0; i < 60; ++i) {
    town.world().apply({town.random_move()}).value();
    held.push_back(town.world().publish());
  }
  EXPECT_EQ(WorldInternals::sharing_replicas(town.world()), 57U);
  held.clear();
  for (int i = 0; i < 60; ++i) {
    town.world().apply({town.random_move()}).value();
    held = {town.world().publish()};
  }
  EXPECT_EQ(WorldInternals::sharing_replicas(town.world()), 57U) << "one snapshot at a time";
}

TEST(SharedPages, KeepEverySnapshotAsItWas) {
  if (!can_share_pages()) GTEST_SKIP() << "this system does not share pages";
  Town town(3000);
  waywright::World& world = town.world();
  WorldInternals::share_pages(world);
  world.keep_history(100);
  std::deque<std::pair<WorldSnapshot, MeshHash>> held;
  for (int i = 0; i < 60; ++i) {
    world.apply(town.random_moves(i % 7 == 0 ? 80 : 1)).value();
    const std::uint64_t tick = world.mark();
    held.emplace_back(i % 3 == 0 ? world.publish(tick).value() : world.publish(), world.mesh_hash());
    if (i % 5 != 4) continue;
    const auto released = held.begin() + i % 3;
    EXPECT_EQ(released->first->mesh_hash(), released->second);
    held.erase(released);
  }
  EXPECT_GT(WorldInternals::sharing_replicas(world), 40U);
  for (const auto& [snapshot, expected] : held) {
    EXPECT_EQ(snapshot->mesh_hash(), expected);
    EXPECT_EQ(snapshot->validate().fault, "");
  }
  EXPECT_EQ(world.validate().fault, "");
}

}  // namespace
}  // namespace waywright::test

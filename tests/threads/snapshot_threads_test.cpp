#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/world_internals.hpp"

namespace waywright::test {
namespace {

/// A wall between two positions, which each operation makes longer or shorter, and a square.
World world_with_a_wall() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert_segment({50, 0}, {50, 40}, 1).value();
  world.insert(Shape::rectangle({{70, 70}, {80, 80}}), 2).value();
  return world;
}

void move_wall(World& world, int i) {
  world.replace(1, Shape::segment({50, 0}, {50, 40.0 + i % 50})).value();
  if (i % 3 == 0) world.replace(2, Shape::rectangle({{70, 70.0 + i % 7}, {80, 81.0 + i % 7}})).value();
}

double path_length(const World& world, QueryContext& context, Path& path) {
  world.find_path({.start = {10, 10}, .goal = {90, 10}}, context, path).value();
  return path.length;
}

/// The parameter says whether the replicas share pages.
class SnapshotThreads : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Pages, SnapshotThreads, testing::Bool(),
                         [](const auto& shares) { return shares.param ? "shared" : "own"; });

// Made for the thread sanitizer: the writer changes replicas that readers have released, and readers free others.
TEST_P(SnapshotThreads, ReadersAndTheWriterRunAtOnce) {
  constexpr int kSnapshots = 600;
  constexpr std::size_t kReaders = 3;
  World world = world_with_a_wall();
  std::vector<double> lengths;  // by version, computed without snapshots
  {
    World same = world.clone();
    QueryContext context;
    Path path;
    lengths.resize(static_cast<std::size_t>(kSnapshots) * 3, 0.0);
    for (int i = 0; i < kSnapshots; ++i) {
      lengths[same.version()] = path_length(same, context, path);
      move_wall(same, i);
    }
  }
  std::vector<std::atomic<WorldSnapshot*>> slots(kReaders);
  std::atomic<bool> is_over = false;
  std::atomic<std::size_t> read_count = 0;
  std::vector<std::thread> readers;
  for (std::size_t r = 0; r < kReaders; ++r) {
    readers.emplace_back([&, r] {
      QueryContext context;
      Path path;
      std::vector<WorldSnapshot> held;
      while (!is_over.load() || slots[r].load() != nullptr) {
        WorldSnapshot* const newest = slots[r].exchange(nullptr);
        if (newest == nullptr) {
          std::this_thread::yield();
          continue;
        }
        held.push_back(*newest);
        delete newest;
        for (const WorldSnapshot& snapshot : held) {
          EXPECT_EQ(path_length(*snapshot, context, path), lengths[snapshot.version()]);
          read_count.fetch_add(1);
        }
        if (held.size() > 2 * r) held.erase(held.begin());
      }
    });
  }
  for (int i = 0; i < kSnapshots; ++i) {
    if (GetParam()) WorldInternals::share_pages(world);
    const WorldSnapshot snapshot = world.publish();
    for (auto& slot : slots) delete slot.exchange(new WorldSnapshot(snapshot));
    static_cast<void>(world.memory());
    if (i == kSnapshots / 2) world.shrink_to_fit();
    move_wall(world, i);
    while (read_count.load() < static_cast<std::size_t>(i)) std::this_thread::yield();  // so that the readers have work
  }
  is_over = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_GE(read_count.load(), static_cast<std::size_t>(kSnapshots));
  EXPECT_EQ(world.validate().fault, "");
}

}  // namespace
}  // namespace waywright::test

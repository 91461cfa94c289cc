#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "memory/allocations.hpp"

namespace waywright::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr int kOperations = 50'000;
#else
constexpr int kOperations = 1'000'000;
#endif
constexpr int kObstacles = 20;
constexpr int kStepsARound = 100;

/// Returns the shape of obstacle `i` after `step` steps on a circle. It crosses walls and other obstacles. After a full
/// circle it is where it started.
Shape obstacle(int i, int step) {
  const double angle = 2 * 3.14159265358979 * (step % kStepsARound) / kStepsARound + i;
  const double x = std::round((200 + 35 * i) * std::cos(angle));
  const double y = std::round((200 + 35 * i) * std::sin(angle));
  return {ItemKind::polygon, {{{x - 60, y - 40}, {x + 60, y - 37}, {x + 41, y + 50}, {x - 57, y + 43}}}};
}

TEST(MemoryGrowth, MillionInsertionsAndRemovalsOfMovingObstaclesLeaveNothingBehind) {
  World world = World::create({{-1000, -1000}, {1000, 1000}}).value();
  for (int i = 0; i < 12; ++i) {
    const double at = 150.0 * i - 850;
    world.insert_segment({at, -990}, {-at, 990}).value();
    world.insert_segment({-990, at}, {990, at / 2}).value();
  }
  for (int i = 0; i < kObstacles; ++i) world.insert(obstacle(i, 0), {static_cast<std::uint64_t>(100 + i)}).value();
  const std::size_t vertices = world.vertex_count();
  const std::size_t triangles = world.triangle_count();
  const MeshHash mesh = world.mesh_hash();

  std::ptrdiff_t bytes_early = 0;
  std::ptrdiff_t bytes_late = 0;
  int operations = 0;
  for (int step = 1; operations < kOperations || step % kStepsARound != 1; ++step) {
    for (int i = 0; i < kObstacles; ++i) {
      const ItemId id{static_cast<std::uint64_t>(100 + i)};
      world.remove(id).value();
      world.insert(obstacle(i, step), id).value();
      operations += 2;
    }
    if (step % kStepsARound != 0) continue;
    ASSERT_EQ(world.vertex_count(), vertices) << "after " << operations << " operations";
    ASSERT_EQ(world.triangle_count(), triangles);
    std::ptrdiff_t& bytes = operations < kOperations / 4 ? bytes_early : bytes_late;
    bytes = std::max(bytes, live_bytes());
  }
  EXPECT_EQ(world.mesh_hash(), mesh);
  EXPECT_TRUE(world.validate().ok);
  EXPECT_GT(bytes_early, 0);
  EXPECT_LE(bytes_late, bytes_early) << "memory still grows";
}

// When the last wall across several items is removed, the crossing is removed too. The two pieces of the edge become
// one edge with one list of items.
TEST(MemoryGrowth, InsertingAndRemovingAWallAcrossSeveralLeavesNoListBehind) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  for (std::uint64_t id = 1; id <= 3; ++id) world.insert_segment({10, 50}, {90, 50}, {id}).value();
  std::size_t walls_early = 0;
  for (int round = 0; round < 1000; ++round) {
    world.insert_segment({50, 10}, {50, 90}, {9}).value();
    world.remove({9}).value();
    if (round == 10) walls_early = world.memory().walls;
  }
  EXPECT_EQ(world.memory().walls, walls_early);
  EXPECT_TRUE(world.validate().ok);
}

TEST(MemoryGrowth, AWorldGivesEverythingBack) {
  const std::ptrdiff_t before = live_allocations();
  {
    World world = World::create({{-1000, -1000}, {1000, 1000}}).value();
    for (int i = 0; i < kObstacles; ++i) world.insert(obstacle(i, 3 * i)).value();
    for (int i = 0; i < kObstacles; i += 2) world.remove({static_cast<std::uint64_t>(1 + i)}).value();
    (void)world.find_path({{-900, -900}, {900, 900}}).value();
    EXPECT_GT(live_allocations(), before);
  }
  EXPECT_EQ(live_allocations(), before);
}

// Once a context has served a query, it has the memory for the same query.
TEST(MemoryGrowth, WarmQueriesAllocateNothing) {
  World world = World::create({{-1000, -1000}, {1000, 1000}}).value();
  for (int i = 0; i < kObstacles; ++i) world.insert(obstacle(i, 3 * i)).value();
  QueryContext context;
  Path path;
  Location location;
  RayHit hit;
  std::vector<Path> paths;
  std::vector<Path> many_paths;
  const std::vector<Point> goals = {{990, 990}, {-990, 990}, {15, 27}, {990, -990}};
  std::vector<Point> many_goals;
  for (int i = 0; i < 300; ++i) many_goals.push_back({990 - 6.5 * i, 6.0 * i - 900});
  const auto ask_all = [&] {
    for (int i = 0; i < 40; ++i) {
      const Point start{-990 + 20.0 * i, -990};
      const Point goal{990 - 10.0 * i, 990};
      for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal}) {
        world.find_path({start, goal, {}, algorithm, {PathBudget::kNoLimit}, true}, context, path).value();
      }
      world.find_paths_from({start, goals, 0.0, true}, context, paths).value();
      world.find_paths_from({start, many_goals, 0.0, true}, context, many_paths).value();
      world.locate(start, context, location).value();
      world.ray(start, {990 - 10.0 * i, 990}, {}, context, hit).value();
      world.locate({10.0 * i, 5.0 * i}, context, location).value();
    }
  };
  ask_all();
  const std::size_t before = allocation_count();
  ask_all();
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"
#include "waywright/world_snapshot.hpp"

#include "memory/allocations.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

constexpr Box kBox{{0, 0}, {1, 1}};
constexpr std::size_t kCount = 20'000;

std::vector<Point> random_points(std::size_t count) {
  Random random(1);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point = {static_cast<double>(random.below(1U << 30)) * 0x1p-30,
             static_cast<double>(random.below(1U << 30)) * 0x1p-30};
  }
  return points;
}

/// Returns walls from point to point, under ids that are not consecutive.
std::vector<Item> random_walls(std::size_t count) {
  const std::vector<Point> points = random_points(count);
  std::vector<Item> items;
  for (std::size_t i = 0; i < count; ++i) {
    const Point from = points[i];
    const Point to{std::min(1.0, from.x + 0x1p-7), std::min(1.0, from.y + 0x1p-8)};
    items.push_back({{kCount + 3 * i + 1}, {ItemKind::segment, {{from, to}}}});
  }
  return items;
}

/// Compares the memory that a world reports with the memory that it allocated. The latter contains what the allocator
/// rounds up.
void expect_all_counted(const World& world, std::ptrdiff_t bytes_before) {
  const auto given = static_cast<double>(live_bytes() - bytes_before);
  const auto counted = static_cast<double>(world.memory().total());
  EXPECT_LE(counted, given);
  EXPECT_GE(counted, 0.97 * given);
}

// After a replica has repeated changes, the pool of replicas keeps the shapes that the replica has compared.
TEST(MemoryUse, CountsWhatThePoolOfSnapshotsKeeps) {
  const auto star_at = [](double x) {
    std::vector<Point> ring;
    for (std::size_t i = 0; i < kCount; ++i) {
      const double angle = static_cast<double>(i) * 6.283185307 / static_cast<double>(kCount);
      const double radius = i % 2 == 0 ? 0.25 : 0.125;
      ring.push_back({x + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    return Shape::polygon(std::move(ring));
  };
  const Shape left = star_at(0.375);
  const Shape right = star_at(0.625);
  const std::ptrdiff_t before = live_bytes();
  World world = World::create(kBox).value();
  world.insert(left, 1).value();
  world.publish().release();
  world.replace(1, right).value();
  world.publish().release();
  expect_all_counted(world, before);
}

// The covers keep the list of the corners of the last polygon, and sets of the polygons inside it.
TEST(MemoryUse, CountsWhatTheInsertionOfALargePolygonKeeps) {
  const std::ptrdiff_t before = live_bytes();
  World world = World::create(kBox).value();
  world.insert_points(random_points(kCount)).value();
  for (std::size_t i = 0; i < 1000; ++i) {
    const Point at{0.46 + 0.002 * static_cast<double>(i % 40), 0.46 + 0.002 * static_cast<double>(i / 40)};
    world.insert(Shape::rectangle({at, {at.x + 0.001, at.y + 0.001}})).value();
  }
  world.insert(Shape::regular_polygon({0.5, 0.5}, 0.1, kCount / 5)).value();
  const auto uncounted = [&] { return live_bytes() - before - static_cast<std::ptrdiff_t>(world.memory().total()); };
  EXPECT_LE(uncounted(), 12'000);
  world.shrink_to_fit();
  EXPECT_LE(uncounted(), 12'000);
}

TEST(MemoryUse, SumsUpToWhatTheAllocatorGave) {
  const std::vector<Point> points = random_points(kCount);
  const std::vector<Item> walls = random_walls(kCount / 10);
  for (const WorldOptions& options :
       {WorldOptions{.keep_abstraction = false}, WorldOptions{}, WorldOptions{true, true}}) {
    const std::ptrdiff_t before = live_bytes();
    World world = World::create(kBox, options).value();
    world.insert_points(points).value();
    expect_all_counted(world, before);
    world.insert_all(walls).value();
    if (options.keep_bridges) world.shrink_to_fit();
    expect_all_counted(world, before);
    for (std::size_t i = 0; i < walls.size(); i += 2) world.remove(walls[i].id).value();
    if (options.keep_bridges) world.shrink_to_fit();  // frees an array that the counting allocator does not see
    expect_all_counted(world, before);
  }
}

// What remains is the world itself, and the boxes of the last changes: 2,048 boxes of 40 bytes, and at most as many
// again.
TEST(MemoryUse, ShrinkingLeavesLittleSpare) {
  const std::vector<Item> walls = random_walls(kCount / 10);
  const std::ptrdiff_t before = live_bytes();
  World world = World::create(kBox).value();
  world.insert_all(walls).value();
  for (std::size_t i = 0; i < walls.size(); i += 2) world.remove(walls[i].id).value();
  const MeshHash hash = world.mesh_hash();
  ASSERT_GT(world.memory().spare, 150'000U);
  world.shrink_to_fit();
  EXPECT_LE(world.memory().spare, 4096U * 40 + 20'000);
  expect_all_counted(world, before);
  EXPECT_EQ(world.mesh_hash(), hash);
  EXPECT_TRUE(world.validate().ok);
  for (std::size_t i = 0; i < walls.size(); i += 2) world.insert(walls[i].shape, walls[i].id).value();
  EXPECT_TRUE(world.validate().ok);
}

// Bytes for each vertex: 16 for its point, 4 for a half-edge, 4 for a list of items, 48 for its two faces, 4 for its
// item, and 0.4 to 1.7 for sectors, a little more where vertices are crowded. The spare share is 1/64 of the arrays.
// Ids that count up take no memory, and neither do labels.
TEST(MemoryUse, APointOfManyTakesLessThanEightyFourBytes) {
  const std::vector<Point> points = random_points(kCount);
  World world = World::create(kBox, {.keep_abstraction = false}).value();
  world.insert_points(points).value();
  EXPECT_LE(world.memory().total(), 84 * kCount);
}

// There are two faces for each vertex; each face has a component and a byte. Pages of marks are allocated once there is
// something to search.
TEST(MemoryUse, PathsTakeLessThanElevenBytesMore) {
  const std::vector<Point> points = random_points(kCount);
  World world = World::create(kBox).value();
  world.insert_points(points).value();
  EXPECT_LE(world.memory().abstraction, 11 * kCount);
  EXPECT_LE(world.memory().total(), 95 * kCount);
  world.insert_segment({0.5, 0.5}, {0.505, 0.505}).value();
  EXPECT_LE(world.memory().abstraction, 12 * kCount);
}

// There are two faces for each vertex, with three half-edges each. A half-edge takes eight bytes, a foot bridge twelve.
TEST(MemoryUse, BridgesTakeAbout110BytesForEachVertex) {
  const std::vector<Item> walls = random_walls(kCount / 2);
  World world = World::create(kBox, {.keep_bridges = true}).value();
  world.insert_all(walls).value();
  EXPECT_LE(world.memory().bridges, 120 * world.vertex_count());
  EXPECT_GE(world.memory().bridges, 90 * world.vertex_count());
}

// The arrays of a context have room for each half-edge of the mesh. A world keeps one context, so a query without a
// context neither allocates nor clears these arrays.
TEST(MemoryUse, AQueryWithoutAContextAllocatesOnlyItsAnswer) {
  World world = World::create(kBox).value();
  world.insert_points(random_points(kCount)).value();
  world.insert_segment({0.5, 0.495}, {0.5, 0.505}).value();
  for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::ta, PathAlgorithm::tra}) {
    PathQuery query;
    query.start = {0.499, 0.5};
    query.goal = {0.501, 0.5};
    query.algorithm = algorithm;
    Path path = world.find_path(query).value();
    ASSERT_GE(path.points.size(), 3U);
    const std::size_t before = allocation_count();
    path = world.find_path(query).value();
    EXPECT_LE(allocation_count() - before, 6U) << to_string(algorithm);  // the answer's points, while the vector grows
  }
}

TEST(MemoryUse, ShrinkingGivesBackTheContextThatTheWorldKeeps) {
  World world = World::create(kBox).value();
  world.insert_points(random_points(kCount)).value();
  world.shrink_to_fit();
  const std::ptrdiff_t before = live_allocations();
  ASSERT_EQ(world.find_path({.start = {0.1, 0.1}, .goal = {0.9, 0.9}}).value().status, PathStatus::found);
  EXPECT_GT(live_allocations(), before);
  world.shrink_to_fit();
  EXPECT_EQ(live_allocations(), before);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <new>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "support/new_vertices.hpp"

namespace waywright::test {
namespace {

/// A world with some walls, which allows an operation `limit` new vertices.
World world_with_walls(std::size_t limit) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  for (int i = 0; i < 12; ++i) world.insert_segment({8.0 * i + 2, 5}, {8.0 * i + 3, 95}).value();
  world.shrink_to_fit();
  world.set_new_vertex_limit(limit);
  return world;
}

/// Calls `change` on a world once for each allocation that it makes, and lets this allocation fail. Expects that the
/// world does not change, whether an allocation fails or the limit is passed, and that it then accepts the change
/// without a limit.
template <class Perform>
void expect_nothing_changes(std::size_t limit, Perform&& change) {
  std::size_t failures = 0;
  for (bool is_done = false; !is_done;) {
    World world = world_with_walls(limit);
    const WorldState before(world);
    fail_allocation(allocation_count() + failures + 1);
    try {
      const bool is_refused = !change(world).ok();
      fail_allocation(0);
      EXPECT_TRUE(is_refused);
      is_done = true;
    } catch (const std::bad_alloc&) {
      fail_allocation(0);
      ++failures;
    }
    ASSERT_EQ(WorldState(world), before) << "after allocation " << failures << " failed";
    ASSERT_EQ(world.validate().fault, "");
    world.set_new_vertex_limit(kNoVertexLimit);
    ASSERT_TRUE(change(world).ok());
    ASSERT_EQ(world.validate().fault, "");
  }
  EXPECT_GT(failures, 5U);
}

TEST(MemoryFailureBeforeALimit, ChangesNothing) {
  const Shape bar = Shape::polyline({{1, 20}, {99, 21}, {1, 22}});
  expect_nothing_changes(20, [&](World& world) { return world.insert(bar); });
  expect_nothing_changes(20, [&](World& world) { return world.replace(3, bar); });
  expect_nothing_changes(20, [&](World& world) {
    return world.apply({Change::remove(1), Change::insert(bar, 50), Change::insert(Shape::point({1, 1}), 51)});
  });
}

// A refusal takes the operation back without allocating, and the scratch of the refusal serves the next operation.
TEST(RefusalByALimit, AllocatesNothingTheSecondTime) {
  const Shape bar = Shape::polyline({{1, 20}, {99, 21}, {1, 22}});
  World world = world_with_walls(20);
  EXPECT_FALSE(world.insert(bar).ok());
  EXPECT_FALSE(world.insert(bar).ok());
  const std::size_t before = allocation_count();
  EXPECT_FALSE(world.insert(bar).ok());
  EXPECT_EQ(allocation_count() - before, 0U);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <future>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "memory/threads.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

/// Without new threads, the calling thread does all the work alone. The results must be the same.
class ThreadFailure : public testing::Test {
 protected:
  ThreadFailure() { refuse_threads(true); }
  ~ThreadFailure() override { refuse_threads(false); }

  static Point random_point(Random& random) {
    return {static_cast<double>(random.between(0, 1 << 20)), static_cast<double>(random.between(0, 1 << 20))};
  }
  static constexpr Box kBox = {{0, 0}, {1 << 20, 1 << 20}};
};

TEST_F(ThreadFailure, IsOneOfTheSystems) {
  EXPECT_THROW(static_cast<void>(std::async(std::launch::async, [] {})), std::system_error);
}

TEST_F(ThreadFailure, LeavesPathsAsTheyAre) {
  World world = World::create(kBox).value();
  Random random(3);
  for (int i = 0; i < 100; ++i) world.insert_segment(random_point(random), random_point(random)).value();
  std::vector<PathQuery> queries;
  while (queries.size() < 50) queries.push_back({random_point(random), random_point(random)});
  const std::vector<Path> paths = world.find_paths(queries, 4).value();
  ASSERT_EQ(paths.size(), queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_EQ(paths[i].points, world.find_path(queries[i])->points);
  }
}

TEST_F(ThreadFailure, LeavesABulkLoadAsItIs) {
  Random random(4);
  std::vector<Item> items;
  while (items.size() < 40'000) items.push_back({{items.size() + 1}, {ItemKind::point, {{random_point(random)}}}});
  World world = World::create(kBox).value();
  world.insert_all(items, {.threads = 4, .progress = {}}).value();
  World by_one = World::create(kBox).value();
  by_one.insert_all(items).value();
  EXPECT_EQ(world.mesh_hash(), by_one.mesh_hash());
  EXPECT_TRUE(world.validate().ok);
}

}  // namespace
}  // namespace waywright::test

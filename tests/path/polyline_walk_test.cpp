#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "support/oracle_adapter.hpp"
#include "support/point_text.hpp"
#include "support/random.hpp"
#include "support/random_path_cases.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

World world_of(const Scene& scene, const WorldOptions& options = {}) {
  World world = World::create(scene.domain, options).value();
  for (const Item& item : scene.items) EXPECT_TRUE(world.insert(item.shape, item.id).ok());
  return world;
}

World square_in_the_middle() {
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_polygon(std::vector<Point>{{4, 4}, {6, 4}, {6, 6}, {4, 6}}).value();
  return world;
}

bool is_clear(const World& world, const std::vector<Point>& points) { return world.is_clear(points).value(); }

TEST(Clear, APolylineMayTouchWallsAndRunAlongThem) {
  const World world = square_in_the_middle();
  EXPECT_TRUE(is_clear(world, {{4, 0}, {4, 10}})) << "along a side";
  EXPECT_TRUE(is_clear(world, {{2, 6}, {6, 2}})) << "past a corner";
  EXPECT_TRUE(is_clear(world, {{1, 1}, {4, 6}, {6, 6}, {9, 1}})) << "around it";
  EXPECT_TRUE(is_clear(world, {{0, 0}, {10, 0}, {10, 10}})) << "along the domain's border";
  EXPECT_TRUE(is_clear(world, {{4, 5}})) << "on a side";
}

TEST(Clear, APolylineMustNotPassFromWedgeToWedge) {
  const World world = square_in_the_middle();
  EXPECT_FALSE(is_clear(world, {{0, 5}, {10, 5}}));
  EXPECT_FALSE(is_clear(world, {{4, 4}, {6, 6}})) << "a diagonal inside";
  EXPECT_FALSE(is_clear(world, {{4, 5}, {6, 5}})) << "from side to side";
  EXPECT_FALSE(is_clear(world, {{5, 5}, {9, 9}})) << "out of the inside";
  EXPECT_FALSE(is_clear(world, {{5, 5}})) << "inside";
  EXPECT_FALSE(is_clear(world, {})) << "no points";
}

TEST(Clear, NoPolylineLeadsThroughAPointWhereWallsMeet) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_segment({5, 0}, {5, 5}).value();
  world.insert_segment({5, 5}, {5, 10}).value();
  EXPECT_FALSE(is_clear(world, {{1, 5}, {9, 5}}));
  EXPECT_FALSE(is_clear(world, {{1, 5}, {5, 5}, {9, 5}}));
  EXPECT_TRUE(is_clear(world, {{1, 5}, {5, 5}, {1, 9}}));
  EXPECT_TRUE(is_clear(world, {{5, 5}, {9, 5}}))
      << "from a start on the wall, the agent may leave to the left or to the right";
  EXPECT_FALSE(is_clear(world, {{1, 5}, {5, 5}, {5, 9}, {9, 9}}))
      << "the agent would pass from the left of the wall to its right";
  EXPECT_TRUE(is_clear(world, {{1, 5}, {5, 5}, {5, 9}, {1, 9}}));
}

TEST(Clear, TheErrorNamesThePointThatIsOutside) {
  const World world = square_in_the_middle();
  const auto refused = world.is_clear(std::vector<Point>{{1, 1}, {2, 2}, {11, 1}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(refused.error().index, 2U);
  EXPECT_EQ(world.is_clear({1, 1}, {11, 1}).error().index, 1U);
}

/// Returns a point of the scene: a corner of an item, the rounded position of a vertex, or any point.
Point random_point(const PathCase& path_case, const std::vector<oracle::OraclePoint>& vertices, Random& random) {
  if (random.chance(40)) {
    const oracle::OraclePoint& v = vertices[random.below(vertices.size())];
    return {v.x, v.y};
  }
  const Ends& ends = path_case.queries[random.below(path_case.queries.size())];
  return random.chance(50) ? ends.start : ends.goal;
}

/// Compares answers about random polylines and about found paths with the oracle. Returns how many polylines were
/// clear.
std::size_t check_against_oracle(const PathCase& path_case, const WorldOptions& options, Random& random) {
  const World world = world_of(path_case.scene, options);
  const oracle::Oracle oracle(oracle::to_oracle(path_case.scene));
  const auto& vertices = oracle.nearest_vertices();
  QueryContext context;
  std::size_t clear = 0;
  const auto check = [&](const std::vector<Point>& points) {
    const bool expected = !oracle.check_path(oracle::to_oracle(points)).has_value();
    std::string text;
    for (const Point& p : points) text += text_of(p) + "; ";
    EXPECT_EQ(world.is_clear(points, {}, context).value(), expected) << text;
    clear += expected ? 1 : 0;
  };
  for (int i = 0; i < 12; ++i) {
    std::vector<Point> points;
    const std::size_t count = 1 + random.below(4);
    while (points.size() < count) points.push_back(random_point(path_case, vertices, random));
    if (random.chance(20)) points.push_back(points.front());
    check(points);
  }
  for (const Ends& ends : path_case.queries) {
    for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::ta}) {
      const Path path = world.find_path({.start = ends.start, .goal = ends.goal, .algorithm = algorithm}).value();
      if (path.status != PathStatus::found) continue;
      EXPECT_TRUE(is_clear(world, path.points)) << text_of(ends.start) << " to " << text_of(ends.goal);
      check(path.points);
    }
  }
  return clear;
}

TEST(Clear, IsWhatTheOracleSaysAmongObstacles) {
  Random random(4711);
  std::size_t clear = 0;
  for (const Obstacles obstacles : kObstacles) {
    for (std::uint64_t seed = 500; seed < 540; ++seed) {
      SCOPED_TRACE(std::string(to_string(obstacles)) + " " + std::to_string(seed));
      clear += check_against_oracle(random_path_case(obstacles, seed, 6), {.keep_abstraction = seed % 2 == 0}, random);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(clear, 1000U);
}

TEST(Clear, IsWhatTheOracleSaysInRandomScenes) {
  Random random(4712);
  std::size_t clear = 0;
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 500; seed < 540; ++seed) {
      SCOPED_TRACE(std::string(to_string(flavour)) + " " + std::to_string(seed));
      clear += check_against_oracle(random_path_case(flavour, seed, seed % 41, 6), {}, random);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(clear, 500U);
}

TEST(Affected, AreThePathsThatAChangedItemsBoxMeets) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  const std::uint64_t at_first = world.version();
  const std::vector<Point> low = {{0, 10}, {100, 10}};
  const std::vector<Point> high = {{0, 90}, {50, 95}, {100, 90}};
  EXPECT_FALSE(world.is_affected(low, at_first));
  const ItemId box = world.insert_polygon(std::vector<Point>{{40, 5}, {60, 5}, {60, 50}, {40, 50}}).value();
  EXPECT_TRUE(world.is_affected(low, at_first));
  EXPECT_FALSE(world.is_affected(high, at_first));
  const std::uint64_t after_box = world.version();
  EXPECT_FALSE(world.is_affected(low, after_box));
  world.insert_point({50, 10}).value();
  EXPECT_FALSE(world.is_affected(low, after_box)) << "a point is no wall";
  EXPECT_FALSE(world.remove({77}).ok());
  EXPECT_FALSE(world.is_affected(low, after_box)) << "a refused operation changes nothing";
  world.remove(box).value();
  EXPECT_TRUE(world.is_affected(low, after_box)) << "the removal of a wall may make a shorter path possible";
  world.insert_all(std::vector<Item>{{{100}, {ItemKind::segment, {{{50, 80}, {50, 99}}}}}}).value();
  std::vector<Path> paths(3);
  paths[0].points = low;
  paths[1].points = high;
  std::vector<std::size_t> affected;
  world.find_affected(paths, after_box, affected);
  EXPECT_EQ(affected, (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(is_clear(world, high));
}

// The log forgets old boxes. A path from before the oldest box in the log counts as affected.
TEST(Affected, IsEverythingThatTheLogHasForgotten) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  const std::vector<Point> path = {{0, 90}, {100, 90}};
  const std::uint64_t at_first = world.version();
  std::uint64_t recent = 0;
  for (int i = 0; i < 3000; ++i) {
    const ItemId id = world.insert_segment({10, 10}, {20, 20}).value();
    if (i == 2500) recent = world.version();
    world.remove(id).value();
  }
  EXPECT_TRUE(world.is_affected(path, at_first));
  EXPECT_FALSE(world.is_affected(path, recent));
  std::vector<Item> many;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double x = static_cast<double>(i % 100);
    many.push_back({ItemId{i + 10000}, {ItemKind::segment, {{{x, 1}, {x, 2}}}}});
  }
  world.insert_all(many).value();
  EXPECT_FALSE(world.is_affected(path, recent));
  EXPECT_TRUE(world.is_affected(std::vector<Point>{{0.5, 0}, {0.5, 5}}, recent)) << "the box of many items is one";
}

// A clear path that no operation affects stays clear.
TEST(Affected, APathThatIsNotAffectedStaysClear) {
  Random random(99);
  std::size_t unaffected = 0;
  std::size_t blocked = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const PathCase path_case = random_path_case(Obstacles::mixture, 700 + seed, 20);
    World world = World::create(path_case.scene.domain).value();
    std::vector<Path> paths;
    for (const Item& item : path_case.scene.items) {
      paths.clear();
      for (const Ends& ends : path_case.queries) paths.push_back(world.find_path({ends.start, ends.goal}).value());
      const std::uint64_t before = world.version();
      EXPECT_TRUE(world.insert(item.shape, item.id).ok());
      if (random.chance(30)) world.remove(item.id).value();
      for (const Path& path : paths) {
        if (path.status != PathStatus::found) continue;
        const bool is_still_clear = is_clear(world, path.points);
        blocked += is_still_clear ? 0 : 1;
        if (world.is_affected(path.points, before)) continue;
        ++unaffected;
        EXPECT_TRUE(is_still_clear);
      }
    }
  }
  EXPECT_GT(unaffected, 1000U);
  EXPECT_GT(blocked, 100U);
}

}  // namespace
}  // namespace waywright::test

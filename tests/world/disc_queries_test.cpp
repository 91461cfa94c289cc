#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_paths.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"

// Paths of discs in slices, and from one start to many goals: the answers are those of World::find_path.

namespace waywright::test {
namespace {

using disc::expect_equal;
using disc::NamedScene;

World bridged_world_of(const NamedScene& scene) {
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  for (const auto& [a, b] : scene.walls.segments) world.insert_segment(a, b).value();
  return world;
}

NamedScene scene_of_seed(std::uint64_t seed) {
  Random random(seed);
  return disc::random_scene(random, disc::kSceneKinds[seed % disc::kSceneKinds.size()]);
}

std::vector<PathQuery> queries_of(const NamedScene& scene) {
  std::vector<PathQuery> queries;
  for (const auto& [start, goal] : scene.queries) {
    for (const double radius : scene.radii)
      queries.push_back({.start = start, .goal = goal, .agent = {.radius = radius}});
  }
  return queries;
}

TEST(DiscSlices, AnswerAsInOneGo) {
  PathSearch search;
  std::size_t slices = 0;
  for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const NamedScene scene = scene_of_seed(seed);
    const World world = bridged_world_of(scene);
    for (const PathQuery& query : queries_of(scene)) {
      const Path expected = world.find_path(query).value();
      search.begin(world, query).value();
      EXPECT_TRUE(search.is_running());
      while (!search.step(3).value()) {
        ++slices;
        ASSERT_NE(search.path().status, PathStatus::found);
      }
      EXPECT_FALSE(search.is_running());
      EXPECT_TRUE(search.step(1).value());
      expect_equal(search.path(), expected);
      ASSERT_EQ(search.path().expansions, expected.expansions);
      ASSERT_EQ(search.restarts(), 0U);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(slices, 10 * case_count());
}

// Between two slices, `ta` already has a path and a lower bound, and both become better.
TEST(DiscSlices, ImproveThePathOfTa) {
  PathSearch search;
  std::size_t improvements = 0;
  for (std::uint64_t seed = 0; seed < std::max<std::uint64_t>(case_count(), 50); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const NamedScene scene = scene_of_seed(seed);
    const World world = bridged_world_of(scene);
    for (PathQuery query : queries_of(scene)) {
      query.algorithm = PathAlgorithm::ta;
      query.budget.expansions = PathBudget::kNoLimit;
      const Path expected = world.find_path(query).value();
      search.begin(world, query).value();
      double length = std::numeric_limits<double>::infinity();
      double lower_bound = 0.0;
      while (!search.step(3).value()) {
        const Path& path = search.path();
        if (path.status != PathStatus::found) continue;
        ASSERT_LE(path.length, length);
        ASSERT_GE(path.length, expected.length);
        ASSERT_GE(path.lower_bound, lower_bound);
        ASSERT_LE(path.lower_bound, expected.length * (1 + 1e-12));
        length = path.length;
        lower_bound = path.lower_bound;
      }
      if (length > expected.length && length < std::numeric_limits<double>::infinity()) ++improvements;
      expect_equal(search.path(), expected);
      EXPECT_EQ(search.path().lower_bound, search.path().length);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(improvements, 0U);
}

TEST(DiscPathsOfTa, EndWithTheirTime) {
  const NamedScene scene = scene_of_seed(3);
  const World world = bridged_world_of(scene);
  std::size_t found = 0;
  for (PathQuery query : queries_of(scene)) {
    query.algorithm = PathAlgorithm::ta;
    const Path first = world.find_path(query).value();
    query.budget = {.expansions = PathBudget::kNoLimit, .time = std::chrono::nanoseconds(0)};
    expect_equal(world.find_path(query).value(), first);
    query.budget.time = std::chrono::hours(1);
    const Path best = world.find_path(query).value();
    EXPECT_EQ(best.lower_bound, best.length);
    EXPECT_EQ(best.time.count(), 0);
    if (best.status == PathStatus::found) ++found;
  }
  EXPECT_GT(found, 0U);
}

TEST(DiscSlices, AnswerForTheWorldOfTheLastSlice) {
  std::size_t restarts = 0;
  for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const NamedScene scene = scene_of_seed(seed);
    World world = bridged_world_of(scene);
    Random random(seed);
    PathSearch search;
    for (const PathQuery& query : queries_of(scene)) {
      search.begin(world, query).value();
      // Every change starts the search again, so the test stops changing the world at some time.
      for (int slice = 0; !search.step(3).value(); ++slice) {
        if (slice > 8 || !random.chance(30)) continue;
        const auto& [a, b] = scene.walls.segments[random.below(scene.walls.segments.size())];
        // A point makes a second mesh of the walls.
        const ItemId id = random.chance(20) ? world.insert_point(a).value() : world.insert_segment(b, a).value();
        if (random.chance(70)) world.remove(id).value();
        if (random.chance(10)) {
          World moved = std::move(world);
          world = std::move(moved);
          world.shrink_to_fit();
        }
      }
      restarts += search.restarts();
      expect_equal(search.path(), world.find_path(query).value());
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(restarts, case_count());
}

// Without points, shrink_to_fit() frees the second mesh, in which the search runs.
TEST(DiscSlices, StartAgainWhenTheSecondMeshIsFreed) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50, 0}, {50, 60}).value();
  world.insert_segment({70, 30}, {70, 100}).value();
  world.remove(world.insert_point({10, 10}).value()).value();
  PathSearch search;
  const PathQuery query{.start = {20, 50}, .goal = {90, 50}, .agent = {.radius = 5}};
  search.begin(world, query).value();
  ASSERT_FALSE(search.step(1).value());
  world.shrink_to_fit();
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.restarts(), 1U);
  expect_equal(search.path(), world.find_path(query).value());
}

TEST(DiscSlices, CanChangeBetweenPointsAndDiscs) {
  const NamedScene scene = scene_of_seed(3);
  const World world = bridged_world_of(scene);
  PathSearch search;
  for (PathQuery query : queries_of(scene)) {
    for (const double radius : {query.agent.radius, 0.0}) {
      query.agent.radius = radius;
      search.begin(world, query).value();
      search.step(1).value();
      search.begin(world, query).value();
      while (!search.step(5).value()) {
      }
      const Path expected = world.find_path(query).value();
      expect_equal(search.path(), expected);
      EXPECT_EQ(search.path().points, expected.points);
    }
  }
}

TEST(DiscSlices, SayHowLongTheSearchTookIfAsked) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50, 0}, {50, 60}).value();
  PathQuery query{.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}, .end_tolerance = 0};
  PathSearch search;
  for (const Point& start : {Point{20, 50}, Point{48, 50}}) {
    query.start = start;
    for (const bool wants_time : {true, false}) {
      query.wants_time = wants_time;
      search.begin(world, query).value();
      while (!search.step(1).value()) {
      }
      EXPECT_EQ(search.path().time.count() > 0, wants_time) << "start " << to_string(start);
    }
  }
}

// The disc fits neither at the start nor at two of the goals, but near to them.
TEST(DiscEnds, MoveInSlicesAndFromOneStartAsInSingleQueries) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50, 0}, {50, 60}).value();
  world.insert_segment({75, 40}, {75, 100}).value();
  const std::vector<Point> goals{{77, 90}, {90, 20}, {52, 20}};
  const ManyGoalsQuery many{
      .start = {48, 50}, .goals = goals, .agent = {.radius = 5}, .wants_points = true, .end_tolerance = 4};
  const std::vector<Path> paths = world.find_paths_from(many).value();
  PathSearch search;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    SCOPED_TRACE("goal " + std::to_string(i));
    const PathQuery query{.start = {48, 50}, .goal = goals[i], .agent = {.radius = 5}, .end_tolerance = 4};
    const Path expected = world.find_path(query).value();
    ASSERT_EQ(expected.status, PathStatus::found);
    ASSERT_TRUE(expected.moved_start);
    EXPECT_EQ(expected.moved_start->to, (Point{45, 50}));
    EXPECT_EQ(expected.moved_goal.has_value(), i != 1);
    EXPECT_EQ(expected.pieces.front().from, expected.moved_start->to);
    EXPECT_EQ(expected.pieces.back().to, expected.moved_goal ? expected.moved_goal->to : goals[i]);
    expect_equal(paths[i], expected);
    search.begin(world, query).value();
    while (!search.step(1).value()) {
    }
    expect_equal(search.path(), expected);
  }
}

// A wall divides the world into two rooms, and the start is too near to it. For each goal, the start moves into the
// room of this goal.
TEST(DiscEnds, MoveIntoTheRoomOfEachGoal) {
  World world = World::create({{0, 0}, {20, 10}}, {.keep_bridges = true}).value();
  world.insert_segment({10, 0}, {10, 10}).value();
  const std::vector<Point> goals{{5, 5}, {15, 5}};
  const std::vector<Path> paths =
      world.find_paths_from({.start = {9.75, 5}, .goals = goals, .agent = {.radius = 1}, .end_tolerance = 3}).value();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    SCOPED_TRACE("goal " + std::to_string(i));
    ASSERT_EQ(paths[i].status, PathStatus::found);
    ASSERT_TRUE(paths[i].moved_start);
    EXPECT_EQ(paths[i].moved_start->to, (i == 0 ? Point{9, 5} : Point{11, 5}));
    EXPECT_EQ(paths[i].length, 4.0);
  }
}

TEST(DiscSlices, NeedBridges) {
  const World world = World::create({{0, 0}, {100, 100}}).value();
  PathSearch search;
  EXPECT_EQ(search.begin(world, {.start = {1, 1}, .goal = {9, 9}, .agent = {.radius = 1}}).error().code,
            ErrorCode::no_bridges);
  EXPECT_FALSE(search.is_running());
}

TEST(DiscsFromOneStart, FindThePathsOfSingleQueries) {
  std::size_t found = 0;
  std::vector<Path> paths;
  QueryContext context;
  for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const NamedScene scene = scene_of_seed(seed);
    const World world = bridged_world_of(scene);
    std::vector<Point> goals;
    for (const auto& [start, goal] : scene.queries) goals.insert(goals.end(), {goal, start, goal});
    for (const double radius : scene.radii) {
      ManyGoalsQuery query{.start = scene.queries[seed % 4].first, .goals = goals, .agent = {.radius = radius}};
      query.wants_points = seed % 2 == 0;
      world.find_paths_from(query, context, paths).value();
      ASSERT_EQ(paths.size(), goals.size());
      std::size_t expansions = 0;
      for (std::size_t i = 0; i < goals.size(); ++i) {
        Path expected = world.find_path({.start = query.start, .goal = goals[i], .agent = {.radius = radius}}).value();
        expansions += expected.expansions;
        found += expected.status == PathStatus::found ? 1 : 0;
        if (!query.wants_points) expected.pieces.clear();
        expect_equal(paths[i], expected);
      }
      for (const Path& path : paths) EXPECT_EQ(path.expansions, expansions);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(found, case_count());
}

TEST(DiscsFromOneStart, RefuseWhatSingleQueriesRefuse) {
  const std::vector<Point> goals{{9, 9}, {5, 5}};
  const World bare = World::create({{0, 0}, {100, 100}}).value();
  EXPECT_EQ(bare.find_paths_from({.start = {1, 1}, .goals = goals, .agent = {.radius = 1}}).error().code,
            ErrorCode::no_bridges);
  const World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  EXPECT_EQ(world.find_paths_from({.start = {1, 1}, .goals = goals, .agent = {.radius = -1}}).error().code,
            ErrorCode::bad_radius);
  EXPECT_TRUE(world.find_paths_from({.start = {1, 1}, .goals = {}, .agent = {.radius = 1}})->empty());
  EXPECT_EQ(world.find_paths_from({.start = {1, 1}, .goals = goals, .agent = {.radius = 2}})->back().status,
            PathStatus::start_blocked);
}

}  // namespace
}  // namespace waywright::test

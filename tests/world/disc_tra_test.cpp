#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_paths.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"

// The algorithms `tra` and `ta` for discs: they find a path exactly if there is one, the path is valid, and on average
// it is hardly longer than the shortest one. With a budget, `ta` improves its path until it has proven that it is the
// shortest one.

namespace waywright::test {
namespace {

using disc::NamedScene;

/// Sums up how much longer the paths are than the shortest ones.
struct Excess {
  std::size_t count = 0;
  double sum = 0.0;
  double worst = 1.0;

  void add(double ratio) {
    ++count;
    sum += ratio;
    worst = std::max(worst, ratio);
  }
};

/// Checks the paths that `ta` finds with growing budgets.
void check_ta(const disc::Walls& walls, const World& world, PathQuery query, double shortest) {
  query.algorithm = PathAlgorithm::ta;
  double length = std::numeric_limits<double>::infinity();
  std::size_t first_expansions = 0;
  for (const std::size_t budget : {std::size_t{0}, std::size_t{20}, PathBudget::kNoLimit}) {
    SCOPED_TRACE("budget " + std::to_string(budget));
    query.budget.expansions = budget;
    const Path path = world.find_path(query).value();
    ASSERT_EQ(path.status, PathStatus::found);
    const auto report = disc::check_path(walls, query.start, query.goal, query.agent.radius, disc::pieces_of(path));
    ASSERT_EQ(report.fault, "");
    ASSERT_NEAR(report.length, path.length, 1e-9 * path.length);
    ASSERT_LE(path.length, length);
    ASSERT_GE(path.length, shortest * (1 - 1e-12));
    ASSERT_LE(path.lower_bound, shortest * (1 + 1e-12));
    if (budget == 0) first_expansions = path.expansions;
    if (budget == 20) {
      ASSERT_LE(path.expansions, std::max(first_expansions, budget) + 40) << "hardly more than the budget";
    }
    length = path.length;
    if (budget != PathBudget::kNoLimit) continue;
    ASSERT_NEAR(path.length, shortest, 1e-12 * shortest);
    ASSERT_EQ(path.lower_bound, path.length);
  }
}

void check_query(const disc::Walls& walls, const disc::Connectivity& oracle, const World& world, const Point& start,
                 const Point& goal, double radius, Excess& excess) {
  if (!oracle.fits(start, radius) || !oracle.fits(goal, radius)) return;
  PathQuery query{
      .start = start, .goal = goal, .agent = {.radius = radius}, .algorithm = PathAlgorithm::tra, .end_tolerance = 0};
  const Path path = world.find_path(query).value();
  ASSERT_EQ(path.status == PathStatus::found, oracle.connected(start, goal, radius));
  if (path.status != PathStatus::found) return;
  const disc::PathReport report = disc::check_path(walls, start, goal, radius, disc::pieces_of(path));
  ASSERT_EQ(report.fault, "");
  ASSERT_NEAR(report.length, path.length, 1e-9 * path.length);
  query.algorithm = PathAlgorithm::optimal;
  const Path shortest_path = world.find_path(query).value();
  ASSERT_EQ(shortest_path.status, PathStatus::found);
  const double shortest = shortest_path.length;
  ASSERT_GE(path.length, shortest * (1 - 1e-12));
  ASSERT_LE(path.lower_bound, shortest * (1 + 1e-12));
  excess.add(shortest > 0.0 ? path.length / shortest : 1.0);
  check_ta(walls, world, query, shortest);
}

void check_lengths(const NamedScene& scene, bool has_point, bool keeps_abstraction, Excess& excess) {
  const disc::Walls walls = walls_of(scene);
  const disc::Connectivity oracle(walls);
  // Without an abstraction, the search knows no dead ends. With a point, it runs in a second mesh of the walls.
  World world = World::create(scene.domain, {.keep_abstraction = keeps_abstraction, .keep_bridges = true}).value();
  for (const auto& [a, b] : scene.walls.segments) world.insert_segment(a, b).value();
  if (has_point) world.insert_point(scene.queries.front().first).value();
  for (const auto& [start, goal] : scene.queries) {
    for (const double radius : scene.radii) {
      SCOPED_TRACE(scene.name + ", " + to_string(start) + " to " + to_string(goal) + ", radius " +
                   std::to_string(radius));
      check_query(walls, oracle, world, start, goal, radius, excess);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

class DiscTra : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(DiscTra, FindsAPathExactlyIfThereIsOne) {
  Random random(41);
  Excess excess;
  for (std::uint64_t i = 0; i < (case_count() + 4) / 5; ++i) {
    check_lengths(disc::random_scene(random, GetParam()), i % 2 != 0, i % 4 < 2, excess);
    if (testing::Test::HasFatalFailure()) FAIL() << "scene " << i;
  }
  if (excess.count == 0) return;
  RecordProperty("queries", static_cast<int>(excess.count));
  RecordProperty("mean", std::to_string(excess.sum / static_cast<double>(excess.count)));
  RecordProperty("worst", std::to_string(excess.worst));
  EXPECT_LE(excess.sum, 1.02 * static_cast<double>(excess.count) + 1.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DiscTra, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

TEST(DiscTraTraps, HaveAPathExactlyIfThereIsOne) {
  Excess excess;
  for (std::uint64_t seed = 0; seed <= case_count() / 20; ++seed) {
    for (const NamedScene& scene : disc::checked_trap_scenes(seed)) {
      check_lengths(scene, false, true, excess);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(excess.count, 0U);
}

/// Expects the same path from both worlds, found with the same number of expansions, by all three algorithms.
void expect_same_paths(const World& a, const World& b, const Point& start, const Point& goal, double radius) {
  for (const PathAlgorithm algorithm : {PathAlgorithm::tra, PathAlgorithm::ta, PathAlgorithm::optimal}) {
    const PathQuery query{
        .start = start, .goal = goal, .agent = {.radius = radius}, .algorithm = algorithm, .end_tolerance = 0.0};
    const Path path = a.find_path(query).value();
    const Path other = b.find_path(query).value();
    EXPECT_EQ(path.status, PathStatus::found);
    EXPECT_EQ(path.pieces, other.pieces);
    EXPECT_EQ(path.length, other.length);
    EXPECT_EQ(path.expansions, other.expansions);
  }
}

// A channel may lead around an obstacle back to the face of the start. The search must not prefer this channel to the
// one that leaves the face at once: a path through it is a third longer here.
TEST(DiscTraChannels, DoNotLeadBackToTheStart) {
  World world = World::create({{0, 0}, {64, 64}}, {.keep_bridges = true}).value();
  world.insert(Shape::polygon({{6.25, 16.875}, {13.25, 12}, {6.375, 61.75}})).value();
  world.insert_segment({6, 4.875}, {59, 62}).value();
  world.insert_segment({1.125, 50.375}, {37.25, 41.375}).value();
  world.insert(Shape::polygon({{32.375, 43.875}, {35.25, 43.875}, {35.25, 50}, {32.375, 50}})).value();
  PathQuery query{.start = {29.9375, 54.6875}, .goal = {10.6875, 3.5}, .agent = {.radius = 0.5}};
  const Path shortest = world.find_path(query).value();
  query.algorithm = PathAlgorithm::tra;
  const Path path = world.find_path(query).value();
  EXPECT_EQ(path.status, PathStatus::found);
  EXPECT_LT(path.length, 1.001 * shortest.length);
}

// With points, the search for discs runs in a second mesh without them. This mesh stays when the last point is removed.
// A search in it must leave out the same dead ends.
TEST(DiscTraHistory, MakesNoDifferenceAfterTheLastPointIsRemoved) {
  const auto insert_walls = [](World& world) {
    for (std::uint64_t i = 0; i < 6; ++i) {
      const double x = 8.0 + 8.0 * static_cast<double>(i);
      world.insert_segment({x, i % 2 == 0 ? 0.0 : 8.0}, {x, i % 2 == 0 ? 56.0 : 64.0}, {i + 1}).value();
    }
    for (std::uint64_t i = 0; i < 20; ++i) {  // dead ends between the stubs
      const double y = 3.0 * static_cast<double>(i + 1);
      world.insert_segment({0, y}, {5, y + 1}, {i + 20}).value();
      world.insert_segment({64, y}, {59, y - 1}, {i + 50}).value();
    }
    world.insert(Shape::polygon({{26, 20}, {30, 20}, {30, 24}, {26, 24}}), 10).value();
  };
  World world = World::create({{0, 0}, {64, 64}}, {.keep_bridges = true}).value();
  insert_walls(world);
  World with_point = World::create({{0, 0}, {64, 64}}, {.keep_bridges = true}).value();
  with_point.insert_point({36, 32}, 11).value();
  insert_walls(with_point);
  with_point.remove(10).value();
  with_point.insert(Shape::polygon({{26, 20}, {30, 20}, {30, 24}, {26, 24}}), 10).value();
  EXPECT_TRUE(with_point.validate().ok);
  with_point.remove(11).value();
  EXPECT_TRUE(with_point.validate().ok);
  expect_same_paths(world, with_point, {7, 2}, {57, 62}, 0.75);
}

}  // namespace
}  // namespace waywright::test

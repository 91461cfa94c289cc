#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_scenes.hpp"
#include "support/divided_town.hpp"
#include "support/random.hpp"

// Queries for discs that cannot get through: what they answer, and that they answer without a long search.

namespace waywright::test {
namespace {

constexpr std::array kAlgorithms{PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal};

/// Expects what a refused query says: no length, no expansions, and the gap that widest_path() gives.
void expect_refusal(const World& world, const PathQuery& query, const Path& path) {
  ASSERT_EQ(path.expansions, 0U);
  ASSERT_EQ(path.length, 0.0);
  const WidestPath widest = world.widest_path(query.start, query.goal).value();
  ASSERT_EQ(path.widest.has_value(), widest.is_connected);
  if (path.widest) {
    ASSERT_EQ(*path.widest, widest);
    ASSERT_LT(path.widest->radius, query.agent.radius);
  }
}

// One context remembers the gaps of all queries, while the world changes from time to time.
TEST(DiscRefusals, SayWhatWidestPathSays) {
  std::size_t refused = 0;
  QueryContext context;
  Path path;
  for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
    Random random(seed);
    const disc::NamedScene scene = disc::random_scene(random, disc::kSceneKinds[seed % disc::kSceneKinds.size()]);
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = World::create(scene.domain, {.keep_abstraction = seed % 2 == 0, .keep_bridges = true}).value();
    for (const auto& [a, b] : scene.walls.segments) world.insert_segment(a, b).value();
    for (int round = 0; round < 40; ++round) {
      const auto& [start, goal] = scene.queries[random.below(scene.queries.size())];
      const auto& [other_start, other_goal] = scene.queries[random.below(scene.queries.size())];
      PathQuery query{.start = start, .goal = random.chance(50) ? goal : other_start, .end_tolerance = 0.0};
      query.agent.radius = scene.radii[random.below(scene.radii.size())];
      query.algorithm = kAlgorithms[random.below(3)];
      if (query.algorithm == PathAlgorithm::tra && seed % 2 != 0) query.algorithm = PathAlgorithm::optimal;
      world.find_path(query, context, path).value();
      const auto of_widest = world.widest_path(query.start, query.goal).value();
      if (path.status == PathStatus::found) {
        ASSERT_LE(query.agent.radius, of_widest.radius);
      } else if (path.status == PathStatus::no_path) {
        ++refused;
        expect_refusal(world, query, path);
        if (HasFatalFailure()) return;
      }
      if (!random.chance(10)) continue;
      const std::vector<ItemId> ids = world.item_ids();
      if (!ids.empty()) world.remove(ids[random.below(ids.size())]).value();
    }
  }
  EXPECT_GT(refused, case_count());
}

TEST(DiscRefusals, AgreeInATownThatChanges) {
  DividedTown town(1);
  QueryContext context;
  Path path;
  std::array<std::size_t, 2> counts{};
  for (std::size_t round = 0; round < 200; ++round) {
    if (round % 5 == 0) town.change();
    const PathQuery query = town.query(std::array{1.0, 2.0, 4.0, 8.0}[town.random.below(4)], kAlgorithms[round % 3]);
    town.world.find_path(query, context, path).value();
    if (path.status == PathStatus::found) {
      ASSERT_LE(query.agent.radius, 3.0);
    }
    if (path.status != PathStatus::no_path) continue;
    ++counts[query.agent.radius > 3.0 ? 1 : 0];
    expect_refusal(town.world, query, path);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts[1], 30U);
}

/// Returns the number of slices of one step that a search takes.
std::size_t count_slices(PathSearch& search, const World& world, const PathQuery& query) {
  search.begin(world, query).value();
  std::size_t slices = 1;
  while (!search.step(1).value()) ++slices;
  return slices;
}

// The first refusal may search the side of the start. After that, the search knows that the gap is too narrow.
TEST(DiscRefusals, SearchNoSideAgain) {
  DividedTown town(2);
  for (const PathAlgorithm algorithm : kAlgorithms) {
    PathSearch search;
    std::size_t most = 0;
    std::size_t refused = 0;
    const std::size_t first = count_slices(search, town.world, town.query(8, algorithm));
    ASSERT_EQ(search.path().status, PathStatus::no_path);
    for (int i = 0; i < 50; ++i) {
      const PathQuery query = town.query(i % 2 == 0 ? 4.0 : 8.0, algorithm);
      const std::size_t slices = count_slices(search, town.world, query);
      if (search.path().status != PathStatus::no_path) continue;
      ++refused;
      most = std::max(most, slices);
    }
    EXPECT_GT(refused, 30U);
    EXPECT_GT(first, 200U);
    EXPECT_LT(most, 50U);
  }
}

// The goal lies in a small yard, and the start in a large area.
TEST(DiscRefusals, FindASmallEnclosedSideSoon) {
  DividedTown town(3);
  town.world.remove(DividedTown::house(0)).value();
  const auto yard = std::vector<Point>{{1, 1}, {45, 1}, {45, 45}, {1, 45}, {1, 4}};
  town.world.insert(Shape::polyline(yard)).value();
  PathSearch search;
  const PathQuery query{
      .start = {490, 985}, .goal = {23, 23}, .agent = {.radius = 2.5}, .algorithm = PathAlgorithm::optimal};
  const std::size_t slices = count_slices(search, town.world, query);
  ASSERT_EQ(search.path().status, PathStatus::no_path);
  expect_refusal(town.world, query, search.path());
  EXPECT_LT(slices, 1500U);
}

// A refusal in one world says nothing about another one, also if it is at the same version.
TEST(DiscRefusals, BelongToOneWorld) {
  QueryContext context;
  Path path;
  const PathQuery query{.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}};
  for (const double gap : {6.0, 20.0, 8.0}) {
    World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
    world.insert_segment({50, 0}, {50, 45}).value();
    world.insert_segment({50, 45 + gap}, {50, 100}).value();
    world.find_path(query, context, path).value();
    EXPECT_EQ(path.status == PathStatus::found, gap > 10.0);
    const World copy = world.clone();
    copy.find_path(query, context, path).value();
    EXPECT_EQ(path.status == PathStatus::found, gap > 10.0);
  }
}

// The question of an attempt sees the world with the change.
TEST(DiscRefusals, KnowWhetherAnAttemptIsUnderWay) {
  DividedTown town(4);
  QueryContext context;
  Path path;
  const PathQuery query{.start = {490, 498}, .goal = {510, 498}, .agent = {.radius = 8}, .end_tolerance = 0.0};
  const auto is_found = [&] {
    town.world.find_path(query, context, path).value();
    return path.status == PathStatus::found;
  };
  for (std::size_t square = 0; square < DividedTown::kRows * DividedTown::kRows; ++square) {
    if (town.is_built(square)) town.world.remove(DividedTown::house(square)).value();
  }
  EXPECT_FALSE(is_found());
  EXPECT_TRUE(town.world.attempt({Change::remove({1})}, [&](const World&) { return is_found(); }).value());
  EXPECT_FALSE(is_found());
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_paths.hpp"
#include "support/disc_scenes.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

// Two worlds with the same items must give the same answers about discs, whatever their histories.

namespace waywright::test {
namespace {

/// The start and the goal of a query.
using DiscQueryEnds = std::pair<Point, Point>;

/// A query with an algorithm, a budget and a tolerance that `variant` chooses.
PathQuery disc_query_of(const DiscQueryEnds& ends, double radius, unsigned variant, double size) {
  PathQuery query{.start = ends.first, .goal = ends.second, .agent = {.radius = radius}};
  query.algorithm = variant % 3 == 0   ? PathAlgorithm::tra
                    : variant % 3 == 1 ? PathAlgorithm::optimal
                                       : PathAlgorithm::ta;
  if (query.algorithm == PathAlgorithm::ta) query.budget.expansions = variant / 3 % 2 == 0 ? 20 : PathBudget::kNoLimit;
  query.end_tolerance = variant / 6 % 2 == 0 ? 0.0 : 0.25 * size;
  return query;
}

/// Compares the answers about a disc in both worlds. Returns the number of paths that it has found.
std::size_t compare_discs(const World& world, const World& other, const DiscQueryEnds& ends, double radius) {
  const double size =
      std::max(world.domain().max.x - world.domain().min.x, world.domain().max.y - world.domain().min.y);
  constexpr unsigned kVariants = 12;
  std::size_t found = 0;
  for (unsigned variant = 0; variant < kVariants; ++variant) {
    SCOPED_TRACE("variant " + std::to_string(variant));
    const PathQuery query = disc_query_of(ends, radius, variant, size);
    const Path a = world.find_path(query).value();
    const Path b = other.find_path(query).value();
    disc::expect_equal(a, b);
    EXPECT_EQ(a.expansions, b.expansions);
    if (a.status == PathStatus::found) ++found;
  }
  EXPECT_EQ(world.fit_disc(ends.first, {.radius = radius}).value(),
            other.fit_disc(ends.first, {.radius = radius}).value());
  EXPECT_EQ(world.widest_path(ends.first, ends.second).value(), other.widest_path(ends.first, ends.second).value());
  EXPECT_EQ(world.ray(ends.first, ends.second, {.radius = radius}).value(),
            other.ray(ends.first, ends.second, {.radius = radius}).value());
  for (const std::optional<Point>& goal : {std::optional<Point>{}, std::optional<Point>{ends.second}}) {
    EXPECT_EQ(world.nearest_fit({.point = ends.first, .agent = {.radius = radius}, .goal = goal}).value(),
              other.nearest_fit({.point = ends.first, .agent = {.radius = radius}, .goal = goal}).value());
  }
  return found;
}

class DiscHistory : public ::testing::TestWithParam<Flavour> {};

TEST_P(DiscHistory, MakesNoDifferenceAfterRandomChanges) {
  constexpr std::size_t kChangeCount = 80;
  constexpr std::size_t kItemCount = 25;
  constexpr std::size_t kChangesBetween = 16;
  constexpr int kQueriesBetween = 6;
  std::size_t found = 0;
  // Most of the time goes into nearest_fit() with coordinates from 2^-100 to 2^100, so this flavour has fewer cases.
  const std::uint64_t seeds = 1 + case_count() / (GetParam() == Flavour::mixed ? 20 : 2);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const ChangeScript script = random_changes(GetParam(), seed, kChangeCount, kItemCount);
    World world = World::create(script.domain, {.keep_bridges = true}).value();
    LiveItems live(script.domain);
    Random random(seed);
    const double size = script.domain.max.x - script.domain.min.x;
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
      ASSERT_EQ(perform(world, script.steps[i]).ok(), live.apply(script.steps[i]).ok());
      if (i % kChangesBetween != kChangesBetween - 1) continue;
      const World fresh = fresh_world(live, {.keep_bridges = true});
      for (int k = 0; k < kQueriesBetween; ++k) {
        const DiscQueryEnds ends{random_point(GetParam(), script.domain, random),
                                 random_point(GetParam(), script.domain, random)};
        const double share = 0x1p-10 * static_cast<double>(random.below(1024));
        found += compare_discs(world, fresh, ends, 0.1 * size * share * share * share);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << i << ", query " << k;
      }
    }
  }
  EXPECT_GT(found, 10 * seeds);
}

INSTANTIATE_TEST_SUITE_P(Flavours, DiscHistory, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

class DiscSceneHistory : public ::testing::TestWithParam<disc::SceneKind> {};

TEST_P(DiscSceneHistory, MakesNoDifference) {
  Random random(7);
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= case_count(); ++seed) {
    const disc::NamedScene scene = disc::random_scene(random, GetParam());
    World world = World::create(scene.domain, {.keep_bridges = true}).value();
    World other = World::create(scene.domain, {.keep_bridges = true}).value();
    const auto& walls = scene.walls.segments;
    for (std::size_t i = 0; i < walls.size(); ++i)
      world.insert_segment(walls[i].first, walls[i].second, {i + 1}).value();
    for (std::size_t i = walls.size(); i-- > 0;) other.insert_segment(walls[i].first, walls[i].second, {i + 1}).value();
    for (std::size_t round = 0; round < 4; ++round) {
      const std::size_t i = random.below(walls.size());
      other.remove({i + 1}).value();
      other.insert_segment(walls[i].first, walls[i].second, {i + 1}).value();
      for (const auto& [start, goal] : scene.queries) {
        found += compare_discs(world, other, {start, goal}, scene.radii[round]);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", round " << round << ", from " << to_string(start) << " to "
                                   << to_string(goal) << ", radius " << scene.radii[round];
      }
    }
  }
  EXPECT_GT(found, case_count());
}

INSTANTIATE_TEST_SUITE_P(Kinds, DiscSceneHistory, ::testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(disc::to_string(kind.param)); });

}  // namespace
}  // namespace waywright::test

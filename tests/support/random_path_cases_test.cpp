#include "support/random_path_cases.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "oracle/shortest_paths.hpp"
#include "support/oracle_adapter.hpp"
#include "support/path_scene_check.hpp"

namespace waywright::test {
namespace {

using oracle::OracleStatus;

constexpr std::size_t kScenes = 40;
constexpr std::size_t kQueries = 5;

/// Returns how often the oracle gives each status in many cases.
std::map<OracleStatus, std::size_t> census_of(Obstacles obstacles) {
  std::map<OracleStatus, std::size_t> census;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const PathCase path_case = random_path_case(obstacles, seed, kQueries);
    EXPECT_GE(path_case.scene.items.size(), 10U);
    EXPECT_LE(path_case.scene.items.size(), 60U);
    oracle::ShortestPaths paths(oracle::to_oracle(path_case.scene), oracle_ends(path_case));
    for (const Ends& query : path_case.queries) {
      ++census[paths.between(oracle::to_oracle(query.start), oracle::to_oracle(query.goal)).status];
    }
  }
  return census;
}

TEST(RandomPathCases, AskForPathsOfEveryOutcome) {
  for (const Obstacles obstacles : kObstacles) {
    auto census = census_of(obstacles);
    SCOPED_TRACE(to_string(obstacles));
    EXPECT_GE(census[OracleStatus::found], kScenes);
    if (obstacles != Obstacles::walls) {
      EXPECT_GE(census[OracleStatus::no_path], 3U);
    }
    const bool has_solids = obstacles != Obstacles::walls && obstacles != Obstacles::polylines;
    EXPECT_EQ(census[OracleStatus::start_blocked] > 0, has_solids);
    EXPECT_EQ(census[OracleStatus::goal_blocked] > 0, has_solids);
  }
}

// Compares two methods to find out whether a path exists: the visibility graph, and a flood fill over the faces of a
// mesh.
TEST(RandomPathCases, AreConnectedWhereTheVisibilityGraphFindsAPath) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const PathCase path_case = random_path_case(kObstacles.at(seed % kObstacles.size()), seed, kQueries);
    World world = World::create(path_case.scene.domain).value();
    for (const Item& item : path_case.scene.items) ASSERT_TRUE(world.insert(item.shape, item.id).ok());
    const std::string dump = world.dump();
    const oracle::Oracle oracle(oracle::to_oracle(path_case.scene));
    oracle::ShortestPaths paths(oracle::to_oracle(path_case.scene), oracle_ends(path_case));
    for (const Ends& query : path_case.queries) {
      const oracle::OraclePoint start = oracle::to_oracle(query.start);
      const oracle::OraclePoint goal = oracle::to_oracle(query.goal);
      const OracleStatus status = paths.between(start, goal).status;
      EXPECT_EQ(status == OracleStatus::start_blocked, oracle.strictly_inside(start));
      if (status == OracleStatus::start_blocked || status == OracleStatus::goal_blocked) continue;
      EXPECT_EQ(status == OracleStatus::found, oracle.connected(dump, start, goal)) << seed;
    }
  }
}

}  // namespace
}  // namespace waywright::test

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "support/path_positions_check.hpp"
#include "support/random_path_cases.hpp"

namespace waywright::test {
namespace {

class PositionsOnPaths : public ::testing::TestWithParam<Obstacles> {};

// Taut paths touch walls, so a rounded point of a path can lie inside a polygon.
TEST_P(PositionsOnPaths, CanBeStartedFrom) {
  const bool has_solids_only = GetParam() == Obstacles::boxes || GetParam() == Obstacles::tiles;
  std::size_t positions = 0;
  std::size_t moved = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const PathPositionsReport report =
        check_path_positions(random_path_case(GetParam(), 9000 + seed, 8), 10, has_solids_only);
    ASSERT_EQ(report.fault.value_or(""), "") << "seed " << seed;
    positions += report.positions;
    moved += report.moved;
  }
  EXPECT_GT(positions, 1000U);
  if (GetParam() == Obstacles::boxes) {
    EXPECT_GT(moved, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(Obstacles, PositionsOnPaths, ::testing::ValuesIn(kObstacles),
                         [](const auto& obstacles) { return std::string(to_string(obstacles.param)); });

}  // namespace
}  // namespace waywright::test

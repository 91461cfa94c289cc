#include <array>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "support/case_count.hpp"
#include "support/path_scene_check.hpp"
#include "support/random_path_cases.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kQueriesPerScene = 5;

/// The largest allowed mean ratio of a path's length to the shortest length.
constexpr double kLargestMeanRatio = 1.02;

template <class MakeCase>
void check_cases(const std::string& kind, const MakeCase& make) {
  std::array<PathRatios, kPathAlgorithms.size()> ratios;
  for (std::uint64_t seed = 1; seed <= case_count(); ++seed) {
    const PathCase path_case = make(seed);
    const PathReport report = check_paths(path_case);
    if (report.fault) FAIL() << report_failure(path_case, "path-" + kind + "-" + std::to_string(seed));
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios.at(i) += report.ratios.at(i);
  }
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    EXPECT_GT(ratios.at(i).count, case_count()) << to_string(kPathAlgorithms.at(i));
    EXPECT_LE(ratios.at(i).mean(), kLargestMeanRatio) << to_string(kPathAlgorithms.at(i));
  }
}

class PathsAmongObstacles : public ::testing::TestWithParam<Obstacles> {};

TEST_P(PathsAmongObstacles, AreThoseOfTheVisibilityGraph) {
  check_cases(std::string(to_string(GetParam())),
              [](std::uint64_t seed) { return random_path_case(GetParam(), seed, kQueriesPerScene); });
}

INSTANTIATE_TEST_SUITE_P(Obstacles, PathsAmongObstacles, ::testing::ValuesIn(kObstacles),
                         [](const auto& obstacles) { return std::string(to_string(obstacles.param)); });

class PathsInRandomScenes : public ::testing::TestWithParam<Flavour> {};

TEST_P(PathsInRandomScenes, AreThoseOfTheVisibilityGraph) {
  check_cases(std::string(to_string(GetParam())),
              [](std::uint64_t seed) { return random_path_case(GetParam(), seed, seed % 61, kQueriesPerScene); });
}

INSTANTIATE_TEST_SUITE_P(Flavours, PathsInRandomScenes, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test

#include "support/path_scene_check.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "support/random_path_cases.hpp"

namespace waywright::test {
namespace {

using ::testing::HasSubstr;

/// Returns a case with a wall across most of the domain, an item beside it, and a path around the wall.
PathCase wall_case() {
  PathCase result;
  result.scene.domain = {{0.0, 0.0}, {8.0, 8.0}};
  result.scene.items = {{ItemId{1}, {ItemKind::segment, {{{4.0, 0.0}, {4.0, 6.0}}}}},
                        {ItemId{2}, {ItemKind::segment, {{{1.0, 7.0}, {2.0, 7.0}}}}}};
  result.queries = {{{1.0, 1.0}, {2.0, 1.0}}, {{1.0, 6.0}, {7.0, 6.0}}, {{1.0, 2.0}, {7.0, 2.0}}};
  return result;
}

/// Returns a finder that changes the world's answers with `spoil`.
template <class Spoil>
PathFinder spoilt(Spoil spoil) {
  return [spoil](const World& world, const PathQuery& query, QueryContext& context, Path& path) {
    Result<void> done = world.find_path(query, context, path);
    spoil(path);
    return done;
  };
}

std::string fault_with(const PathFinder& find) { return check_paths(wall_case(), find).fault.value_or("no fault"); }

TEST(PathSceneCheck, IsContentWithTheWorld) {
  const PathReport report = check_paths(wall_case());
  EXPECT_EQ(report.fault.value_or("no fault"), "no fault");
  EXPECT_EQ(report.queries, 3 * kPathAlgorithms.size());
  for (const PathRatios& ratios : report.ratios) {
    EXPECT_EQ(ratios.count, 3U);
    EXPECT_NEAR(ratios.mean(), 1.0, 1e-12);
  }
}

TEST(PathSceneCheck, FindsEveryKindOfFault) {
  EXPECT_THAT(fault_with(spoilt([](Path& path) { path.status = PathStatus::no_path; })), HasSubstr("no-path instead"));
  EXPECT_THAT(fault_with(spoilt([](Path& path) { path.length *= 1.0 + 1e-8; })), HasSubstr("not that of the points"));
  EXPECT_THAT(fault_with(spoilt([](Path& path) { path.points.pop_back(); })), HasSubstr("does not lead"));
  EXPECT_THAT(fault_with(spoilt([](Path& path) {
                if (path.points.size() < 3) return;
                path.points = {path.points.front(), path.points.back()};
                path.length = 6.0;
              })),
              HasSubstr("wall of item 1"));
}

/// Adds a corner to a path around the wall that has one corner.
void add_detour(Path& path) {
  if (path.points.size() != 3) return;
  path.points.insert(path.points.begin() + 2, {4.0, 8.0});
  path.length = 5.0 + 2.0 + std::sqrt(9.0 + 36.0);
}

TEST(PathSceneCheck, MeasuresDetoursAndGrantsTheShortestNone) {
  const PathReport report = check_paths(wall_case(), spoilt(add_detour));
  EXPECT_NEAR(report.ratios[0].worst, (7.0 + std::sqrt(45.0)) / 10.0, 1e-12);
  EXPECT_THAT(report.fault.value_or("no fault"), HasSubstr("not the shortest"));
  EXPECT_EQ(report.line, "path 1 2 7 2 0 optimal");
  EXPECT_EQ(report.failed_query, 2U);
}

TEST(PathSceneCheck, ShrinksToTheQueryAndItsItems) {
  const PathFinder find = spoilt([](Path& path) {
    if (path.points.size() == 3) path.status = PathStatus::no_path;
  });
  const std::string report = report_failure(wall_case(), "path-check-test", find);
  const auto file = std::filesystem::temp_directory_path() / "waywright-path-check-test.wws";
  std::stringstream script;
  script << std::ifstream(file).rdbuf();
  std::filesystem::remove(file);
  EXPECT_EQ(script.str(), "waywright 1\ndomain 0 0 8 8\nsegment 1 4 0 4 6\npath 1 2 7 2 0 ta\n");
  EXPECT_THAT(report, HasSubstr("no-path instead of found"));
  EXPECT_THAT(report, HasSubstr(script.str()));
}

}  // namespace
}  // namespace waywright::test

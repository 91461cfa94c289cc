#include <cstddef>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"

#include "support/random_scenes.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

using ::testing::HasSubstr;

/// Fails while the scene contains a polygon with a point left of `x`, and a segment.
SceneReport polygon_and_segment(const Scene& scene, double x) {
  bool polygon = false;
  bool segment = false;
  for (const Item& item : scene.items) {
    segment = segment || item.shape.kind == ItemKind::segment;
    if (item.shape.kind != ItemKind::polygon) continue;
    for (const auto& ring : item.shape.rings) {
      for (const Point& p : ring) polygon = polygon || p.x < x;
    }
  }
  SceneReport report;
  if (polygon && segment) report.fault = "both are there";
  return report;
}

TEST(Shrink, LeavesOnlyWhatTheFaultNeeds) {
  const auto check = [](const Scene& scene) { return polygon_and_segment(scene, 3.0); };
  const Scene scene = random_scene(Flavour::lattice, 1, 60);
  ASSERT_TRUE(check(scene).fault.has_value());
  const Scene small = shrink(scene, check);
  EXPECT_TRUE(check(small).fault.has_value());
  ASSERT_EQ(small.items.size(), 2U);
  std::size_t points = 0;
  for (const Item& item : small.items) {
    for (const auto& ring : item.shape.rings) points += ring.size();
  }
  EXPECT_EQ(points, 1U + 2U);
}

TEST(Shrink, ReportsFaultFileAndScript) {
  const auto check = [](const Scene& scene) { return polygon_and_segment(scene, 3.0); };
  const std::string report = report_failure(random_scene(Flavour::lattice, 1, 60), "shrink-test", check);
  const auto file = std::filesystem::temp_directory_path() / "waywright-shrink-test.wws";
  EXPECT_THAT(report, HasSubstr("both are there"));
  EXPECT_THAT(report, HasSubstr(file.string()));
  std::stringstream script;
  script << std::ifstream(file).rdbuf();
  EXPECT_THAT(script.str(), HasSubstr("polygon "));
  EXPECT_THAT(report, HasSubstr(script.str()));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace waywright::test

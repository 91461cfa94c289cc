#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"

#include "support/case_count.hpp"
#include "tools/command.hpp"

namespace waywright::test {
namespace {

const std::filesystem::path kRoot = WAYWRIGHT_SOURCE_DIR;
const std::string kMap = (kRoot / "examples/maps/highground.wws").string();

TEST(DemoMap, HoldsWhatARealMapHolds) {
  const Scene scene = read_scene(kMap).value();
  const auto count = [&](ItemKind kind) {
    return std::count_if(scene.items.begin(), scene.items.end(),
                         [&](const Item& item) { return item.shape.kind == kind; });
  };
  EXPECT_GE(count(ItemKind::polygon), 250);
  EXPECT_GE(count(ItemKind::polyline) + count(ItemKind::segment), 20);
  EXPECT_GE(count(ItemKind::point), 10);
  EXPECT_TRUE(std::any_of(scene.items.begin(), scene.items.end(), [](const Item& item) {
    return item.shape.rings.size() > 1;
  })) << "no polygon with a hole";
}

TEST(DemoMap, LiesOnQuarters) {
  const Scene scene = read_scene(kMap).value();
  for (const Item& item : scene.items) {
    for (const auto& ring : item.shape.rings) {
      for (const Point& point : ring) {
        EXPECT_EQ(point.x * 4, std::round(point.x * 4)) << item.id.value;
        EXPECT_EQ(point.y * 4, std::round(point.y * 4)) << item.id.value;
      }
    }
  }
}

TEST(DemoMap, IsWhatItsScriptDraws) {
  if (is_quick()) GTEST_SKIP() << "the script takes ten seconds";
  const auto drawn = run_program("python3", {(kRoot / "scripts/make_highground.py").string()});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_TRUE(drawn.out == read_file(kMap)) << "run scripts/make_highground.py examples/maps/highground.wws";
}

TEST(DemoMap, IsTakenWholeAndIsSound) {
  const auto result = run_command({"run", "-", "--strict"}, read_file(kMap) + "check\n");
  EXPECT_EQ(result.status, 0);
  ASSERT_EQ(json_lines(result.out).size(), 1U) << result.out;
  EXPECT_EQ(json_lines(result.out)[0].at("ok"), true);
}

TEST(DemoMap, HasAWindingPathFromBaseToBase) {
  const auto result = run_command({"path", kMap, "--from", "60", "40", "--to", "452", "344"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].at("found"), true);
  EXPECT_GT(lines[0].at("length").get<double>(), 1.1 * std::hypot(452 - 60, 344 - 40));
  EXPECT_GE(lines[0].at("pieces").size(), 8U);
}

TEST(DemoMap, TheIslandAndNothingElseIsOutOfReach) {
  const auto lines =
      json_lines(run_script(read_file(kMap) + "path 60 40 256 192 0\npath 60 40 60 290 0\npath 60 40 452 94 0\n").out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].at("reason"), "no-path");
  EXPECT_EQ(lines[1].at("found"), true);
  EXPECT_EQ(lines[2].at("found"), true);
}

}  // namespace
}  // namespace waywright::test

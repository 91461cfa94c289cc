#include "waywright/script.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace waywright {
namespace {

using Ring = std::vector<Point>;
using Rings = std::vector<Ring>;

/// Returns the script of the lines, which follow a header and a domain of [0, 10] x [0, 10] on lines 1 and 2.
Script parsed(std::string_view lines) {
  const Result<Script> script = parse_script("waywright 1\ndomain 0 0 10 10\n" + std::string(lines), "test.wws");
  EXPECT_TRUE(script.ok()) << script.error().message();
  return script.ok() ? *script : Script{};
}

ScriptLine parsed_one(std::string_view line) {
  const Script script = parsed(line);
  EXPECT_EQ(script.lines.size(), 1U);
  return script.lines.size() == 1 ? script.lines.front() : ScriptLine{};
}

TEST(ParseScript, ReadsTheDomain) {
  const Result<Script> script = parse_script("waywright 1\n\ndomain -1.5 +2 1e3 .5e1", "test.wws");
  ASSERT_TRUE(script.ok());
  EXPECT_EQ(script->domain, (Box{{-1.5, 2.0}, {1000.0, 5.0}}));
  EXPECT_EQ(script->domain_line, 3U);
  EXPECT_TRUE(script->lines.empty());
}

TEST(ParseScript, PassesOverCommentsBlanksTabsAndCarriageReturns) {
  const Result<Script> script = parse_script(
      "# a title\r\n\r\n \t\r\n  waywright\t1 # version\r\n#\r\ndomain 0 0 1 1# box\r\n\tcheck  \r\n# end", "test.wws");
  ASSERT_TRUE(script.ok()) << script.error().message();
  EXPECT_EQ(script->domain_line, 6U);
  ASSERT_EQ(script->lines.size(), 1U);
  EXPECT_EQ(script->lines[0].kind, ScriptLineKind::check);
  EXPECT_EQ(script->lines[0].line, 7U);
}

TEST(ParseScript, ReadsInsertions) {
  const auto expect_item = [](std::string_view line, const Item& expected) {
    const ScriptLine operation = parsed_one(line);
    EXPECT_EQ(operation.kind, ScriptLineKind::insert) << line;
    EXPECT_EQ(operation.line, 3U) << line;
    EXPECT_EQ(operation.item, expected) << line;
  };
  expect_item("point 7 1 2", {{7}, {ItemKind::point, {{{1, 2}}}}});
  expect_item("segment 8 1 2 3 4", {{8}, {ItemKind::segment, {{{1, 2}, {3, 4}}}}});
  expect_item("segment 8 1 2 1 2", {{8}, {ItemKind::segment, {{{1, 2}, {1, 2}}}}});
  expect_item("polyline 9 1 5 6", {{9}, {ItemKind::polyline, {{{5, 6}}}}});
  expect_item("polyline 9 3 1 2 3 4 1 2", {{9}, {ItemKind::polyline, {{{1, 2}, {3, 4}, {1, 2}}}}});
  expect_item("polygon 9223372036854775807 3 0 0 1 0 0 1",
              {{ItemId::kLargest}, {ItemKind::polygon, {{{0, 0}, {1, 0}, {0, 1}}}}});
  expect_item("polygon 1 2 0 0 1 0 / 1 5 5 / 3 1 1 2 1 1 2",
              {{1}, {ItemKind::polygon, {{{0, 0}, {1, 0}}, {{5, 5}}, {{1, 1}, {2, 1}, {1, 2}}}}});
  expect_item("polygon 7 nonzero 3 0 0 1 0 0 1 / 1 5 5",
              {{7}, {ItemKind::polygon, {{{0, 0}, {1, 0}, {0, 1}}, {{5, 5}}}, FillRule::nonzero}});
}

TEST(ParseScript, ReadsReplacementsAsInsertionsAfterAWord) {
  for (const std::string insertion :
       {"point 7 1 2", "segment 8 1 2 3 4", "polyline 9 2 1 2 3 4", "polygon 1 2 0 0 1 0 / 1 5 5 / 3 1 1 2 1 1 2"}) {
    const ScriptLine replacement = parsed_one("replace " + insertion);
    EXPECT_EQ(replacement.kind, ScriptLineKind::replace) << insertion;
    EXPECT_EQ(replacement.item, parsed_one(insertion).item) << insertion;
    EXPECT_EQ(to_string(replacement), "replace");
  }
}

TEST(ParseScript, ReadsTheOtherOperations) {
  EXPECT_EQ(parsed_one("remove 5").kind, ScriptLineKind::remove);
  EXPECT_EQ(parsed_one("remove 5").item.id, ItemId{5});
  EXPECT_EQ(parsed_one("locate 1 2").kind, ScriptLineKind::locate);
  EXPECT_EQ(parsed_one("locate 1 2").from, (Point{1, 2}));
  EXPECT_EQ(parsed_one("hash").kind, ScriptLineKind::hash);

  const ScriptLine ray = parsed_one("ray 1 2 3 4");
  EXPECT_EQ(ray.kind, ScriptLineKind::ray);
  EXPECT_EQ(ray.from, (Point{1, 2}));
  EXPECT_EQ(ray.to, (Point{3, 4}));
  EXPECT_FALSE(ray.has_radius);
  const ScriptLine swept = parsed_one("ray 1 2 3 4 0.5");
  EXPECT_EQ(swept.to, (Point{3, 4}));
  EXPECT_TRUE(swept.has_radius);
  EXPECT_EQ(swept.agent.radius, 0.5);

  const ScriptLine disc = parsed_one("disc 1 2 0.5");
  EXPECT_EQ(disc.kind, ScriptLineKind::disc);
  EXPECT_EQ(disc.from, (Point{1, 2}));
  EXPECT_EQ(disc.agent.radius, 0.5);

  const ScriptLine nearest = parsed_one("nearest 3 4 0.25");
  EXPECT_EQ(nearest.kind, ScriptLineKind::nearest);
  EXPECT_EQ(nearest.from, (Point{3, 4}));
  EXPECT_EQ(nearest.agent.radius, 0.25);
  EXPECT_FALSE(nearest.has_goal);
  const ScriptLine with_goal = parsed_one("nearest 3 4 0.25 goal 5 6");
  EXPECT_TRUE(with_goal.has_goal);
  EXPECT_EQ(with_goal.to, (Point{5, 6}));
}

TEST(ParseScript, ReadsPathsWithOrWithoutAnAlgorithm) {
  const ScriptLine plain = parsed_one("path 1 2 3 4 0.5");
  EXPECT_EQ(plain.kind, ScriptLineKind::path);
  EXPECT_EQ(plain.from, (Point{1, 2}));
  EXPECT_EQ(plain.to, (Point{3, 4}));
  EXPECT_EQ(plain.agent.radius, 0.5);
  EXPECT_EQ(plain.algorithm, std::nullopt);
  EXPECT_EQ(parsed_one("path 1 2 3 4 0 ta").algorithm, PathAlgorithm::ta);
  EXPECT_EQ(parsed_one("path 1 2 3 4 0 tra").algorithm, PathAlgorithm::tra);
  EXPECT_EQ(parsed_one("path 1 2 3 4 0 optimal").algorithm, PathAlgorithm::optimal);
}

TEST(ParseScript, LeavesRangesToTheWorld) {
  const ScriptLine huge = parsed_one("point 1 1e999 nan");
  EXPECT_EQ(huge.item.shape.rings[0][0].x, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(huge.item.shape.rings[0][0].y));
  EXPECT_EQ(parsed_one("disc 50 50 -1").agent.radius, -1.0);
}

TEST(ToString, IsTheWordOfTheLine) {
  for (const std::string_view line :
       {"point 1 0 0", "segment 1 0 0 1 1", "polyline 1 1 0 0", "polygon 1 1 0 0", "remove 1", "locate 0 0",
        "ray 0 0 1 1", "disc 0 0 1", "nearest 0 0 1", "path 0 0 1 1 0", "check", "hash"}) {
    EXPECT_EQ(to_string(parsed_one(line)), line.substr(0, line.find(' ')));
  }
}

std::vector<std::uint64_t> ids_of(const Scene& scene) {
  std::vector<std::uint64_t> ids;
  for (const Item& item : scene.items) ids.push_back(item.id.value);
  return ids;
}

TEST(SceneOf, KeepsWhatIsInsertedAndNotRemoved) {
  const Scene scene = scene_of(parsed("point 5 1 1\npoint 3 2 2\nlocate 1 1\npoint 4 3 3\nremove 3\nhash\n"));
  EXPECT_EQ(scene.domain, (Box{{0, 0}, {10, 10}}));
  EXPECT_FALSE(scene.y_down);
  EXPECT_EQ(ids_of(scene), (std::vector<std::uint64_t>{5, 4}));
}

TEST(SceneOf, PassesOverAnIdInUse) {
  const Scene scene = scene_of(parsed("point 1 1 1\nsegment 1 2 2 3 3\n"));
  ASSERT_EQ(scene.items.size(), 1U);
  EXPECT_EQ(scene.items[0].shape, (Shape{ItemKind::point, {{{1, 1}}}}));
}

TEST(SceneOf, TakesAnIdAgainOnceItIsFree) {
  const Scene scene = scene_of(parsed("point 1 1 1\npoint 2 5 5\nremove 1\nremove 1\npoint 1 2 2\nremove 9\n"));
  EXPECT_EQ(ids_of(scene), (std::vector<std::uint64_t>{2, 1}));
  EXPECT_EQ(scene.items[1].shape, (Shape{ItemKind::point, {{{2, 2}}}}));
}

TEST(SceneOf, ARefusedInsertionTakesNoId) {
  const Scene scene = scene_of(parsed("point 1 11 1\npoint 1 2 2\n"));
  ASSERT_EQ(scene.items.size(), 1U);
  EXPECT_EQ(scene.items[0].shape, (Shape{ItemKind::point, {{{2, 2}}}}));
}

TEST(SceneOf, PassesOverWhatLiesOutsideTheDomainOrOutOfRange) {
  for (const std::string_view line :
       {"point 1 -0.1 5", "point 1 5 -0.1", "point 1 10.1 5", "point 1 5 10.1", "segment 1 1 1 11 1",
        "polyline 1 3 1 1 2 2 3 nan", "polygon 1 3 0 0 1 0 0 1 / 1 11 0", "point 1 1e999 0", "point 1 nan 0",
        "point 1 1e-40 0"}) {
    EXPECT_EQ(scene_of(parsed(line)).items.size(), 0U) << line;
  }
  for (const std::string_view line : {"point 1 0 0", "point 1 10 10", "point 1 -0 5", "point 1 1e-30 0"}) {
    EXPECT_EQ(scene_of(parsed(line)).items.size(), 1U) << line;
  }
}

TEST(SceneOf, CarriesOutReplacements) {
  const Scene scene =
      scene_of(parsed("point 1 1 1\npoint 2 2 2\nreplace segment 1 3 3 4 4\nreplace point 5 5 5\nreplace point 2 11 0\n"
                      "point 3 3 3\nremove 3\nreplace point 3 4 4\nreplace point 1 6 6"));
  const std::vector<Item> expected{{{1}, {ItemKind::point, {{{6, 6}}}}}, {{2}, {ItemKind::point, {{{2, 2}}}}}};
  EXPECT_EQ(scene.items, expected);
}

TEST(SceneOf, DropsAReplacementWithItsItem) {
  EXPECT_EQ(scene_of(parsed("point 1 1 1\nreplace point 1 2 2\nremove 1\npoint 1 3 3")).items,
            (std::vector<Item>{{{1}, {ItemKind::point, {{{3, 3}}}}}}));
}

TEST(SceneOf, KnowsTheEndsOfTheRange) {
  // 2^100 = 1267650600228229401496703205376 is in range; the next larger double is not.
  const Result<Script> script = parse_script(
      "waywright 1\ndomain 0 0 1267650600228229401496703205376 1267650600228229401496703205376\npoint 1 "
      "1267650600228229401496703205376 0\npoint 2 "
      "1267650600228229682971679916032 0\n",
      "test.wws");
  ASSERT_TRUE(script.ok());
  EXPECT_EQ(ids_of(scene_of(*script)), std::vector<std::uint64_t>{1});
}

}  // namespace
}  // namespace waywright

#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "tools/command.hpp"
#include "tools/svg_outline.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

TEST(ToSvg, EscapesTexts) {
  World world = make_world({{0, 0}, {1, 1}});
  const std::string bytes = "a<b> & \"c\" \xc3\xa9\x01\xff\xed\xa0\x80.";
  const std::string shown = "a<b> & \"c\" \u00e9 ????.";
  SvgOptions options = bare_options();
  options.title = bytes;
  const SvgOverlay overlay{.polylines = {{.points = {{0, 0}, {1, 1}}, .colour = bytes, .hint = bytes}},
                           .discs = {{{0.5, 0.5}, 0.1, bytes, bytes}},
                           .labels = {{.at = {0.5, 0.5}, .text = bytes, .colour = bytes}},
                           .keys = {{bytes, bytes}}};
  const json drawn = drawing_of(world, overlay, options);
  EXPECT_EQ(drawn["title"], shown);
  EXPECT_EQ(hints_of(drawn, "polylines"), std::vector<std::string>{shown});
  EXPECT_EQ(hints_of(drawn, "discs"), std::vector<std::string>{shown});
  EXPECT_EQ(elements_of(drawn, "polylines", "path").at(0)["stroke"], shown);
  EXPECT_EQ(elements_of(drawn, "discs", "circle").at(0)["fill"], shown);
  EXPECT_EQ(elements_of(drawn, "labels", "text").at(0)["fill"], shown);
  EXPECT_EQ(elements_of(drawn, "labels", "text").at(0)["text"], shown);
  EXPECT_EQ(elements_of(drawn, "legend", "circle").at(0)["fill"], shown);
  EXPECT_EQ(drawn["labels"], json({shown}));
}

TEST(ToSvg, MarksRays) {
  World world = make_world({{0, 0}, {10, 10}});
  world.insert_segment({5, 0}, {5, 8}, {3}).value();
  const SvgOverlay overlay{.rays = {{{1, 2}, {9, 2}, world.ray({1, 2}, {9, 2}).value()},
                                    {{1, 9}, {9, 9}, world.ray({1, 9}, {9, 9}).value()}}};
  const SvgOptions options = bare_options();
  const json drawn = drawing_of(world, overlay, options);
  EXPECT_EQ(drawn["labels"], json({"1 polyline", "2 rays", "1 hit"}));
  EXPECT_EQ(hints_of(drawn, "rays"), (std::vector<std::string>{"ray from (1, 2) to (9, 2), hits 3 at (5, 2)",
                                                               "ray from (1, 9) to (9, 9), hits nothing"}));
  EXPECT_EQ(hints_of(drawn, "rays-ends"),
            (std::vector<std::string>{"end (9, 2)", "start (1, 2)", "hit (5, 2): 3", "end (9, 9)", "start (1, 9)"}));
  // Each ray has an outline and a line. The ray that hits also has its rest, which is dashed.
  std::vector<json> lines = elements_of(drawn, "rays", "path");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_TRUE(lines[2].contains("stroke-dasharray"));
  EXPECT_FALSE(lines[1].contains("stroke-dasharray"));
}

TEST(ToSvg, MarksFailedPathsWithTheirStatus) {
  World world = make_world({{0, 0}, {10, 10}});
  const SvgOverlay overlay{.failed_paths = {{{1, 1}, {9, 2}, PathStatus::no_path},
                                            {{1, 5}, {9, 6}, PathStatus::start_blocked},
                                            {{1, 8}, {9, 9}, PathStatus::goal_blocked},
                                            {{2, 8}, {9, 9}, PathStatus::goal_blocked}}};
  const json drawn = drawing_of(world, overlay, bare_options());
  EXPECT_EQ(drawn["labels"],
            json({"1 failed path, no path", "1 failed path, start blocked", "2 failed paths, goal blocked"}));
  std::vector<std::string> texts;
  for (const json& text : elements_of(drawn, "failed-paths-ends", "text")) texts.push_back(text["text"]);
  EXPECT_EQ(texts, (std::vector<std::string>{"no path", "start blocked", "goal blocked", "goal blocked"}));
  EXPECT_EQ(hints_of(drawn, "failed-paths").at(1), "start blocked from (1, 5) to (9, 6)");
  EXPECT_EQ(hints_of(drawn, "failed-paths-ends").at(0), "start (1, 1): no path");
  const std::vector<json> lines = elements_of(drawn, "failed-paths", "path");
  ASSERT_EQ(lines.size(), 8U);
  for (std::size_t i = 1; i < lines.size(); i += 2) EXPECT_TRUE(lines[i].contains("stroke-dasharray"));
}

TEST(ToSvg, ColoursLocationsByTheirAnswer) {
  World world = make_world({{0, 0}, {10, 10}});
  world.insert_polygon({{1, 1}, {4, 1}, {4, 4}, {1, 4}}, {8}).value();
  world.insert_segment({6, 1}, {6, 9}, {2}).value();
  SvgOverlay overlay;
  for (const Point& point : {Point{8, 5.25}, Point{6, 5}, Point{6, 9}, Point{2, 3}, Point{4, 2}, Point{4, 4}}) {
    overlay.locations.push_back({point, world.locate(point).value()});
  }
  const json drawn = drawing_of(world, overlay, bare_options());
  EXPECT_EQ(drawn["labels"], json({"1 polygon", "1 polyline", "1 located point in a face", "1 located point on an edge",
                                   "1 located point on a vertex", "3 located points in polygons"}));
  EXPECT_EQ(hints_of(drawn, "locations"),
            (std::vector<std::string>{"(8, 5.25): face", "(6, 5): edge", "(6, 9): vertex", "(2, 3): face, inside 8",
                                      "(4, 2): edge, inside 8", "(4, 4): vertex, inside 8"}));
  std::vector<std::string> colours;
  for (const json& element : drawn["elements"]) {
    if (element["group"] == "locations" && element["tag"] != "title") colours.push_back(element["fill"]);
  }
  ASSERT_EQ(colours.size(), 6U);
  EXPECT_EQ(std::set<std::string>(colours.begin(), colours.begin() + 4).size(), 4U);
  EXPECT_EQ(std::set<std::string>(colours.begin() + 3, colours.end()).size(), 1U);
}

TEST(ToSvg, ShortensLongListsOfIds) {
  World world = make_world({{0, 0}, {10, 10}});
  for (std::uint64_t id = 1; id <= 1000; ++id) {
    world.insert_polygon({{1, 1}, {4, 1}, {4, 4}, {1, 4}}, {id}).value();
  }
  const json drawn = drawing_of(world, {.locations = {{{2, 2}, world.locate({2, 2}).value()}}});
  const std::string hint = hints_of(drawn, "locations").at(0);
  EXPECT_TRUE(hint.ends_with("inside 1, 2, 3, 4, 5, 6, 7, 8 and 992 more")) << hint;
}

TEST(ToSvg, DrawsWhatTheCallerAdds) {
  World world = make_world({{0, 0}, {10, 10}});
  const SvgOptions options = bare_options();
  const SvgFrame frame = frame_of(world, options);
  const double nan = std::nan("");
  const SvgOverlay overlay{
      .polylines = {{.points = {{1, 1}, {2, 3}}, .width = 5, .dashed = true, .colour = "red"},
                    {.points = {{nan, 1}, {2, 3}}, .width = nan}},
      .discs = {{{5, 5}, 0.5, "#00ff00", "unit"}, {{6, 6}, 0, "", ""}, {{nan, 1}, 1, "", ""}, {{7, 7}, nan, "", ""}},
      .elements = "<rect width=\"3\" height=\"4\"/>",
      .labels = {{.at = {5, 5}, .text = "left of its place: far too long for the room on the right", .radius = 0.5},
                 {.at = {1, 5}, .text = "right"}},
      .keys = {{"mine", "blue"}}};
  const json drawn = drawing_of(world, overlay, options);
  const std::vector<json> lines = elements_of(drawn, "polylines", "path");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0]["stroke"], "red");
  EXPECT_EQ(lines[0]["stroke-width"], "5");
  EXPECT_TRUE(lines[0].contains("stroke-dasharray"));
  const std::vector<json> discs = elements_of(drawn, "discs", "circle");
  ASSERT_EQ(discs.size(), 3U);
  EXPECT_NEAR(number_of(discs[0], "cx"), frame.to_picture({5, 5}).x, 0.006);
  EXPECT_NEAR(number_of(discs[0], "r"), 0.5 * frame.scale(), 0.006);
  EXPECT_EQ(number_of(discs[1], "r"), 3);
  EXPECT_EQ(number_of(discs[2], "r"), 3);
  EXPECT_EQ(elements_of(drawn, "elements", "rect").size(), 1U);
  const std::vector<json> labels = elements_of(drawn, "labels", "text");
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0]["text-anchor"], "start");  // there is no room to the left either
  EXPECT_NEAR(number_of(labels[0], "x"), frame.to_picture({5.5, 5}).x + 8, 0.006);
  EXPECT_EQ(labels[1]["text-anchor"], "start");
  EXPECT_EQ(drawn["labels"], json({"mine"}));

  const json near_edge = drawing_of(world, {.labels = {{.at = {9.9, 5}, .text = "left", .radius = 0.5}}}, options);
  const json label = elements_of(near_edge, "labels", "text").at(0);
  EXPECT_EQ(label["text-anchor"], "end");
  EXPECT_NEAR(number_of(label, "x"), frame.to_picture({9.4, 5}).x - 8, 0.006);
}

TEST(ToSvg, TakesPathsThatLeaveThePicture) {
  const World world = make_world({{0, 0}, {1, 1}});
  const Path path = path_through({{0, 0}, {1e300, -1e300}, {std::nan(""), HUGE_VAL}, {1, 1}});
  const json drawn = drawing_of(world, {.paths = {path}});
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  for (const double number : drawn["numbers"]) EXPECT_LE(std::abs(number), 2000);
}

TEST(ToSvg, CountsPathsWhereThereAreMoreThanColours) {
  const World world = make_world({{0, 0}, {1, 1}});
  const Path path = path_through({{0, 0}, {0, 1}});
  const std::string four = picture_of(world, {.paths = std::vector<Path>(4, path)});
  EXPECT_THAT(four, ::testing::HasSubstr("path, length 1</text>"));
  EXPECT_THAT(four, ::testing::Not(::testing::HasSubstr("paths<")));
  const std::string five = picture_of(world, {.paths = std::vector<Path>(5, path)});
  EXPECT_THAT(five, ::testing::HasSubstr("5 paths<"));
  EXPECT_THAT(five, ::testing::Not(::testing::HasSubstr("path, length 1</text>")));
}

}  // namespace
}  // namespace waywright::test

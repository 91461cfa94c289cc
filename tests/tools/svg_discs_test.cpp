#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "tools/svg_outline.hpp"

namespace waywright::test {
namespace {

/// A command of the `d` attribute of a path element.
struct Stroke {
  char command = 'M';
  std::vector<double> numbers;

  [[nodiscard]] Point end() const { return {numbers[numbers.size() - 2], numbers[numbers.size() - 1]}; }
};

std::vector<Stroke> strokes_of(std::string data) {
  std::vector<Stroke> strokes;
  for (const char command : {'M', 'L', 'A'}) {
    for (std::size_t at = data.find(command); at != std::string::npos; at = data.find(command, at + 3)) {
      data.replace(at, 1, std::string(" ") + command + " ");
    }
  }
  std::istringstream words(data);
  for (std::string word; words >> word;) {
    if (word == "M" || word == "L" || word == "A") {
      strokes.push_back({word[0], {}});
    } else {
      strokes.back().numbers.push_back(std::stod(word));
    }
  }
  return strokes;
}

/// Returns the centre of an arc of at most half a circle between two points. Source: SVG 1.1, F.6.5.
Point centre_of(const Point& from, const Stroke& arc) {
  EXPECT_EQ(arc.numbers.at(0), arc.numbers.at(1));
  EXPECT_EQ(arc.numbers.at(2), 0.0);
  EXPECT_EQ(arc.numbers.at(3), 0.0);
  const double radius = arc.numbers.at(0);
  const Point to = arc.end();
  const double half = std::hypot(to.x - from.x, to.y - from.y) / 2.0;
  const double height = std::sqrt(std::max(radius * radius - half * half, 0.0));
  const double sign = arc.numbers.at(4) != 0.0 ? 1.0 : -1.0;
  return {(from.x + to.x) / 2.0 - sign * height * (to.y - from.y) / (2.0 * half),
          (from.y + to.y) / 2.0 + sign * height * (to.x - from.x) / (2.0 * half)};
}

/// A box with a wall from its lower side up to (50, 60).
World make_yard() {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50, 0}, {50, 60}, 7).value();
  return world;
}

SvgDiscPath disc_path(const World& world, const Point& start, const Point& goal, double radius) {
  const PathQuery query{.start = start, .goal = goal, .agent = {.radius = radius}};
  return {query, world.find_path(query).value()};
}

std::string data_of(const json& drawn, const std::string& group) {
  for (const json& element : drawn["elements"]) {
    if (element["tag"] == "path" && element["group"] == group) return element["d"];
  }
  return {};
}

TEST(SvgDiscs, DrawsTheCentreLineWithItsArcs) {
  const World world = make_yard();
  for (const bool y_down : {false, true}) {
    for (const bool is_reversed : {false, true}) {
      SvgOptions options = bare_options();
      options.y_down = y_down;
      const SvgFrame frame = frame_of(world, options);
      const Point start = is_reversed ? Point{80, 50} : Point{20, 50};
      const Point goal{100.0 - start.x, 50};
      const json drawn = drawing_of(world, {.disc_paths = {disc_path(world, start, goal, 5)}}, options);
      const std::vector<Stroke> strokes = strokes_of(data_of(drawn, "disc-paths"));
      ASSERT_GE(strokes.size(), 4U);
      EXPECT_EQ(strokes.front().command, 'M');
      EXPECT_LE(distance(strokes.front().end(), frame.to_picture(start)), 0.01);
      EXPECT_EQ(strokes.back().command, 'L');
      EXPECT_LE(distance(strokes.back().end(), frame.to_picture(goal)), 0.01);
      std::size_t arc_count = 0;
      for (std::size_t i = 1; i < strokes.size(); ++i) {
        if (strokes[i].command != 'A') continue;
        ++arc_count;
        EXPECT_NEAR(strokes[i].numbers[0], 5 * frame.scale(), 0.006);
        EXPECT_LE(distance(centre_of(strokes[i - 1].end(), strokes[i]), frame.to_picture({50, 60})), 0.1);
      }
      EXPECT_GE(arc_count, 1U);
    }
  }
}

TEST(SvgDiscs, DrawsTheDiscWhereThePathEndsAfterTheSearchHasMovedTheGoal) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert(Shape::polygon({{60, 30}, {90, 30}, {90, 70}, {60, 70}})).value();
  const SvgOptions options = bare_options();
  const SvgFrame frame = frame_of(world, options);
  const PathQuery query{.start = {20, 50}, .goal = {75, 50}, .agent = {.radius = 5}, .end_tolerance = 50.0};
  const json drawn = drawing_of(world, {.disc_paths = {{query, world.find_path(query).value()}}}, options);
  const std::vector<json> discs = elements_of(drawn, "disc-paths", "circle");
  ASSERT_EQ(discs.size(), 2U);
  const Point end = frame.to_picture({55, 50});
  EXPECT_LE(distance({number_of(discs[1], "cx"), number_of(discs[1], "cy")}, end), 0.01);
}

TEST(SvgDiscs, DrawsTheAreaAsAStrokeAsWideAsTheDisc) {
  const World world = make_yard();
  const SvgOptions options = bare_options();
  const double radius = 5 * frame_of(world, options).scale();
  const json drawn = drawing_of(world, {.disc_paths = {disc_path(world, {20, 50}, {80, 50}, 5)}}, options);
  const json area = elements_of(drawn, "swept-areas", "path").at(0);
  EXPECT_NEAR(number_of(area, "stroke-width"), 2 * radius, 0.006);
  EXPECT_LT(number_of(area, "stroke-opacity"), 0.5);
  EXPECT_EQ(area["d"], data_of(drawn, "disc-paths"));
  for (const json& element : drawn["elements"]) {
    if (element.value("id", "") != "swept-areas") continue;
    EXPECT_EQ(element["stroke-linecap"], "round");
    EXPECT_EQ(element["stroke-linejoin"], "round");
  }
  const std::vector<json> discs = elements_of(drawn, "disc-paths", "circle");
  ASSERT_EQ(discs.size(), 2U);
  for (const json& disc : discs) EXPECT_NEAR(number_of(disc, "r"), radius, 0.006);
  EXPECT_EQ(drawn["groups"]["disc-ends"], 2);
  // From (20, 50) the tangent at the circle around (50, 60) is sqrt(30^2 + 10^2 - 5^2) long. The arc lies between the
  // spokes to both touching positions.
  const double to_corner = std::sqrt(1000.0);
  const double arc = 5.0 * 2.0 * (std::acos(0.0) * 2.0 - std::acos(10.0 / to_corner) - std::acos(5.0 / to_corner));
  const double length = 2.0 * std::sqrt(975.0) + std::max(arc, 0.0);
  const std::string label = drawn["labels"].at(1);
  EXPECT_EQ(label.substr(0, 39), "path of a disc, radius 5, length 67.255");
  EXPECT_NEAR(length, 67.255, 0.001);
  EXPECT_EQ(drawn["labels"],
            json({"1 polyline", label, "area that the disc covers", "disc at its start and goal", "start", "goal"}));
}

TEST(SvgDiscs, DrawsADiscThatStaysWhereItIs) {
  const World world = make_yard();
  const SvgOptions options = bare_options();
  const json drawn = drawing_of(world, {.disc_paths = {disc_path(world, {20, 50}, {20, 50}, 5)}}, options);
  const json area = elements_of(drawn, "swept-areas", "path").at(0);
  EXPECT_NEAR(number_of(area, "stroke-width"), 10 * frame_of(world, options).scale(), 0.006);
  const std::vector<Stroke> strokes = strokes_of(data_of(drawn, "disc-paths"));
  EXPECT_LE(distance(strokes.front().end(), frame_of(world, options).to_picture({20, 50})), 0.01);
}

/// Expects arcs around `centre`, and no number far outside the picture.
void expect_arcs_near(const json& drawn, const Point& centre, double room) {
  std::size_t arc_count = 0;
  const std::vector<Stroke> strokes = strokes_of(data_of(drawn, "swept-areas"));
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Point end = strokes[i].end();
    EXPECT_TRUE(std::fabs(end.x) < 1300 + room && std::fabs(end.y) < 1300 + room) << end.x << ' ' << end.y;
    if (strokes[i].command != 'A') continue;
    ++arc_count;
    EXPECT_LE(distance(centre_of(strokes[i - 1].end(), strokes[i]), centre), 0.02 * strokes[i].numbers[0]);
  }
  EXPECT_GE(arc_count, 1U);
}

TEST(SvgDiscs, CutsArcsNearTheCrop) {
  const World world = make_yard();
  const SvgDiscPath path = disc_path(world, {20, 50}, {80, 50}, 20);
  // The boxes show the top of the arc, its left piece, and the corner at which the disc turns: there the picture shows
  // nothing but the covered area, far from the centre line.
  for (const Box& crop : {Box{{49, 79}, {51, 81}}, Box{{30, 66}, {42, 76}}, Box{{47, 58}, {53, 64}}}) {
    SvgOptions options = bare_options();
    options.crop = crop;
    const SvgFrame frame = frame_of(world, options);
    expect_arcs_near(drawing_of(world, {.disc_paths = {path}}, options), frame.to_picture({50, 60}),
                     21 * frame.scale());
  }
  SvgOptions options = bare_options();
  options.crop = Box{{0, 0}, {1, 1}};
  const json elsewhere = drawing_of(world, {.disc_paths = {path}}, options);
  EXPECT_EQ(elements_of(elsewhere, "swept-areas", "path").size(), 0U);
  EXPECT_EQ(elsewhere["groups"]["disc-ends"], 0);
}

TEST(SvgDiscs, MarksTheGapThatStopsTheDisc) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50, 0}, {50, 40}, 7).value();
  world.insert_polygon({{50, 50}, {60, 100}, {40, 100}}, 8).value();
  const SvgDiscPath path = disc_path(world, {20, 45}, {80, 45}, 6);
  ASSERT_EQ(path.answer.status, PathStatus::no_path);
  SvgOptions options = bare_options();
  const SvgFrame frame = frame_of(world, options);
  const json drawn = drawing_of(world, {.disc_paths = {path}}, options);

  const std::vector<Stroke> gap = strokes_of(data_of(drawn, "gaps"));
  ASSERT_EQ(gap.size(), 2U);
  const double high = std::min(gap[0].end().y, gap[1].end().y);
  EXPECT_NEAR(gap[0].end().x, frame.to_picture({50, 40}).x, 0.01);
  EXPECT_NEAR(high, frame.to_picture({50, 50}).y, 0.01);
  EXPECT_NEAR(std::fabs(gap[0].end().y - gap[1].end().y), 10 * frame.scale(), 0.02);
  EXPECT_EQ(drawn["groups"]["obstacles"], 2);
  EXPECT_EQ(hints_of(drawn, "gaps"), std::vector<std::string>{"gap 10: 7, 8"});
  const std::vector<json> labels = elements_of(drawn, "disc-ends", "text");
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(labels[0]["text"], "gap 10");
  EXPECT_EQ(drawn["labels"],
            json({"1 polygon", "1 polyline", "1 failed path of a disc, no path", "disc at its start and goal",
                  "gap 10 wide: a disc of radius 5 fits through", "items that stop the disc"}));
}

TEST(SvgDiscs, MarksTheItemsThatBlockAnEnd) {
  const World world = make_yard();
  const SvgDiscPath path = disc_path(world, {48, 3}, {80, 50}, 5);
  ASSERT_EQ(path.answer.status, PathStatus::start_blocked);
  const json drawn = drawing_of(world, {.disc_paths = {path}}, bare_options());
  EXPECT_EQ(drawn["groups"]["obstacles"], 2);  // the wall and the border of the domain
  EXPECT_EQ(drawn["groups"]["gaps"], 0);
  EXPECT_EQ(drawn["labels"], json({"1 polyline", "1 failed path of a disc, start blocked", "disc at its start and goal",
                                   "items that stop the disc"}));
}

TEST(SvgDiscs, SumsUpManyPathsInTheLegend) {
  const World world = make_yard();
  SvgOverlay overlay;
  for (int i = 1; i <= 5; ++i) overlay.disc_paths.push_back(disc_path(world, {20, 50}, {80, 50}, i));
  const json drawn = drawing_of(world, overlay, bare_options());
  EXPECT_EQ(drawn["groups"]["swept-areas"], 5);
  EXPECT_EQ(drawn["labels"].at(1), "5 paths of discs");
}

// A program can fill the members of an overlay with anything.
TEST(SvgDiscs, SurvivesHostileNumbers) {
  const World world = make_yard();
  const SvgDiscPath good = disc_path(world, {20, 50}, {80, 50}, 5);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -5.0, 0.0,
                           1e300, -1e300, 5e-324, 1e-300}) {
    SvgOverlay overlay;
    for (int member = 0; member < 8; ++member) {
      SvgDiscPath path = good;
      if (member == 0) path.query.agent.radius = bad;
      if (member == 1) path.query.start.x = bad;
      if (member == 2) path.answer.pieces.at(1).radius = bad;
      if (member == 3) path.answer.pieces.at(1).end_angle = bad;
      if (member == 4) path.answer.pieces.at(1).centre.y = bad;
      if (member == 5) path.answer.pieces.at(0).to.y = bad;
      if (member == 6) path.answer.length = bad;
      if (member == 7) {
        path.answer.status = PathStatus::no_path;
        path.answer.widest = WidestPath{true, true, bad, {bad, bad}, {50, 60}, {ItemId{99}}, {ItemId{}}};
      }
      overlay.disc_paths.push_back(path);
    }
    for (const bool is_cropped : {false, true}) {
      if (is_quick() && is_cropped != (bad > 0)) continue;
      SvgOptions options;
      if (is_cropped) options.crop = Box{{49, 64}, {49.5, 64.5}};
      const json drawn = drawing_of(world, overlay, options);
      for (const json& number : drawn["numbers"]) EXPECT_LE(std::fabs(number.get<double>()), 1e7) << bad;
    }
  }
}

}  // namespace
}  // namespace waywright::test

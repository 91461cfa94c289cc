#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

std::vector<std::string> arguments(const std::string& map, const std::vector<std::string>& from,
                                   const std::vector<std::string>& to) {
  std::vector<std::string> all{"path", map, "--from"};
  all.insert(all.end(), from.begin(), from.end());
  all.emplace_back("--to");
  all.insert(all.end(), to.begin(), to.end());
  return all;
}

TEST(PathCommand, PrintsOneLineAndNothingElse) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.wws", "waywright 1\ndomain -10 -10 10 10\n");
  const auto result = run_command(arguments(map, {"-3", "4"}, {"0", "-0.0"}));
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, R"({"op":"path","found":true,"length":5,"pieces":[{"line":[-3,4,0,0]}]})"
                        "\n");
}

TEST(PathCommand, TakesNumbersAsScriptsDo) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.wws", "waywright 1\ndomain -10 -10 10 10\n");
  for (const std::string three : {"-3", "-3.0", "-.3e1", "-30e-1"}) {
    const auto lines = json_lines(run_command(arguments(map, {three, three}, {"+5", "3"})).out);
    ASSERT_EQ(lines.size(), 1U) << three;
    EXPECT_EQ(lines[0].at("length"), 10) << three;
  }
}

TEST(PathCommand, NoPathIsAnAnswer) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.wws",
                                      "waywright 1\ndomain 0 0 10 10\nsegment 1 5 0 5 10\n"
                                      "polygon 2 3 1 1 4 1 1 4\npath 1 1 2 2 0\n");
  const auto unconnected = run_command(arguments(map, {"4", "8"}, {"8", "8"}));
  EXPECT_EQ(unconnected.status, 0);
  EXPECT_EQ(unconnected.out, "{\"op\":\"path\",\"found\":false,\"reason\":\"no-path\"}\n");
  EXPECT_EQ(json_lines(run_command(arguments(map, {"2", "2"}, {"4", "8"})).out).at(0).at("reason"), "start-blocked");
  EXPECT_EQ(json_lines(run_command(arguments(map, {"4", "8"}, {"2", "2"})).out).at(0).at("reason"), "goal-blocked");
}

class PathCommandBy : public ::testing::TestWithParam<std::string> {};

/// Expects an answer with this length, and a piece from each of the points to the next.
void expect_path(const std::string& map, const std::vector<std::string>& from, const std::vector<std::string>& to,
                 const std::string& algorithm, double length, const std::vector<double>& points) {
  std::vector<std::string> all = arguments(map, from, to);
  all.insert(all.end(), {"--algorithm", algorithm});
  const auto lines = json_lines(run_command(all).out);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].at("length").get<double>(), length, 1e-12);
  const json& pieces = lines[0].at("pieces");
  ASSERT_EQ(pieces.size() + 1, points.size() / 2);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto from_here = points.begin() + static_cast<std::ptrdiff_t>(2 * i);
    EXPECT_EQ(pieces.at(i).at("line"), json(std::vector<double>(from_here, from_here + 4)));
  }
}

// Over the block, from corner to corner, the length is 5 + 2 + 5; under it 2 + 2 sqrt(109).
TEST_P(PathCommandBy, LeadsAroundTheNearerCorners) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.wws", "waywright 1\ndomain 0 0 10 20\npolygon 1 4 4 2 6 2 6 16 4 16\n");
  expect_path(map, {"1", "12"}, {"9", "12"}, GetParam(), 12.0, {1, 12, 4, 16, 6, 16, 9, 12});
}

// The first wall touches the border, so every path leads around three of the ends.
TEST_P(PathCommandBy, WindsAroundWallsThatCross) {
  const TemporaryFolder folder;
  const std::string map =
      folder.file("map.wws", "waywright 1\ndomain 0 0 10 10\nsegment 1 4 0 4 7\nsegment 2 2 4 8 4\n");
  expect_path(map, {"1", "1"}, {"7", "1"}, GetParam(), 2 * std::sqrt(10.0) + std::sqrt(13.0) + 5,
              {1, 1, 2, 4, 4, 7, 8, 4, 7, 1});
}

TEST_P(PathCommandBy, IsStraightWherePossible) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.wws", "waywright 1\ndomain 0 0 10 10\nsegment 1 4 5 4 7\npoint 2 5 4\n");
  expect_path(map, {"1", "1"}, {"9", "7"}, GetParam(), 10.0, {1, 1, 9, 7});
}

INSTANTIATE_TEST_SUITE_P(Algorithms, PathCommandBy, ::testing::Values("optimal", "ta", "tra"),
                         [](const auto& algorithm) { return algorithm.param; });

/// Returns the answer for a disc of this radius, in the yard of docs/formats.md: a wall up to (50, 60).
CommandResult disc_in_yard(const std::string& radius, const std::vector<std::string>& from = {"20", "50"},
                           const std::vector<std::string>& to = {"80", "50"}) {
  const TemporaryFolder folder;
  const std::string map = folder.file("yard.wws", "waywright 1\ndomain 0 0 100 100\nsegment 7 50 0 50 60\n");
  std::vector<std::string> all = arguments(map, from, to);
  all.insert(all.end(), {"--radius", radius});
  return run_command(all);
}

// The tangents from the ends touch the circle of radius 5 around (50, 60), and are sqrt(30^2 + 10^2 - 5^2) long.
TEST(PathCommand, FindsThePathOfADisc) {
  const auto lines = json_lines(disc_in_yard("5").out);
  ASSERT_EQ(lines.size(), 1U);
  const json& pieces = lines[0].at("pieces");
  ASSERT_EQ(pieces.size(), 3U);
  const double tangent = std::sqrt(975.0);
  double length = 0.0;
  for (const std::size_t i : {0U, 2U}) {
    const json& line = pieces.at(i).at("line");
    const double x = line.at(2).get<double>() - line.at(0).get<double>();
    const double y = line.at(3).get<double>() - line.at(1).get<double>();
    EXPECT_NEAR(std::sqrt(x * x + y * y), tangent, 1e-9);
    length += tangent;
  }
  const json& arc = pieces.at(1).at("arc");
  EXPECT_EQ(arc.at(0), 50);
  EXPECT_EQ(arc.at(1), 60);
  EXPECT_EQ(arc.at(2), 5);
  length += 5 * (arc.at(3).get<double>() - arc.at(4).get<double>());
  EXPECT_NEAR(lines[0].at("length").get<double>(), length, 1e-9);
}

TEST(PathCommand, SaysWhatStopsADisc) {
  // The gap above the wall is 40 wide.
  EXPECT_TRUE(json_lines(disc_in_yard("20").out).at(0).at("found"));
  const json gap = json_lines(disc_in_yard("20.5", {"25", "50"}, {"75", "50"}).out).at(0);
  EXPECT_EQ(gap.at("reason"), "no-path");
  EXPECT_EQ(gap.at("widest").at("radius"), 20);
  EXPECT_EQ(gap.at("widest").at("items"), json({0, 7}));
  const json blocked = json_lines(disc_in_yard("5", {"46", "4"}).out).at(0);
  EXPECT_EQ(blocked.at("reason"), "start-blocked");
  EXPECT_EQ(blocked.at("items"), json({0, 7}));
}

TEST(PathCommand, TakesARadiusOfZeroAsAPoint) {
  for (const std::string zero : {"0", "-0", "0.0", "+0", "1e-400"}) {
    const auto lines = json_lines(disc_in_yard(zero).out);
    ASSERT_EQ(lines.size(), 1U) << zero;
    EXPECT_EQ(lines[0].at("pieces").size(), 2U) << zero;
  }
  for (const std::string large : {"50.5", "1e30", "1e300", "1.7976931348623157e308"}) {
    EXPECT_EQ(json_lines(disc_in_yard(large).out).at(0).at("reason"), "start-blocked") << large;
  }
}

TEST(PathCommand, RefusesABadRadius) {
  for (const std::string bad :
       {"-1", "-5e-324", "nan", "inf", "-inf", "1e400", "-1e400", "", "five", "0x5", "5 5", "5,5"}) {
    const auto result = disc_in_yard(bad);
    EXPECT_EQ(result.status, 2) << bad;
    EXPECT_EQ(result.out, "") << bad;
    EXPECT_EQ(result.err.find("waywright: --radius: '" + bad + "'"), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST(PathCommand, DrawsThePathOfADisc) {
  const TemporaryFolder folder;
  const std::string map = folder.file("yard.wws", "waywright 1\ndomain 0 0 100 100\nsegment 7 50 0 50 60\n");
  const std::string svg = folder.file("yard.svg");
  for (const std::string radius : {"5", "20.5"}) {
    std::vector<std::string> all = arguments(map, {"25", "50"}, {"75", "50"});
    all.insert(all.end(), {"--radius", radius, "--svg", svg});
    EXPECT_EQ(run_command(all).status, 0);
    const std::string picture = read_file(svg);
    const std::string expected = radius == "5" ? "path of a disc, radius 5, length" : ">gap 40</text>";
    EXPECT_NE(picture.find(expected), std::string::npos) << radius;
  }
}

TEST(PathCommand, ReadsMovingAiMaps) {
  const TemporaryFolder folder;
  // All tiles are free except a column of two tiles below the upper side. The path around it leads through (1, 2) and
  // (2, 2).
  const std::string map = folder.file("map.map", "type octile\nheight 3\nwidth 3\nmap\n.@.\n.T.\n...\n");
  const auto lines = json_lines(run_command(arguments(map, {"0", "0"}, {"3", "0"})).out);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].at("length").get<double>(), 1 + 2 * std::sqrt(5.0), 1e-12);
}

TEST(PathCommand, ReadsTrianglesFormats) {
  const TemporaryFolder folder;
  const std::string vertices = "1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 2 0\n6 2 3\n";
  const std::string segments = "5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n";
  const double round_the_wall = 2 * std::sqrt(1.0 + 4.0);
  for (const std::string& map : {folder.file("whole.poly", "6 2 0 0\n" + vertices + segments),
                                 folder.file("split.poly", "0 2 0 0\n" + segments)}) {
    static_cast<void>(folder.file("split.node", "6 2 0 0\n" + vertices));
    const auto lines = json_lines(run_command(arguments(map, {"1", "1"}, {"3", "1"})).out);
    ASSERT_EQ(lines.size(), 1U) << map;
    EXPECT_NEAR(lines[0].at("length").get<double>(), round_the_wall, 1e-12) << map;
  }
  const auto free = json_lines(run_command(arguments(folder.file("split.node"), {"1", "1"}, {"3", "1"})).out);
  ASSERT_EQ(free.size(), 1U);
  EXPECT_EQ(free[0].at("length"), 2);
}

TEST(ConvertCommand, WritesAScriptThatHoldsTheSameWorld) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.map", "type octile\nheight 4\nwidth 5\nmap\n.@@..\n.@.@.\n.@@@.\nT...W\n");
  const std::string script = folder.file("a.wws");
  const auto converted = run_command({"convert", map, script});
  EXPECT_EQ(converted.status, 0);
  EXPECT_EQ(converted.out + converted.err, "");
  // The tile (2, 1) touches the free tile at its upper right only diagonally, and that diagonal is closed.
  const auto result = run_script(read_file(script) +
                                 "locate 1.5 1.5\nlocate 2.5 1.5\nlocate 3.5 0.5\nlocate 4.5 3.5\n"
                                 "path 2.5 1.5 3.5 0.5 0\n");
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0].at("inside").size(), 1U);
  EXPECT_EQ(lines[1].at("inside").size(), 0U);
  EXPECT_EQ(lines[2].at("inside").size(), 0U);
  EXPECT_EQ(lines[3].at("inside").size(), 1U);
  EXPECT_EQ(lines[4].at("reason"), "no-path");

  const std::string again = folder.file("b.wws");
  EXPECT_EQ(run_command({"convert", script, again}).status, 0);
  EXPECT_EQ(read_file(again), read_file(script));
}

TEST(ConvertCommand, KeepsWhatRemovalsLeaveAndPassesOverQueries) {
  const TemporaryFolder folder;
  const std::string script =
      "waywright 1\ndomain 0 0 10 10\npoint 3 1 1\nsegment 5 1 2 3 4\nremove 3\n"
      "point 6 99 99\npath 1 1 2 2 0\npolygon 3 3 5 5 6 5 6 6\n";
  const std::string out = folder.file("b.wws");
  EXPECT_EQ(run_command({"convert", folder.file("a.wws", script), out}).status, 0);
  const std::string dump = folder.file("dump");
  EXPECT_EQ(run_command({"run", out, "--dump", dump}).status, 0);
  const std::string expected = folder.file("expected");
  EXPECT_EQ(
      run_script("waywright 1\ndomain 0 0 10 10\npolygon 3 3 5 5 6 5 6 6\nsegment 5 1 2 3 4\n", {"--dump", expected})
          .status,
      0);
  EXPECT_EQ(read_file(dump), read_file(expected));
}

}  // namespace
}  // namespace waywright::test

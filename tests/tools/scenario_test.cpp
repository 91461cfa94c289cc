#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

/// All tiles are free except a column of two tiles below the upper side. The path around it leads through (1, 2) and
/// (2, 2).
const std::string kScenarioMap = "type octile\nheight 3\nwidth 3\nmap\n.@.\n.T.\n...\n";

std::string query(const std::string& ends, const std::string& length) {
  return "0\tu.map\t3\t3\t" + ends + "\t" + length + "\n";
}

/// 1 + 2 sqrt 5 is 5.472135954999579...
const std::string kQueries = "version 1\n" + query("0\t0\t3\t0", "5.472136") + query("0\t0\t0\t3", "3.5") +
                             query("0\t0\t0\t2", "1.9") + query("1 2 1 2", "0") + query("0\t1\t3\t1", "-1") +
                             query("1.5\t0.5\t0\t1", "1");

struct ScenarioFiles {
  TemporaryFolder folder;
  std::string map = folder.file("u.map", kScenarioMap);
  std::string scenario = folder.file("u.map.scen", kQueries);
};

/// Returns the number after the name of a line.
std::string number_after(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\n" + name);
  if (at == std::string::npos) return "no such line";
  std::istringstream rest(text.substr(at + 1 + name.size()));
  std::string word;
  rest >> word;
  return word;
}

TEST(ScenarioCommand, ComparesLengthsWithThoseGiven) {
  for (const std::string algorithm : {"optimal", "ta", "tra"}) {
    const ScenarioFiles files;
    const auto result = run_command({"scenario", files.map, files.scenario, "--algorithm", algorithm});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
              "6 queries of u.map.scen through u.map, algorithm " + algorithm);
    EXPECT_EQ(number_after(result.out, "as given"), "2");
    EXPECT_EQ(number_after(result.out, "shorter than given"), "1");
    EXPECT_EQ(number_after(result.out, "longer than given"), "1");
    EXPECT_EQ(number_after(result.out, "no path where one is given"), "1");
    EXPECT_EQ(number_after(result.out, "a path where none is given"), "1");
    EXPECT_EQ(number_after(result.out, "an end between two tiles"), "0");
    // The mean over the three lengths above 0: 1, 3 / 3.5 and 2 / 1.9.
    EXPECT_NEAR(std::stod(number_after(result.out, "length / given")), (1 + 3 / 3.5 + 2 / 1.9) / 3, 1e-6);
  }
}

// Two blocked tiles touch at (1, 1). A path that starts there may start in either of the two free areas at this point,
// and no short path leads from one area to the other.
TEST(ScenarioCommand, CountsEndsBetweenTwoCells) {
  TemporaryFolder folder;
  const std::string map = folder.file("u.map", "type octile\nheight 4\nwidth 4\nmap\n@...\n.@..\n....\n....\n");
  const auto line = [](const std::string& ends, const std::string& length) {
    return "0\tu.map\t4\t4\t" + ends + "\t" + length + "\n";
  };
  const std::string scenario = folder.file(
      "d.map.scen", "version 1\n" + line("1\t1\t3\t0", "2.2360679775") + line("0\t3\t1\t1", "2.2360679775") +
                        line("2\t2\t3\t3", "1.4142135624") + line("2\t1\t3\t1", "1"));
  const auto result = run_command({"scenario", map, scenario});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(number_after(result.out, "an end between two tiles"), "2");
}

TEST(ScenarioCommand, WritesALineForEachQuery) {
  const ScenarioFiles files;
  const std::string csv = files.folder.file("u.csv");
  EXPECT_EQ(run_command({"scenario", files.map, files.scenario, "--csv", csv}).status, 0);
  std::istringstream text(read_file(csv));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "query,start_x,start_y,goal_x,goal_y,given,status,length,ratio,expansions,microseconds");
  EXPECT_EQ(lines[2].substr(0, lines[2].find("3,0.857")), "2,0,0,0,3,3.5,found,");
  EXPECT_EQ(lines[5].substr(0, 25), "5,0,1,3,1,-1,found,3.8284");  // 1 + 2 sqrt 2
  EXPECT_EQ(lines[6].substr(0, 32), "6,1.5,0.5,0,1,1,start-blocked,,,");
}

// The gap below the column of two blocked tiles is one tile high, so a disc of radius 0.5 fits exactly.
TEST(ScenarioCommand, AsksForDiscs) {
  TemporaryFolder folder;
  const std::string map = folder.file("u.map", kScenarioMap);
  const std::string scenario =
      folder.file("u.map.scen", "version 1\n" + query("0.5\t0.5\t2.5\t0.5", "9") + query("0.5 0.5 0.5 2.5", "2") +
                                    query("0\t0\t2.5\t0.5", "1") + query("0.5\t0.5\t2\t1", "-1"));
  const std::string csv = folder.file("u.csv");
  const auto result = run_command({"scenario", map, scenario, "--radius", "0.5", "--csv", csv});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
            "4 queries of u.map.scen through u.map, algorithm optimal, radius 0.5");
  EXPECT_EQ(number_after(result.out, "path found"), "2");
  EXPECT_EQ(number_after(result.out, "no path"), "0");
  EXPECT_EQ(number_after(result.out, "start blocked"), "1");
  EXPECT_EQ(number_after(result.out, "goal blocked"), "1");
  EXPECT_GT(std::stod(number_after(result.out, "microseconds")), 0.0);
  // Down by 1.5, around the corner (1, 2) by a quarter of a circle, and so on: 2 * 1.5 + 1 + pi / 2. The other is 2.
  EXPECT_NEAR(std::stod(number_after(result.out, "length ")), (4 + std::acos(-1.0) / 2 + 2) / 2, 1e-3);
  EXPECT_EQ(number_after(result.out, "as given"), "no such line");
  EXPECT_NE(result.out.find("not compared"), std::string::npos);
  std::istringstream text(read_file(csv));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_TRUE(lines[2].starts_with("2,0.5,0.5,0.5,2.5,2,found,2,,")) << lines[2];  // no ratio
  EXPECT_EQ(lines[3].substr(0, 32), "3,0,0,2.5,0.5,1,start-blocked,,,");

  const auto wide = run_command({"scenario", map, scenario, "--radius", "0.5000001"});
  EXPECT_EQ(number_after(wide.out, "path found"), "0");
  EXPECT_EQ(number_after(wide.out, "start blocked"), "4");
}

TEST(ScenarioCommand, PutsDiscsAtTheCentresOfCells) {
  TemporaryFolder folder;
  const std::string map = folder.file("u.map", kScenarioMap);
  const std::string tiles = folder.file("u.map.scen", "version 1\n" + query("0\t0\t2\t0", "9"));
  const std::string csv = folder.file("u.csv");
  const auto result = run_command({"scenario", map, tiles, "--radius", "0.5", "--csv", csv});
  EXPECT_EQ(number_after(result.out, "path found"), "1");
  EXPECT_NE(result.out.find("centres of their tiles"), std::string::npos);
  EXPECT_NE(read_file(csv).find("\n1,0.5,0.5,2.5,0.5,9,found,"), std::string::npos);
  // A point starts at the corner of its tile: see ReadsMovingAiMaps.
  EXPECT_EQ(run_command({"scenario", map, tiles}).out.find("centres of their tiles"), std::string::npos);
  // The map has three columns, so 3 is no tile.
  const std::string corners = folder.file("v.map.scen", "version 1\n" + query("0\t0\t3\t0", "9"));
  const auto blocked = run_command({"scenario", map, corners, "--radius", "0.5"});
  EXPECT_EQ(number_after(blocked.out, "start blocked"), "1");
  EXPECT_EQ(blocked.out.find("centres of their tiles"), std::string::npos);
}

TEST(ScenarioCommand, RefusesABadRadius) {
  const ScenarioFiles files;
  for (const std::string bad : {"-1", "nan", "inf", "1e400", "", "five"}) {
    const auto result = run_command({"scenario", files.map, files.scenario, "--radius", bad});
    EXPECT_EQ(result.status, 2) << bad;
    EXPECT_EQ(result.out, "") << bad;
    EXPECT_EQ(result.err.find("waywright: --radius: '" + bad + "'"), 0U) << result.err;
  }
}

TEST(ScenarioCommand, DrawsTheQueriesAskedFor) {
  const ScenarioFiles files;
  const std::string svg = files.folder.file("u.svg");
  EXPECT_EQ(
      run_command({"scenario", files.map, files.scenario, "--svg", svg, "--query", "1", "--query", "2", "--no-mesh"})
          .status,
      0);
  const std::string picture = read_file(svg);
  EXPECT_EQ(picture.substr(0, 4), "<svg");
  EXPECT_NE(picture.find("u.map.scen"), std::string::npos);
  EXPECT_EQ(files.folder.file_count(), 3U);
}

TEST(ScenarioCommand, TakesBlanksCarriageReturnsAndStandardInput) {
  const ScenarioFiles files;
  const auto result = run_command({"scenario", files.map, "-"}, "version 1.0\r\n0 u.map 3 3 0 0 0 3 3.0\r\n\r\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(number_after(result.out, "as given"), "1");
}

struct BadScenario {
  std::string text;
  std::string message;  ///< after the file's name
};

void PrintTo(const BadScenario& bad, std::ostream* out) { *out << bad.message; }

class BadScenarios : public testing::TestWithParam<BadScenario> {};

TEST_P(BadScenarios, AreReportedWithTheirLineAndLeaveNothing) {
  const ScenarioFiles files;
  const std::string scenario = files.folder.file("bad.scen", GetParam().text);
  const auto result = run_command({"scenario", files.map, scenario, "--csv", files.folder.file("out.csv")});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, scenario + GetParam().message + "\n");
  EXPECT_EQ(files.folder.file_count(), 3U);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScenarios,
    testing::Values(
        BadScenario{"", ":1: expected 'version 1', as scenarios of Moving AI begin, found the end of the text"},
        BadScenario{"version 1\n\n", ":2: expected a query after 'version 1', found the end of the text"},
        BadScenario{"version 2\n", ":1: expected 'version 1', as scenarios of Moving AI begin, found 'version 2'"},
        BadScenario{"version 1\n\n0 u.map 3 3 0 x 0 3 3\n", ":3: expected a finite number as the start's y, found 'x'"},
        BadScenario{"version 1\n0 u.map 3 3 0 0 0 9 9\n",
                    ":2: the goal, (0, 9), lies outside the domain, (0, 0) to (3, 3); is this the scenario of another "
                    "map?"},
        BadScenario{"version 1\n0 u.map 3 3 0 0 0 1 1\n0 maps/dao/v.map 3 3 0 0 0 1 1\n",
                    ":3: the query is for the map 'maps/dao/v.map', and the map given is 'u.map'; give that map, or "
                    "add --any-map to carry out these queries, too"},
        BadScenario{
            "version 1\n0 u.map 4 3 0 0 0 1 1\n",
            ":2: the query is for a map of 4 x 3 tiles, and u.map has 3 x 3; give that map, or add --any-map to "
            "carry out these queries, too"},
        BadScenario{"version 1\n0 u.map 3 18446744073709551615 0 0 0 1 1\n",
                    ":2: the query is for a map of 3 x 18446744073709551615 tiles, and u.map has 3 x 3; give that map, "
                    "or add --any-map to carry out these queries, too"}));

TEST(ScenarioCommand, TakesTheNameOfItsMapFromAnyFolderAndSystem) {
  const ScenarioFiles files;
  for (const std::string name : {"u.map", "maps/dao/u.map", "maps\\dao\\u.map", "./u.map"}) {
    const auto result = run_command({"scenario", files.map, "-"}, "version 1\n0 " + name + " 3 3 0 0 0 3 3.0\n");
    EXPECT_EQ(result.status, 0) << name << result.err;
  }
  EXPECT_EQ(run_command({"scenario", files.map, "-"}, "version 1\n0 su.map 3 3 0 0 0 3 3.0\n").status, 2);
}

TEST(ScenarioCommand, AnswersTheQueriesOfAnotherMapIfAsked) {
  const ScenarioFiles files;
  const std::string scenario = files.folder.file("v.scen", "version 1\n0 v.map 99 3 0 0 0 3 3.0\n");
  EXPECT_EQ(run_command({"scenario", files.map, scenario}).status, 2);
  const auto result = run_command({"scenario", files.map, scenario, "--any-map"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(number_after(result.out, "as given"), "1");
}

// A world script has no tiles, and a map that was converted to one keeps its name.
TEST(ScenarioCommand, TakesTheMapAsAWorldScript) {
  const ScenarioFiles files;
  const std::string script = files.folder.file("u.wws");
  ASSERT_EQ(run_command({"convert", files.map, script}).status, 0);
  const auto result = run_command({"scenario", script, files.scenario});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(run_command({"scenario", "-", files.scenario}, read_file(script)).out.substr(0, 40),
            "6 queries of u.map.scen through standard");
}

class BadScenarioArguments : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(BadScenarioArguments, EndInOneLineAndStatus2) {
  const ScenarioFiles files;
  std::vector<std::string> arguments{"scenario", files.map, files.scenario};
  for (const std::string& argument : GetParam()) {
    arguments.push_back(argument.starts_with("NEW") ? files.folder.file(argument) : argument);
  }
  const auto result = run_command(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(files.folder.file_count(), 2U);
}

using Arguments = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(All, BadScenarioArguments,
                         testing::Values(Arguments{"--algorithm", "best"}, Arguments{"--algorithm"},
                                         Arguments{"--svg", "NEW.svg"}, Arguments{"--query", "1"},
                                         Arguments{"--svg", "NEW.svg", "--query", "0"},
                                         Arguments{"--svg", "NEW.svg", "--query", "7"},
                                         Arguments{"--svg", "NEW.svg", "--query", "one"},
                                         Arguments{"--svg", "NEW", "--csv", "NEW", "--query", "1"}, Arguments{"more"}));

TEST(PathCommand, TakesTheNameOfAnAlgorithm) {
  const ScenarioFiles files;
  for (const std::string algorithm : {"optimal", "ta", "tra"}) {
    const auto lines = json_lines(
        run_command({"path", files.map, "--from", "0", "0", "--to", "3", "0", "--algorithm", algorithm}).out);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].at("length").get<double>(), 1 + 2 * std::sqrt(5.0), 1e-12);
  }
  EXPECT_EQ(run_command({"path", files.map, "--from", "0", "0", "--to", "3", "0", "--algorithm", "best"}).err,
            "waywright path: --algorithm: 'best' is none of optimal, ta and tra (see waywright path --help)\n");
}

}  // namespace
}  // namespace waywright::test

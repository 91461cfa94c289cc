#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "tools/command.hpp"
#include "tools/svg_outline.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

TEST(SvgFile, OfARunShowsTheFinalWorldAndThePathsFoundInIt) {
  const TemporaryFolder folder;
  const std::string picture = folder.file("world.svg");
  const auto result = run_script(
      "waywright 1\ndomain 0 0 10 10\npath 1 1 9 9 0\nsegment 1 5 0 5 6\n"
      "path 2 3 8 3 0\npath 1 1 2 2 0\npoint 1 2 2\n",
      {"--svg", picture});
  EXPECT_EQ(result.status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["groups"]["lines"], 1);
  EXPECT_EQ(drawn["groups"]["paths"], 2);
  EXPECT_THAT(read_file(picture), ::testing::HasSubstr("path, length 8.4853</text>"));  // 6 sqrt(2)
  EXPECT_THAT(read_file(picture), ::testing::HasSubstr("path, length 1.4142</text>"));
  EXPECT_EQ(drawn["title"], "standard input");
  EXPECT_GT(drawn["mesh"], 0);
}

TEST(SvgFile, OfAPathHasTheTitleAndTheOrientationOfTheMap) {
  const TemporaryFolder folder;
  const std::string map = folder.file("one & two.map", "type octile\nheight 4\nwidth 4\nmap\n@...\n....\n....\n....\n");
  const std::string picture = folder.file("a.svg");
  const auto result = run_command({"path", map, "--from", "0", "3", "--to", "4", "0", "--svg", picture, "--no-mesh"});
  EXPECT_EQ(result.status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["title"], "one & two.map");
  EXPECT_EQ(drawn["mesh"], 0);
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  // The blocked tile is the topmost element: its smallest y is that of the whole map.
  const auto numbers = drawn["numbers"].get<std::vector<double>>();
  ASSERT_GE(numbers.size(), 8U);
  EXPECT_LT(*std::min_element(numbers.begin(), numbers.begin() + 8), 100);
}

TEST(SvgFile, OfAConversionHoldsEveryItem) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.wws", "waywright 1\ndomain 0 0 9 9\npoint 1 1 1\npolygon 2 3 2 2 4 2 3 4\n");
  const std::string picture = folder.file("a.svg");
  EXPECT_EQ(run_command({"convert", map, picture}).status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["groups"]["polygons"], 1);
  EXPECT_EQ(drawn["groups"]["points"], 1);
  EXPECT_GT(drawn["mesh"], 0);
}

TEST(SvgFile, OfARunShowsTheQueriesSinceTheWorldLastChanged) {
  const TemporaryFolder folder;
  const std::string picture = folder.file("world.svg");
  const std::string world =
      "waywright 1\ndomain 0 0 10 10\nlocate 3 3\npolygon 1 4 2 2 8 2 8 8 2 8 / 4 4 4 6 4 6 6 4 6\n";
  const std::string queries =
      "locate 1 1.5\nlocate 3 3.25\nray 1 5 9 5\npath 1 1 5 5 0\npath 1 1 3 3 0\npath 1 1 1 9 0\n";
  EXPECT_EQ(run_script(world + queries + "locate 11 11\n", {"--svg", picture}).status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(hints_of(drawn, "locations"), (std::vector<std::string>{"(1, 1.5): face", "(3, 3.25): face, inside 1"}));
  EXPECT_EQ(hints_of(drawn, "rays"), std::vector<std::string>{"ray from (1, 5) to (9, 5), hits 1 at (2, 5)"});
  EXPECT_EQ(hints_of(drawn, "failed-paths"),
            (std::vector<std::string>{"no path from (1, 1) to (5, 5)", "goal blocked from (1, 1) to (3, 3)"}));
  EXPECT_EQ(drawn["groups"]["paths"], 1);

  EXPECT_EQ(run_script(world + queries + "remove 1\n", {"--svg", picture}).status, 0);
  const json after = outline(read_file(picture));
  for (const char* group : {"locations", "rays", "failed-paths", "paths"})
    EXPECT_EQ(after["groups"][group], 0) << group;
}

TEST(SvgFile, OfAPathThatIsNotFoundShowsItsEnds) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.wws", "waywright 1\ndomain 0 0 9 9\nsegment 1 4 0 4 9\n");
  const std::string picture = folder.file("a.svg");
  EXPECT_EQ(run_command({"path", map, "--from", "1", "1", "--to", "8", "8", "--svg", picture}).status, 0);
  EXPECT_EQ(hints_of(outline(read_file(picture)), "failed-paths"),
            std::vector<std::string>{"no path from (1, 1) to (8, 8)"});
}

TEST(SvgFile, ShowsACropBoxInAThemeWithoutAxes) {
  const TemporaryFolder folder;
  const std::string text = "waywright 1\ndomain -20 -20 20 20\npoint 1 1 1\npoint 2 -9 -9\n";
  const std::string map = folder.file("a.wws", text);
  const std::string picture = folder.file("a.svg");
  const std::vector<std::string> options{"--crop", "-10", "-10.5", "-5", "-1e0", "--theme", "dark", "--no-axes"};
  const std::vector<std::vector<std::string>> commands{
      {"convert", map, picture},
      {"run", map, "--svg", picture},
      {"path", map, "--from", "1", "1", "--to", "2", "2", "--svg", picture}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), options.begin(), options.end());
    const CommandResult result = run_command(command);
    EXPECT_EQ(result.status, 0) << result.err;
    const json drawn = outline(read_file(picture));
    ASSERT_TRUE(drawn.is_object()) << drawn;
    EXPECT_EQ(hints_of(drawn, "points"), std::vector<std::string>{"point 2"});
    EXPECT_EQ(drawn["groups"].contains("axes"), false);
    EXPECT_LT(luminance(elements_of(drawn, "", "rect").at(0)["fill"]), 0.2);
    std::filesystem::remove(picture);
  }
}

TEST(SvgFile, OfABadCropBoxSaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.wws", "waywright 1\ndomain 0 0 9 9\nlocate 1 1\n");
  const auto error_of = [&](const std::vector<std::string>& crop) {
    std::vector<std::string> arguments{"run", map, "--svg", folder.file("a.svg"), "--crop"};
    arguments.insert(arguments.end(), crop.begin(), crop.end());
    const CommandResult result = run_command(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");  // refused before anything runs
    EXPECT_EQ(folder.file_count(), 1U);
    return result.err;
  };
  EXPECT_EQ(error_of({"3", "1", "2", "5"}),
            "waywright: --crop: the crop box, (3, 1) to (2, 5), is empty: each coordinate of its first corner must be "
            "less than that of its second\n");
  EXPECT_EQ(error_of({"10", "1", "12", "5"}),
            "waywright: --crop: the crop box, (10, 1) to (12, 5), shows nothing of the domain, (0, 0) to (9, 9)\n");
  EXPECT_EQ(error_of({"1", "1", "12", "five"}),
            "waywright: --crop: 'five' is not a decimal number such as -1.5 or 2e3\n");
}

}  // namespace
}  // namespace waywright::test

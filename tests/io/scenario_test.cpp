#include "waywright/scenario.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace waywright {
namespace {

std::vector<ScenarioQuery> queries_of(const std::string& text) {
  const auto queries = parse_movingai_scenario(text, "s.scen");
  EXPECT_TRUE(queries.ok()) << queries.error().message();
  return queries.ok() ? *queries : std::vector<ScenarioQuery>{};
}

TEST(ParseScenario, ReadsEveryField) {
  const auto queries = queries_of("version 1\n\n7\tmaps/dao/arena.map\t49\t50\t1\t2.5\t-3\t4e1\t12.25\n");
  ASSERT_EQ(queries.size(), 1U);
  const ScenarioQuery& query = queries.front();
  EXPECT_EQ(query.line, 3U);
  EXPECT_EQ(query.map, "maps/dao/arena.map");
  EXPECT_EQ(query.width, 49U);
  EXPECT_EQ(query.height, 50U);
  EXPECT_EQ(query.start, (Point{1, 2.5}));
  EXPECT_EQ(query.goal, (Point{-3, 40}));
  EXPECT_EQ(query.length, 12.25);
  EXPECT_DOUBLE_EQ(query.precision, 0.005);
}

TEST(ParseScenario, TakesCarriageReturnsBlanksAndNoLastLineEnd) {
  const auto queries = queries_of("version 1.0\r\n0 a.map 3 3 0 0 1 0 1\r\n\r\n0 a.map 3 3 0 0 0 1 1.0e2");
  ASSERT_EQ(queries.size(), 2U);
  EXPECT_EQ(queries[0].precision, 0.5);
  EXPECT_EQ(queries[1].line, 4U);
  EXPECT_DOUBLE_EQ(queries[1].precision, 5.0);
}

TEST(ParseScenario, SaysWhatIsWrongAndWhere) {
  const auto expect_message = [](const std::string& text, const std::string& message) {
    const auto queries = parse_movingai_scenario(text, "s.scen");
    ASSERT_FALSE(queries.ok()) << text;
    EXPECT_EQ(queries.error().code, ErrorCode::malformed);
    EXPECT_EQ(queries.error().message(), "s.scen:" + message);
  };
  const std::string begin = "expected 'version 1', as scenarios of Moving AI begin, found ";
  expect_message("", "1: " + begin + "the end of the text");
  expect_message("version 2\n", "1: " + begin + "'version 2'");
  expect_message("version 1 1\n", "1: " + begin + "'version 1 1'");
  expect_message("type octile\n", "1: " + begin + "'type octile'");
  expect_message("version 1\n\n", "2: expected a query after 'version 1', found the end of the text");
  expect_message(
      "version 1\n0 a.map 3 3 0 0 1 0\n",
      "2: expected 9 fields (bucket, map, width, height, start x, start y, goal x, goal y, length), found 8");
  expect_message("version 1\n0 a.map x 3 0 0 1 0 1\n", "2: expected a whole number of tiles as the width, found 'x'");
  expect_message("version 1\n0 a.map 3 -3 0 0 1 0 1\n",
                 "2: expected a whole number of tiles as the height, found '-3'");
  expect_message("version 1\n0 a.map 3 3 x 0 1 0 1\n", "2: expected a finite number as the start's x, found 'x'");
  expect_message("version 1\n0 a.map 3 3 0 1,5 1 0 1\n", "2: expected a finite number as the start's y, found '1,5'");
  expect_message("version 1\n0 a.map 3 3 0 0 nan 0 1\n", "2: expected a finite number as the goal's x, found 'nan'");
  expect_message("version 1\n0 a.map 3 3 0 0 0 1e400 1\n",
                 "2: expected a finite number as the goal's y, found '1e400'");
  expect_message("version 1\n0 a.map 3 3 0 0 0 1 0x1p3\n", "2: expected a finite number as the length, found '0x1p3'");
}

}  // namespace
}  // namespace waywright

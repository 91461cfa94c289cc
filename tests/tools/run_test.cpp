#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

const std::string kHead = "waywright 1\ndomain 0 0 10 10\n";

TEST(RunCommand, PrintsTheFormatsOwnLocateLine) {
  const auto result = run_script(
      "waywright 1\n"
      "# a triangle that fills half the domain\n"
      "domain 0 0 4 4\n\n\n\n\n\n\n\n"
      "polygon 7 3 0 0 4 0 0 4\n"
      "locate 1 1\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, R"({"line":12,"op":"locate","at":"face","vertices":[[0,0],[4,0],[0,4]],"inside":[7]})"
                        "\n");
}

TEST(RunCommand, LocatesInFacesOnEdgesAndAtVertices) {
  // The domain's diagonal runs through its smallest corner (0, 0).
  const auto lines = json_lines(run_script(kHead + "locate 5 2\nlocate 2 2\nlocate 10 0\nlocate 10 4\n").out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0],
            json::parse(R"({"line":3,"op":"locate","at":"face","vertices":[[0,0],[10,0],[10,10]],"inside":[]})"));
  EXPECT_EQ(lines[1], json::parse(R"({"line":4,"op":"locate","at":"edge","vertices":[[0,0],[10,10]],"inside":[]})"));
  EXPECT_EQ(lines[2], json::parse(R"({"line":5,"op":"locate","at":"vertex","vertices":[[10,0]],"inside":[]})"));
  EXPECT_EQ(lines[3], json::parse(R"({"line":6,"op":"locate","at":"edge","vertices":[[10,0],[10,10]],"inside":[]})"));
}

TEST(RunCommand, ListsThePolygonsThatCoverAPointAscending) {
  const auto lines = json_lines(run_script(kHead + "polygon 9 4 1 1 6 1 6 6 1 6\n"
                                                   "polygon 4 4 4 4 9 4 9 9 4 9\n"
                                                   "polygon 5 4 0 0 10 0 10 10 0 10 / 4 3 3 7 3 7 7 3 7\n"
                                                   "locate 5 5\nlocate 2 2\nlocate 6 6\nlocate 3 3\n")
                                    .out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].at("inside"), json::parse("[4,9]"));  // in the hole of 5
  EXPECT_EQ(lines[1].at("inside"), json::parse("[5,9]"));
  EXPECT_EQ(lines[2].at("inside"), json::parse("[4,9]"));  // a corner of 9
  EXPECT_EQ(lines[3].at("inside"), json::parse("[5,9]"));  // the hole's corner is on the boundary of 5
}

TEST(RunCommand, GoesBackToAMark) {
  const std::string start = kHead + "segment 1 4 0 4 7\nmark 1\n";
  const std::string there = run_script(start + "hash\npath 1 1 7 1 0\n").out;
  const CommandResult result = run_script(
      start + "polygon 2 3 5 0 9 0 9 4\nmark 2\nremove 1\nrewind 1\nhash\npath 1 1 7 1 0\ncheck\nremove 2\n");
  EXPECT_EQ(result.status, 0);
  const auto lines = json_lines(result.out);
  const auto before = json_lines(there);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].at("mesh"), before[0].at("mesh"));
  EXPECT_EQ(lines[0].at("items"), before[0].at("items"));
  EXPECT_EQ(lines[1].at("pieces"), before[1].at("pieces"));
  EXPECT_EQ(lines[2].at("ok"), true);
  EXPECT_EQ(lines[3].at("error"), "unknown-id");
}

TEST(RunCommand, PrintsTheFirstWallOfARay) {
  const auto result = run_script(kHead +
                                 "segment 9 3 1 3 4\nsegment 4 3 2 5 3\npoint 2 2 5\n"
                                 "ray 1 3 9 3\nray 1 2 9 2\nray 9 2 1 2\nray 1 5 8 5\nray 5 9 5 10\n");
  EXPECT_EQ(result.out,
            "{\"line\":6,\"op\":\"ray\",\"hit\":true,\"at\":[3,3],\"items\":[9]}\n"
            "{\"line\":7,\"op\":\"ray\",\"hit\":true,\"at\":[3,2],\"items\":[4,9]}\n"
            "{\"line\":8,\"op\":\"ray\",\"hit\":true,\"at\":[3,2],\"items\":[4,9]}\n"
            "{\"line\":9,\"op\":\"ray\",\"hit\":false}\n"
            "{\"line\":10,\"op\":\"ray\",\"hit\":true,\"at\":[5,10],\"items\":[0]}\n");
}

TEST(RunCommand, PrintsTheFirstWallThatADiscTouches) {
  const auto result = run_script(kHead +
                                 "segment 9 3 1 3 4\nsegment 4 3 2 5 3\npoint 2 2 5\n"
                                 "ray 1.5 3 8 3 1\nray 1.5 5 8 5 1\nray 1 3 9 3 0\nray 2 5 2 6 0.5\n");
  EXPECT_EQ(result.out,
            "{\"line\":6,\"op\":\"ray\",\"hit\":true,\"at\":[2,3],\"contact\":[3,3],\"items\":[9]}\n"
            "{\"line\":7,\"op\":\"ray\",\"hit\":true,\"at\":[3,5],\"contact\":[3,4],\"items\":[9]}\n"
            "{\"line\":8,\"op\":\"ray\",\"hit\":true,\"at\":[3,3],\"contact\":[3,3],\"items\":[9]}\n"
            "{\"line\":9,\"op\":\"ray\",\"hit\":false}\n");
}

TEST(RunCommand, PrintsPathsOfDiscsAsLinesAndArcsOrTheGapThatStopsThem) {
  const std::string walls = kHead + "segment 4 5 0 5 4\nsegment 9 5 6 5 10\n";
  const auto result = run_script(walls + "path 1 5 9 5 1\npath 4.5 1 9 5 1\npath 2 5 8 5 1.5\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out,
            "{\"line\":5,\"op\":\"path\",\"found\":true,\"length\":8,\"pieces\":[{\"line\":[1,5,9,5]}]}\n"
            "{\"line\":6,\"op\":\"path\",\"found\":false,\"reason\":\"start-blocked\",\"items\":[4]}\n"
            "{\"line\":7,\"op\":\"path\",\"found\":false,\"reason\":\"no-path\",\"widest\":{\"radius\":1,"
            "\"gap\":[[5,4],[5,6]],\"items\":[4,9]}}\n");
  const auto turning = run_script(walls + "path 2 4 8 4 0.5\n");
  EXPECT_NE(turning.out.find("{\"arc\":[5,4,0.5,"), std::string::npos) << turning.out;
}

TEST(RunCommand, PrintsWhetherADiscFitsAndWhatStopsIt) {
  const auto result =
      run_script(kHead +
                 "segment 9 3 1 3 4\nsegment 4 3 2 5 3\npoint 2 2 5\npolygon 7 4 6 6 9 6 9 9 6 9\n"
                 "disc 1 3 1\ndisc 1 3 1.5\ndisc 2 2.5 1.25\ndisc 7.5 7.5 0\ndisc 6 7 0\ndisc 6 7 0.5\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out,
            "{\"line\":7,\"op\":\"disc\",\"free\":true,\"items\":[]}\n"
            "{\"line\":8,\"op\":\"disc\",\"free\":false,\"items\":[0]}\n"
            "{\"line\":9,\"op\":\"disc\",\"free\":false,\"items\":[4,9]}\n"
            "{\"line\":10,\"op\":\"disc\",\"free\":false,\"items\":[7]}\n"
            "{\"line\":11,\"op\":\"disc\",\"free\":true,\"items\":[]}\n"
            "{\"line\":12,\"op\":\"disc\",\"free\":false,\"items\":[7]}\n");
}

TEST(RunCommand, PrintsTheNearestPositionWhereADiscFits) {
  const std::string walls = kHead + "segment 4 5 0 5 4\nsegment 9 5 6 5 10\n";
  const auto result = run_script(walls + "nearest 4.5 2 1\nnearest 4.5 2 1.5 goal 8 5\nnearest 4.5 2 6\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out,
            "{\"line\":5,\"op\":\"nearest\",\"found\":true,\"at\":[4,2]}\n"
            "{\"line\":6,\"op\":\"nearest\",\"found\":true,\"at\":[6.5,2]}\n"
            "{\"line\":7,\"op\":\"nearest\",\"found\":false}\n");
}

TEST(RunCommand, PrintsAPathInTheFormatsShape) {
  const auto result = run_script(kHead + "path 1 1 5 4 0 ta\n");
  EXPECT_EQ(result.out, R"({"line":3,"op":"path","found":true,"length":5,"pieces":[{"line":[1,1,5,4]}]})"
                        "\n");
}

TEST(RunCommand, ReportsHowManyCallsEachStageDecided) {
  const std::string script = kHead + "segment 1 2 0 2 10\nsegment 2 0 5 10 5\nsegment 3 1.1 1.1 8 9\nlocate 5 2\n";
  const auto plain = run_script(script);
  EXPECT_EQ(plain.err, "");
  const auto counted = run_script(script, {"--stats"});
  EXPECT_EQ(counted.status, 0);
  EXPECT_EQ(counted.out, plain.out);
  const auto stats = json::parse(counted.err);
  EXPECT_EQ(stats.at("op"), "stats");
  // Three crossings: one of the two walls along the axes, and one of each of these with the third wall, whose ends are
  // not whole numbers.
  EXPECT_EQ(stats.at("crossing"), json::parse(R"({"doubles":1,"lattice":2,"integers":0})"));
  for (const char* const question : {"orientation", "in_circle", "order"}) {
    EXPECT_GT(stats.at(question).at("doubles"), 0) << question;
    EXPECT_EQ(stats.at(question).at("integers"), 0) << question;
  }
}

// A box and a point have 6 vertices with the ghost vertex. Each has two coordinates, a half-edge and a list of items.
// The triangulated sphere has 8 faces with three corners and three neighbours each.
TEST(RunCommand, ReportsTheUseOfMemory) {
  const auto memory = json::parse(run_script(kHead + "point 1 5 2\n", {"--stats"}).err).at("memory");
  EXPECT_EQ(memory.at("faces"), 8 * 24);
  EXPECT_GE(memory.at("vertices"), 6 * (4 + 4 + 16));
  EXPECT_EQ(memory.at("crossings"), 0);
  for (const char* const part : {"walls", "items", "sectors", "abstraction", "spare"})
    EXPECT_GT(memory.at(part), 0) << part;
}

TEST(RunCommand, WalksRoundTheEndOfAWall) {
  const auto lines = json_lines(run_script(kHead + "segment 1 5 0 5 6\npath 2 3 8 3 0\n").out);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].at("found"), true);
  EXPECT_EQ(lines[0].at("pieces"), json::parse(R"([{"line":[2,3,5,6]},{"line":[5,6,8,3]}])"));
  EXPECT_NEAR(lines[0].at("length").get<double>(), 8.48528137423857, 1e-12);  // 6 sqrt(2)
}

TEST(RunCommand, SaysWhyThereIsNoPath) {
  const auto result = run_script(kHead +
                                 "segment 1 5 0 5 10\n"
                                 "polygon 2 4 7 7 9 7 9 9 7 9\n"
                                 "path 1 1 9 1 0\npath 8 8 6 6 0\npath 6 6 8 8 0\n");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, R"({"line":5,"op":"path","found":false,"reason":"no-path"})"
                        "\n"
                        R"({"line":6,"op":"path","found":false,"reason":"start-blocked","items":[2]})"
                        "\n"
                        R"({"line":7,"op":"path","found":false,"reason":"goal-blocked","items":[2]})"
                        "\n");
}

TEST(RunCommand, PrintsCheck) {
  EXPECT_EQ(run_script(kHead + "segment 1 1 1 9 9\nsegment 2 1 9 9 1\ncheck\n").out,
            "{\"line\":5,\"op\":\"check\",\"ok\":true}\n");
}

TEST(RunCommand, PrintsNumbersInTheirShortestFormAndNoNegativeZero) {
  const auto result = run_script(
      "waywright 1\n"
      "domain -1 -1 1 1\n"
      "point 1 0.1 -0.0\n"
      "point 2 -1e-7 0.30000000000000004\n"
      "locate 0.1 0\nlocate -1e-7 0.30000000000000004\n");
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(result.out.find("[[0.1,0]]"), std::string::npos) << result.out;
  EXPECT_EQ(lines[1].at("vertices"), json::parse("[[-1e-7,0.30000000000000004]]"));
}

struct Refusal {
  std::string operation;
  std::string op;
  std::string code;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.operation; }

class RunCommandRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(RunCommandRefuses, WithACodeAndAMessageAndContinues) {
  const auto& [operation, op, code] = GetParam();
  const std::string script = kHead + "point 1 5 5\n" + operation + "\nlocate 5 5\n";
  const auto result = run_script(script, {"--check"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U) << result.out;
  EXPECT_EQ(lines[0].at("line"), 4);
  EXPECT_EQ(lines[0].at("op"), op);
  EXPECT_EQ(lines[0].at("error"), code);
  EXPECT_GT(lines[0].at("message").get<std::string>().size(), 8U);
  EXPECT_EQ(lines[0].size(), 4U);
  EXPECT_EQ(lines[1].at("at"), "vertex");

  const auto strict = run_script(script, {"--strict"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_EQ(strict.err, "");
  EXPECT_EQ(strict.out, result.out.substr(0, result.out.find('\n') + 1));
}

TEST(RunCommand, RefusesAnOperationThatMakesMoreVerticesThanTheLimit) {
  const std::string script =
      kHead + "segment 1 5 1 5 9\nsegment 2 1 5 9 5\nreplace segment 2 1 6 4 6\nsegment 3 1 5 9 5\n";
  EXPECT_EQ(run_script(script, {"--limit", "3"}).out, "");
  const auto result = run_script(script, {"--limit=2"});
  EXPECT_EQ(result.status, 0);
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 3U) << result.out;
  EXPECT_EQ(lines[0],
            json::parse(R"({"line":4,"op":"segment","error":"too-many-vertices","message":"item 2 would bring )"
                        R"(the operation to more than 2 new vertices, its limit; divide the operation or raise )"
                        R"(the limit"})"));
  EXPECT_EQ(lines[1].at("error"), "unknown-id");
  EXPECT_EQ(lines[2].at("error"), "too-many-vertices");
  EXPECT_EQ(run_script(script, {"--limit", "2", "--strict"}).status, 1);
  EXPECT_EQ(json_lines(run_script(script, {"--limit", "0"}).out).size(), 4U);
  const auto wrong = run_script(script, {"--limit", "-1"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("--limit: '-1' is not a number of vertices, 0 or more"), std::string::npos) << wrong.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, RunCommandRefuses,
    testing::Values(
        Refusal{"point 1 2 2", "point", "id-in-use"}, Refusal{"segment 1 2 2 3 3", "segment", "id-in-use"},
        Refusal{"point 2 11 2", "point", "out-of-domain"}, Refusal{"segment 2 1 1 1 -0.5", "segment", "out-of-domain"},
        Refusal{"polyline 2 3 1 1 2 2 3 30", "polyline", "out-of-domain"},
        Refusal{"polygon 2 3 1 1 2 2 3 30", "polygon", "out-of-domain"},
        Refusal{"polygon 2 3 1 1 2 2 3 3 / 1 -1 1", "polygon", "out-of-domain"},
        Refusal{"point 2 nan 2", "point", "coordinate-range"}, Refusal{"point 2 inf 2", "point", "coordinate-range"},
        Refusal{"point 2 1e300 2", "point", "coordinate-range"},
        Refusal{"segment 2 1 1 1 1e-300", "segment", "coordinate-range"},
        Refusal{"locate 11 2", "locate", "out-of-domain"}, Refusal{"locate nan 2", "locate", "coordinate-range"},
        Refusal{"path 1 1 20 1 0", "path", "out-of-domain"}, Refusal{"path -1 1 2 1 0 ta", "path", "out-of-domain"},
        Refusal{"path 1 1 2 1e300 0", "path", "coordinate-range"}, Refusal{"path 1 1 2 1 -1", "path", "bad-radius"},
        Refusal{"path 1 1 2 1 inf", "path", "bad-radius"}, Refusal{"path 1 1 2 1 nan ta", "path", "bad-radius"},
        Refusal{"remove 9", "remove", "unknown-id"}, Refusal{"path 1 1 2 1 0 tolerance -1", "path", "bad-distance"},
        Refusal{"path 1 1 2 1 0 ta tolerance nan", "path", "bad-distance"},
        Refusal{"clear 2 1 1 12 1", "clear", "out-of-domain"}, Refusal{"clear 1 nan 1", "clear", "coordinate-range"},
        Refusal{"ray 1 1 2 12", "ray", "out-of-domain"}, Refusal{"ray -1 1 2 2", "ray", "out-of-domain"},
        Refusal{"ray 1 1 2 inf", "ray", "coordinate-range"}, Refusal{"ray 1 1 2 2 -1", "ray", "bad-radius"},
        Refusal{"disc 11 1 2", "disc", "out-of-domain"}, Refusal{"disc 1 nan 2", "disc", "coordinate-range"},
        Refusal{"disc 1 1 -2", "disc", "bad-radius"}, Refusal{"disc 1 1 inf", "disc", "bad-radius"},
        Refusal{"disc 1 1 nan", "disc", "bad-radius"}, Refusal{"nearest 11 1 0", "nearest", "out-of-domain"},
        Refusal{"nearest 1 1 1 goal 1 11", "nearest", "out-of-domain"},
        Refusal{"nearest 1 1 nan", "nearest", "bad-radius"}, Refusal{"nearest 1 1 inf", "nearest", "bad-radius"}));

// 2^-20 of the domain's largest coordinate is 0.0000095.
TEST(RunCommand, MovesAnEndThatIsBlockedByRoundingAndSaysSo) {
  const std::string square = kHead + "polygon 7 4 4 4 8 4 8 8 4 8\n";
  const auto answer = [&](const std::string& query) { return json_lines(run_script(square + query).out).at(0); };
  EXPECT_EQ(answer("path 4.000001 6 3 6 0\n"),
            json::parse(R"({"line":4,"op":"path","found":true,"length":1,"pieces":[{"line":[4,6,3,6]}],)"
                        R"("moved_start":[[4.000001,6],[4,6]]})"));
  EXPECT_EQ(answer("path 3 6 4.000001 6 0 ta\n").at("moved_goal"), json::parse("[[4.000001,6],[4,6]]"));
  EXPECT_EQ(answer("path 4.5 6 3 6 0\n"),
            json::parse(R"({"line":4,"op":"path","found":false,"reason":"start-blocked","items":[7]})"));
  EXPECT_EQ(answer("path 4.5 6 3 6 0 tolerance 0.5\n").at("moved_start"), json::parse("[[4.5,6],[4,6]]"));
  EXPECT_EQ(answer("path 4.000001 6 3 6 0 optimal tolerance 0\n").at("reason"), "start-blocked");
}

TEST(RunCommand, ReportsWhetherAPolylineIsClear) {
  const auto result = run_script(kHead + "polygon 7 4 4 4 8 4 8 8 4 8\nclear 3 1 1 4 4 4 9\nclear 2 1 1 9 9\n");
  EXPECT_EQ(result.out,
            "{\"line\":4,\"op\":\"clear\",\"clear\":true}\n{\"line\":5,\"op\":\"clear\",\"clear\":false}\n");
  for (const char* wrong :
       {"clear", "clear 0", "clear 2 1 1 2", "clear 1 1 1 1", "path 1 1 2 2 0 best", "path 1 1 2 2 0 tolerance",
        "path 1 1 2 2 0 ta tolerance x", "path 1 1 2 2 0 tolerance 1 ta"}) {
    EXPECT_EQ(run_script(kHead + wrong + "\n").status, 2) << wrong;
  }
}

TEST(RunCommand, RemovesItemsAndFreesTheirIds) {
  const auto result = run_script(kHead +
                                 "segment 7 5 0 5 10\npath 1 1 9 1 0\nremove 7\npath 1 1 9 1 0\nremove 7\n"
                                 "segment 7 1 1 2 2\ncheck\n");
  EXPECT_EQ(result.status, 0);
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].at("found"), false);
  EXPECT_EQ(lines[1].at("found"), true);
  EXPECT_EQ(lines[2], json::parse(R"({"line":7,"op":"remove","error":"unknown-id","message":"no item has id 7"})"));
  EXPECT_EQ(lines[3].at("ok"), true);
}

TEST(RunCommand, ReplacesItemsAsThoughTheyHadAlwaysBeenSo) {
  const auto moved = run_script(kHead +
                                "polygon 7 4 1 1 2 1 2 2 1 2\npoint 8 5 5\nlocate 1.5 1.5\n"
                                "replace polygon 7 4 3 3 4 3 4 4 3 4\nlocate 1.5 1.5\nlocate 3.5 3.5\n"
                                "replace segment 8 6 6 7 7\nray 6 7 7 6\ncheck\nhash\n");
  EXPECT_EQ(moved.status, 0);
  const auto lines = json_lines(moved.out);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0].at("inside"), json({7}));
  EXPECT_EQ(lines[1].at("inside"), json::array());
  EXPECT_EQ(lines[2].at("inside"), json({7}));
  EXPECT_EQ(lines[3].at("items"), json({8}));
  EXPECT_EQ(lines[4].at("ok"), true);
  const auto fresh = json_lines(run_script(kHead + "segment 8 6 6 7 7\npolygon 7 4 3 3 4 3 4 4 3 4\nhash\n").out);
  EXPECT_EQ(lines[5].at("items"), fresh.at(0).at("items"));
  EXPECT_EQ(lines[5].at("mesh"), fresh.at(0).at("mesh"));
}

TEST(RunCommand, RefusesToReplaceWhatIsNotThere) {
  const auto result = run_script(kHead + "point 1 5 5\nreplace point 9 1 1\nreplace point 1 1000 1\nlocate 5 5\n");
  EXPECT_EQ(result.status, 0);
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
            R"({"line":4,"op":"replace","error":"unknown-id","message":"no item has id 9"})");
  EXPECT_EQ(lines[1].at("op"), "replace");
  EXPECT_EQ(lines[1].at("error"), "out-of-domain");
  EXPECT_EQ(lines[2].at("at"), "vertex") << "the item stays as it was";
  EXPECT_EQ(run_script(kHead + "replace point 9 1 1\n", {"--strict"}).status, 1);
}

TEST(RunCommand, DrawsNoPathOfAWorldBeforeAReplacement) {
  const TemporaryFolder folder;
  const std::string head = kHead + "point 1 5 5\n";
  const auto svg_of = [&](const std::string& lines) { return run_script(head + lines, {"--svg", "-"}).out; };
  EXPECT_EQ(svg_of("path 1 1 2 2 0\nreplace point 1 6 6\n"), svg_of("replace point 1 6 6\n"));
  EXPECT_NE(svg_of("replace point 1 6 6\npath 1 1 2 2 0\n"), svg_of("replace point 1 6 6\n"));
}

TEST(RunCommand, SaysWhatIsWrongWithADomain) {
  EXPECT_EQ(run_script("waywright 1\n# here\ndomain nan 0 1 1\n").err,
            "-:3: expected X0 to be 0 or of a size from 2^-100 to 2^100 in 'domain X0 Y0 X1 Y1', found 'nan'\n");
}

TEST(RunCommand, AcceptsAByteOrderMarkAndReportsUtf16) {
  const std::string script = kHead + "locate 5 5\n";
  EXPECT_EQ(run_script("\xef\xbb\xbf" + script).out, run_script(script).out);
  std::string wide = "\xff\xfe";
  for (const char c : script) wide += {c, '\0'};
  EXPECT_EQ(run_script(wide).status, 2);
  EXPECT_EQ(run_script(wide).err,
            "-:1: expected UTF-8, found UTF-16LE; save the text as UTF-8, or convert it with 'iconv -f UTF-16LE -t "
            "UTF-8'\n");
}

TEST(RunCommand, HashesDependOnLiveItemsAlone) {
  const auto result = run_script(kHead +
                                 "hash\nsegment 1 1 1 9 9\nsegment 2 1 9 9 1\nhash\nremove 1\nremove 2\nhash\n"
                                 "segment 2 1 9 9 1\nsegment 1 1 1 9 9\nhash\n");
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 4U);
  for (const char* const key : {"items", "mesh"}) {
    EXPECT_EQ(lines[0].at(key), lines[2].at(key));
    EXPECT_EQ(lines[1].at(key), lines[3].at(key));
    EXPECT_NE(lines[0].at(key), lines[1].at(key));
  }
  EXPECT_EQ(lines[0].at("items").get<std::string>().size(), 32U);
  // By sha256sum: the hash of the dump of an empty domain from (0, 0) to (10, 10).
  EXPECT_EQ(lines[0].at("mesh"), "328b360e93502b993a3e5ef13145f53b099dca3a5613bf958a38dee452aeb19e");
}

TEST(RunCommand, RunsAFileAsItRunsStandardInput) {
  const TemporaryFolder folder;
  const std::string script = kHead + "segment 1 2 2 8 3\nlocate 5 2\npath 1 1 9 9 0\ncheck\n";
  const auto from_file = run_command({"run", folder.file("world.wws", script)});
  EXPECT_EQ(from_file.status, 0);
  EXPECT_EQ(from_file.out, run_script(script).out);
  EXPECT_EQ(json_lines(from_file.out).size(), 3U);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(RunCommand, TakesCarriageReturnsCommentsAndBlankLines) {
  const auto result =
      run_script("\r\n# a comment\r\nwaywright 1 # the header\r\n\r\ndomain 0 0 1 1\r\ncheck # all\r\n");
  EXPECT_EQ(result.out, "{\"line\":6,\"op\":\"check\",\"ok\":true}\n");
}

TEST(RunCommand, DumpsTheMeshOfAnEmptyDomain) {
  const TemporaryFolder folder;
  const auto result = run_script("waywright 1\ndomain 0 0 1 0.5\n", {"--dump", folder.file("mesh"), "--check"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(read_file(folder.file("mesh")),
            "vertices 4\n0 1 0 1\n0 1 1 2\n1 1 0 1\n1 1 1 2\n"
            "triangles 2\n0 2 3\n0 3 1\n"
            "constraints 4\n0 1 0\n0 2 0\n1 3 0\n2 3 0\n");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(RunCommand, StopsAtTheFirstRefusalAndWritesNoFilesWhenStrict) {
  const TemporaryFolder folder;
  const auto result = run_script(kHead + "locate 1 2\npoint 1 20 20\nlocate 3 4\n",
                                 {"--strict", "--dump", folder.file("dump"), "--svg", folder.file("svg")});
  EXPECT_EQ(result.status, 1);
  const auto lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1].at("error"), "out-of-domain");
  EXPECT_EQ(folder.file_count(), 0U);
}

// A picture shows a path only if the world is still the world in which it was found. Otherwise it shows the world
// alone.
TEST(RunCommand, DrawsNoPathOfAWorldThatHasChangedSince) {
  const TemporaryFolder folder;
  const std::string world = kHead + "segment 1 2 5 8 5\nsegment 2 5 6 5 9\n";
  const auto picture = [&](const std::string& script) {
    EXPECT_EQ(run_script(script, {"--svg", folder.file("svg")}).status, 0);
    return read_file(folder.file("svg"));
  };
  EXPECT_NE(picture(world + "path 5 1 5 4 0\n"), picture(world));
  EXPECT_EQ(picture(world + "path 5 1 5 4 0\nremove 2\n"), picture(world + "remove 2\n"));
  EXPECT_EQ(picture(world + "path 5 1 5 4 0\npoint 3 1 1\n"), picture(world + "point 3 1 1\n"));
}

TEST(RunCommand, ManyAnswersComeInOrder) {
  std::string script = kHead;
  for (int i = 0; i < 5000; ++i) script += "locate 5 2\n";
  const auto lines = json_lines(run_script(script).out);
  ASSERT_EQ(lines.size(), 5000U);
  for (std::size_t i = 0; i < lines.size(); ++i) ASSERT_EQ(lines[i].at("line"), i + 3);
}

}  // namespace
}  // namespace waywright::test

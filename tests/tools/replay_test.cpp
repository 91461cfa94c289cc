#include <string>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

const std::string kStart = "waywright 1\ndomain 0 0 10 10\npoint 1 1 2\n";

/// The hash of the items after a script.
std::string hash_after(const std::string& script) {
  return json_lines(run_script(script + "hash\n").out).at(0).at("items").get<std::string>();
}

const std::string kLog = kStart + "tick 1 " + hash_after(kStart) + "\nsegment 7 4 0 4 7\ntick 2\nremove 1\ntick 3 " +
                         hash_after(kStart + "segment 7 4 0 4 7\nremove 1\n") + "\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(CommandReplay, AcceptsALog) {
  const TemporaryFolder folder;
  const CommandResult result = run_command({"replay", folder.file("a.wws", kLog)});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "{\"op\":\"replay\",\"same\":true,\"ticks\":3}\n");
  EXPECT_EQ(run_command({"replay", "-"}, kLog).out, result.out);
}

TEST(CommandReplay, SaysWhereALogDiffers) {
  const CommandResult result = run_command({"replay", "-"}, replaced(kLog, "4 7\n", "4 8\n"));
  EXPECT_EQ(result.status, 1) << result.err;
  const json line = json_lines(result.out).at(0);
  EXPECT_EQ(line.at("same"), false);
  EXPECT_EQ(line.at("tick"), 3);
  EXPECT_EQ(line.at("line"), 8);
  EXPECT_EQ(line.at("last_same"), 1);
  EXPECT_EQ(line.at("items"), (json{1, 7}));
  EXPECT_NE(line.at("expected"), line.at("computed"));
  const json refusal = json_lines(run_command({"replay", "-"}, replaced(kLog, "remove 1", "remove 2")).out).at(0);
  EXPECT_EQ(refusal.at("tick"), 3);
  EXPECT_EQ(refusal.at("error"), "unknown-id");
  EXPECT_EQ(refusal.at("items"), json{2});
}

TEST(CommandReplay, ComparesTwoLogs) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.wws", kLog);
  const CommandResult same = run_command({"replay", a, "-"}, kLog);
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(same.out, "{\"op\":\"compare\",\"same\":true}\n");
  const CommandResult different = run_command({"replay", a, "-"}, replaced(kLog, "segment 7", "segment 8"));
  EXPECT_EQ(different.status, 1) << different.err;
  EXPECT_EQ(different.out,
            "{\"op\":\"compare\",\"same\":false,\"kind\":\"change\",\"tick\":2,\"line\":5,\"other_line\":5,"
            "\"item\":7,\"other_item\":8}\n");
  EXPECT_EQ(run_command({"replay", "-", "-"}, kLog).status, 2);
}

TEST(CommandReplay, RefusesWhatIsNoLog) {
  const CommandResult result = run_command({"replay", "-"}, kStart + "tick x\n");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err.rfind("-:4: expected the number of a tick", 0), 0U) << result.err;
}

TEST(CommandRun, ReadsAReplayLogAndChecksItsHashes) {
  EXPECT_EQ(run_script(kLog).status, 0);
  EXPECT_EQ(run_script(kLog).out, "");
  const CommandResult different = run_script(replaced(kLog, "4 7\n", "4 8\n"));
  EXPECT_EQ(different.status, 1);
  const json line = json_lines(different.out).at(0);
  EXPECT_EQ(line.at("op"), "tick");
  EXPECT_EQ(line.at("line"), 8);
  EXPECT_EQ(line.at("tick"), 3);
  EXPECT_EQ(line.at("same"), false);
}

}  // namespace
}  // namespace waywright::test

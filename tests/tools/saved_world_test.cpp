#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

const std::string kScript = "waywright 1\ndomain 0 0 10 10\npoint 3 1 2\nsegment 7 4 0 4 7\n";

/// The options of the world that has a saved world: byte 40. The largest id: bytes 44 to 51.
std::string with(std::string bytes, std::size_t at, char value) {
  bytes.at(at) = value;
  return bytes;
}

TEST(CommandConvert, WritesAndReadsSavedWorlds) {
  const TemporaryFolder folder;
  const std::string script = folder.file("a.wws", kScript);
  const CommandResult written = run_command({"convert", script, folder.file("a.wwb")});
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out + written.err, "");
  EXPECT_EQ(read_file(folder.file("a.wwb")).substr(0, 8), std::string("WWORLD\1\0", 8));
  const CommandResult read = run_command({"convert", folder.file("a.wwb"), "-"});
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, kScript);
}

TEST(CommandConvert, KnowsASavedWorldByItsContents) {
  const TemporaryFolder folder;
  const CommandResult written = run_command({"convert", "-", "-", "--format", "wwb"}, kScript);
  ASSERT_EQ(written.status, 0) << written.err;
  for (const std::string name : {"a.wws", "a.map", "a"}) {
    const CommandResult read = run_command({"convert", folder.file(name, written.out), "-"});
    EXPECT_EQ(read.status, 0) << read.err;
    EXPECT_EQ(read.out, kScript);
  }
  EXPECT_EQ(run_command({"convert", "-", "-"}, written.out).out, kScript);
  const CommandResult path = run_command({"path", "-", "--from", "1", "1", "--to", "7", "1"}, written.out);
  EXPECT_EQ(path.status, 0) << path.err;
  EXPECT_EQ(json_lines(path.out).at(0).at("pieces").size(), 2U);
}

TEST(CommandConvert, KeepsTheOptionsAndTheNextIdOfASavedWorld) {
  const TemporaryFolder folder;
  const std::string golden = WAYWRIGHT_SOURCE_DIR "/tests/saved/every_kind.wwb";
  ASSERT_EQ(run_command({"convert", golden, folder.file("a.wwb")}).status, 0);
  EXPECT_EQ(read_file(folder.file("a.wwb")), read_file(golden));
  EXPECT_EQ(run_command({"convert", "-", "-", "--format", "wwb"}, read_file(golden)).out, read_file(golden));
}

TEST(CommandConvert, RefusesAnAlteredSavedWorld) {
  const TemporaryFolder folder;
  const std::string bytes = run_command({"convert", "-", "-", "--format", "wwb"}, kScript).out;
  const std::vector<std::string> altered = {bytes.substr(0, 50), with(bytes, 40, 3), with(bytes, 44, 9), bytes + "x",
                                            "WWORLD"};
  for (const std::string& text : altered) {
    const std::string name = folder.file("a.wwb", text);
    for (const std::string out : {"out.wws", "out.wwb"}) {
      const CommandResult result = run_command({"convert", name, folder.file(out)});
      EXPECT_EQ(result.status, 2);
      EXPECT_EQ(result.err.rfind(name + ": ", 0), 0U) << result.err;
      EXPECT_EQ(folder.file_count(), 1U);
    }
    const CommandResult run = run_command({"run", name});
    EXPECT_EQ(run.status, 2);
  }
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

const std::string kWorld = "waywright 1\ndomain -10 -10 10 10\n";

void expect_one_line_and_status_2(const CommandResult& result) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_GT(result.err.size(), 15U);
}

/// WORLD stands for a good script's file, NEW for a file that is not there, LOST for one in a folder that is not there.
class BadArguments : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(BadArguments, EndInOneLineStatus2AndNoFile) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = GetParam();
  for (std::string& argument : arguments) {
    if (argument == "WORLD") argument = folder.file("world.wws", kWorld);
    if (argument.starts_with("NEW")) argument = folder.file("new" + argument.substr(3));
    if (argument.starts_with("LOST")) argument = folder.file("lost/new" + argument.substr(4));
  }
  const std::size_t before = folder.file_count();
  expect_one_line_and_status_2(run_command(arguments));
  EXPECT_EQ(folder.file_count(), before);
}

using Arguments = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(
    All, BadArguments,
    testing::Values(
        Arguments{}, Arguments{"walk"}, Arguments{"--fast"}, Arguments{"run"}, Arguments{"run", "WORLD", "more"},
        Arguments{"run", "WORLD", "--fast"}, Arguments{"run", "WORLD", "--dump"}, Arguments{"run", "WORLD", "--svg"},
        Arguments{"run", "WORLD", "--dump", ""}, Arguments{"run", "WORLD", "--dump", "NEW", "--dump", "NEW2"},
        Arguments{"run", "WORLD", "--dump", "NEW", "--svg", "NEW"}, Arguments{"run", "NEW"}, Arguments{"run", ""},
        Arguments{"run", "/"}, Arguments{"run", "WORLD", "--dump", "LOST"}, Arguments{"run", "WORLD", "--svg", "LOST"},
        Arguments{"run", "WORLD", "--dump", "/"}, Arguments{"run", "WORLD", "path", "WORLD"}, Arguments{"path"},
        Arguments{"path", "WORLD"}, Arguments{"path", "WORLD", "--from", "1", "1"},
        Arguments{"path", "WORLD", "--to", "1", "1"}, Arguments{"path", "WORLD", "--from", "1", "--to", "1", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "2", "--to", "1", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--from", "2", "2", "--to", "1", "1"},
        Arguments{"path", "WORLD", "--from", "one", "1", "--to", "1", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1", "1x"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1", ""},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1", "0x1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1", "nan"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "inf", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1e999", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "11", "1"},
        Arguments{"path", "WORLD", "--from", "1", "-10.5", "--to", "1", "1"},
        Arguments{"path", "NEW.wws", "--from", "1", "1", "--to", "1", "1"},
        Arguments{"path", "NEW.png", "--from", "1", "1", "--to", "1", "1"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "1", "2", "--svg", "LOST.svg"},
        Arguments{"path", "WORLD", "--from", "1", "1", "--to", "11", "2", "--svg", "NEW.svg"}, Arguments{"convert"},
        Arguments{"convert", "WORLD"}, Arguments{"convert", "WORLD", "NEW.png"}, Arguments{"convert", "WORLD", "NEW"},
        Arguments{"convert", "WORLD", "LOST.wws"}, Arguments{"convert", "WORLD", "LOST.svg"},
        Arguments{"convert", "NEW.wws", "NEW.svg"}, Arguments{"convert", "NEW.txt", "NEW.wws"},
        Arguments{"convert", "WORLD", "NEW.wws", "NEW.svg"}, Arguments{"scenario"}, Arguments{"scenario", "WORLD"},
        Arguments{"scenario", "WORLD", "NEW.scen"}, Arguments{"scenario", "NEW.wws", "WORLD"}));

TEST(Help, IsPrintedWithExamplesForTheCommandAndEachOfItsSubcommands) {
  for (const std::string command : {"", "run", "path", "scenario", "convert"}) {
    std::vector<std::string> arguments{"--help"};
    if (!command.empty()) arguments.insert(arguments.begin(), command);
    const auto result = run_command(arguments);
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_EQ(result.err, "") << command;
    EXPECT_NE(result.out.find("Examples:"), std::string::npos) << command;
    EXPECT_NE(result.out.find("  waywright " + command), std::string::npos) << command;
  }
}

TEST(Version, IsOneLine) {
  const auto result = run_command({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.substr(0, 10), "waywright ");
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '.'), 2);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
}

TEST(Files, AnUnwritableTargetIsKnownBeforeAnythingRuns) {
  const TemporaryFolder folder;
  const std::string target = folder.file("lost/dump");
  const auto result = run_script(kWorld + "locate 1 1\n", {"--dump", target});
  expect_one_line_and_status_2(result);
  EXPECT_EQ(result.err.substr(0, target.size() + 2), target + ": ");
}

TEST(Files, AFailedWriteLeavesTheOtherFileUnwritten) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const TemporaryFolder folder;
  const auto result = run_script(kWorld, {"--svg", folder.file("picture.svg"), "--dump", "/dev/full"});
  expect_one_line_and_status_2(result);
  EXPECT_EQ(folder.file_count(), 0U);
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST(Files, AnExistingFileIsReplacedWholeOrKept) {
  const TemporaryFolder folder;
  const std::string target = folder.file("dump", "what was there before");
  EXPECT_EQ(run_script(kWorld + "point 0 1 1\n", {"--dump", target}).status, 2);
  EXPECT_EQ(read_file(target), "what was there before");
  EXPECT_EQ(run_script(kWorld, {"--dump", target}).status, 0);
  EXPECT_EQ(read_file(target).substr(0, 11), "vertices 4\n");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(Files, ALinkKeepsPointingAtTheFileItNames) {
  const TemporaryFolder folder;
  const std::string target = folder.file("dump", "old");
  std::filesystem::create_symlink(target, folder.file("link"));
  EXPECT_EQ(run_script(kWorld, {"--dump", folder.file("link")}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(read_file(target).substr(0, 11), "vertices 4\n");
}

TEST(Files, ATemporaryOfAnotherRunIsLeftAlone) {
  const TemporaryFolder folder;
  const std::string other = folder.file("dump.tmp0", "another run's");
  EXPECT_EQ(run_script(kWorld, {"--dump", folder.file("dump")}).status, 0);
  EXPECT_EQ(read_file(other), "another run's");
  EXPECT_EQ(read_file(folder.file("dump")).substr(0, 11), "vertices 4\n");
  EXPECT_EQ(folder.file_count(), 2U);
}

TEST(StandardOutput, AFullDiskIsTold) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const TemporaryFolder folder;
  const std::vector<std::string> run{"run", "-", "--dump", folder.file("dump")};
  expect_one_line_and_status_2(run_command(run, kWorld + "locate 1 1\n", "/dev/full"));
  EXPECT_EQ(folder.file_count(), 0U);
  expect_one_line_and_status_2(run_command({"--help"}, {}, "/dev/full"));
}

TEST(StandardOutput, AReaderThatGoesAwayIsTold) {
  const TemporaryFolder folder;
  std::string script = kWorld;
  for (int i = 0; i < 50000; ++i) script += "locate 1 2\n";
  const std::string world = folder.file("long.wws", script);
  // The shell's own exit status is that of the command on the pipe's left, put into a file.
  const auto result = run_program("sh", {"-c", "{ \"$0\" run \"$1\"; echo $? >\"$2\"; } | head -n 1", WAYWRIGHT_COMMAND,
                                         world, folder.file("status")});
  EXPECT_EQ(read_file(folder.file("status")), "2\n");
  EXPECT_EQ(json_lines(result.out).size(), 1U);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

}  // namespace
}  // namespace waywright::test

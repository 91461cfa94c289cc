#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

const std::string kClosedWorld = "waywright 1\ndomain 0 0 9 9\n";

/// Each subcommand with arguments for which it prints, and the options that print without a subcommand. "$D" in the
/// shell is the folder.
const std::vector<std::string> kPrinting{
    "run \"$D\"/a.wws",
    "run - <\"$D\"/a.wws",
    "run \"$D\"/a.wws --dump -",
    "run \"$D\"/a.wws --svg /dev/stdout",
    "path \"$D\"/a.wws --from 1 1 --to 2 2",
    "path \"$D\"/a.wws --from 1 1 --to 2 2 --svg -",
    "scenario \"$D\"/a.wws \"$D\"/a.scen",
    "scenario \"$D\"/a.wws \"$D\"/a.scen --csv -",
    "convert \"$D\"/a.wws -",
    "convert \"$D\"/a.wws - --format svg",
    "help",
    "help run",
    "--help",
    "run --help",
    "--version",
};

/// A folder with the files that kPrinting reads.
struct Inputs {
  TemporaryFolder folder;
  std::string script = folder.file("a.wws", kClosedWorld + "locate 1 1\n");
  std::string scenario = folder.file("a.scen", "version 1\n0 a.map 9 9 1 1 1 3 2\n");
  std::string silent = folder.file("silent.wws", kClosedWorld + "point 1 1 1\n");

  [[nodiscard]] CommandResult shell(const std::string& line) const {
    return run_shell("D=$1; " + line, {folder.file("")});
  }
};

TEST(ClosedStreams, StandardOutputIsReportedForEverySubcommand) {
  const Inputs inputs;
  for (const std::string& words : kPrinting) {
    const auto result = inputs.shell("\"$W\" " + words +
                                     " >&- 2>\"$D\"/err; S=$?; grep -c '' \"$D\"/err; "
                                     "grep -c '^waywright: cannot write to standard output: ' \"$D\"/err; exit $S");
    EXPECT_EQ(result.status, 2) << words;
    const bool answers_to_error = words.find("--dump -") != std::string::npos ||
                                  words.find("--svg") != std::string::npos || words.find("--csv") != std::string::npos;
    EXPECT_TRUE(answers_to_error ? result.out.ends_with("\n1\n") : result.out == "1\n1\n") << words << result.out;
  }
}

TEST(ClosedStreams, AFullStandardOutputIsReportedForEverySubcommand) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const Inputs inputs;
  for (const std::string& words : kPrinting) {
    const auto result = inputs.shell("\"$W\" " + words + " >/dev/full");
    EXPECT_EQ(result.status, 2) << words;
    EXPECT_NE(result.err.find("waywright: cannot write to standard output: No space left"), std::string::npos)
        << words << result.err;
  }
}

// The command cannot print an error to a closed stream, but the exit status tells about it.
TEST(ClosedStreams, StandardErrorEndsNothingInAnAbort) {
  const Inputs inputs;
  for (const std::string closed : {"2>&-", "2>/dev/full", "2>&- >&-", "2>&- >&- <&-", "2>&- >/dev/full"}) {
    for (const std::string words :
         {"", "rum", "run", "run /nope", "run \"$D\"", "run \"$D\"/a.scen", "path /nope.wws --from 1 1 --to 2 2",
          "path \"$D\"/a.wws --from 1 1 --to 20 20", "scenario \"$D\"/a.wws /nope", "convert /nope.map \"$D\"/x.svg",
          "convert \"$D\"/a.wws /nope/x.svg", "run \"$D\"/a.wws --stats", "run \"$D\"/a.wws --dump -",
          "path \"$D\"/a.wws --from 1 1 --to 2 2 --svg -", "scenario \"$D\"/a.wws \"$D\"/a.scen --csv -"}) {
      EXPECT_EQ(inputs.shell("\"$W\" " + words + " " + closed).status, 2) << words << " " << closed;
    }
  }
}

TEST(ClosedStreams, SilentWorkNeedsNone) {
  const Inputs inputs;
  for (const std::string words : {"run \"$D\"/silent.wws --dump \"$D\"/dump", "convert \"$D\"/a.wws \"$D\"/x.svg"}) {
    EXPECT_EQ(inputs.shell("\"$W\" " + words + " <&- >&- 2>&-").status, 0) << words;
  }
  EXPECT_EQ(read_file(inputs.folder.file("dump")).substr(0, 11), "vertices 5\n");
  EXPECT_EQ(read_file(inputs.folder.file("x.svg")).substr(0, 4), "<svg");
}

// If an output file got the descriptor of a closed stream, the command would print into that file.
TEST(ClosedStreams, NoOutputFileTakesTheirDescriptors) {
  const Inputs inputs;
  const std::string dump = inputs.folder.file("dump");
  ASSERT_EQ(run_command({"run", inputs.script, "--dump", dump}).status, 0);
  const std::string expected = read_file(dump);
  for (const std::string closed : {">&-", "2>&-", "<&-", "<&- >&-", ">&- 2>&-", "<&- 2>&-", "<&- >&- 2>&-"}) {
    std::filesystem::remove(dump);
    const auto result = inputs.shell("\"$W\" run \"$D\"/a.wws --stats --dump \"$D\"/dump " + closed);
    EXPECT_EQ(result.status, closed == "<&-" ? 0 : 2) << closed;
    EXPECT_EQ(std::filesystem::exists(dump), closed == "<&-") << closed;
    if (closed == "<&-") {
      EXPECT_EQ(read_file(dump), expected);
    }
    EXPECT_EQ(read_file(inputs.script), kClosedWorld + "locate 1 1\n") << closed;
  }
}

// The command opens a pipe before the run. If the pipe got the descriptor of a closed stream, it would receive the
// answers.
TEST(ClosedStreams, NoPipeTakesTheirDescriptor) {
  const Inputs inputs;
  const auto result = inputs.shell(
      "mkfifo \"$D\"/pipe; \"$W\" run \"$D\"/a.wws --dump \"$D\"/pipe >&- & cat \"$D\"/pipe; wait $!; echo $?");
  EXPECT_EQ(result.out, "2\n");
  EXPECT_EQ(result.err, "waywright: cannot write to standard output: Bad file descriptor\n");
}

TEST(ClosedStreams, StandardInputIsReported) {
  const Inputs inputs;
  for (const std::string words : {"run -", "path - --from 1 1 --to 2 2", "convert - \"$D\"/x.svg",
                                  "scenario \"$D\"/a.wws -", "scenario - \"$D\"/a.scen"}) {
    const auto result = inputs.shell("\"$W\" " + words + " <&-");
    EXPECT_EQ(result.status, 2) << words;
    EXPECT_EQ(result.err, "standard input: cannot be read: Bad file descriptor\n") << words;
    EXPECT_EQ(inputs.shell("\"$W\" " + words + " </").err, "standard input: cannot be read: Is a directory\n") << words;
  }
}

TEST(ClosedStreams, AFileBeyondTheUsersLimitIsReported) {
  const Inputs inputs;
  const auto result = inputs.shell("ulimit -f 0; \"$W\" convert \"$D\"/a.wws \"$D\"/big.wws 2>/dev/null");
  EXPECT_EQ(result.status, 2);
  EXPECT_FALSE(std::filesystem::exists(inputs.folder.file("big.wws")));
  EXPECT_EQ(inputs.folder.file_count(), 3U);
}

TEST(ClosedStreams, UsedUpMemoryIsReported) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs more addresses than the limit leaves";
#endif
  const auto result = run_shell("ulimit -v 400000; exec \"$W\" run /dev/zero");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, "waywright: not enough memory\n");
}

TEST(Messages, KeepControlCharactersOfNamesFromTheTerminal) {
  EXPECT_EQ(run_command({"run", "no\x1b[2J\nfile"}).err, "no?[2J file: cannot be read: No such file or directory\n");
  const std::string longest(2000, 'n');
  EXPECT_EQ(run_command({"run", longest}).err, longest + ": cannot be read: File name too long\n");
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <random>
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

/// WORLD stands for the file of a valid script, NEW for a file that does not exist, LOST for a file in a folder that
/// does not exist.
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
        Arguments{"convert", "WORLD", "NEW.wws", "NEW.svg"}, Arguments{"run", "WORLD", "--crop", "0", "0", "1", "1"},
        Arguments{"run", "WORLD", "--theme", "dark"}, Arguments{"run", "WORLD", "--svg", "NEW", "--theme", "grey"},
        Arguments{"run", "WORLD", "--svg", "NEW", "--crop", "0", "0", "1"},
        Arguments{"run", "WORLD", "--svg", "NEW", "--crop", "0", "0", "0", "1"},
        Arguments{"convert", "WORLD", "NEW.wws", "--crop", "0", "0", "1", "1"},
        Arguments{"convert", "WORLD", "NEW.svg", "--crop", "0", "0", "1", "nan"}, Arguments{"scenario"},
        Arguments{"scenario", "WORLD"}, Arguments{"scenario", "WORLD", "NEW.scen"},
        Arguments{"scenario", "NEW.wws", "WORLD"}));

/// The arguments and the message that the command must print. WORLD stands for the file of a valid script.
struct Message {
  Arguments arguments;
  std::string text;
};

void PrintTo(const Message& message, std::ostream* out) { *out << message.text; }

class Messages : public testing::TestWithParam<Message> {};

TEST_P(Messages, SayWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string world = folder.file("world.wws", kWorld);
  Arguments arguments = GetParam().arguments;
  std::replace(arguments.begin(), arguments.end(), std::string("WORLD"), world);
  const auto result = run_command(arguments);
  expect_one_line_and_status_2(result);
  EXPECT_EQ(result.err, GetParam().text + "\n");
  EXPECT_EQ(folder.file_count(), 1U);
}

Message of_path(Arguments values, const std::string& text) {
  values.insert(values.begin(), {"path", "WORLD"});
  return {values, "waywright path: " + text + " (see waywright path --help)"};
}

Message of_run(Arguments values, const std::string& text) {
  values.insert(values.begin(), "run");
  return {values, "waywright run: " + text + " (see waywright run --help)"};
}

INSTANTIATE_TEST_SUITE_P(
    Counts, Messages,
    testing::Values(
        of_path({"--from", "1", "--to", "1", "1"}, "--from takes 2 values, X Y, and only 1 is given: '1'"),
        of_path({"--from=1", "--to", "1", "1"}, "--from takes 2 values, X Y, and only 1 is given: '1'"),
        of_path({"--from", "--to", "1", "1"}, "--from takes 2 values, X Y, and none is given"),
        of_path({"--from", "-1", "-2", "--to", "-.5"}, "--to takes 2 values, X Y, and only 1 is given: '-.5'"),
        of_path({"--from", "1", "1", "2", "--to", "1", "1"},
                "--from takes 2 values, X Y, and 3 follow it: '1' '1' '2'"),
        of_path({"--from", "1", "1", "--to", "1", "1", "2"}, "--to takes 2 values, X Y, and 3 follow it: '1' '1' '2'"),
        of_path({"--from", "1", "1", "--to", "2", "2", "--from", "1", "1"}, "--from is given twice"),
        of_path({"--from", "1", "1"}, "--to X Y is missing: Where the path ends"),
        of_path({"--from", "1", "1", "--to", "1", "1", "--algorithm", "--no-mesh"},
                "--algorithm takes a value, NAME, and none is given"),
        of_run({}, "SCRIPT is missing: The script (.wws), or a map whose items it inserts; - is standard input"),
        of_run({""}, "SCRIPT: the file's name is empty"),
        of_run({"WORLD", "--svg", ""}, "--svg: the file's name is empty"),
        of_run({"WORLD", "more"}, "'more' is one argument too many, after SCRIPT"),
        of_run({"WORLD", "--dump", "--svg", "x"}, "--dump takes a value, FILE, and none is given"),
        of_run({"WORLD", "--dump="}, "--dump takes a value, FILE, and none is given"),
        of_run({"WORLD", "--check=false"}, "--check takes no value"),
        of_run({"WORLD", "--fast"}, "there is no option '--fast'"),
        of_run({"-world.wws"}, "there is no option '-world.wws'; for a file with this name, write ./-world.wws")));

const std::string kCommands = "; the commands are run, path, scenario, convert, replay and help";

INSTANTIATE_TEST_SUITE_P(
    Others, Messages,
    testing::Values(
        Message{{}, "waywright: a command is missing" + kCommands + " (see waywright --help)"},
        Message{{"rum", "WORLD"}, "waywright: 'rum' is not a command" + kCommands + " (see waywright --help)"},
        Message{{"--fast", "run"},
                "waywright: there is no option '--fast' before the command" + kCommands + " (see waywright --help)"},
        Message{{"help", "rum"}, "waywright help: 'rum' is not a command" + kCommands},
        Message{{"help", "run", "path"},
                "waywright help: 'path' is one argument too many, after COMMAND (see waywright help --help)"},
        Message{{"scenario", "-", "-"}, "waywright: MAP and SCENARIO cannot both be standard input"},
        Message{{"scenario", "WORLD", "WORLD", "--query", "-1"},
                "waywright scenario: --query: '-1' is not the number of a query, which counts from 1 (see waywright "
                "scenario --help)"},
        Message{{"convert", "WORLD", "a.png"},
                "waywright: convert writes world scripts (.wws), saved worlds (.wwb), pictures (.svg) and GeoJSON "
                "(.geojson, .json), and 'a.png' has none of these endings; "
                "--format says which"},
        Message{{"convert", "WORLD", "-", "--format", "png"},
                "waywright convert: --format: 'png' is none of wws, wwb, svg, geojson and geojson-mesh (see waywright "
                "convert --help)"},
        Message{{"path", "WORLD", "--from", "1,5", "2", "--to", "1", "1"},
                "waywright: --from: '1,5' is not a decimal number such as -1.5 or 2e3"},
        Message{{"path", "WORLD", "--from", "0x1p3", "2", "--to", "1", "1"},
                "waywright: --from: '0x1p3' is not a decimal number such as -1.5 or 2e3"},
        Message{{"path", "WORLD", "--from", "1", "1", "--to", "1e400", "1"},
                "waywright: --to: '1e400' lies beyond +-2^100"},
        Message{{"path", "WORLD", "--from", "-inf", "1", "--to", "1", "1"},
                "waywright: path: x of the start, -inf, is not finite"},
        Message{{"path", "WORLD", "--from", "-1", "-20", "--to", "1", "1"},
                "waywright: path: the start, (-1, -20), lies outside the domain, (-10, -10) to (10, 10)"}));

TEST(Arguments, MayStandInAnyOrder) {
  const TemporaryFolder folder;
  const std::string world = folder.file("world.wws", kWorld);
  const std::string expected = run_command({"path", world, "--from", "-1", "-2", "--to", "3", "3"}).out;
  EXPECT_EQ(json_lines(expected).at(0).at("length").get<double>(), std::hypot(4, 5));
  EXPECT_EQ(run_command({"path", "--to", "3", "3", "--from", "-1", "-2", world}).out, expected);
  EXPECT_EQ(run_command({"path", "--from=-1", "-2", "--to", "3", "3", "--", world}).out, expected);
  EXPECT_EQ(run_command({"path", "--from", "-1", "-2", world, "--to", "3", "3"}).out, expected);
}

TEST(Arguments, TooSmallForADoubleReadAsInAScript) {
  const auto result = run_command({"path", "-", "--from", "1e-400", "0", "--to", "1", "0"}, kWorld);
  EXPECT_EQ(json_lines(result.out).at(0).at("length"), 1) << result.err;
}

// CLI11 must find no error that the command's own check has not found before: CLI11 uses other statuses and messages.
TEST(Arguments, OfAnyKindEndInAStatusAndOneLine) {
  const TemporaryFolder folder;
  const std::string world = folder.file("world.wws", kWorld);
  const std::vector<std::string> vocabulary{
      "run",    "path",    "scenario", "convert", "help",    world,      world,    "-",          "--",
      "--from", "--to",    "--from=1", "--query", "1",       "2",        "-3",     "-.5",        "",
      "--svg",  "--svg=-", "--dump",   "--csv",   "--check", "--stats",  "--help", "-h",         "--strict",
      "-x",     "--fast",  "=",        "--=",     "-=",      "--check=", "ta",     "--algorithm"};
  std::mt19937 random(1);
  for (int i = 0; i < 400; ++i) {
    Arguments arguments(random() % 7);
    for (std::string& argument : arguments) argument = vocabulary[random() % vocabulary.size()];
    if (!arguments.empty() && i % 4 != 0) arguments.front() = vocabulary[random() % 5];
    const auto result = run_command(arguments);
    const std::string shown = testing::PrintToString(arguments);
    ASSERT_TRUE(result.status == 0 || result.status == 2) << shown;
    if (result.status == 0) continue;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << shown << result.err;
    for (const std::string phrase : {"not expected", "is required", "required but received", " required "}) {
      EXPECT_EQ(result.err.find(phrase), std::string::npos) << shown << result.err;
    }
  }
}

TEST(Help, OfACommandIsTheSameByEitherName) {
  EXPECT_EQ(run_command({"help"}).out, run_command({"--help"}).out);
  EXPECT_EQ(run_command({"help"}).status, 0);
  for (const std::string command : {"run", "path", "scenario", "convert", "help"}) {
    const auto result = run_command({"help", command});
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_EQ(result.out, run_command({command, "--help"}).out) << command;
    EXPECT_NE(result.out.find("waywright " + command), std::string::npos) << command;
  }
}

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

TEST(StandardOutput, AFullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const TemporaryFolder folder;
  const std::vector<std::string> run{"run", "-", "--dump", folder.file("dump")};
  expect_one_line_and_status_2(run_command(run, kWorld + "locate 1 1\n", "/dev/full"));
  EXPECT_EQ(folder.file_count(), 0U);
  expect_one_line_and_status_2(run_command({"--help"}, {}, "/dev/full"));
}

TEST(StandardOutput, AClosedPipeIsReported) {
  const TemporaryFolder folder;
  std::string script = kWorld;
  for (int i = 0; i < 50000; ++i) script += "locate 1 2\n";
  const std::string world = folder.file("long.wws", script);
  // The shell writes the exit status of the command, which is left of the pipe, into a file.
  const auto result = run_program("sh", {"-c", "{ \"$0\" run \"$1\"; echo $? >\"$2\"; } | head -n 1", WAYWRIGHT_COMMAND,
                                         world, folder.file("status")});
  EXPECT_EQ(read_file(folder.file("status")), "2\n");
  EXPECT_EQ(json_lines(result.out).size(), 1U);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

}  // namespace
}  // namespace waywright::test

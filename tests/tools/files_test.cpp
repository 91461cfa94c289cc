#include <algorithm>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;

const std::string kFileWorld = "waywright 1\ndomain 0 0 9 9\nlocate 1 1\n";
const std::string kFileMap = "type octile\nheight 9\nwidth 9\nmap\n" + [] {
  std::string rows;
  for (int i = 0; i < 9; ++i) rows += ".........\n";
  return rows;
}();
const std::string kScenario = "version 1\n0 a.map 9 9 1 1 1 3 2\n";
const std::string kPoly = "0 2 0 0\n0\n0\n";
const std::string kNode = "1 2 0 0\n1 0 0\n";

/// The files that each subcommand reads, and other names of these files.
struct Files {
  TemporaryFolder folder;
  std::string script = folder.file("a.wws", kFileWorld);
  std::string map = folder.file("a.map", kFileMap);
  std::string scenario = folder.file("a.scen", kScenario);
  std::string poly = folder.file("b.poly", kPoly);
  std::string node = folder.file("b.node", kNode);
  std::size_t count = 0;

  Files() {
    fs::create_directory(folder.file("sub"));
    for (const std::string& file : {script, map, scenario, node}) {
      fs::create_hard_link(file, file + ".hard.svg");
      fs::create_symlink(file, file + ".link.svg");
      fs::create_symlink(fs::path(file).filename(), file + ".far.svg");
    }
    count = folder.file_count();
  }

  void expect_untouched() const {
    EXPECT_EQ(read_file(script), kFileWorld);
    EXPECT_EQ(read_file(map), kFileMap);
    EXPECT_EQ(read_file(scenario), kScenario);
    EXPECT_EQ(read_file(node), kNode);
    EXPECT_EQ(folder.file_count(), count);
  }
};

/// Returns other names of a file.
std::vector<std::string> spellings(const std::string& file) {
  const fs::path name(file);
  return {file,
          (name.parent_path() / "." / name.filename()).string(),
          (name.parent_path() / "sub" / ".." / name.filename()).string(),
          fs::relative(name).string(),
          file + ".hard.svg",
          file + ".link.svg",
          file + ".far.svg"};
}

void expect_refused(const Files& files, const std::vector<std::string>& arguments, const std::string& option,
                    const std::string& input) {
  const auto result = run_command(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "waywright: " + option + " would write to '" + arguments.back() + "', the file that " + input +
                            " reads; nothing was written\n");
  files.expect_untouched();
}

TEST(SharedFiles, NoOutputReplacesAnInput) {
  const Files files;
  for (const std::string& name : spellings(files.script)) {
    expect_refused(files, {"run", files.script, "--dump", name}, "--dump", "SCRIPT");
    expect_refused(files, {"run", files.script, "--svg", name}, "--svg", "SCRIPT");
    expect_refused(files, {"path", files.script, "--from", "1", "1", "--to", "2", "2", "--svg", name}, "--svg", "MAP");
    expect_refused(files, {"convert", files.script, "--format", "wws", name}, "OUT", "MAP");
    expect_refused(files, {"convert", name.ends_with(".svg") ? files.script : name, "--format", "svg", files.script},
                   "OUT", "MAP");
  }
  for (const std::string& name : spellings(files.map)) {
    expect_refused(files, {"scenario", files.map, files.scenario, "--csv", name}, "--csv", "MAP");
  }
  for (const std::string& name : spellings(files.scenario)) {
    expect_refused(files, {"scenario", files.map, files.scenario, "--query", "1", "--svg", name}, "--svg", "SCENARIO");
  }
  for (const std::string& name : spellings(files.node)) {
    expect_refused(files, {"convert", files.poly, "--format", "svg", name}, "OUT", "MAP");
  }
}

TEST(SharedFiles, NoOutputReplacesWhatAStandardStreamReadsOrWrites) {
  const Files files;
  const auto expect_message = [&](const std::string& line, const std::string& message) {
    const auto result = run_shell("cd \"$1\"; \"$W\" " + line, {files.folder.file("")});
    EXPECT_EQ(result.status, 2) << line;
    EXPECT_EQ(result.err, "waywright: " + message + "\n") << line;
  };
  expect_message("run - --dump a.wws <a.wws",
                 "--dump would write to 'a.wws', the file that SCRIPT reads; nothing was written");
  expect_message("run - --dump a.wws.hard.svg <a.wws",
                 "--dump would write to 'a.wws.hard.svg', the file that SCRIPT reads; nothing was written");
  expect_message("run a.wws >>a.wws", "standard output goes to the file that SCRIPT reads");
  expect_message("run - <a.wws >>a.wws.hard.svg", "standard output goes to the file that SCRIPT reads");
  expect_message("scenario a.map a.scen --csv - >>a.map", "standard output goes to the file that MAP reads");
  files.expect_untouched();
  expect_message("run a.wws --svg out >out",
                 "--svg would write to 'out', where standard output goes; nothing was written");
  EXPECT_EQ(run_shell("cd \"$1\"; \"$W\" run a.wws --stats --svg out 2>out", {files.folder.file("")}).status, 2);
  EXPECT_EQ(run_shell("cd \"$1\"; \"$W\" run a.wws --stats >both 2>&1", {files.folder.file("")}).status, 0);
}

TEST(SharedFiles, NoTwoOutputsAreOne) {
  const Files files;
  const auto expect_two = [&](const std::string& first, const std::string& second) {
    const auto result = run_command({"run", files.script, "--dump", first, "--svg", second});
    EXPECT_EQ(result.status, 2) << first << " " << second;
    EXPECT_EQ(result.err,
              "waywright: --svg would write to '" + second + "', where --dump writes too; nothing was written\n");
    const auto scenario =
        run_command({"scenario", files.map, files.scenario, "--query", "1", "--csv", first, "--svg", second});
    EXPECT_EQ(scenario.status, 2) << first << " " << second;
  };
  const std::string free_name = files.folder.file("new");
  expect_two(free_name, free_name);
  expect_two(free_name, files.folder.file("sub/../new"));
  expect_two(free_name, fs::relative(free_name).string());
  files.expect_untouched();
  fs::create_symlink("new", files.folder.file("dangling"));
  expect_two(free_name, files.folder.file("dangling"));
  expect_two("-", "-");
  expect_two("-", "/dev/stdout");
  EXPECT_FALSE(fs::exists(free_name));
  const std::string old = files.folder.file("old", "old");
  fs::create_hard_link(old, files.folder.file("older"));
  expect_two(old, files.folder.file("older"));
  EXPECT_EQ(read_file(old), "old");
  EXPECT_EQ(run_command({"run", files.script, "--dump", "/dev/null", "--svg", "/dev/null"}).status, 0);
}

/// Runs the command three times; each run writes a file of that name.
void write_all(const Files& files, const std::string& target) {
  EXPECT_EQ(run_command({"run", files.script, "--dump", target}).status, 0);
  EXPECT_EQ(read_file(target).substr(0, 11), "vertices 4\n");
  EXPECT_EQ(run_command({"scenario", files.map, files.scenario, "--csv", target}).status, 0);
  EXPECT_EQ(read_file(target).substr(0, 6), "query,");
  EXPECT_EQ(run_command({"convert", files.map, target, "--format", "svg"}).status, 0);
  EXPECT_EQ(read_file(target).substr(0, 4), "<svg");
}

TEST(WrittenFiles, KeepTheirPermissions) {
  const Files files;
  const std::string target = files.folder.file("target", "old");
  for (const unsigned mode : {0600U, 0640U, 0664U, 0777U, 0200U | 0400U | 0111U}) {
    fs::permissions(target, static_cast<fs::perms>(mode));
    write_all(files, target);
    EXPECT_EQ(static_cast<unsigned>(fs::status(target).permissions()), mode);
  }
}

TEST(WrittenFiles, TakeTheUsersMaskWhereNew) {
  const Files files;
  const auto result = run_shell("umask 027; \"$W\" convert \"$1\" \"$2\"", {files.map, files.folder.file("new.wws")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(static_cast<unsigned>(fs::status(files.folder.file("new.wws")).permissions()), 0640U);
}

TEST(WrittenFiles, KeepTheirOwner) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
  const Files files;
  const std::string target = files.folder.file("target", "old");
  ASSERT_EQ(chown(target.c_str(), 4711, 4712), 0);
  write_all(files, target);
  struct stat status {};
  ASSERT_EQ(stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 4711U);
  EXPECT_EQ(status.st_gid, 4712U);
}

/// Runs the command as a user without rights. Requires: the caller is the superuser.
CommandResult run_as_nobody(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"--reuid=65534", "--regid=65534", "--clear-groups", WAYWRIGHT_COMMAND};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_program("setpriv", all);
}

bool can_be_nobody() {
  return geteuid() == 0 && fs::exists("/usr/bin/setpriv") && run_as_nobody({"--version"}).status == 0;
}

TEST(WrittenFiles, AreRefusedWhereTheUserMayNotWriteThem) {
  if (!can_be_nobody()) GTEST_SKIP() << "needs the superuser and setpriv";
  const Files files;
  const std::string target = files.folder.file("target", "old");
  for (const auto& [file, mode] : {std::pair{files.folder.file(""), 0777}, {files.script, 0644}, {target, 0644}}) {
    fs::permissions(file, static_cast<fs::perms>(mode));
  }
  const auto result = run_as_nobody({"run", files.script, "--dump", target});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, target + ": cannot be written: Permission denied\n");
  EXPECT_EQ(read_file(target), "old");
  fs::permissions(files.script, fs::perms::none);
  EXPECT_EQ(run_as_nobody({"run", files.script}).err, files.script + ": cannot be read: Permission denied\n");
}

// The folder accepts no new file, or a new file could not have the old file's owner. The command can still write the
// file itself.
TEST(WrittenFiles, AreOverwrittenInPlaceIfNoOtherFileCanReplaceThem) {
  if (!can_be_nobody()) GTEST_SKIP() << "needs the superuser and setpriv";
  const Files files;
  const std::string target = files.folder.file("target", std::string(5000, 'x'));
  fs::permissions(files.script, static_cast<fs::perms>(0644));
  fs::permissions(target, static_cast<fs::perms>(0666));
  for (const int folder_mode : {0755, 0777}) {
    fs::permissions(files.folder.file(""), static_cast<fs::perms>(folder_mode));
    const auto result = run_as_nobody({"run", files.script, "--dump", target});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(read_file(target), run_command({"run", files.script, "--dump", "-"}).out);
    struct stat status {};
    ASSERT_EQ(stat(target.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, geteuid());
    EXPECT_EQ(status.st_mode & 07777U, 0666U);
    EXPECT_EQ(files.folder.file_count(), files.count + 1);
  }
}

TEST(WrittenFiles, FollowLinksToTheirEnd) {
  const Files files;
  fs::create_symlink("sub/free", files.folder.file("second"));
  fs::create_symlink("second", files.folder.file("first"));
  EXPECT_EQ(run_command({"run", files.script, "--dump", files.folder.file("first")}).status, 0);
  EXPECT_TRUE(fs::is_symlink(files.folder.file("first")));
  EXPECT_TRUE(fs::is_symlink(files.folder.file("second")));
  EXPECT_EQ(read_file(files.folder.file("sub/free")).substr(0, 11), "vertices 4\n");

  fs::create_symlink("loop", files.folder.file("loop"));
  const auto result = run_command({"run", files.script, "--dump", files.folder.file("loop")});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, files.folder.file("loop") + ": cannot be written: Too many levels of symbolic links\n");
  EXPECT_TRUE(fs::is_symlink(files.folder.file("loop")));
}

TEST(WrittenFiles, MayHaveTheLongestName) {
  const Files files;
  const std::string target = files.folder.file(std::string(255, 'n'));
  EXPECT_EQ(run_command({"run", files.script, "--dump", target}).status, 0);
  EXPECT_EQ(read_file(target).substr(0, 11), "vertices 4\n");
  EXPECT_EQ(run_command({"run", files.script, "--dump", target + "n"}).err,
            target + "n: cannot be written: File name too long\n");
}

TEST(WrittenFiles, NameAFolderThatIsNotThere) {
  const Files files;
  const std::string lost = files.folder.file("lost/dump");
  EXPECT_EQ(run_command({"run", files.script, "--dump", lost}).err,
            lost + ": cannot be written: there is no folder '" + files.folder.file("lost") + "'\n");
  EXPECT_EQ(run_command({"run", files.script, "--dump", files.folder.file("sub")}).err,
            files.folder.file("sub") + ": cannot be written: Is a directory\n");
}

// Nobody reads the answers, so the run blocks when the pipe is full.
TEST(WrittenFiles, LeaveNothingBehindWhereTheRunIsKilled) {
  const Files files;
  std::string script = kFileWorld;
  for (int i = 0; i < 50000; ++i) script += "locate 1 2\n";
  const auto result = run_shell(
      "cd \"$1\"; mkfifo pipe; { \"$W\" run - --dump new <\"$2\" & echo $! >&2; wait; } 2>id >pipe & exec 3<pipe; "
      "sleep 1; "
      "kill -9 $(cat id); wait; rm id; ls",
      {files.folder.file("sub"), files.folder.file("long", script)});
  EXPECT_EQ(result.out, "pipe\n");
}

TEST(SpecialFiles, AreWrittenToDirectly) {
  const Files files;
  const auto result = run_shell(
      "cd \"$1\"; mkfifo pipe; \"$W\" run a.wws --dump pipe >out & cat pipe; wait $! || exit 9; test -p pipe; echo $?",
      {files.folder.file("")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, run_command({"run", files.script, "--dump", "-"}).out + "0\n");
  EXPECT_EQ(run_command({"run", files.script, "--dump", "/dev/null"}).status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(SpecialFiles, OpenDescriptorsKeepWhatTheyHold) {
  const Files files;
  const auto result = run_shell(
      "cd \"$1\"; echo before >three; \"$W\" run a.wws --dump /dev/fd/3 3>>three >/dev/null && head -n 2 three; "
      "echo note >err; \"$W\" run a.wws --dump /dev/stderr 2>>err >/dev/null && head -n 2 err",
      {files.folder.file("")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "before\nvertices 4\nnote\nvertices 4\n");
}

/// The file that an option writes, and what a run prints besides.
struct Written {
  std::vector<std::string> arguments;  ///< the last is the file
};

TEST(Dash, IsStandardOutputWhereAFileIsWritten) {
  const Files files;
  fs::create_symlink("/dev/stdout", files.folder.file("out.svg"));
  const std::vector<Written> all{
      {{"run", files.script, "--dump"}},
      {{"run", files.script, "--svg"}},
      {{"path", files.map, "--from", "1", "1", "--to", "2", "2", "--svg"}},
      {{"scenario", files.map, files.scenario, "--query", "1", "--svg"}},
      {{"convert", files.map, "--format", "wws"}},
      {{"convert", files.map, "--format", "svg"}},
  };
  for (const Written& written : all) {
    const auto with_file = [&](const std::string& name) {
      std::vector<std::string> arguments = written.arguments;
      arguments.push_back(name);
      return run_command(arguments);
    };
    const std::string target = files.folder.file("target");
    const auto plain = with_file(target);
    EXPECT_EQ(plain.status, 0) << plain.err;
    for (const std::string& name : {std::string("-"), std::string("/dev/stdout"), files.folder.file("out.svg")}) {
      const auto result = with_file(name);
      EXPECT_EQ(result.status, 0) << result.err;
      EXPECT_EQ(result.out, read_file(target)) << name;
      // The rest of the output goes to standard error; times differ.
      EXPECT_EQ(result.err.substr(0, 60), plain.out.substr(0, 60)) << name;
    }
  }
  EXPECT_EQ(run_command({"scenario", files.map, files.scenario, "--csv", "-"}).out.substr(0, 6), "query,");
  EXPECT_FALSE(fs::exists("-"));
}

TEST(Dash, IsAWorldScriptWhereNothingSaysOtherwise) {
  const Files files;
  EXPECT_EQ(run_command({"convert", files.map, "-"}).out, "waywright 1\ndomain 0 0 9 9\n");
}

TEST(Dash, IsAWorldScriptWhereAMapIsRead) {
  const Files files;
  EXPECT_EQ(run_command({"convert", "-", "-"}, kFileWorld).out, "waywright 1\ndomain 0 0 9 9\n");
  EXPECT_EQ(run_command({"path", "-", "--from", "1", "1", "--to", "4", "5"}, kFileWorld).out,
            run_command({"path", files.script, "--from", "1", "1", "--to", "4", "5"}).out);
  const auto result = run_command({"convert", "-", "-"}, kFileMap);
  EXPECT_EQ(result.err, "-:1: expected the header 'waywright 1', found 'type'\n");
}

TEST(Dash, WritesNothingWhereTheRunEndsEarly) {
  const auto result = run_script("waywright 1\ndomain 0 0 9 9\nremove 1\n", {"--strict", "--dump", "-"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(json_lines(result.err).at(0).at("error"), "unknown-id");
}

}  // namespace
}  // namespace waywright::test

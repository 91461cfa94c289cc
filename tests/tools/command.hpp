#pragma once

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <nlohmann/json.hpp>

#ifndef WAYWRIGHT_COMMAND
#error "the tests of the command need WAYWRIGHT_COMMAND, its file"
#endif

namespace waywright::test {

/// A folder that exists as long as its test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "waywright_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    root_ = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(root_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (root_ / name).string(); }

  /// Writes a file and returns its name.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
    return file(name);
  }

  /// Returns the number of files in the folder, for example those that a command left.
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(root_), {}));
  }

 private:
  std::filesystem::path root_;
};

inline std::string read_file(const std::string& name) {
  const std::ifstream in(name, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct CommandResult {
  int status = -1;  ///< exit status; -1 if the program did not exit by itself
  std::string out;
  std::string err;
};

/// Runs a program and stores its standard output and error in files. If `output` is not empty, standard output goes
/// there instead.
inline CommandResult run_program(const std::string& program, std::vector<std::string> arguments,
                                 const std::string& input = {}, const std::string& output = {}) {
  const TemporaryFolder folder;
  const std::string in = folder.file("in", input);
  const std::string out = output.empty() ? folder.file("out") : output;
  const std::string err = folder.file("err");
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  arguments.insert(arguments.begin(), program);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int fault = posix_spawnp(&process, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) throw std::runtime_error("cannot start " + program);
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output.empty() ? read_file(out) : std::string(),
          read_file(err)};
}

/// Runs the command as a user does.
inline CommandResult run_command(const std::vector<std::string>& arguments, const std::string& input = {},
                                 const std::string& output = {}) {
  return run_program(WAYWRIGHT_COMMAND, arguments, input, output);
}

/// Runs a line of the shell, in which "$W" is the command and "$1", "$2", ... are arguments. The line can redirect and
/// close streams that run_command cannot.
inline CommandResult run_shell(const std::string& line, std::vector<std::string> arguments = {},
                               const std::string& input = {}) {
  arguments.insert(arguments.begin(), {"-c", "W=$0; " + line, WAYWRIGHT_COMMAND});
  return run_program("sh", arguments, input);
}

/// Runs a script from standard input.
inline CommandResult run_script(const std::string& script, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"run", "-"});
  return run_command(options, script);
}

inline std::vector<nlohmann::json> json_lines(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

}  // namespace waywright::test

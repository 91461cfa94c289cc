#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "platform.hpp"

namespace waywright::command {

/// Prints one line for people on standard error. Ignores a failure to write, because there is no other channel to
/// report it. Replaces control characters, which a file name may contain.
void print_message(std::string_view line) noexcept;

/// Writes text to standard output or standard error in large pieces, and detects every failure to write.
class StreamWriter {
 public:
  /// `stream` is `output` or `error`.
  explicit StreamWriter(StandardStream stream) : stream_(stream) {}

  /// Throws Failure.
  void write_line(std::string_view line);
  /// Throws Failure.
  void write(std::string_view text);
  /// Throws Failure.
  void flush();

 private:
  StandardStream stream_;
  std::string pending_;
};

/// A file that the command writes whole or not at all. Its target is one of these:
/// - empty: no file.
/// - `-`, or another name of this process's standard output such as `/dev/stdout`: standard output.
/// - a regular file, or a name without a file: the text goes to a temporary file in the same folder. commit() gives
///   this file the target's name, permissions, owner and group. Symbolic links are followed. The file is instead
///   overwritten in place if its folder accepts no new files, or if the user cannot give a new file the same owner.
/// - a device, a pipe, an open descriptor (`/dev/fd/3`): written directly.
class OutputFile {
 public:
  /// Checks whether the target can be written, before the command does any work. Throws Failure.
  explicit OutputFile(const std::string& target);
  /// Removes the temporary file unless commit() has succeeded.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] bool wanted() const { return method_ != Method::none; }
  /// Writes the whole text of the file. Throws Failure.
  void write(std::string_view text);
  /// Moves the written text to the target. Throws Failure.
  void commit();

 private:
  enum class Method : unsigned char { none, standard_output, temporary, in_place, special };

  void choose_method_for_regular_file(bool exists);
  /// Creates the temporary file under an unused name. Returns null and sets errno if the folder accepts no new file.
  std::FILE* create_temporary();
  /// Gives the temporary file the owner, group and permissions of the target. Returns false if the user may not do so.
  [[nodiscard]] bool adopt_attributes() const;
  void remove_temporary();
  [[noreturn]] void fail(int fault) const;

  std::string name_;                 // as the user gave it
  std::filesystem::path target_;     // after following links
  std::filesystem::path temporary_;  // empty if there is none
  Method method_ = Method::none;
  std::FILE* file_ = nullptr;  // for a special file open from the start, otherwise only during writing
};

}  // namespace waywright::command

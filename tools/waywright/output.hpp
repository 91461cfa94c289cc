#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "platform.hpp"

namespace waywright::command {

/// Prints one line for people on standard error. A failure to write is ignored, since nobody is left to be told.
/// Control characters, which a file's name may hold, are replaced.
void print_message(std::string_view line) noexcept;

/// Text on standard output or standard error, written in large pieces; every failure to write is noticed.
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

/// A file that is written whole or not at all. Its target is one of these:
/// - empty: no file is wanted.
/// - `-`, or a name of this process' standard output such as `/dev/stdout`: standard output.
/// - a regular file, or a name that is free: the text goes to a temporary file in the same folder, which then takes the
///   target's name, permissions, owner and group. Symbolic links are followed. A file whose folder takes no new files,
///   or whose owner the user cannot give to a new file, is overwritten in place.
/// - a device, a pipe, an open descriptor (`/dev/fd/3`): written to directly.
class OutputFile {
 public:
  /// Finds out whether the target can be written, so that the user is told before any work. Throws Failure.
  explicit OutputFile(const std::string& target);
  /// Removes the temporary file unless committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] bool wanted() const { return way_ != Way::none; }
  /// Writes all of the file's text. Throws Failure.
  void write(std::string_view text);
  /// Puts the written text in the target's place. Throws Failure.
  void commit();

 private:
  enum class Way : unsigned char { none, standard_output, temporary, in_place, special };

  void choose_way_to_regular_file(bool exists);
  /// Creates the temporary file under a free name. Returns null, with errno set, where the folder takes none.
  std::FILE* create_temporary();
  /// Gives the temporary file what the target has. Returns false where the user may not do so.
  [[nodiscard]] bool adopt_attributes() const;
  void remove_temporary();
  [[noreturn]] void fail(int fault) const;

  std::string name_;                 // as the user gave it
  std::filesystem::path target_;     // links followed
  std::filesystem::path temporary_;  // empty while there is none
  Way way_ = Way::none;
  std::FILE* file_ = nullptr;  // open from the start for a special file, else while it is written
};

}  // namespace waywright::command

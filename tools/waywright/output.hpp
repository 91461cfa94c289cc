#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace waywright::command {

/// Standard output, written in large pieces; every failure to write is noticed.
class StandardOutput {
 public:
  /// Throws Failure.
  void write_line(std::string_view line);
  /// Throws Failure.
  void flush();

 private:
  std::string pending_;
};

/// A file that appears whole or not at all: written to a temporary beside its target, renamed at the end. A target that
/// is no regular file (a device, a pipe) is written to directly. An empty target stands for no file.
class OutputFile {
 public:
  /// Opens the temporary, so that a target that cannot be written is known before any work. Throws Failure.
  explicit OutputFile(const std::string& target);
  /// Removes the temporary unless committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] bool wanted() const { return file_ != nullptr; }
  /// Writes all of the file's text and closes it. Throws Failure.
  void write(std::string_view text);
  /// Puts the written text in the target's place. Throws Failure.
  void commit();

 private:
  void open_temporary();
  [[noreturn]] void fail(int fault) const;

  std::string name_;       // as the user gave it
  std::string target_;     // links followed
  std::string temporary_;  // empty where the target is written to directly, or after the renaming
  std::FILE* file_ = nullptr;
};

/// Whether two names mean one file. Empty names mean none.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

}  // namespace waywright::command

#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace waywright::command {

/// A line on standard error that shows the progress of long work. Prints nothing if standard error is not a terminal,
/// and nothing during the first second.
class Progress {
 public:
  explicit Progress(std::string_view what);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows that `done` of `total` steps are done.
  void show(std::size_t done, std::size_t total);
  /// Erases the line.
  void finish();

 private:
  std::string_view what_;
  bool to_terminal_ = false;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace waywright::command

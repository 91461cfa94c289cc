#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace waywright::command {

/// A line on standard error about how far long work has come; silent unless that is a terminal, and for the first
/// second.
class Progress {
 public:
  explicit Progress(std::string_view what);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So much of it is done.
  void show(std::size_t done, std::size_t total);
  /// Wipes the line.
  void finish();

 private:
  std::string_view what_;
  bool to_terminal_ = false;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace waywright::command

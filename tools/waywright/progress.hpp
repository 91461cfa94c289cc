#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace waywright::command {

/// A line on standard error about how far long work has come; silent unless that is a terminal, and for the first
/// second.
class Progress {
 public:
  Progress(std::string_view what, std::size_t total);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more step begins.
  void advance();
  /// Wipes the line.
  void finish();

 private:
  std::string_view what_;
  std::size_t total_ = 0;
  std::size_t done_ = 0;
  bool to_terminal_ = false;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace waywright::command

#include "progress.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "system.hpp"

namespace waywright::command {

namespace {

using std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1000};
constexpr std::chrono::milliseconds kInterval{200};

}  // namespace

Progress::Progress(std::string_view what)
    : what_(what), to_terminal_(is_terminal(stderr)), next_(steady_clock::now() + kPatience) {}

void Progress::show(std::size_t done, std::size_t total) {
  if (!to_terminal_ || steady_clock::now() < next_) return;
  next_ = steady_clock::now() + kInterval;
  shown_ = true;
  fmt::print(stderr, "\r{}: {} of {}", what_, done, total);
  std::fflush(stderr);
}

void Progress::finish() {
  if (!shown_) return;
  shown_ = false;
  fmt::print(stderr, "\r\x1b[K");
}

}  // namespace waywright::command

#include "progress.hpp"

#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "platform.hpp"

namespace waywright::command {

namespace {

using std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1000};
constexpr std::chrono::milliseconds kInterval{200};

/// Ignores errors: if the terminal is gone, there is nobody to inform.
void print(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string_view what)
    : what_(what), to_terminal_(error_is_terminal()), next_(steady_clock::now() + kPatience) {}

void Progress::show(std::size_t done, std::size_t total) {
  if (!to_terminal_ || steady_clock::now() < next_) return;
  next_ = steady_clock::now() + kInterval;
  shown_ = true;
  print(fmt::format("\r{}: {} of {}", what_, done, total));
}

void Progress::finish() {
  if (!shown_) return;
  shown_ = false;
  print("\r\x1b[K");
}

}  // namespace waywright::command

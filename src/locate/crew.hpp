#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <utility>
#include <vector>

#include "base/compiler.hpp"

namespace waywright::locate {

/// A piece of work that one thread does while others do something else.
using Job = std::function<void()>;

/// Who works on something large: the calling thread and, where asked for, others. What comes out never depends on it.
class Crew {
 public:
  using Report = std::function<void(std::size_t done)>;

  /// Of one.
  Crew() = default;
  /// `report`, if there is one, is called by the calling thread now and then. Requires: `threads` is 1 or more. Where
  /// the system has no threads, the calling one works alone.
  Crew(std::size_t threads, Report report) : threads_(base::kHasThreads ? threads : 1), report_(std::move(report)) {}

  [[nodiscard]] std::size_t threads() const { return threads_; }

  /// Calls work(t) for each t below threads(), on a thread each; work(0) on the calling one.
  template <class Work>
  void run(const Work& work) const {
    // Futures hand on what a thread throws. They wait for their threads when they go. Where the system has none left,
    // the calling one does the work when it asks for what has come of it.
    std::vector<std::future<void>> others;
    others.reserve(threads_ - 1);
    for (std::size_t t = 1; t < threads_; ++t) {
      others.push_back(std::async(std::launch::async | std::launch::deferred, [&work, t] { work(t); }));
    }
    work(0);
    for (std::future<void>& other : others) other.get();
  }
  /// Calls work(t, begin, end) for each t below threads(): parts of [0, count), in order, of about one size.
  template <class Work>
  void share(std::size_t count, const Work& work) const {
    run([&](std::size_t t) { work(t, start_of_share(count, t), start_of_share(count, t + 1)); });
  }

  /// Where the part of thread `t` starts in [0, count); for threads(), `count`.
  [[nodiscard]] std::size_t start_of_share(std::size_t count, std::size_t t) const {
    return static_cast<std::size_t>(std::uint64_t{count} * t / threads_);  // the product can exceed 32 bits
  }

  /// Calls work(t, i) once for each i below `count`, the lowest first, on whichever thread t has nothing to do.
  template <class Work>
  void take_turns(std::size_t count, const Work& work) const {
    std::atomic<std::size_t> next{0};
    run([&](std::size_t t) {
      for (std::size_t i = next++; i < count; i = next++) work(t, i);
    });
  }

  /// To be called by the calling thread.
  void report(std::size_t done) const {
    if (report_) report_(done);
  }

 private:
  std::size_t threads_ = 1;
  Report report_;
};

}  // namespace waywright::locate

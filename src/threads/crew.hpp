#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>

#include "waywright/job_system.hpp"

#include "base/compiler.hpp"

namespace waywright::threads {

/// A piece of work that one thread does while others do something else.
using Job = std::function<void()>;

/// Who works on something large: the calling thread and, where asked for, others, which a job system lends or which are
/// started for each run. What comes out never depends on it. The parts of a run do not wait for one another, so that
/// they may also be done one after the other on one thread.
class Crew {
 public:
  using Report = std::function<void(std::size_t done)>;

  /// Of one.
  Crew() = default;
  /// `report`, if there is one, is called now and then on the thread that makes this object. `jobs`, or null, is asked
  /// to do the work. Requires: `threads` is 1 or more. Where the system has no threads and there is no job system, the
  /// calling thread works alone.
  Crew(std::size_t threads, Report report, JobSystem* jobs = nullptr)
      : threads_(base::kHasThreads || jobs != nullptr ? threads : 1), report_(std::move(report)), jobs_(jobs) {}

  [[nodiscard]] std::size_t threads() const { return threads_; }

  /// Calls work(t) for each t below threads(), on whichever threads there are. Throws what one of the calls throws,
  /// when all have returned.
  template <class Work>
  void run(const Work& work) const {
    if (threads_ == 1) return work(0);
    run_all([&work](std::size_t t) { work(t); });
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

  /// Does nothing on another thread than the one that made this object.
  void report(std::size_t done) const {
    if (report_ && std::this_thread::get_id() == owner_) report_(done);
  }

 private:
  void run_all(const std::function<void(std::size_t)>& work) const;

  std::size_t threads_ = 1;
  Report report_;
  JobSystem* jobs_ = nullptr;  ///< or null
  std::thread::id owner_ = std::this_thread::get_id();
};

}  // namespace waywright::threads

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>

#include "waywright/job_system.hpp"

#include "base/compiler.hpp"

namespace waywright::threads {

/// A piece of work that one thread does while other threads do something else.
using Job = std::function<void()>;

/// The threads that work on a large task: the calling thread and, if the caller asks for more, threads that a job
/// system provides or that the team starts for each run. No result depends on the number of threads. The pieces of a
/// run do not wait for one another, so one thread may also do them one after the other.
class ThreadTeam {
 public:
  using Report = std::function<void(std::size_t done)>;

  /// A larger number of threads counts as this one: to start more takes longer than they save.
  static constexpr std::size_t kMostThreads = 256;

  /// A team of one thread, the calling one.
  ThreadTeam() = default;
  /// From time to time, the thread that makes this object calls `report`, if it is not empty. `jobs` does the work if
  /// it is not null. Requires: `threads` is 1 or more. If the system has no threads and `jobs` is null, the calling
  /// thread works alone.
  ThreadTeam(std::size_t threads, Report report, JobSystem* jobs = nullptr)
      : threads_(base::kHasThreads || jobs != nullptr ? std::min(threads, kMostThreads) : 1),
        report_(std::move(report)),
        jobs_(jobs) {}

  [[nodiscard]] std::size_t threads() const { return threads_; }

  /// Calls work(t) for each t below threads(), on the threads that are available. If calls throw, throws one of their
  /// exceptions after all calls have returned.
  template <class Work>
  void run(const Work& work) const {
    if (threads_ == 1) return work(0);
    run_all([&work](std::size_t t) { work(t); });
  }
  /// Calls work(t, begin, end) for each t below threads(). The ranges divide [0, count) in order and have nearly equal
  /// sizes.
  template <class Work>
  void for_each_range(std::size_t count, const Work& work) const {
    run([&](std::size_t t) { work(t, start_of_range(count, t), start_of_range(count, t + 1)); });
  }

  /// The start of the range of thread `t` in [0, count); `count` if `t` is threads().
  [[nodiscard]] std::size_t start_of_range(std::size_t count, std::size_t t) const {
    return static_cast<std::size_t>(std::uint64_t{count} * t / threads_);  // the product can exceed 32 bits
  }

  /// Calls work(t, i) once for each i below `count`, in ascending order of i, each on a thread t that is idle.
  template <class Work>
  void for_each_index(std::size_t count, const Work& work) const {
    std::atomic<std::size_t> next{0};
    run([&](std::size_t t) {
      for (std::size_t i = next++; i < count; i = next++) work(t, i);
    });
  }

  /// Calls the report of the constructor. Does nothing on a thread that has not made this object.
  void report(std::size_t done) const {
    if (report_ && std::this_thread::get_id() == owner_) report_(done);
  }

 private:
  void run_all(const std::function<void(std::size_t)>& work) const;

  std::size_t threads_ = 1;
  Report report_;
  JobSystem* jobs_ = nullptr;  ///< may be null
  std::thread::id owner_ = std::this_thread::get_id();
};

}  // namespace waywright::threads

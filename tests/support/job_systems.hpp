#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "waywright/job_system.hpp"

/// Job systems with different behaviours that JobSystem allows.
namespace waywright::test {

/// Makes all calls on the calling thread, from the first to the last or from the last to the first.
class OneThread final : public JobSystem {
 public:
  enum class Order { forwards, backwards };

  explicit OneThread(Order order) : order_(order) {}

  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    ++run_count;
    for (std::size_t i = 0; i < count; ++i) job(order_ == Order::forwards ? i : count - 1 - i);
  }

  std::size_t run_count = 0;

 private:
  Order order_;
};

/// Threads that take calls from a list. Makes no call on the calling thread.
class Pool final : public JobSystem {
 public:
  /// Calls `prepare` once on each thread.
  explicit Pool(
      std::size_t thread_count, const std::function<void()>& prepare = [] {}) {
    for (std::size_t i = 0; i < thread_count; ++i) {
      threads_.emplace_back([this, prepare] {
        prepare();
        work();
      });
    }
  }
  ~Pool() override {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    std::unique_lock lock(mutex_);
    for (std::size_t i = 0; i < count; ++i) waiting_.emplace_back(&job, i);
    open_count_ += count;
    call_count += count;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_count_ == 0; });
  }

  std::size_t call_count = 0;

 private:
  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return is_over_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      const auto [job, i] = waiting_.back();
      waiting_.pop_back();
      lock.unlock();
      (*job)(i);
      lock.lock();
      if (--open_count_ == 0) changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::pair<const std::function<void(std::size_t)>*, std::size_t>> waiting_;
  std::size_t open_count_ = 0;
  bool is_over_ = false;
  std::vector<std::thread> threads_;
};

/// Makes the calls 0, 3, 6 and so on, then the calls 2, 5, 8 and so on. Leaves the others to the library.
class Dawdler final : public JobSystem {
 public:
  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    for (std::size_t i = 0; i < count; i += 3) job(i);
    for (std::size_t i = 2; i < count; i += 3) job(i);
    if (count > 1) ++left_out;
  }

  std::size_t left_out = 0;
};

}  // namespace waywright::test

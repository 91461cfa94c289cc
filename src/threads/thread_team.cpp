#include "threads/thread_team.hpp"

#include <future>
#include <vector>

#include "base/float_environment.hpp"

namespace waywright::threads {

namespace {

/// A job system that starts new threads for each run.
class StartedThreads final : public JobSystem {
 public:
  // If the system cannot start another thread, the calling thread does that thread's work when it asks for the result.
  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    std::vector<std::future<void>> others;
    others.reserve(count - 1);
    for (std::size_t i = 1; i < count; ++i) {
      others.push_back(std::async(std::launch::async | std::launch::deferred, [&job, i] { job(i); }));
    }
    job(0);
    for (std::future<void>& other : others) other.get();
  }
};

/// The calls of one run. Several threads may ask for the same call; it is made once.
class Calls {
 public:
  Calls(std::size_t count, const std::function<void(std::size_t)>& work) : calls_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      calls_[i].task = std::packaged_task<void()>([&work, i] {
        const base::FloatEnvironment environment;
        work(i);
      });
      calls_[i].result = calls_[i].task.get_future();
    }
  }

  /// Makes call `i` unless a thread has already started it. Throws nothing: a task keeps its exception in its result.
  void make(std::size_t i) {
    if (calls_[i].is_made.exchange(1) == 0) calls_[i].task();
  }
  /// Makes the calls that no thread has started, and waits for all. If calls have thrown exceptions, throws the
  /// exception of the call with the lowest index.
  void finish() {
    for (std::size_t i = 0; i < calls_.size(); ++i) make(i);
    for (Call& call : calls_) call.result.wait();
    for (Call& call : calls_) call.result.get();
  }

 private:
  struct Call {
    std::packaged_task<void()> task;
    std::future<void> result;
    std::atomic<std::uint32_t> is_made = 0;  // not bool: some processors need a library to exchange one byte
  };

  std::vector<Call> calls_;
};

}  // namespace

void ThreadTeam::run_all(const std::function<void(std::size_t)>& work) const {
  Calls calls(threads_, work);
  const std::function<void(std::size_t)> job = [&calls](std::size_t i) { calls.make(i); };
  StartedThreads started;
  JobSystem& jobs = jobs_ != nullptr ? *jobs_ : started;
  jobs.run(threads_, job);
  calls.finish();
}

}  // namespace waywright::threads

namespace waywright {

JobSystem::~JobSystem() = default;

}  // namespace waywright

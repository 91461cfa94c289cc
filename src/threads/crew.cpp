#include "threads/crew.hpp"

#include <future>
#include <vector>

#include "base/float_environment.hpp"

namespace waywright::threads {

namespace {

/// Starts threads for each run.
class StartedThreads final : public JobSystem {
 public:
  // Where the system has no threads left, the calling thread does the work when it asks for the result.
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

/// The calls of one run: each is made once, whoever asks for it.
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

  /// Throws nothing: a task keeps what it throws for its result.
  void make(std::size_t i) {
    if (calls_[i].is_made.exchange(1) == 0) calls_[i].task();
  }
  /// Makes the calls that nobody has made. Throws what the first one that failed has thrown.
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

void Crew::run_all(const std::function<void(std::size_t)>& work) const {
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

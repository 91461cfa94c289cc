#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace waywright::python {

namespace {

constexpr std::size_t kLargestChunk = 1024;
constexpr std::size_t kChunksPerThread = 32;
constexpr std::size_t kMostThreads = 256;

/// What the threads of one batch share.
class Run {
 public:
  Run(const Batch& batch, ContextPool& contexts, const Batch::Answer& answer)
      : batch_(batch), contexts_(contexts), answer_(answer) {}

  /// Answers chunks until there is none left. `report` is called after each chunk.
  template <class Report>
  void work(const Report& report) {
    std::optional<ContextPool::Loan> context;
    while (!must_stop_) {
      const std::size_t index = next_++;
      if (index >= batch_.chunk_count()) return;
      try {
        if (!context) context.emplace(contexts_);
        answer_(**context, batch_.chunk(index));
        ++done_;
        report(done_.load());
      } catch (...) {
        keep(index, std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// Keeps the exception of the chunk with the smallest index. The chunks before it have started already, so their
  /// threads will still report a smaller index.
  void keep(std::size_t index, std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    must_stop_ = true;
    if (failure_ && index >= failed_) return;
    failed_ = index;
    failure_ = std::move(failure);
  }

  const Batch& batch_;
  ContextPool& contexts_;
  const Batch::Answer& answer_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> must_stop_ = false;
  std::mutex mutex_;
  std::size_t failed_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

Batch::Batch(std::size_t count, std::size_t threads) : count_(count), threads_(std::min(threads, kMostThreads)) {
  chunk_size_ = std::clamp(count / (threads_ * kChunksPerThread), std::size_t{1}, kLargestChunk);
  chunk_count_ = (count + chunk_size_ - 1) / chunk_size_;
}

Chunk Batch::chunk(std::size_t index) const {
  return {index, index * chunk_size_, std::min(count_, (index + 1) * chunk_size_)};
}

void Batch::run(ContextPool& contexts, Reporter& reporter, const Answer& answer) const {
  Run run(*this, contexts, answer);
  std::vector<std::thread> others;
  const std::size_t other_count = std::min(threads_, std::max(chunk_count_, std::size_t{1})) - 1;
  for (std::size_t i = 0; i < other_count; ++i) {
    try {
      others.emplace_back([&run] { run.work([](std::size_t) {}); });
    } catch (const std::system_error&) {
      break;  // fewer threads give the same answers
    }
  }
  run.work([&](std::size_t done) { reporter(done, chunk_count_ + 1); });
  for (std::thread& other : others) other.join();
  run.rethrow();
  reporter(chunk_count_ + 1, chunk_count_ + 1);
}

void refuse_query(Error error, std::size_t index) {
  error.index = index;
  error.words.element_noun = "query";
  throw BadResult(std::move(error));
}

}  // namespace waywright::python

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace waywright::bench {

namespace detail {

/// Calls `job(data, pipe)` in a child process and waits until the process ends. `result` receives the `size` bytes
/// that `job` wrote into the pipe. Returns what went wrong, or an empty text.
std::string run_in_child(void (*job)(void* data, int pipe), void* data, double seconds, void* result, std::size_t size);
void write_result(int pipe, const void* result, std::size_t size);

}  // namespace detail

/// The result of a job in a child process, or how the process ended without one.
template <class Result>
struct Outcome {
  std::optional<Result> result;
  std::string failure;
};

/// Runs `job()` in a child process with a limit of `seconds` of processor time and 4 GB of memory, for arithmetic that
/// may loop, crash or fill the memory.
template <class Job, class Result = std::invoke_result_t<Job>>
[[nodiscard]] Outcome<Result> run_in_child(double seconds, Job job) {
  static_assert(std::is_trivially_copyable_v<Result>, "a result goes through a pipe");
  const auto run = [](void* data, int pipe) {
    const Result result = (*static_cast<Job*>(data))();
    detail::write_result(pipe, &result, sizeof result);
  };
  Result result{};
  std::string failure = detail::run_in_child(run, &job, seconds, &result, sizeof result);
  if (!failure.empty()) return {std::nullopt, std::move(failure)};
  return {result, {}};
}

}  // namespace waywright::bench

#include "thesis/child_process.hpp"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace waywright::bench::detail {
namespace {

constexpr rlim_t kBytes = rlim_t{4} << 30;
constexpr int kThrew = 3;

void limit(decltype(RLIMIT_AS) resource, rlim_t most) {
  const rlimit limits = {most, most};
  setrlimit(resource, &limits);
}

std::string describe(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) return "does not end";
    return "crashes (signal " + std::to_string(signal) + ")";
  }
  return WEXITSTATUS(status) == kThrew ? "runs out of memory" : "ends too early";
}

}  // namespace

void write_result(int pipe, const void* result, std::size_t size) {
  // A pipe accepts a few words in one write. If it does not, the reader notices the missing bytes.
  if (write(pipe, result, size) != static_cast<ssize_t>(size)) _exit(1);
}

std::string run_in_child(void (*job)(void* data, int pipe), void* data, double seconds, void* result,
                         std::size_t size) {
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return "no pipe";
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return "no process";
  if (child == 0) {
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(seconds)));
    limit(RLIMIT_AS, kBytes);
    limit(RLIMIT_CORE, 0);
    std::set_terminate([] { _exit(kThrew); });
    job(data, pipe_ends[1]);
    _exit(0);
  }
  close(pipe_ends[1]);
  const bool is_whole = read(pipe_ends[0], result, size) == static_cast<ssize_t>(size);
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  const bool has_ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return is_whole && has_ended_well ? std::string() : describe(status);
}

}  // namespace waywright::bench::detail

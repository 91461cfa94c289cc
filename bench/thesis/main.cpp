#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <benchmark/benchmark.h>

#include "thesis/registers.hpp"
#include "thesis/tables.hpp"

namespace {

constexpr std::size_t kThesisTrials = 1'000'000;
constexpr std::size_t kScenes = 1000;

/// Keeps freed memory in the process. Otherwise a mesh may return its memory to the system, and the timed run must
/// request it again, page by page. Whether that happens depends on the sizes of other tables.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kMost = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, kMost);
  mallopt(M_TRIM_THRESHOLD, kMost);
#endif
}

// Benchmarks are named WORKLOAD/SIZE/CONTENDER.
int run_benchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  waywright::bench::register_location();
  waywright::bench::register_arithmetic();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace

// usage: waywright_thesis in_circle [TRIALS] | survival [SCENES] | evaluations | [BENCHMARK-ARGUMENT...]
int main(int argc, char** argv) {
  const std::string_view experiment = argc > 1 ? argv[1] : "";
  const auto count_or = [&](std::size_t usual) { return argc > 2 ? std::strtoul(argv[2], nullptr, 10) : usual; };
  if (experiment == "in_circle") {
    waywright::bench::print_in_circle_table(count_or(kThesisTrials));
    return 0;
  }
  if (experiment == "survival") {
    waywright::bench::print_survival_table(count_or(kScenes));
    return 0;
  }
  if (experiment == "evaluations") {
    waywright::bench::print_evaluations_table();
    return 0;
  }
  keep_freed_memory();
  return run_benchmarks(argc, argv);
}

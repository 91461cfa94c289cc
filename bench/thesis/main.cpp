#include <benchmark/benchmark.h>

#include "thesis/registers.hpp"

// The experiments of Chen 2009 that measure time. All are named WORKLOAD/SIZE/CONTENDER.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  waywright::bench::register_location();
  waywright::bench::register_arithmetic();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

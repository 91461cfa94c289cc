#include <string>

#include <benchmark/benchmark.h>

#include "registers.hpp"

// All benchmarks are named WORKLOAD/SIZE/CONTENDER. Those of `large/` take minutes and run only if a filter names them.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  waywright::bench::register_insertions();
  waywright::bench::register_location();
  waywright::bench::register_updates();
  waywright::bench::register_degenerate();
  waywright::bench::register_paths();
  waywright::bench::register_disc_paths();
  waywright::bench::register_many_paths();
  waywright::bench::register_abstraction();
  waywright::bench::register_maps();
  waywright::bench::register_path_watch();
  waywright::bench::register_snapshots();
  waywright::bench::register_history();
#ifdef WAYWRIGHT_BENCH_WITH_CGAL
  waywright::bench::register_cgal_points();
  waywright::bench::register_cgal_rounded();
  waywright::bench::register_cgal_exact();
#endif
  const std::string filter = benchmark::GetBenchmarkFilter();
  benchmark::RunSpecifiedBenchmarks(filter.empty() ? "-^large/" : filter);
  benchmark::Shutdown();
  return 0;
}

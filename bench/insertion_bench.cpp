#include <cstddef>
#include <string>

#include <benchmark/benchmark.h>

#include "apply_all.hpp"
#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {

void register_insertions() {
  for (const std::size_t count : kThesisPointCounts) {
    register_updates<Waywright>("thesis_points/" + std::to_string(count), "waywright",
                                [count] { return thesis_points(count); });
  }
  for (const PointSize& size : point_sizes()) {
    const std::size_t count = size.count;
    register_updates<Waywright>(size.name("random_points"), "waywright", [count] { return uniform_points(count); });
    register_updates<Waywright>(size.name("sorted_points"), "waywright", [count] { return sorted_points(count); });
    benchmark::RegisterBenchmark((size.name("bulk_points") + "/waywright").c_str(),
                                 [count](benchmark::State& state) { time_apply(state, uniform_points(count)); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  for (const PointSize& side : lattice_sides()) {
    register_updates<Waywright>(side.name("lattice"), "waywright", [side] { return lattice_points(side.count); });
  }
  register_segments<Waywright>("waywright");
}

}  // namespace waywright::bench

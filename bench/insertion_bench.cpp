#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/world.hpp"

#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

/// All insertions as one operation.
void time_apply(benchmark::State& state, const Workload& workload) {
  std::vector<Change> changes;
  for (const Update& update : workload.updates) {
    changes.push_back({Change::Kind::insert, update.inserted.id, update.inserted.shape});
  }
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      World world = World::create(workload.domain).value();
      state.ResumeTiming();
      benchmark::DoNotOptimize(world.apply(changes).value());
      state.PauseTiming();
      state.counters["vertices"] = static_cast<double>(world.vertex_count());
    }
    state.ResumeTiming();
  }
  report_time_per_operation(state, changes.size());
}

}  // namespace

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

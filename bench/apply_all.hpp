#pragma once

#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/world.hpp"

#include "harness.hpp"
#include "workloads.hpp"

namespace waywright::bench {

/// Times all of a workload's insertions as one operation of this library.
inline void time_apply(benchmark::State& state, const Workload& workload) {
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

}  // namespace waywright::bench

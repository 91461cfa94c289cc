#pragma once

#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/world.hpp"

#include "harness.hpp"
#include "workloads.hpp"

namespace waywright::bench {

/// Times a call of `insert` on a new world, without the world's destruction.
template <class Insert>
void time_at_once(benchmark::State& state, const Workload& workload, const WorldOptions& options, Insert&& insert) {
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      World world = World::create(workload.domain, options).value();
      state.ResumeTiming();
      insert(world);
      state.PauseTiming();
      state.counters["vertices"] = static_cast<double>(world.vertex_count());
    }
    state.ResumeTiming();
  }
  report_time_per_operation(state, workload.updates.size());
}

/// Times the insertion of all of the workload's items in one operation.
inline void time_items_at_once(benchmark::State& state, const Workload& workload, const WorldOptions& options) {
  std::vector<Item> items;
  for (const Update& update : workload.updates) items.push_back(update.inserted);
  time_at_once(state, workload, options,
               [&](World& world) { benchmark::DoNotOptimize(world.insert_all(items).value()); });
}

}  // namespace waywright::bench

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "workloads.hpp"

namespace waywright::bench {

/// Reports the processor time for one operation.
inline void report_time_per_operation(benchmark::State& state, std::size_t operation_count) {
  state.counters["per_op"] =
      benchmark::Counter(static_cast<double>(operation_count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Ends a benchmark without a result and says which file is missing. The benchmark library has no other method for
/// this.
inline void skip_without_data(benchmark::State& state, const std::string& file) {
  state.SkipWithError(("skipped: no real input " + file + "; set WAYWRIGHT_DATA").c_str());
}

/// Runs the workload's updates through a contender. A contender has: a constructor from the domain; insert(item) and
/// update(update); vertex_count(); fault(), empty if its mesh is correct. `is_checked` stores between repetitions
/// whether fault() was called, because fault() takes longer than many workloads.
template <class Contender>
void time_updates(benchmark::State& state, const Workload& workload, bool& is_checked) {
  std::string fault;
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      Contender contender(workload.domain);
      for (const Item& item : workload.before) contender.insert(item);
      state.ResumeTiming();
      for (const Update& update : workload.updates) contender.update(update);
      state.PauseTiming();
      state.counters["vertices"] = static_cast<double>(contender.vertex_count());
      if (!is_checked) fault = contender.fault();
      is_checked = true;
    }
    state.ResumeTiming();
  }
  if (!fault.empty()) state.SkipWithError(fault.c_str());
  report_time_per_operation(state, workload.updates.size());
}

/// Registers `WORKLOAD/CONTENDER`. `make` returns the workload. Each repetition has one iteration: a workload is long
/// enough, and starts with a new structure.
template <class Contender, class Make>
void register_updates(const std::string& workload_name, const std::string& contender_name, Make make) {
  benchmark::RegisterBenchmark((workload_name + '/' + contender_name).c_str(),
                               [make, is_checked = std::make_shared<bool>(false)](benchmark::State& state) {
                                 time_updates<Contender>(state, make(), *is_checked);
                               })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace waywright::bench

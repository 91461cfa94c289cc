#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "workloads.hpp"

namespace waywright::bench {

/// Reports the processor's time for one operation.
inline void report_time_per_operation(benchmark::State& state, std::size_t operation_count) {
  state.counters["per_op"] =
      benchmark::Counter(static_cast<double>(operation_count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Says what is missing, in the only way the library has to end a benchmark without a result.
inline void skip_without_data(benchmark::State& state, const std::string& file) {
  state.SkipWithError(("skipped: no real input " + file + "; set WAYWRIGHT_DATA").c_str());
}

/// Runs the workload's updates through a contender. A contender has: a constructor from the domain; insert(item) and
/// update(update); vertex_count(); fault(), empty when its mesh is right. `is_checked` remembers between repetitions
/// that fault() was asked: it takes longer than many a workload.
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

/// Registers `WORKLOAD/CONTENDER`. `make` gives the workload. One iteration a repetition: a workload is long enough,
/// and starts from a fresh structure.
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

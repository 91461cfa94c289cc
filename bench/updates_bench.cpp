#include <cstddef>
#include <string>

#include <benchmark/benchmark.h>

#include "waywright/mesh_snapshot.hpp"

#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

/// Returns how many edges the line y = 0 crosses between their ends.
std::size_t count_crossed(const MeshSnapshot& mesh) {
  std::size_t edges = 0;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double y = mesh.vertices[triangle[i]].y;
      const double next_y = mesh.vertices[triangle[(i + 1) % 3]].y;
      edges += (y < 0 && next_y > 0) || (y > 0 && next_y < 0) ? 1 : 0;
    }
  }
  return edges / 2;
}

/// Times the insertion of one segment and reports the time for each edge that it crosses.
void time_wall(benchmark::State& state, const Workload& workload) {
  const Item& segment = workload.updates.front().inserted;
  std::size_t crossed = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      Waywright contender(workload.domain);
      for (const Item& item : workload.before) contender.insert(item);
      crossed = count_crossed(contender.snapshot());
      state.ResumeTiming();
      contender.insert(segment);
      state.PauseTiming();
      if (const std::string fault = contender.fault(); !fault.empty()) state.SkipWithError(fault.c_str());
    }
    state.ResumeTiming();
  }
  state.counters["crossed"] = static_cast<double>(crossed);
  report_time_per_operation(state, crossed);
}

void register_walls() {
  for (const PointSize& size : point_sizes()) {
    benchmark::RegisterBenchmark((size.name("long_wall") + "/waywright").c_str(),
                                 [size](benchmark::State& state) { time_wall(state, long_wall(size.count)); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

void register_updates() {
  register_updates<Waywright>("point_removal/" + std::to_string(kRemovalCount), "waywright",
                              [] { return point_removal(kRemovalCount); });
  register_moving_square<Waywright>("waywright");
  register_moving_square<WaywrightReplace>("waywright_replace");
  register_rts<Waywright>("waywright");
  register_rts<ForPaths<Waywright>>("waywright_for_paths");
  register_walls();
}

}  // namespace waywright::bench

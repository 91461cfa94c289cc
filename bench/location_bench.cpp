#include <cstddef>
#include <string>

#include <benchmark/benchmark.h>

#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

void time_location(benchmark::State& state, const PointsToLocate& workload) {
  World world = World::create({{0.0, 0.0}, {1.0, 1.0}}, kMeshOnly).value();
  world.insert_points(workload.points).value();
  QueryContext context;
  Location location;
  for ([[maybe_unused]] const auto iteration : state) {
    for (const Point& target : workload.targets) world.locate(target, context, location).value();
  }
  report_time_per_operation(state, workload.targets.size());
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
}

}  // namespace

void register_location() {
  for (const LocationKind& kind : location_kinds()) {
    for (const PointSize& size : point_sizes()) {
      benchmark::RegisterBenchmark(
          (size.name(kind.name) + "/waywright").c_str(),
          [kind, size](benchmark::State& state) { time_location(state, kind.make(size.count)); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace waywright::bench

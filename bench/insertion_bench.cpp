#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/world.hpp"

#include "at_once.hpp"
#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

void time_points(benchmark::State& state, const Workload& workload, const WorldOptions& options, std::size_t threads) {
  std::vector<Point> points;
  for (const Update& update : workload.updates) points.push_back(update.inserted.shape.rings[0][0]);
  time_at_once(state, workload, options, [&](World& world) { world.insert_points(points, {}, {threads, {}}).value(); });
}

/// Measures wall time: the processor time would be the sum over all threads.
template <class Make>
void register_points(const std::string& name, Make make) {
  struct Contender {
    const char* name;
    WorldOptions options;
    std::size_t threads;
  };
  for (const Contender& contender : {Contender{"/waywright", kMeshOnly, 1},
                                     {"/waywright_2_threads", kMeshOnly, 2},
                                     {"/waywright_for_paths", {}, 1}}) {
    benchmark::RegisterBenchmark((name + contender.name).c_str(),
                                 [make, contender](benchmark::State& state) {
                                   time_points(state, make(), contender.options, contender.threads);
                                 })
        ->Iterations(1)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

void register_insertions() {
  for (const std::size_t count : kThesisPointCounts) {
    const std::string name = "thesis_points/" + std::to_string(count);
    register_updates<Waywright>(name, "waywright", [count] { return thesis_points(count); });
    register_updates<ForPaths<Waywright>>(name, "waywright_for_paths", [count] { return thesis_points(count); });
  }
  for (const PointSize& size : point_sizes()) {
    const std::size_t count = size.count;
    register_updates<Waywright>(size.name("random_points"), "waywright", [count] { return uniform_points(count); });
    register_updates<Waywright>(size.name("sorted_points"), "waywright", [count] { return sorted_points(count); });
    register_points(size.name("bulk_points"), [count] { return uniform_points(count); });
  }
  for (const PointSize& row : lattice_rows()) {
    register_updates<Waywright>(row.name("lattice"), "waywright", [row] { return lattice_points(row.count); });
    register_points(row.name("bulk_lattice"), [row] { return lattice_points(row.count); });
  }
  for (const PointSize& size : growing_sizes()) {
    register_points(size.name("growth"), [size] { return uniform_points(size.count); });
  }
  benchmark::RegisterBenchmark(
      ("bulk_segments/" + std::to_string(kSegmentCount) + "/waywright").c_str(),
      [](benchmark::State& state) { time_items_at_once(state, disjoint_segments(kSegmentCount), kMeshOnly); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  register_segments<Waywright>("waywright");
}

}  // namespace waywright::bench

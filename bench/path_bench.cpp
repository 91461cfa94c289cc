#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "harness.hpp"
#include "real_scenes.hpp"
#include "registers.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

struct NamedAlgorithm {
  const char* name;
  PathAlgorithm algorithm;
};
constexpr std::array<NamedAlgorithm, 3> kAlgorithms = {
    {{"ta", PathAlgorithm::ta}, {"tra", PathAlgorithm::tra}, {"optimal", PathAlgorithm::optimal}}};

struct MapQueries {
  const char* map;
  const char* queries;
};
constexpr std::array<MapQueries, 6> kMapQueries = {{
    {"grid/dao/arena.map", "grid/anyangle/arena.anyangle.scen"},
    {"grid/dao/brc202d.map", "grid/anyangle/brc202d.anyangle.scen"},
    {"grid/sc1/Aurora.map", "grid/anyangle/Aurora.anyangle.scen"},
    {"grid/bgmaps/AR0500SR.map", "grid/anyangle/AR0500SR.anyangle.scen"},
    {"grid/mazes/maze512-2-5.map", "grid/anyangle/maze512-2-5.anyangle.scen"},
    {"grid/random/random512-20-0.map", "grid/anyangle/random512-20-0.anyangle.scen"},
}};

World build(const Workload& workload) {
  World world = World::create(workload.domain).value();
  for (const Item& item : workload.before) static_cast<void>(world.insert(item.shape, item.id).value());
  for (const Update& update : workload.updates) {
    static_cast<void>(world.insert(update.inserted.shape, update.inserted.id).value());
  }
  return world;
}

/// Algorithms that this version does not carry out are left out.
bool is_supported(PathAlgorithm algorithm) {
  const World world = World::create({{0.0, 0.0}, {1.0, 1.0}}).value();
  return world.find_path({{0.25, 0.25}, {0.75, 0.75}, 0.0, algorithm}).ok();
}

/// What a series of queries found.
struct PathTotals {
  std::size_t found = 0;
  double length = 0.0;
  double shortest = 0.0;  ///< of those found, where it is known
};

/// Asks every query once with a warm context. The mean comes from the processor's time, the median from a clock around
/// each query.
void time_queries(benchmark::State& state, const World& world, const std::vector<KnownPath>& queries,
                  PathAlgorithm algorithm) {
  using Clock = std::chrono::steady_clock;
  QueryContext context;
  Path path;
  std::vector<double> times(queries.size());
  PathTotals totals;
  for ([[maybe_unused]] const auto iteration : state) {
    totals = {};
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto start = Clock::now();
      const Result<void> done = world.find_path({queries[i].start, queries[i].goal, 0.0, algorithm}, context, path);
      times[i] = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
      if (!done.ok()) return state.SkipWithError(done.error().message.c_str());
      if (path.status != PathStatus::found) continue;
      ++totals.found;
      totals.length += path.length;
      totals.shortest += queries[i].length;
    }
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  report_time_per_operation(state, queries.size());
  state.counters["median_us"] = times[times.size() / 2];
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["not_found"] = static_cast<double>(queries.size() - totals.found);
  if (totals.shortest > 0.0) state.counters["length_ratio"] = totals.length / totals.shortest;
}

void time_map_paths(benchmark::State& state, const MapQueries& files, PathAlgorithm algorithm) {
  const auto workload = read_real_scene(files.map);
  if (!workload) return skip_without_data(state, files.map);
  const auto queries = read_known_paths(files.queries);
  if (!queries) return skip_without_data(state, files.queries);
  time_queries(state, build(*workload), *queries, algorithm);
}

void time_square_paths(benchmark::State& state, std::size_t count, PathAlgorithm algorithm) {
  constexpr std::size_t kQueries = 1000;
  const Workload workload = random_squares(count);
  const std::vector<Point> ends = free_points(workload, 2 * kQueries);
  std::vector<KnownPath> queries;
  for (std::size_t i = 0; i < kQueries; ++i) queries.push_back({ends[2 * i], ends[2 * i + 1], 0.0});
  time_queries(state, build(workload), queries, algorithm);
}

}  // namespace

void register_paths() {
  for (const auto& [name, algorithm] : kAlgorithms) {
    if (!is_supported(algorithm)) continue;
    for (const std::size_t count : {100U, 500U, 2000U}) {
      const std::string full = "path_squares/" + std::to_string(count) + "/waywright_" + name;
      benchmark::RegisterBenchmark(
          full.c_str(),
          [count, algorithm = algorithm](benchmark::State& state) { time_square_paths(state, count, algorithm); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
    for (const MapQueries& files : kMapQueries) {
      const std::string map = files.map;
      const std::string full = "path/" + map.substr(map.rfind('/') + 1) + "/waywright_" + name;
      benchmark::RegisterBenchmark(
          full.c_str(),
          [files, algorithm = algorithm](benchmark::State& state) { time_map_paths(state, files, algorithm); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace waywright::bench

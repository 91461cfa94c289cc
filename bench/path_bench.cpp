#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numeric>
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
#include "world_of.hpp"

namespace waywright::bench {
namespace {

/// How a benchmark searches a path.
struct PathContender {
  const char* name;
  PathAlgorithm algorithm;
  PathBudget budget;
  double radius = 0.0;
};
constexpr std::array<PathContender, 4> kContenders = {{
    {"waywright_ta", PathAlgorithm::ta, {}},
    {"waywright_ta_proven", PathAlgorithm::ta, {.expansions = PathBudget::kNoLimit}},
    {"waywright_tra", PathAlgorithm::tra, {}},
    {"waywright_optimal", PathAlgorithm::optimal, {}},
}};

/// Discs, whose paths the benchmark measures only among squares.
constexpr std::array<PathContender, 2> kDiscs = {{
    {"waywright_tra_radius_5", PathAlgorithm::tra, {}, 5.0},
    {"waywright_tra_radius_20", PathAlgorithm::tra, {}, 20.0},
}};

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

/// The results of a series of queries.
struct PathTotals {
  std::size_t found = 0;
  double length = 0.0;
  double shortest = 0.0;  ///< of the found paths whose shortest length is known
};

PathQuery query_between(const KnownPath& ends, const PathContender& contender) {
  return {ends.start, ends.goal, {.radius = contender.radius}, contender.algorithm, contender.budget};
}

/// The timed loop repeats all queries until, by the times of the first pass, it takes this many microseconds. So
/// neither the clock's resolution nor the work before the loop affects the mean.
constexpr double kTimed = 20'000.0;

/// Makes every query once and measures each, for the median and the mean of a first search. Then makes all of them
/// inside the benchmark's timed loop.
void time_queries(benchmark::State& state, const World& world, const std::vector<KnownPath>& queries,
                  const PathContender& contender) {
  using Clock = std::chrono::steady_clock;
  QueryContext context;
  Path path;
  std::vector<double> times;
  PathTotals totals;
  for (const KnownPath& query : queries) {
    const auto start = Clock::now();
    const Result<void> done = world.find_path(query_between(query, contender), context, path);
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    if (!done.ok()) return state.SkipWithError(done.error().message().c_str());
    if (path.status != PathStatus::found) continue;
    ++totals.found;
    totals.length += path.length;
    totals.shortest += query.length;
  }
  const double once = std::accumulate(times.begin(), times.end(), 0.0);
  const auto passes = static_cast<std::size_t>(std::ceil(kTimed / once));
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t pass = 0; pass < passes; ++pass) {
      for (const KnownPath& query : queries) {
        world.find_path(query_between(query, contender), context, path).value();
        benchmark::DoNotOptimize(path.length);
      }
    }
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  report_time_per_operation(state, passes * queries.size());
  state.counters["first_median_us"] = times[times.size() / 2];
  state.counters["first_mean_us"] = once / static_cast<double>(times.size());
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["not_found"] = static_cast<double>(queries.size() - totals.found);
  if (totals.shortest > 0.0) state.counters["length_ratio"] = totals.length / totals.shortest;
}

void time_map_paths(benchmark::State& state, const MapQueries& files, const PathContender& contender) {
  const auto workload = read_real_scene(files.map);
  if (!workload) return skip_without_data(state, files.map);
  const auto queries = read_known_paths(files.queries);
  if (!queries) return skip_without_data(state, files.queries);
  time_queries(state, world_of(*workload), *queries, contender);
}

void time_square_paths(benchmark::State& state, std::size_t count, const PathContender& contender) {
  constexpr std::size_t kQueries = 1000;
  const Workload workload = random_squares(count);
  const World world = world_of(workload, {.keep_bridges = contender.radius > 0.0});
  const std::vector<Point> ends = free_points(workload, 2 * kQueries);
  std::vector<KnownPath> queries;
  const auto fits = [&](const Point& end) {
    return contender.radius == 0.0 || world.fit_disc(end, {.radius = contender.radius}).value().fits;
  };
  for (std::size_t i = 0; i < kQueries; ++i) {
    if (fits(ends[2 * i]) && fits(ends[2 * i + 1])) queries.push_back({ends[2 * i], ends[2 * i + 1], 0.0});
  }
  time_queries(state, world, queries, contender);
}

template <class Run>
void register_queries(const std::string& name, Run&& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Iterations(1)->Unit(benchmark::kMillisecond);
}

void register_square_paths(const PathContender& contender) {
  for (const std::size_t count : kPathSquares) {
    register_queries("path_squares/" + std::to_string(count) + '/' + contender.name,
                     [count, contender](benchmark::State& state) { time_square_paths(state, count, contender); });
  }
}

}  // namespace

void register_paths() {
  for (const PathContender& contender : kContenders) {
    register_square_paths(contender);
    for (const MapQueries& files : kMapQueries) {
      const std::string map = files.map;
      register_queries("path/" + map.substr(map.rfind('/') + 1) + '/' + contender.name,
                       [files, contender](benchmark::State& state) { time_map_paths(state, files, contender); });
    }
  }
  for (const PathContender& disc : kDiscs) register_square_paths(disc);
}

}  // namespace waywright::bench

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "harness.hpp"
#include "registers.hpp"
#include "workloads.hpp"
#include "world_of.hpp"

// Many paths in one call: by many threads, and from one start.

namespace waywright::bench {
namespace {

constexpr std::size_t kSquares = 2000;

/// Times searches for shortest paths between random ends. Reports the wall time and the processor time, which is the
/// sum over all threads: if it does not grow with the threads, they do not slow each other down.
void time_threads(benchmark::State& state, std::size_t threads) {
  constexpr std::size_t kQueries = 8000;
  const Workload workload = random_squares(kSquares);
  const World world = world_of(workload);
  const std::vector<Point> ends = free_points(workload, 2 * kQueries);
  std::vector<PathQuery> queries;
  for (std::size_t i = 0; i < kQueries; ++i) queries.push_back({ends[2 * i], ends[2 * i + 1]});
  std::vector<QueryContext> contexts(threads);
  std::vector<Path> paths;
  world.find_paths(queries, contexts, paths).value();  // so that the contexts have their memory
  for ([[maybe_unused]] const auto iteration : state) world.find_paths(queries, contexts, paths).value();
  report_time_per_operation(state, kQueries);
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
}

/// Times ask(world, start, goals) for some starts and the same random goals. One operation is one path.
template <class Ask>
void time_goals(benchmark::State& state, std::size_t goal_count, Ask&& ask) {
  constexpr std::size_t kStarts = 20;
  const Workload workload = random_squares(kSquares);
  const World world = world_of(workload);
  const std::vector<Point> ends = free_points(workload, kStarts + goal_count);
  const std::span<const Point> goals(ends.begin() + kStarts, ends.end());
  double length = 0.0;
  for (std::size_t i = 0; i < kStarts; ++i) length = ask(world, ends[i], goals);  // for their memory
  for ([[maybe_unused]] const auto iteration : state) {
    length = 0.0;
    for (std::size_t i = 0; i < kStarts; ++i) length += ask(world, ends[i], goals);
  }
  report_time_per_operation(state, kStarts * goal_count);
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["length"] = length;
}

/// Times World::find_paths_from.
void time_goals_at_once(benchmark::State& state, std::size_t goal_count) {
  QueryContext context;
  std::vector<Path> paths;
  time_goals(state, goal_count, [&](const World& world, const Point& start, std::span<const Point> goals) {
    world.find_paths_from({start, goals, 0.0, true}, context, paths).value();
    double length = 0.0;
    for (const Path& path : paths) length += path.length;
    return length;
  });
}

/// Times one query for each goal.
void time_goals_one_by_one(benchmark::State& state, std::size_t goal_count) {
  QueryContext context;
  Path path;
  time_goals(state, goal_count, [&](const World& world, const Point& start, std::span<const Point> goals) {
    double length = 0.0;
    for (const Point& goal : goals) {
      world.find_path({start, goal}, context, path).value();
      length += path.length;
    }
    return length;
  });
}

}  // namespace

void register_many_paths() {
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const std::string name = "find_paths/" + std::to_string(kSquares) + "/waywright";
    benchmark::RegisterBenchmark((threads == 1 ? name : name + '_' + std::to_string(threads) + "_threads").c_str(),
                                 [threads](benchmark::State& state) { time_threads(state, threads); })
        ->Iterations(1)
        ->UseRealTime()
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::size_t goals : {10U, 100U, 1000U, 10000U}) {
    const std::string name = "goals/" + std::to_string(goals) + "/waywright";
    benchmark::RegisterBenchmark(name.c_str(), time_goals_at_once, goals)->Iterations(1)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((name + "_one_by_one").c_str(), time_goals_one_by_one, goals)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace waywright::bench

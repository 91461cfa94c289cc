#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "harness.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"
#include "world_of.hpp"

namespace waywright::bench {
namespace {

/// Returns updates that each move one of the squares a little, and back when it is chosen again.
Workload square_moves(std::size_t count) {
  constexpr std::size_t kMoves = 4000;
  constexpr double kStep = 3.0;
  Workload workload = random_squares(count);
  std::vector<Item> squares = workload.before;
  std::vector<bool> has_moved(count, false);
  for (std::size_t i = 0; i < kMoves; ++i) {
    const std::size_t moving = i * 7 % count;
    const double step = has_moved[moving] ? -kStep : kStep;
    has_moved[moving] = !has_moved[moving];
    for (Point& corner : squares[moving].shape.rings[0]) corner = {corner.x + step, corner.y + step};
    workload.updates.push_back({squares[moving].id, squares[moving]});
  }
  return workload;
}

/// Times searches for paths between two halves of a world that a wall disconnects.
void time_unconnected_ends(benchmark::State& state, std::size_t count) {
  constexpr std::size_t kQueries = 1000;
  const Workload workload = random_squares(count);
  World world = world_of(workload);
  const double middle = workload.domain.max.x / 2 + 0.5;
  world.insert_segment({middle, workload.domain.min.y}, {middle, workload.domain.max.y}).value();
  std::vector<Point> left;
  std::vector<Point> right;
  for (const Point& point : free_points(workload, 4 * kQueries)) (point.x < middle ? left : right).push_back(point);
  QueryContext context;
  Path path;
  std::size_t found = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kQueries; ++i) {
      world.find_path({left[i], right[i]}, context, path).value();
      found += path.status == PathStatus::found ? 1 : 0;
    }
  }
  if (found > 0) state.SkipWithError("a path through the wall");
  report_time_per_operation(state, kQueries);
}

}  // namespace

void register_abstraction() {
  for (const std::size_t count : kPathSquares) {
    const std::string moves = "square_moves/" + std::to_string(count);
    register_updates<ForPaths<WaywrightReplace>>(moves, "waywright_replace_for_paths",
                                                 [count] { return square_moves(count); });
    register_updates<ForDiscs<WaywrightReplace>>(moves, "waywright_replace_for_discs",
                                                 [count] { return square_moves(count); });
    register_updates<WaywrightReplace>(moves, "waywright_replace", [count] { return square_moves(count); });
    benchmark::RegisterBenchmark(("no_path/" + std::to_string(count) + "/waywright").c_str(),
                                 [count](benchmark::State& state) { time_unconnected_ends(state, count); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace waywright::bench

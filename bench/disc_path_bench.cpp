#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "divided_town.hpp"
#include "harness.hpp"
#include "real_scenes.hpp"
#include "registers.hpp"
#include "timing.hpp"
#include "world_of.hpp"

// What a path of a disc costs beside the path of a point agent with the same ends, on real maps. And what it costs to
// find out that a disc cannot get through a gap, beside a path through this gap.

namespace waywright::bench {
namespace {

struct Map {
  std::string_view name;
  const char* map;
  const char* queries;
};
constexpr std::array<Map, 4> kMaps = {{
    {"arena", "grid/dao/arena.map", "grid/anyangle/arena.anyangle.scen"},
    {"brc202d", "grid/dao/brc202d.map", "grid/anyangle/brc202d.anyangle.scen"},
    {"Aurora", "grid/sc1/Aurora.map", "grid/anyangle/Aurora.anyangle.scen"},
    {"AR0500SR", "grid/bgmaps/AR0500SR.map", "grid/anyangle/AR0500SR.anyangle.scen"},
}};

struct Algorithm {
  std::string_view name;
  PathAlgorithm algorithm;
};
constexpr std::array<Algorithm, 2> kAlgorithms = {{
    {"optimal", PathAlgorithm::optimal},
    {"tra", PathAlgorithm::tra},
}};

/// In tiles of the map.
constexpr std::array<double, 5> kRadii = {0.25, 0.5, 1.0, 2.0, 4.0};

/// The disc and the point agent take turns, this many times. The shorter time of each counts.
constexpr int kPasses = 3;

/// Moves the ends of the queries, which are corners of tiles, to the centres of these tiles, where small discs fit.
void move_to_centres(std::vector<KnownPath>& queries) {
  const auto centre = [](const Point& tile) { return Point{tile.x + 0.5, tile.y + 0.5}; };
  for (KnownPath& query : queries) {
    query.start = centre(query.start);
    query.goal = centre(query.goal);
  }
}

/// Returns the queries for which the disc has a path.
std::vector<KnownPath> queries_with_path(const World& world, const std::vector<KnownPath>& queries, double radius) {
  QueryContext context;
  Path path;
  std::vector<KnownPath> found;
  for (const KnownPath& query : queries) {
    const PathQuery of_disc{query.start, query.goal, {.radius = radius}, PathAlgorithm::tra};
    world.find_path(of_disc, context, path).value();
    if (path.status == PathStatus::found) found.push_back(query);
  }
  return found;
}

/// Returns the microseconds that all queries take.
double time_queries(const World& world, const std::vector<KnownPath>& queries, double radius, PathAlgorithm algorithm,
                    QueryContext& context) {
  Path path;
  const auto start = Clock::now();
  for (const KnownPath& query : queries) {
    world.find_path({query.start, query.goal, {.radius = radius}, algorithm}, context, path).value();
    benchmark::DoNotOptimize(path.length);
  }
  return microseconds_since(start);
}

void time_disc_paths(benchmark::State& state, const Map& map, PathAlgorithm algorithm, double radius) {
  const auto workload = read_real_scene(map.map);
  if (!workload) return skip_without_data(state, map.map);
  auto queries = read_known_paths(map.queries);
  if (!queries) return skip_without_data(state, map.queries);
  move_to_centres(*queries);
  const World world = world_of(*workload, {.keep_bridges = true});
  const std::vector<KnownPath> found = queries_with_path(world, *queries, radius);
  if (found.empty()) return state.SkipWithError("the disc has no path for any query");
  QueryContext context;
  double disc = std::numeric_limits<double>::infinity();
  double point = disc;
  for ([[maybe_unused]] const auto iteration : state) {
    for (int pass = 0; pass < kPasses; ++pass) {
      disc = std::min(disc, time_queries(world, found, radius, algorithm, context));
      point = std::min(point, time_queries(world, found, 0.0, algorithm, context));
    }
  }
  const double count = static_cast<double>(found.size());
  state.counters["queries"] = count;
  state.counters["disc_us"] = disc / count;
  state.counters["point_us"] = point / count;
  state.counters["ratio"] = disc / point;
}

/// Returns the queries with this status.
std::vector<PathQuery> queries_with_status(const World& world, std::vector<PathQuery> queries, PathStatus status) {
  std::erase_if(queries, [&](const PathQuery& query) { return world.find_path(query).value().status != status; });
  return queries;
}

/// Returns the microseconds that a query takes in the mean. If `change` is true, a house moves before each query.
double time_in_town(DividedTown& town, const std::vector<PathQuery>& queries, bool change, QueryContext& context) {
  Path path;
  double sum = 0.0;
  for (const PathQuery& query : queries) {
    if (change) town.move_house();
    const auto start = Clock::now();
    town.world().find_path(query, context, path).value();
    sum += microseconds_since(start);
    benchmark::DoNotOptimize(path.length);
  }
  return sum / static_cast<double>(queries.size());
}

void time_refusals(benchmark::State& state, PathAlgorithm algorithm) {
  constexpr std::size_t kQueries = 400;
  DividedTown town;
  const auto found = queries_with_status(town.world(), town.queries(kQueries, 2.0, algorithm), PathStatus::found);
  const auto refused = queries_with_status(town.world(), town.queries(kQueries, 4.0, algorithm), PathStatus::no_path);
  QueryContext context;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 4> times{kInfinity, kInfinity, kInfinity, kInfinity};
  for ([[maybe_unused]] const auto iteration : state) {
    for (int pass = 0; pass < kPasses; ++pass) {
      times[0] = std::min(times[0], time_in_town(town, found, false, context));
      times[1] = std::min(times[1], time_in_town(town, refused, false, context));
      times[2] = std::min(times[2], time_in_town(town, found, true, context));
      times[3] = std::min(times[3], time_in_town(town, refused, true, context));
    }
  }
  state.counters["found_us"] = times[0];
  state.counters["refused_us"] = times[1];
  state.counters["found_after_change_us"] = times[2];
  state.counters["refused_after_change_us"] = times[3];
}

}  // namespace

void register_disc_paths() {
  for (const Algorithm& algorithm : kAlgorithms) {
    register_single_run("disc_path/divided_town/" + std::string(algorithm.name),
                        [algorithm](benchmark::State& state) { time_refusals(state, algorithm.algorithm); });
  }
  for (const Map& map : kMaps) {
    for (const Algorithm& algorithm : kAlgorithms) {
      for (const double radius : kRadii) {
        const std::string name = "disc_path/" + std::string(map.name) + '/' + std::string(algorithm.name) + '/' +
                                 std::to_string(radius).substr(0, 4);
        register_single_run(name, [map, algorithm, radius](benchmark::State& state) {
          time_disc_paths(state, map, algorithm.algorithm, radius);
        });
      }
    }
  }
}

}  // namespace waywright::bench

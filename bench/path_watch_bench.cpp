#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/path_watch.hpp"
#include "waywright/world.hpp"

#include "divided_town.hpp"
#include "harness.hpp"
#include "random.hpp"
#include "real_scenes.hpp"
#include "registers.hpp"
#include "timing.hpp"
#include "world_of.hpp"

// What PathWatch::update() adds to an operation, while it watches many paths on a real map.

namespace waywright::bench {
namespace {

constexpr const char* kMap = "grid/sc1/Aurora.map";
constexpr const char* kQueries = "grid/anyangle/Aurora.anyangle.scen";

/// The paths of units. The key of a path is its index.
class Units {
 public:
  /// Finds `count` paths of the map with `tra`. Every query of the map has several paths if there are too few.
  Units(const World& world, const std::vector<KnownPath>& queries, std::size_t count) : watch_(world) {
    for (std::size_t i = 0; i < count; ++i) {
      const KnownPath& query = queries[i * 7919 % queries.size()];
      queries_.push_back({query.start, query.goal, {}, PathAlgorithm::tra});
      paths_.push_back(world.find_path(queries_.back()).value());
      watch_.add(i, paths_.back());
    }
  }

  [[nodiscard]] PathWatch& watch() { return watch_; }
  void search_again(const World& world, const std::vector<std::uint64_t>& keys) {
    for (const std::uint64_t key : keys) watch_.add(key, world.find_path(queries_[key]).value());
  }
  void take_first_path(const std::vector<std::uint64_t>& keys) {
    for (const std::uint64_t key : keys) watch_.add(key, paths_[key]);
  }

 private:
  std::vector<PathQuery> queries_;
  std::vector<Path> paths_;
  PathWatch watch_;
};

/// Where the buildings appear.
enum class Where {
  at_goals,  ///< of queries, where units are
  anywhere   ///< in the domain
};

/// A building: a square of two tiles.
Shape building_at(const Point& p) { return Shape::polygon({p, p + Point{2, 0}, p + Point{2, 2}, p + Point{0, 2}}); }

void time_watch(benchmark::State& state, std::size_t count, Where where) {
  constexpr std::size_t kBuildings = 2000;
  const auto workload = read_real_scene(kMap);
  if (!workload) return skip_without_data(state, kMap);
  const auto queries = read_known_paths(kQueries);
  if (!queries) return skip_without_data(state, kQueries);
  World world = world_of(*workload);
  Units units(world, *queries, count);
  Random random{1};
  double operations_us = 0.0;
  double insertions_us = 0.0;
  double removals_us = 0.0;
  std::size_t blocked = 0;
  std::size_t too_long = 0;
  PathChanges changes;
  const Box domain = world.domain().expanded(-2.0);
  const auto position = [&]() -> Point {
    if (where == Where::at_goals) return (*queries)[random.below(queries->size())].goal;
    return domain.min + Point{domain.width() * random.unit(), domain.height() * random.unit()};
  };
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kBuildings; ++i) {
      const auto start = Clock::now();
      const ItemId id = world.insert(building_at(position())).value();
      operations_us += microseconds_since(start);
      const auto inserted = Clock::now();
      units.watch().update(world, changes);
      insertions_us += microseconds_since(inserted);
      blocked += changes.blocked.size();
      const std::vector<std::uint64_t> moved = changes.blocked;
      units.search_again(world, moved);
      const auto removal = Clock::now();
      world.remove(id).value();
      operations_us += microseconds_since(removal);
      const auto removed = Clock::now();
      units.watch().update(world, changes);
      removals_us += microseconds_since(removed);
      too_long += changes.may_be_too_long.size();
      units.take_first_path(moved);
    }
  }
  state.counters["operation_us"] = operations_us / (2 * kBuildings);
  state.counters["update_after_insertion_us"] = insertions_us / kBuildings;
  state.counters["update_after_removal_us"] = removals_us / kBuildings;
  state.counters["blocked"] = static_cast<double>(blocked) / kBuildings;
  state.counters["may_be_too_long"] = static_cast<double>(too_long) / kBuildings;
}

/// Watches paths that were not found, while houses move.
void time_refused(benchmark::State& state, std::size_t count, double radius) {
  constexpr std::size_t kMoves = 100;
  DividedTown town;
  if (radius == 0.0) town.world().insert_segment({500, 490}, {500, 510}).value();
  PathWatch watch(town.world());
  const auto queries = town.queries(count, radius, PathAlgorithm::tra);
  for (std::size_t i = 0; i < count; ++i) watch.add(i, town.world().find_path(queries[i]).value());
  PathChanges changes;
  double updates_us = 0.0;
  std::size_t named = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kMoves; ++i) {
      town.move_house();
      const auto start = Clock::now();
      watch.update(town.world(), changes);
      updates_us += microseconds_since(start);
      named += changes.may_be_too_long.size();
    }
  }
  state.counters["update_us"] = updates_us / kMoves;
  state.counters["may_be_too_long"] = static_cast<double>(named) / kMoves;
}

}  // namespace

void register_path_watch() {
  for (const double radius : {0.0, 4.0}) {
    const std::string agents = radius == 0.0 ? "points" : "discs";
    benchmark::RegisterBenchmark(("path_watch/10000/refused_" + agents).c_str(),
                                 [=](benchmark::State& state) { time_refused(state, 10'000, radius); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::size_t count : {std::size_t{1000}, std::size_t{10'000}}) {
    for (const Where where : {Where::at_goals, Where::anywhere}) {
      const std::string name = where == Where::at_goals ? "buildings_at_goals" : "buildings_anywhere";
      benchmark::RegisterBenchmark(("path_watch/" + std::to_string(count) + '/' + name).c_str(),
                                   [=](benchmark::State& state) { time_watch(state, count, where); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace waywright::bench

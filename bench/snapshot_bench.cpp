#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/change.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"
#include "waywright/world_snapshot.hpp"

#include "physical_memory.hpp"
#include "random.hpp"
#include "registers.hpp"
#include "timing.hpp"
#include "town.hpp"

// Snapshots for readers, among a million vertices: the time of World::publish() for the present and for earlier ticks,
// what snapshots cost the updates of the world, and what an update costs the readers.

namespace waywright::bench {
namespace {

constexpr std::size_t kChanges = 10;  ///< changes between two snapshots

/// Makes the changes and returns the time for each of them, in microseconds.
double time_of_moves(World& world, const std::vector<Change>& moves) {
  const auto start = Clock::now();
  for (const Change& move : moves) world.replace(move.id, move.shape).value();
  return microseconds_since(start) / static_cast<double>(moves.size());
}

void set_percentiles(benchmark::State& state, std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  state.counters["p50_us"] = times[times.size() / 2];
  state.counters["p99_us"] = times[times.size() * 99 / 100];
  state.counters["max_us"] = times.back();
}

/// What a reader does with the snapshots in time_publish().
enum class Holding {
  none,       ///< releases each before the next is made
  until_next  ///< releases each after the next is made
};

/// The changes between two snapshots in time_publish().
enum class Changes {
  moves,       ///< moves of random polygons: each removes the old shape and inserts the new one
  same_moves,  ///< moves of always the same polygons
  buildings    ///< removals of random polygons and, as often, insertions of polygons in empty squares
};

/// Makes kChanges changes in a town. `round` is the number of earlier calls.
class TownChanger {
 public:
  TownChanger(Town& town, Changes changes) : town_(town), changes_(changes), polygons_(town.random_moves(kChanges)) {
    constexpr std::size_t kEmptySquares = 1000;
    if (changes != Changes::buildings) return;
    for (std::size_t i = 0; i < kEmptySquares; ++i) town.world().apply({town.random_removal()}).value();
  }

  void run(std::size_t round) {
    for (std::size_t k = 0; k < kChanges; ++k) town_.world().apply({next(round, k)}).value();
  }

 private:
  [[nodiscard]] Change next(std::size_t round, std::size_t k) {
    switch (changes_) {
      case Changes::moves:
        return town_.random_move();
      case Changes::buildings:
        return k % 2 == 0 ? town_.random_removal() : town_.insertion();
      case Changes::same_moves:
        break;
    }
    const auto step = static_cast<double>(round % 5) / 4;
    return Change::replace(polygons_[k].id, translated(polygons_[k].shape, step, 0));
  }

  Town& town_;
  Changes changes_;
  std::vector<Change> polygons_;  ///< for Changes::same_moves
};

/// Times publish() after every kChanges changes.
void time_publish(benchmark::State& state, std::size_t vertices, Holding holding, Changes changes) {
  constexpr std::size_t kRounds = 2000;
  constexpr std::size_t kFirst = 20;  // the first snapshots are copies
  Town town(vertices);
  const World& world = town.world();
  TownChanger changer(town, changes);
  std::vector<double> times;
  WorldSnapshot held;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kRounds + kFirst; ++i) {
      changer.run(i);
      if (holding == Holding::none) held.release();
      const auto start = Clock::now();
      WorldSnapshot snapshot = town.world().publish();
      if (i >= kFirst) times.push_back(microseconds_since(start));
      held = std::move(snapshot);
    }
  }
  set_percentiles(state, times);
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["MB_world"] = static_cast<double>(world.memory().total()) * 1e-6;
  state.counters["MB_snapshot"] = static_cast<double>(held->memory().total()) * 1e-6;
}

/// Times publish() after every kChanges moves while a reader holds all snapshots. Counts the memory of each.
void time_publish_held(benchmark::State& state, std::size_t vertices) {
  constexpr std::size_t kFirst = 4;  // copies of the world: three snapshots, and the base of the others
  constexpr std::size_t kHeld = 10;
  Town town(vertices);
  TownChanger changer(town, Changes::moves);
  std::vector<WorldSnapshot> held;
  std::vector<double> times;
  std::size_t before = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kFirst + kHeld; ++i) {
      changer.run(i);
      const auto start = Clock::now();
      held.push_back(town.world().publish());
      if (i >= kFirst) times.push_back(microseconds_since(start));
      if (i + 1 == kFirst) before = physical_memory();
    }
  }
  state.counters["first_us"] = times.front();
  state.counters["last_us"] = times.back();
  state.counters["kB_each"] = static_cast<double>(physical_memory() - before) * 1e-3 / kHeld;
  state.counters["MB_world"] = static_cast<double>(town.world().memory().total()) * 1e-6;
}

/// In each round, marks a tick, makes kChanges changes, publishes the present and times the snapshot of an earlier
/// tick. Readers hold both until the next round.
void time_publish_tick(benchmark::State& state, std::size_t vertices) {
  constexpr std::size_t kRounds = 1000;
  constexpr std::size_t kTicks = 100;
  constexpr std::uint64_t kEarlier = 8;
  Town town(vertices);
  World& world = town.world();
  world.keep_history(kTicks);
  TownChanger changer(town, Changes::moves);
  std::vector<double> times;
  WorldSnapshot present;
  WorldSnapshot earlier;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kRounds + kTicks; ++i) {
      const std::uint64_t tick = world.mark();
      changer.run(i);
      present = world.publish();
      if (tick <= kEarlier) continue;
      const auto start = Clock::now();
      WorldSnapshot snapshot = world.publish(tick - kEarlier).value();
      if (i >= kTicks) times.push_back(microseconds_since(start));
      earlier = std::move(snapshot);
    }
  }
  set_percentiles(state, times);
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["MB_world"] = static_cast<double>(world.memory().total()) * 1e-6;
  state.counters["kB_each_tick"] = static_cast<double>(world.memory().history) * 1e-3 / kTicks;
}

/// Times moves without snapshots, then while a snapshot is held, then with a new snapshot after every kChanges moves.
/// Reports the medians of many short runs, which take turns.
void time_updates_beside(benchmark::State& state, std::size_t vertices) {
  constexpr std::size_t kRuns = 1000;
  Town alone(vertices);
  Town held(vertices);
  Town published(vertices);
  const WorldSnapshot first = held.world().publish();
  WorldSnapshot latest = published.world().publish();
  std::vector<double> times_alone;
  std::vector<double> times_held;
  std::vector<double> times_published;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kRuns; ++i) {
      times_alone.push_back(time_of_moves(alone.world(), alone.random_moves(kChanges)));
      times_held.push_back(time_of_moves(held.world(), held.random_moves(kChanges)));
      times_published.push_back(time_of_moves(published.world(), published.random_moves(kChanges)));
      latest = published.world().publish();
    }
  }
  state.counters["alone_us"] = median(times_alone);
  state.counters["held_us"] = median(times_held);
  state.counters["published_us"] = median(times_published);
}

/// Asks for paths until `is_over` is set. Returns the number of paths per microsecond. Takes the newest snapshot from
/// `next` after every path, if there is a new one.
class Reader {
 public:
  Reader(const Town& town, WorldSnapshot snapshot) : town_(town), snapshot_(std::move(snapshot)) {}

  [[nodiscard]] double paths_per_microsecond(std::chrono::milliseconds duration, std::atomic<WorldSnapshot*>& next) {
    const auto start = Clock::now();
    std::size_t count = 0;
    while (Clock::now() - start < duration) {
      if (next.load(std::memory_order_relaxed) != nullptr) {
        WorldSnapshot* const newer = next.exchange(nullptr);
        if (newer != nullptr) snapshot_ = std::move(*newer);
        delete newer;
      }
      snapshot_->find_path(town_.random_query(random_), context_, path_).value();
      ++count;
    }
    return static_cast<double>(count) / microseconds_since(start);
  }

 private:
  const Town& town_;
  WorldSnapshot snapshot_;
  Random random_{2};
  QueryContext context_;
  Path path_;
};

/// Counts the paths of a reader while nothing else happens, and while another thread moves polygons and publishes, with
/// a pause after each snapshot. The two take turns.
void time_readers(benchmark::State& state, std::size_t vertices, std::chrono::milliseconds pause) {
  constexpr int kSlices = 20;
  constexpr std::chrono::milliseconds kSlice{250};
  Town town(vertices);
  std::atomic<WorldSnapshot*> next = nullptr;
  Reader reader(town, town.world().publish());
  double alone = reader.paths_per_microsecond(kSlice, next);  // so that the context has its memory
  double beside = 0;
  std::size_t published = 0;
  alone = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (int i = 0; i < kSlices; ++i) {
      alone += reader.paths_per_microsecond(kSlice, next);
      std::atomic<bool> is_over = false;
      std::thread writer([&] {
        while (!is_over.load(std::memory_order_relaxed)) {
          for (std::size_t k = 0; k < kChanges; ++k) {
            const Change move = town.random_move();
            town.world().replace(move.id, move.shape).value();
          }
          delete next.exchange(new WorldSnapshot(town.world().publish()));
          ++published;
          if (pause.count() > 0) std::this_thread::sleep_for(pause);
        }
      });
      beside += reader.paths_per_microsecond(kSlice, next);
      is_over = true;
      writer.join();
    }
  }
  delete next.exchange(nullptr);
  state.counters["us_alone"] = kSlices / alone;
  state.counters["us_beside"] = kSlices / beside;
  state.counters["snapshots"] = static_cast<double>(published);
}

}  // namespace

void register_snapshots() {
  const auto add_all = [](const std::string& prefix, std::size_t vertices) {
    const std::string size = '/' + std::to_string(vertices);
    const auto add_publish = [&](const std::string& name, Holding holding, Changes changes) {
      register_single_run(prefix + "publish" + size + name,
                          [=](benchmark::State& state) { time_publish(state, vertices, holding, changes); });
    };
    add_publish("/released", Holding::none, Changes::moves);
    add_publish("/held_until_next", Holding::until_next, Changes::moves);
    add_publish("/same_polygons", Holding::until_next, Changes::same_moves);
    add_publish("/buildings", Holding::none, Changes::buildings);
    add_publish("/buildings_held_until_next", Holding::until_next, Changes::buildings);
    register_single_run(prefix + "publish_held" + size,
                        [=](benchmark::State& state) { time_publish_held(state, vertices); });
    register_single_run(prefix + "publish_tick" + size,
                        [=](benchmark::State& state) { time_publish_tick(state, vertices); });
    register_single_run(prefix + "updates_beside_snapshots" + size,
                        [=](benchmark::State& state) { time_updates_beside(state, vertices); });
    register_single_run(prefix + "readers_beside_writer" + size + "/without_pause",
                        [=](benchmark::State& state) { time_readers(state, vertices, std::chrono::milliseconds(0)); });
    register_single_run(prefix + "readers_beside_writer" + size + "/16_ms_ticks",
                        [=](benchmark::State& state) { time_readers(state, vertices, std::chrono::milliseconds(16)); });
  };
  add_all("", 100'000);
  add_all("large/", 1'000'000);
}

}  // namespace waywright::bench

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/change.hpp"
#include "waywright/save.hpp"
#include "waywright/world.hpp"

#include "random.hpp"
#include "registers.hpp"
#include "timing.hpp"
#include "town.hpp"

// Going back, trying out, saving and loading: the times of World::mark(), World::rewind() and World::attempt() beside
// the times of the changes themselves, and the time of load_world() beside the bulk load of the same items.

namespace waywright::bench {
namespace {

constexpr std::size_t kTicks = 8;
constexpr std::size_t kChangesOfTick = 10;

/// Runs the function and returns its time in microseconds.
template <class Run>
double time_of(const Run& run) {
  const auto start = Clock::now();
  run();
  return microseconds_since(start);
}

/// Plays 8 ticks of 10 moves each, and goes back to the first: the time of each mark, of all moves and of the rewind.
void time_rewind(benchmark::State& state, std::size_t vertices) {
  constexpr std::size_t kRuns = 500;
  Town town(vertices);
  World& world = town.world();
  world.keep_history(kTicks);
  std::vector<double> marks;
  std::vector<double> forward;
  std::vector<double> back;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t run = 0; run < kRuns; ++run) {
      const std::uint64_t first = world.mark();
      double moves = 0;
      for (std::size_t tick = 0; tick < kTicks; ++tick) {
        const std::vector<Change> changes = town.random_moves(kChangesOfTick);
        moves += time_of([&] {
          for (const Change& change : changes) world.replace(change.id, change.shape).value();
        });
        if (tick + 1 < kTicks) marks.push_back(time_of([&] { world.mark(); }));
      }
      forward.push_back(moves);
      back.push_back(time_of([&] { world.rewind(first).value(); }));
    }
  }
  state.counters["mark_us"] = median(marks);
  state.counters["forward_us"] = median(forward);
  state.counters["rewind_us"] = median(back);
  state.counters["ratio"] = median(back) / median(forward);
}

/// Tries moves out and then makes them: the time of attempt() with a question that returns at once, and of apply().
void time_attempt(benchmark::State& state, std::size_t vertices, std::size_t changes) {
  constexpr std::size_t kRuns = 2000;
  Town town(vertices);
  World& world = town.world();
  std::vector<double> tried;
  std::vector<double> made;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t run = 0; run < kRuns; ++run) {
      // Different places, so that neither of the two finds in the cache what the other has read.
      const std::vector<Change> to_try = town.random_moves(changes);
      const std::vector<Change> to_make = town.random_moves(changes);
      tried.push_back(time_of([&] { world.attempt(to_try, [](const World&) {}).value(); }));
      made.push_back(time_of([&] { world.apply(to_make).value(); }));
    }
  }
  state.counters["attempt_us"] = median(tried);
  state.counters["apply_us"] = median(made);
  state.counters["ratio"] = median(tried) / median(made);
}

/// Saves random points, loads them, and inserts the same points with insert_points().
void time_save(benchmark::State& state, std::size_t points) {
  constexpr std::size_t kRuns = 3;
  Random random(1);
  std::vector<Point> positions;
  for (std::size_t i = 0; i < points; ++i) positions.push_back({random.unit(), random.unit()});
  World world = World::create({{0, 0}, {1, 1}}).value();
  world.insert_points(positions).value();
  std::vector<double> saving;
  std::vector<double> loading;
  std::vector<double> inserting;
  std::size_t bytes = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t run = 0; run < kRuns; ++run) {
      std::stringstream stream;
      saving.push_back(time_of([&] { save_world(world, stream).value(); }));
      bytes = stream.view().size();
      loading.push_back(time_of([&] { load_world(stream).value(); }));
      inserting.push_back(time_of([&] {
        World other = World::create({{0, 0}, {1, 1}}).value();
        other.insert_points(positions).value();
      }));
    }
  }
  state.counters["bytes_per_point"] = static_cast<double>(bytes) / static_cast<double>(points);
  state.counters["save_ms"] = median(saving) * 1e-3;
  state.counters["load_ms"] = median(loading) * 1e-3;
  state.counters["insert_ms"] = median(inserting) * 1e-3;
  state.counters["ratio"] = median(loading) / median(inserting);
}

}  // namespace

void register_history() {
  const auto add_all = [](const std::string& prefix, std::size_t vertices) {
    const std::string size = '/' + std::to_string(vertices);
    register_single_run(prefix + "rewind" + size, [=](benchmark::State& state) { time_rewind(state, vertices); });
    for (const std::size_t changes : {std::size_t{1}, std::size_t{10}}) {
      register_single_run(prefix + "attempt" + size + '/' + std::to_string(changes),
                          [=](benchmark::State& state) { time_attempt(state, vertices, changes); });
    }
    register_single_run(prefix + "save" + size, [=](benchmark::State& state) { time_save(state, vertices); });
  };
  add_all("", 100'000);
  add_all("large/", 1'000'000);
}

}  // namespace waywright::bench

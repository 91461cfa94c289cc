#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "random.hpp"
#include "registers.hpp"

// Snapshots for readers, among a million vertices: the time of World::publish(), what snapshots cost the updates of the
// world, and what an update costs the readers.

namespace waywright::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kCell = 64;
constexpr std::size_t kChanges = 10;  ///< moves between two snapshots

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// A town: a square of cells. Every second cell contains a regular polygon of 4 to 8 corners at a random position and
/// angle. The id of a polygon is the number of its cell, plus 1.
class Town {
 public:
  explicit Town(std::size_t vertices)
      : side_(2 * static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices) / 12))) {
    const double width = kCell * static_cast<double>(side_);
    world_ = World::create({{0, 0}, {width, width}}).value();
    std::vector<Item> items;
    for (std::size_t cell = 0; cell < side_ * side_; ++cell) {
      if (is_built(cell)) items.push_back({{cell + 1}, building(cell)});
    }
    world_.insert_all(items).value();
  }

  [[nodiscard]] World& world() { return world_; }

  /// Returns the move of a random polygon within its cell.
  [[nodiscard]] Change random_move() {
    std::size_t cell = random_.below(side_ * side_);
    while (!is_built(cell)) cell = random_.below(side_ * side_);
    return Change::replace({cell + 1}, building(cell));
  }

  /// Returns a query between two cells without a polygon that are at most 16 cells apart along each axis.
  [[nodiscard]] PathQuery random_query(Random& random) const {
    const std::size_t x = random.below(side_ - 16);
    const std::size_t y = random.below(side_ - 16);
    return {.start = empty_position(x, y), .goal = empty_position(x + random.below(16), y + random.below(16))};
  }

 private:
  [[nodiscard]] bool is_built(std::size_t cell) const { return (cell % side_ + cell / side_) % 2 == 0; }
  [[nodiscard]] static Point empty_position(std::size_t x, std::size_t y) {
    return {kCell * (static_cast<double>(x + (x + y + 1) % 2) + 0.5), kCell * (static_cast<double>(y) + 0.5)};
  }
  [[nodiscard]] Shape building(std::size_t cell) {
    constexpr double kTurn = 6.283185307179586;
    const std::size_t corners = 4 + random_.below(5);
    const double radius = 8 + 16 * random_.unit();
    const double play = kCell - 2 * radius;
    const Point corner{kCell * static_cast<double>(cell % side_), kCell * static_cast<double>(cell / side_)};
    const Point centre = corner + Point{radius + play * random_.unit(), radius + play * random_.unit()};
    const double first = random_.unit();
    std::vector<Point> ring;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = kTurn * (first + static_cast<double>(i) / static_cast<double>(corners));
      ring.push_back(centre + Point{radius * std::cos(angle), radius * std::sin(angle)});
    }
    return Shape::polygon(ring);
  }

  Random random_{1};
  std::size_t side_;  ///< the number of cells along each axis
  World world_ = World::create({{0, 0}, {1, 1}}).value();
};

/// Makes the changes and returns the time for each of them, in microseconds.
double time_of_moves(World& world, const std::vector<Change>& moves) {
  const auto start = Clock::now();
  for (const Change& move : moves) world.replace(move.id, move.shape).value();
  return microseconds_since(start) / static_cast<double>(moves.size());
}

std::vector<Change> random_moves(Town& town, std::size_t count) {
  std::vector<Change> moves;
  for (std::size_t i = 0; i < count; ++i) moves.push_back(town.random_move());
  return moves;
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

/// Times publish() after every kChanges moves. Either new polygons move every time, or always the same.
void time_publish(benchmark::State& state, std::size_t vertices, Holding holding, bool are_same_polygons) {
  constexpr std::size_t kRounds = 2000;
  constexpr std::size_t kFirst = 20;  // the first snapshots are copies
  Town town(vertices);
  World& world = town.world();
  const std::vector<Change> polygons = random_moves(town, kChanges);
  std::vector<double> times;
  WorldSnapshot held;
  for ([[maybe_unused]] const auto iteration : state) {
    for (std::size_t i = 0; i < kRounds + kFirst; ++i) {
      for (std::size_t k = 0; k < kChanges; ++k) {
        if (are_same_polygons) {
          const auto step = static_cast<double>(i % 5) / 4;
          world.replace(polygons[k].id, translated(polygons[k].shape, step, 0)).value();
        } else {
          const Change move = town.random_move();
          world.replace(move.id, move.shape).value();
        }
      }
      if (holding == Holding::none) held.release();
      const auto start = Clock::now();
      WorldSnapshot snapshot = world.publish();
      if (i >= kFirst) times.push_back(microseconds_since(start));
      held = std::move(snapshot);
    }
  }
  set_percentiles(state, times);
  state.counters["vertices"] = static_cast<double>(world.vertex_count());
  state.counters["MB_world"] = static_cast<double>(world.memory().total()) * 1e-6;
  state.counters["MB_snapshot"] = static_cast<double>(held->memory().total()) * 1e-6;
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
      times_alone.push_back(time_of_moves(alone.world(), random_moves(alone, kChanges)));
      times_held.push_back(time_of_moves(held.world(), random_moves(held, kChanges)));
      times_published.push_back(time_of_moves(published.world(), random_moves(published, kChanges)));
      latest = published.world().publish();
    }
  }
  const auto median = [](std::vector<double>& times) {
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
  };
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

/// Counts the paths of a reader while nothing else happens, and while another thread moves polygons and publishes. The
/// two take turns.
void time_readers(benchmark::State& state, std::size_t vertices) {
  constexpr int kTurns = 20;
  constexpr std::chrono::milliseconds kTurn{250};
  Town town(vertices);
  std::atomic<WorldSnapshot*> next = nullptr;
  Reader reader(town, town.world().publish());
  double alone = reader.paths_per_microsecond(kTurn, next);  // so that the context has its memory
  double beside = 0;
  std::size_t published = 0;
  alone = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    for (int i = 0; i < kTurns; ++i) {
      alone += reader.paths_per_microsecond(kTurn, next);
      std::atomic<bool> is_over = false;
      std::thread writer([&] {
        while (!is_over.load(std::memory_order_relaxed)) {
          for (std::size_t k = 0; k < kChanges; ++k) {
            const Change move = town.random_move();
            town.world().replace(move.id, move.shape).value();
          }
          delete next.exchange(new WorldSnapshot(town.world().publish()));
          ++published;
        }
      });
      beside += reader.paths_per_microsecond(kTurn, next);
      is_over = true;
      writer.join();
    }
  }
  delete next.exchange(nullptr);
  state.counters["us_alone"] = kTurns / alone;
  state.counters["us_beside"] = kTurns / beside;
  state.counters["snapshots"] = static_cast<double>(published);
}

template <class Run>
void add(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Iterations(1)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_snapshots() {
  const auto add_all = [](const std::string& prefix, std::size_t vertices) {
    const std::string size = '/' + std::to_string(vertices);
    add(prefix + "publish" + size + "/released",
        [=](benchmark::State& state) { time_publish(state, vertices, Holding::none, false); });
    add(prefix + "publish" + size + "/held_until_next",
        [=](benchmark::State& state) { time_publish(state, vertices, Holding::until_next, false); });
    add(prefix + "publish" + size + "/same_polygons",
        [=](benchmark::State& state) { time_publish(state, vertices, Holding::until_next, true); });
    add(prefix + "updates_beside_snapshots" + size,
        [=](benchmark::State& state) { time_updates_beside(state, vertices); });
    add(prefix + "readers_beside_writer" + size, [=](benchmark::State& state) { time_readers(state, vertices); });
  };
  add_all("", 100'000);
  add_all("large/", 1'000'000);
}

}  // namespace waywright::bench

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "apply_all.hpp"
#include "harness.hpp"
#include "random.hpp"
#include "real_scenes.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

// Compares degenerate data with data whose predicates the filters can decide: lattices of points with random points,
// all in random order, and the obstacles of a map with as many rectangles at random positions.

namespace waywright::bench {
namespace {

constexpr const char* kMap = "grid/random/random512-20-0.map";

Workload shuffled(Workload workload) {
  Random random(300);
  std::vector<Update>& updates = workload.updates;
  for (std::size_t i = updates.size(); i > 1; --i) std::swap(updates[i - 1], updates[random.below(i)]);
  // The copy's shapes lie in memory in the order in which the benchmark reads them, as those of random points do.
  return Workload(workload);
}

/// Returns the lattice with every coordinate multiplied by `unit` and rounded.
Workload scaled_lattice(std::size_t side, double unit) {
  Workload workload = shuffled(lattice_points(side));
  workload.domain.max = {workload.domain.max.x * unit, workload.domain.max.y * unit};
  for (Update& update : workload.updates) {
    Point& point = update.inserted.shape.rings.front().front();
    point = {point.x * unit, point.y * unit};
  }
  return workload;
}

/// Returns as many rectangles as the scene has items, in its domain, each a little smaller than a square of a grid over
/// the domain. Few of them touch another.
Workload random_rectangles(const Workload& scene) {
  Random random(301);
  Workload workload{scene.domain, {}, {}};
  const Point size{scene.domain.max.x - scene.domain.min.x - 1.0, scene.domain.max.y - scene.domain.min.y - 1.0};
  for (const Update& update : scene.updates) {
    const Point low{scene.domain.min.x + size.x * random.unit(), scene.domain.min.y + size.y * random.unit()};
    const Point high{low.x + 0.1 + 0.8 * random.unit(), low.y + 0.1 + 0.8 * random.unit()};
    Item item;
    item.id = update.inserted.id;
    item.shape.kind = ItemKind::polygon;
    item.shape.rings = {{low, {high.x, low.y}, high, {low.x, high.y}}};
    workload.updates.push_back({{}, std::move(item)});
  }
  return workload;
}

/// Registers insertions one by one and in one operation.
template <class Make>
void register_points(const std::string& name, const std::string& size, Make make) {
  register_updates<Waywright>(name + size, "waywright", make);
  benchmark::RegisterBenchmark((name + "_at_once" + size + "/waywright").c_str(),
                               [make](benchmark::State& state) { time_apply(state, make()); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

/// Registers the map's obstacles, or random rectangles instead, both in random order.
void register_obstacles(const std::string& name, bool are_real) {
  benchmark::RegisterBenchmark((name + "/waywright").c_str(),
                               [are_real, is_checked = std::make_shared<bool>(false)](benchmark::State& state) {
                                 const auto scene = read_real_scene(kMap);
                                 if (!scene) return skip_without_data(state, kMap);
                                 const Workload workload = are_real ? *scene : random_rectangles(*scene);
                                 time_updates<Waywright>(state, shuffled(workload), *is_checked);
                               })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_degenerate() {
  for (const std::size_t side : {100U, 1000U}) {
    const std::string prefix = side == 100 ? "degenerate/" : "large/degenerate/";
    const std::string size = '/' + std::to_string(side * side);
    register_points(prefix + "random", size, [side] { return uniform_points(side * side); });
    register_points(prefix + "lattice", size, [side] { return scaled_lattice(side, 1.0); });
    register_points(prefix + "decimals", size, [side] { return scaled_lattice(side, 0.1); });
  }
  register_obstacles("degenerate/map", true);
  register_obstacles("degenerate/rectangles", false);
}

}  // namespace waywright::bench

#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "base/compiler.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"

/// Runs a fixed set of scripts, always the same. Prints the hashes of the worlds after every step and, at the end,
/// their meshes, some paths, and answers about discs. The output must be equal byte for byte on every machine, with
/// every compiler and at every optimisation level.
namespace waywright::test {
namespace {

constexpr std::uint64_t kScriptsOfFlavour = 40;
constexpr std::size_t kSteps = 60;
constexpr std::size_t kLiveItems = 25;

constexpr std::size_t kPaths = 4;

/// Returns all bits of a double as hexadecimal digits.
std::string bits_of(double value) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto bits = base::bit_cast<std::uint64_t>(value);
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kHex[static_cast<std::size_t>(bits >> shift & 0xf)];
  return text;
}

void print_ids(const std::vector<ItemId>& ids) {
  std::cout << " [";
  for (const ItemId id : ids) std::cout << ' ' << id.value;
  std::cout << " ]";
}

void print_path(const World& world, const PathQuery& query) {
  const Result<Path> path = world.find_path(query);
  std::cout << to_string(query.algorithm) << ' ';
  if (!path) {
    std::cout << to_string(path.error().code) << '\n';
    return;
  }
  std::cout << to_string(path->status) << ' ' << path->expansions << ' ' << bits_of(path->length) << ' '
            << bits_of(path->lower_bound);
  for (const Point& point : path->points) std::cout << ' ' << bits_of(point.x) << ' ' << bits_of(point.y);
  std::cout << '\n';
}

/// Prints positions on the path of a disc, and the path as points.
void print_walk(const Path& path, double tolerance) {
  if (path.status != PathStatus::found) return;
  for (int i = 0; i <= 16; ++i) {
    const PathPosition position = path.at(path.length * i / 16);
    const PathPosition nearest = path.nearest(position.at + tolerance * position.heading);
    for (const Point& point : {position.at, position.heading, nearest.at}) {
      std::cout << ' ' << bits_of(point.x) << ' ' << bits_of(point.y);
    }
  }
  for (const Point& point : path.polyline(tolerance).value()) {
    std::cout << ' ' << bits_of(point.x) << ' ' << bits_of(point.y);
  }
  std::cout << '\n';
}

void print_point(const Point& point) { std::cout << ' ' << bits_of(point.x) << ' ' << bits_of(point.y); }

/// Prints which items stop discs at a point, and the nearest points where these discs fit.
void print_fits(const World& world, const Point& start, const Point& goal, double extent) {
  for (const double radius : {0.0, 0x1p-8 * extent, 0x1p-5 * extent, 0x1p-3 * extent}) {
    const Result<DiscFit> fit = world.fit_disc(start, {.radius = radius});
    std::cout << "disc";
    if (!fit) std::cout << ' ' << to_string(fit.error().code);
    if (fit) print_ids(fit->items);
    for (const std::optional<Point>& wanted : {std::optional<Point>(), std::optional(goal)}) {
      const Result<NearestFit> nearest =
          world.nearest_fit({.point = start, .agent = {.radius = radius}, .goal = wanted});
      if (!nearest) continue;
      std::cout << ' ' << nearest->is_found << ' ' << bits_of(nearest->distance);
      print_point(nearest->at);
    }
    std::cout << '\n';
  }
}

/// Prints the path of a disc, and what a disc touches that moves along a segment.
void print_disc_path(const World& world, const PathQuery& query, double extent) {
  const Result<Path> path = world.find_path(query);
  if (!path) return;
  std::cout << "disc path " << to_string(path->status) << ' ' << path->expansions << ' ' << bits_of(path->length);
  for (const PathPiece& piece : path->pieces) {
    for (const double number : {piece.from.x, piece.from.y, piece.to.x, piece.to.y, piece.start_angle, piece.end_angle})
      std::cout << ' ' << bits_of(number);
  }
  std::cout << '\n';
  print_walk(*path, 0x1p-9 * extent);
  const Result<RayHit> touched = world.ray(query.start, query.goal, query.agent);
  if (!touched) return;
  std::cout << "sweep " << touched->hit;
  for (const Point& point : {touched->at, touched->contact}) print_point(point);
  print_ids(touched->items);
  std::cout << '\n';
}

/// Prints the answers of the queries about discs.
void print_discs(const World& world, const Point& start, const Point& goal, double extent) {
  print_fits(world, start, goal, extent);
  for (const double radius : {0x1p-10 * extent, 0x1p-6 * extent, 0x1p-4 * extent}) {
    for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::tra}) {
      print_disc_path(world, {.start = start, .goal = goal, .agent = {.radius = radius}, .algorithm = algorithm},
                      extent);
    }
  }
  const Result<WidestPath> widest = world.widest_path(start, goal);
  std::cout << "widest ";
  if (!widest) {
    std::cout << to_string(widest.error().code) << '\n';
    return;
  }
  std::cout << widest->is_connected << ' ' << widest->is_limited << ' ' << bits_of(widest->radius);
  for (const Point& point : {widest->from, widest->to}) print_point(point);
  print_ids(widest->from_items);
  print_ids(widest->to_items);
  std::cout << '\n';
}

/// Prints the answers of all algorithms, and of the queries about discs, for points on a grid of 64 steps over the
/// domain.
void print_paths(const World& world, const Box& domain, std::uint64_t seed) {
  Random random(seed);
  const auto between = [&](double low, double high) {
    const auto parts = static_cast<double>(random.below(65));
    return low + (high - low) / 64.0 * parts;
  };
  const auto random_point = [&] {
    const double x = between(domain.min.x, domain.max.x);
    const double y = between(domain.min.y, domain.max.y);
    return Point{x, y};
  };
  for (std::size_t i = 0; i < kPaths; ++i) {
    const Point start = random_point();
    const Point goal = random_point();
    for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::ta, PathAlgorithm::tra}) {
      print_path(world, {.start = start, .goal = goal, .algorithm = algorithm});
    }
    print_path(
        world,
        {.start = start, .goal = goal, .algorithm = PathAlgorithm::ta, .budget = {.expansions = PathBudget::kNoLimit}});
    print_discs(world, start, goal, domain.max.x - domain.min.x);
  }
}

bool print_world(Flavour flavour, std::uint64_t seed) {
  const ChangeScript script = random_changes(flavour, seed, kSteps, kLiveItems);
  Result<World> world = World::create(script.domain, {.keep_bridges = true});
  if (!world) return false;
  std::cout << "script " << to_string(flavour) << ' ' << seed << '\n';
  for (const Step& step : script.steps) {
    const Result<std::vector<ItemId>> done = perform(*world, step);
    std::cout << (done ? "done" : to_string(done.error().code)) << ' ' << to_string(world->items_hash()) << ' '
              << to_string(world->mesh_hash()) << '\n';
  }
  std::cout << world->dump();
  print_paths(*world, script.domain, seed);
  return true;
}

}  // namespace
}  // namespace waywright::test

int main() {
  for (const waywright::test::Flavour flavour : waywright::test::kFlavours) {
    for (std::uint64_t seed = 0; seed < waywright::test::kScriptsOfFlavour; ++seed) {
      if (!waywright::test::print_world(flavour, seed)) return 1;
    }
  }
  std::cout.flush();
  return std::cout.good() ? 0 : 1;
}

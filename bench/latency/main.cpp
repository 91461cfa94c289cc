#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "building.hpp"
#include "random.hpp"

namespace waywright::bench {
namespace {

constexpr double kSquare = 64;         ///< the width of a square, which contains at most one building
constexpr std::int64_t kReach = 16;    ///< the largest distance of the ends of a path, in squares, along each axis
constexpr std::size_t kPathEvery = 8;  ///< rounds between two rounds with path queries

enum class Kind : std::uint8_t {
  buildings,
  points,  ///< few buildings and many points
  discs,   ///< buildings, with bridges
  street,  ///< one row of buildings beside free space, with bridges
};

/// A town: a grid of squares, or one row of squares. Half of the squares contain a building, anywhere in its square.
class Town {
 public:
  /// Makes a town with about `vertices` vertices.
  Town(std::size_t vertices, Kind kind)
      : random_(1),
        row_length_(kind == Kind::street ? vertices / 3
                                         : row_length_of(kind == Kind::points ? vertices / 16 : vertices)),
        ids_(kind == Kind::street ? row_length_ : row_length_ * row_length_),
        corners_(ids_.size()) {
    const bool are_points = kind == Kind::points;
    const bool keeps_bridges = kind == Kind::discs || kind == Kind::street;
    const double margin = keeps_bridges ? 2 * kSquare : 0;
    const double width = kSquare * static_cast<double>(row_length_);
    const double height = kSquare * static_cast<double>(ids_.size() / row_length_);
    world_ =
        World::create({{-margin, -margin}, {width + margin, height + margin}}, {.keep_bridges = keeps_bridges}).value();
    std::vector<Item> items;
    for (std::size_t square = 0; square < ids_.size(); ++square) free_.push_back(square);
    while (built_.size() < ids_.size() / 2) built_.push_back(take(free_));
    for (const std::size_t square : built_) {
      corners_[square] = random_.below(2) == 0 ? 4 : 8;
      ids_[square] = {++last_id_};
      items.push_back({ids_[square], building(square, corners_[square])});
    }
    world_.insert_all(items).value();
    std::vector<Point> points;
    while (are_points && world_.vertex_count() + points.size() < vertices) points.push_back(anywhere());
    if (!points.empty()) last_id_ = world_.insert_points(points).value().value + points.size() - 1;
  }

  [[nodiscard]] std::size_t vertex_count() const { return world_.vertex_count(); }

  /// Performs each kind of update and query once, and prints the time of each. The number of buildings does not change.
  void run_round(std::size_t round) {
    insert("insert a building, 4 corners", 4);
    insert("insert a building, 8 corners", 8);
    for (int i = 0; i < 2; ++i) {
      const std::size_t square = take(built_);
      const ItemId id = std::exchange(ids_[square], {});
      time("remove a building", [&] { world_.remove(id).value(); });
      free_.push_back(square);
    }
    const std::size_t square = built_[random_.below(built_.size())];
    const Shape moved = building(square, corners_[square]);
    time("move a building", [&] { world_.replace(ids_[square], moved).value(); });
    const Point point = anywhere();
    time("locate a point", [&] { world_.locate(point, context_, location_).value(); });
    if (round % kPathEvery != 0) return;
    PathQuery query;
    query.start = position_in(free_[random_.below(free_.size())]);
    query.goal = goal_near(query.start);
    query.algorithm = PathAlgorithm::tra;
    time("find a path, tra", [&] { world_.find_path(query, context_, path_).value(); });
    query.algorithm = PathAlgorithm::optimal;
    time("find a path, optimal", [&] { world_.find_path(query, context_, path_).value(); });
  }

 private:
  /// The number of squares along each axis: half of the squares have a building with 6 corners on average.
  static std::size_t row_length_of(std::size_t vertices) {
    return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(vertices) / 3)));
  }

  /// Prints the time, and by how many bytes the operation has changed the memory of the world and the memory of its
  /// sectors.
  template <class Run>
  void time(const char* what, const Run& run) {
    const MemoryUse before = world_.memory();
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::nanoseconds elapsed = std::chrono::steady_clock::now() - start;
    const MemoryUse after = world_.memory();
    const auto difference = [](std::size_t old, std::size_t now) {
      return static_cast<double>(now) - static_cast<double>(old);
    };
    std::printf("%s\t%lld\t%.0f\t%.0f\n", what, static_cast<long long>(elapsed.count()),
                difference(before.total(), after.total()), difference(before.sectors, after.sectors));
  }

  void insert(const char* what, std::size_t corners) {
    const std::size_t square = take(free_);
    const Shape shape = building(square, corners);
    ids_[square] = {++last_id_};
    corners_[square] = corners;
    time(what, [&] { world_.insert(shape, ids_[square]).value(); });
    built_.push_back(square);
  }

  /// Takes a random square out of a list.
  std::size_t take(std::vector<std::size_t>& squares) {
    std::swap(squares[random_.below(squares.size())], squares.back());
    const std::size_t square = squares.back();
    squares.pop_back();
    return square;
  }

  [[nodiscard]] Point corner_of(std::size_t square) const {
    return {kSquare * static_cast<double>(square % row_length_), kSquare * static_cast<double>(square / row_length_)};
  }
  [[nodiscard]] Point anywhere() {
    const double width = kSquare * static_cast<double>(row_length_);
    const double height = kSquare * static_cast<double>(ids_.size() / row_length_);
    const double x = width * random_.unit();
    return {x, height * random_.unit()};
  }
  [[nodiscard]] Point position_in(std::size_t square) {
    return corner_of(square) + Point{kSquare * random_.unit(), kSquare * random_.unit()};
  }
  /// Returns a regular polygon at a random position and angle in the square.
  [[nodiscard]] Shape building(std::size_t square, std::size_t corners) {
    return random_building(random_, corner_of(square), kSquare, corners);
  }

  /// Returns a position in a free square at most kReach squares from the start, along each axis.
  [[nodiscard]] Point goal_near(const Point& start) {
    const auto row_length = static_cast<std::int64_t>(row_length_);
    for (;;) {
      const auto x = static_cast<std::int64_t>(start.x / kSquare) +
                     static_cast<std::int64_t>(random_.below(2 * kReach + 1)) - kReach;
      const auto y = static_cast<std::int64_t>(start.y / kSquare) +
                     static_cast<std::int64_t>(random_.below(2 * kReach + 1)) - kReach;
      if (x < 0 || y < 0 || x >= row_length || y >= static_cast<std::int64_t>(ids_.size()) / row_length) continue;
      const auto square = static_cast<std::size_t>(y * row_length + x);
      if (ids_[square].is_null()) return position_in(square);
    }
  }

  Random random_;
  std::size_t row_length_;                 ///< the number of squares along each axis
  std::vector<ItemId> ids_;                ///< by square: of its building, or null
  std::vector<std::size_t> corners_;       ///< by square: of its building
  std::vector<std::size_t> free_, built_;  ///< squares
  std::uint64_t last_id_ = 0;
  World world_ = World::create({{0, 0}, {1, 1}}).value();
  QueryContext context_;
  Location location_;
  Path path_;
};

}  // namespace
}  // namespace waywright::bench

// usage: waywright_latency buildings|points|discs|street VERTICES ROUNDS
// Prints the number of vertices, and then a line for each update or query: its name, its time in nanoseconds, and by
// how many bytes it has changed the memory of the world and of its sectors.
int main(int argc, char** argv) {
  constexpr std::array<std::string_view, 4> kNames = {"buildings", "points", "discs", "street"};
  const auto* const name = std::find(kNames.begin(), kNames.end(), argc == 4 ? argv[1] : "");
  if (name == kNames.end()) {
    std::fputs("usage: waywright_latency buildings|points|discs|street VERTICES ROUNDS\n", stderr);
    return 2;
  }
  const auto kind = static_cast<waywright::bench::Kind>(name - kNames.begin());
  waywright::bench::Town town(std::strtoull(argv[2], nullptr, 10), kind);
  const std::size_t rounds = std::strtoull(argv[3], nullptr, 10);
  std::printf("%zu\n", town.vertex_count());
  for (std::size_t i = 0; i < rounds; ++i) town.run_round(i);
}

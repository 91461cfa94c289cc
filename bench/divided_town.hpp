#pragma once

#include <cstddef>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "random.hpp"

namespace waywright::bench {

/// A town of 200 houses on both sides of a wall with one gap of width 6. Discs with a radius of at most 3 get through.
class DividedTown {
 public:
  static constexpr double kLargestRadius = 3.0;

  DividedTown() : world_(World::create({{0, 0}, {kWidth, kWidth}}, {.keep_bridges = true}).value()) {
    std::vector<Item> items;
    items.push_back({{1}, Shape::segment({kWall, 0}, {kWall, 495})});
    items.push_back({{2}, Shape::segment({kWall, 501}, {kWall, kWidth})});
    for (std::size_t square = 0; square < kRows * kRows; ++square) {
      if ((square + square / kRows) % 2 == 0) items.push_back({house(square), house_in(square)});
    }
    world_.insert_all(items).value();
  }

  [[nodiscard]] World& world() { return world_; }
  /// Returns queries across the wall.
  [[nodiscard]] std::vector<PathQuery> queries(std::size_t count, double radius, PathAlgorithm algorithm) {
    std::vector<PathQuery> queries;
    for (std::size_t i = 0; i < count; ++i) {
      const bool starts_left = random_.below(2) == 0;
      const Point start = point(starts_left);
      queries.push_back(
          {.start = start, .goal = point(!starts_left), .agent = {.radius = radius}, .algorithm = algorithm});
    }
    return queries;
  }
  /// Moves a random house within its square.
  void move_house() {
    std::size_t square = random_.below(kRows * kRows);
    while (!world_.contains(house(square))) square = random_.below(kRows * kRows);
    world_.replace(house(square), house_in(square)).value();
  }

 private:
  static constexpr double kWidth = 1000;
  static constexpr double kWall = 500;
  static constexpr std::size_t kRows = 20;
  static constexpr double kSquare = kWidth / static_cast<double>(kRows);

  [[nodiscard]] static ItemId house(std::size_t square) { return {square + 3}; }
  [[nodiscard]] Shape house_in(std::size_t square) {
    const Point at{static_cast<double>(square % kRows) * kSquare + random_.between(2, 17),
                   static_cast<double>(square / kRows) * kSquare + random_.between(2, 17)};
    return Shape::rectangle({at, at + Point{random_.between(5, 20), random_.between(5, 20)}});
  }
  [[nodiscard]] Point point(bool is_left) {
    const double x = random_.between(10, 490);
    return {is_left ? x : kWall + x, random_.between(10, 990)};
  }

  World world_;
  Random random_{1};
};

}  // namespace waywright::bench

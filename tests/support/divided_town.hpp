#pragma once

#include <cstddef>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "support/random.hpp"

namespace waywright::test {

/// A town of houses on both sides of a wall with one gap of width 6. Discs with a radius of at most 3 get through.
class DividedTown {
 public:
  static constexpr double kWidth = 1000;
  static constexpr double kGap = 6;
  static constexpr double kWall = 500;
  static constexpr std::size_t kRows = 20;  ///< the town has kRows * kRows squares, with at most one house each

  explicit DividedTown(std::uint64_t seed, WorldOptions options = {.keep_bridges = true})
      : world(World::create({{0, 0}, {kWidth, kWidth}}, options).value()), random(seed) {
    world.insert_segment({kWall, 0}, {kWall, 495}, 1).value();
    world.insert_segment({kWall, 495 + kGap}, {kWall, kWidth}, 2).value();
    for (std::size_t square = 0; square < kRows * kRows; square += 2) build(square);
  }

  /// The id of the house in a square.
  [[nodiscard]] static ItemId house(std::size_t square) { return {square + 3}; }
  [[nodiscard]] bool is_built(std::size_t square) const { return world.contains(house(square)); }
  void build(std::size_t square) {
    constexpr double kSquare = kWidth / kRows;
    const auto unit = [&] { return static_cast<double>(random.below(16)); };
    const Point at{static_cast<double>(square % kRows) * kSquare + 2 + unit(),
                   static_cast<double>(square / kRows) * kSquare + 2 + unit()};
    world.insert(Shape::rectangle({at, at + Point{5 + unit(), 5 + unit()}}), house(square)).value();
  }
  /// Builds a house in a random square, or removes the house there. Returns whether it has removed a house.
  bool change() {
    const std::size_t square = random.below(kRows * kRows);
    const bool was_built = is_built(square);
    if (was_built) {
      world.remove(house(square)).value();
    } else {
      build(square);
    }
    return was_built;
  }
  /// Returns a random position on the left or on the right of the wall.
  [[nodiscard]] Point point(bool is_left) {
    const double x = static_cast<double>(10 + random.below(480));
    return {is_left ? x : kWall + x, static_cast<double>(10 + random.below(980))};
  }
  /// Returns a query across the wall.
  [[nodiscard]] PathQuery query(double radius, PathAlgorithm algorithm = PathAlgorithm::optimal) {
    const bool starts_left = random.chance(50);
    const Point start = point(starts_left);
    return {.start = start, .goal = point(!starts_left), .agent = {.radius = radius}, .algorithm = algorithm};
  }

  World world;
  Random random;
};

}  // namespace waywright::test

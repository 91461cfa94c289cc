#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "waywright/change.hpp"
#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "building.hpp"
#include "random.hpp"

namespace waywright::bench {

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

  [[nodiscard]] std::vector<Change> random_moves(std::size_t count) {
    std::vector<Change> moves;
    for (std::size_t i = 0; i < count; ++i) moves.push_back(random_move());
    return moves;
  }

  /// Returns a query between two cells without a polygon that are at most 16 cells apart along each axis.
  [[nodiscard]] PathQuery random_query(Random& random) const {
    const std::size_t x = random.below(side_ - 16);
    const std::size_t y = random.below(side_ - 16);
    return {.start = empty_position(x, y), .goal = empty_position(x + random.below(16), y + random.below(16))};
  }

 private:
  static constexpr double kCell = 64;

  [[nodiscard]] bool is_built(std::size_t cell) const { return (cell % side_ + cell / side_) % 2 == 0; }
  [[nodiscard]] static Point empty_position(std::size_t x, std::size_t y) {
    return {kCell * (static_cast<double>(x + (x + y + 1) % 2) + 0.5), kCell * (static_cast<double>(y) + 0.5)};
  }
  [[nodiscard]] Shape building(std::size_t cell) {
    const std::size_t corners = 4 + random_.below(5);
    const Point corner{kCell * static_cast<double>(cell % side_), kCell * static_cast<double>(cell / side_)};
    return random_building(random_, corner, kCell, corners);
  }

  Random random_{1};
  std::size_t side_;  ///< the number of cells along each axis
  World world_ = World::create({{0, 0}, {1, 1}}).value();
};

}  // namespace waywright::bench

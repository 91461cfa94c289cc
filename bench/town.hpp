#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

#include "waywright/change.hpp"
#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "building.hpp"
#include "random.hpp"

namespace waywright::bench {

/// A town: a grid of squares. Every second square contains a regular polygon of 4 to 8 corners at a random position and
/// angle. The id of a polygon is the number of its square, plus 1.
class Town {
 public:
  explicit Town(std::size_t vertices)
      : row_length_(2 * static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices) / 12))) {
    const double width = kSquare * static_cast<double>(row_length_);
    world_ = World::create({{0, 0}, {width, width}}).value();
    std::vector<Item> items;
    for (std::size_t square = 0; square < row_length_ * row_length_; ++square) {
      if (is_built(square)) items.push_back({{square + 1}, building(square)});
    }
    world_.insert_all(items).value();
  }

  [[nodiscard]] World& world() { return world_; }

  /// Returns the move of a random polygon within its square.
  [[nodiscard]] Change random_move() {
    std::size_t square = random_.below(row_length_ * row_length_);
    while (!is_built(square)) square = random_.below(row_length_ * row_length_);
    return Change::replace({square + 1}, building(square));
  }

  /// Returns the removal of a random polygon. Make the change before the next call.
  [[nodiscard]] Change random_removal() {
    std::size_t square = random_.below(row_length_ * row_length_);
    while (!world_.contains({square + 1})) square = random_.below(row_length_ * row_length_);
    empty_squares_.push_back(square);
    return Change::remove({square + 1});
  }

  /// Returns the insertion of a polygon in the square that has been empty for the longest time since random_removal().
  [[nodiscard]] Change insertion() {
    const std::size_t square = empty_squares_.front();
    empty_squares_.pop_front();
    return Change::insert(building(square), {square + 1});
  }

  [[nodiscard]] std::vector<Change> random_moves(std::size_t count) {
    std::vector<Change> moves;
    for (std::size_t i = 0; i < count; ++i) moves.push_back(random_move());
    return moves;
  }

  /// Returns a query between two squares without a polygon that are at most 16 squares apart along each axis.
  [[nodiscard]] PathQuery random_query(Random& random) const {
    const std::size_t x = random.below(row_length_ - 16);
    const std::size_t y = random.below(row_length_ - 16);
    return {.start = empty_position(x, y), .goal = empty_position(x + random.below(16), y + random.below(16))};
  }

 private:
  static constexpr double kSquare = 64;

  [[nodiscard]] bool is_built(std::size_t square) const {
    return (square % row_length_ + square / row_length_) % 2 == 0;
  }
  [[nodiscard]] static Point empty_position(std::size_t x, std::size_t y) {
    return {kSquare * (static_cast<double>(x + (x + y + 1) % 2) + 0.5), kSquare * (static_cast<double>(y) + 0.5)};
  }
  [[nodiscard]] Shape building(std::size_t square) {
    const std::size_t corners = 4 + random_.below(5);
    const Point corner{kSquare * static_cast<double>(square % row_length_),
                       kSquare * static_cast<double>(square / row_length_)};
    return random_building(random_, corner, kSquare, corners);
  }

  Random random_{1};
  std::size_t row_length_;                 ///< the number of squares along each axis
  std::deque<std::size_t> empty_squares_;  ///< the squares of removed polygons, in the order of the removals
  World world_ = World::create({{0, 0}, {1, 1}}).value();
};

}  // namespace waywright::bench

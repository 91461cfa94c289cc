#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "threads/crew.hpp"

namespace waywright::locate {

/// A box in Morton's order: a point's key is its place in a grid of 2^32 x 2^32 square cells, the bits of x and y in
/// turn, the highest bit that of x. Points whose keys agree down to some bit lie in one axis-parallel rectangle, which
/// the next bit halves; so every run of sorted keys is parted by straight lines.
///
/// Rounding is monotone: of two points with different cells in x, the one with the lower cell has the lower x.
/// Source: Morton, *A computer oriented geodetic data base and a new technique in file sequencing*, 1966.
class Curve {
 public:
  using Key = std::uint64_t;

  explicit Curve(const Box& box)
      : min_(box.min), scale_(kCells / std::max(box.max.x - box.min.x, box.max.y - box.min.y)) {}

  /// Requires: `point` lies in the box.
  [[nodiscard]] Key key(const Point& point) const {
    return spread(cell(point.x, min_.x)) << 1 | spread(cell(point.y, min_.y));
  }
  /// A squared distance in cells.
  [[nodiscard]] double squared_cells(double squared_distance) const { return squared_distance * scale_ * scale_; }
  /// Whether the bit halves by x, or else by y.
  [[nodiscard]] static bool is_bit_of_x(int bit) { return bit % 2 == 1; }

 private:
  static constexpr double kCells = 0x1p32;

  [[nodiscard]] std::uint64_t cell(double at, double from) const {
    const double cell = std::min((at - from) * scale_, kCells - 1.0);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell));  // processors convert to signed numbers
  }
  /// Puts a zero before each of the lower 32 bits.
  [[nodiscard]] static std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits << 2) & 0x3333333333333333u;
    return (bits | bits << 1) & 0x5555555555555555u;
  }

  Point min_;
  double scale_;
};

/// Points along a curve, each once.
struct SortedPoints {
  std::vector<Point> points;         ///< distinct, by key; those of one key in (x, y) order; with room for one more
  std::vector<Curve::Key> keys;      ///< of each
  std::vector<std::uint32_t> ranks;  ///< of each point as it was given: where it is now
};

/// Requires: the points lie in the box, and none has a coordinate of -0. Cost: linear where keys are spread evenly,
/// O(n log n) at most.
[[nodiscard]] SortedPoints sort_along_curve(const Box& box, std::span<const Point> points,
                                            const threads::Crew& crew = {});

}  // namespace waywright::locate

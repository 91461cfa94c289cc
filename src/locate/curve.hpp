#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "memory/array.hpp"
#include "threads/thread_team.hpp"

namespace waywright::locate {

/// The Morton order of the points of a box. The box has a grid of 2^32 x 2^32 squares. The key of a point names
/// its square: its bits come alternately from the square's x and from its y, and the highest bit comes from x. If the
/// keys of some points agree in all bits above a certain bit, the points lie in one axis-parallel rectangle, and this
/// bit says in which half of the rectangle a point lies. So if this bit divides a range of sorted keys into two, a
/// straight line divides their points in the same way.
///
/// Rounding is monotone: if the squares of two points differ in x, the point in the lower square has the lower x.
/// Source: Morton, *A computer oriented geodetic data base and a new technique in file sequencing*, 1966.
class Curve {
 public:
  using Key = std::uint64_t;

  explicit Curve(const Box& box)
      : min_(box.min), scale_(kSquares / std::max(box.max.x - box.min.x, box.max.y - box.min.y)) {}

  /// The key of a point. Requires: `point` lies in the box.
  [[nodiscard]] Key key(const Point& point) const {
    return spread(to_grid(point.x, min_.x)) << 1 | spread(to_grid(point.y, min_.y));
  }
  /// A box around the square of a key. It is a little larger than the square, because the square of a point is rounded.
  [[nodiscard]] Box box_of(Key key) const {
    const double x = static_cast<double>(gather(key >> 1));
    const double y = static_cast<double>(gather(key));
    constexpr double kMargin = 1.0 / 64;
    return {{min_.x + (x - kMargin) / scale_, min_.y + (y - kMargin) / scale_},
            {min_.x + (x + 1.0 + kMargin) / scale_, min_.y + (y + 1.0 + kMargin) / scale_}};
  }
  /// The key of the square nearest to a point, which may lie outside the box.
  [[nodiscard]] Key nearest_key(const Point& point) const {
    return key({std::max(point.x, min_.x), std::max(point.y, min_.y)});
  }
  /// Converts a squared distance to multiples of the squared width of a square of the grid.
  [[nodiscard]] double in_squared_widths(double squared_distance) const { return squared_distance * scale_ * scale_; }
  /// Whether the bit of a key comes from x; otherwise it comes from y.
  [[nodiscard]] static bool is_bit_of_x(int bit) { return bit % 2 == 1; }

 private:
  static constexpr double kSquares = 0x1p32;

  [[nodiscard]] std::uint64_t to_grid(double at, double from) const {
    const double grid = std::min((at - from) * scale_, kSquares - 1.0);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(grid));  // processors convert only to signed integers
  }
  /// Puts a 0 before each of the lower 32 bits.
  [[nodiscard]] static std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits << 2) & 0x3333333333333333u;
    return (bits | bits << 1) & 0x5555555555555555u;
  }

  /// The inverse of spread(). Ignores the bits at odd positions.
  [[nodiscard]] static std::uint64_t gather(std::uint64_t bits) {
    bits &= 0x5555555555555555u;
    bits = (bits | bits >> 1) & 0x3333333333333333u;
    bits = (bits | bits >> 2) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits >> 4) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits >> 8) & 0x0000ffff0000ffffu;
    return (bits | bits >> 16) & 0x00000000ffffffffu;
  }

  Point min_;
  double scale_;
};

/// Distinct points, sorted along a curve.
struct SortedPoints {
  memory::Array<Point> points;       ///< sorted by key, then by (x, y); has capacity for one more point
  std::vector<Curve::Key> keys;      ///< the key of each of `points`
  std::vector<std::uint32_t> ranks;  ///< for each point of the input, its index in `points`
};

/// Sorts points along the curve of a box and removes duplicates. Requires: the points lie in the box, and no coordinate
/// is -0. Cost: linear if the keys are evenly distributed, at most O(n log n).
[[nodiscard]] SortedPoints sort_along_curve(const Box& box, std::span<const Point> points,
                                            const threads::ThreadTeam& team = {});

}  // namespace waywright::locate

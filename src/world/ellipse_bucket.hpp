#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright {

/// The positions from which the sum of the distances to two foci is at most `length`, and all positions that are at
/// most `reach` away from them.
struct Ellipse {
  Point start;
  Point goal;
  double length = std::numeric_limits<double>::infinity();
  double reach = 0.0;
};

/// An ellipse of a path.
struct EllipseOfPath {
  Ellipse ellipse;
  std::uint32_t slot;  ///< of the path
};

/// The entries of a node of BoxTree: ellipses of paths. for_each_overlapping() does not ask whether boxes overlap: it
/// calls visit(slot) for each ellipse that a box may meet.
///
/// An update visits thousands of ellipses, and their data is rarely in the cache. So the class stores only what the
/// test needs, in blocks of lanes: the compiler computes several lanes at once.
class EllipseBucket {
 public:
  using Handle = std::uint32_t;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Handle handle(std::size_t i) const { return blocks_[i / kLanes].handle[i % kLanes]; }

  /// Adds an ellipse. If memory runs out, nothing changes.
  void add(const Box& bounds, const EllipseOfPath& path, Handle handle) {
    if (size_ % kLanes == 0) blocks_.emplace_back();
    Block& block = blocks_.back();
    const std::size_t lane = size_++ % kLanes;
    const Ellipse& ellipse = path.ellipse;
    block.bounds.min_x[lane] = rounded_down(bounds.min.x);
    block.bounds.min_y[lane] = rounded_down(bounds.min.y);
    block.bounds.max_x[lane] = -rounded_down(-bounds.max.x);
    block.bounds.max_y[lane] = -rounded_down(-bounds.max.y);
    block.start_x[lane] = ellipse.start.x;
    block.start_y[lane] = ellipse.start.y;
    block.goal_x[lane] = ellipse.goal.x;
    block.goal_y[lane] = ellipse.goal.y;
    block.length[lane] = ellipse.length;
    block.reach[lane] = ellipse.reach;
    block.slot[lane] = path.slot;
    block.handle[lane] = handle;
  }
  /// Removes the entry `i`. The last entry takes its place.
  void remove(std::size_t i) {
    --size_;
    copy(blocks_[i / kLanes], i % kLanes, blocks_[size_ / kLanes], size_ % kLanes);
    if (size_ % kLanes == 0) blocks_.pop_back();
  }

  /// Calls visit(slot) for each ellipse that the box meets, and for a few that the box misses. Requires: whoever added
  /// an ellipse has made its length larger by a 2^40th part. This part covers the rounding errors of the test.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    const float min_x = rounded_down(box.min.x);
    const float min_y = rounded_down(box.min.y);
    const float max_x = -rounded_down(-box.max.x);
    const float max_y = -rounded_down(-box.max.y);
    for (std::size_t begin = 0; begin < size_; begin += kLanes) {
      const Block& block = blocks_[begin / kLanes];
      const Bounds& bounds = block.bounds;
      unsigned overlapping = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const unsigned overlaps_x = unsigned{bounds.min_x[lane] <= max_x} & unsigned{bounds.max_x[lane] >= min_x};
        const unsigned overlaps_y = unsigned{bounds.min_y[lane] <= max_y} & unsigned{bounds.max_y[lane] >= min_y};
        overlapping |= (overlaps_x & overlaps_y) << lane;
      }
      for (; overlapping != 0; overlapping &= overlapping - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(overlapping));
        if (begin + lane < size_ && margin_of(block, lane, box) >= 0.0) visit(block.slot[lane]);
      }
    }
  }

 private:
  static constexpr std::size_t kLanes = 4;

  /// The bounding boxes of the ellipses, rounded outwards.
  struct Bounds {
    std::array<float, kLanes> min_x{};
    std::array<float, kLanes> min_y{};
    std::array<float, kLanes> max_x{};
    std::array<float, kLanes> max_y{};
  };
  struct Block {
    Bounds bounds;
    std::array<double, kLanes> start_x{};
    std::array<double, kLanes> start_y{};
    std::array<double, kLanes> goal_x{};
    std::array<double, kLanes> goal_y{};
    std::array<double, kLanes> length{};
    std::array<double, kLanes> reach{};
    std::array<std::uint32_t, kLanes> slot{};
    std::array<Handle, kLanes> handle{};
  };

  /// The largest float that is at most `x`.
  static float rounded_down(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest > x ? std::nextafter(nearest, -std::numeric_limits<float>::infinity()) : nearest;
  }
  static double squared_distance(const Box& box, double reach, double x, double y) {
    const auto beyond = [&](double least, double most, double at) {
      const double below = least - at;
      const double above = at - most;
      const double larger = (below > above ? below : above) - reach;
      return larger > 0.0 ? larger : 0.0;
    };
    const double dx = beyond(box.min.x, box.max.x, x);
    const double dy = beyond(box.min.y, box.max.y, y);
    return dx * dx + dy * dy;
  }
  /// Not negative if the box may meet the ellipse: if the box, larger by the reach in each of the four directions,
  /// contains a position of the ellipse. Let a and b be the distances of the larger box from the foci. Then a + b <=
  /// length if and only if the square of 2 a b is at most the square of the rest, and the rest is not negative: the
  /// rest is length^2 - a^2 - b^2. The products of four coordinates neither overflow nor underflow.
  static double margin_of(const Block& block, std::size_t lane, const Box& box) {
    const double a2 = squared_distance(box, block.reach[lane], block.start_x[lane], block.start_y[lane]);
    const double b2 = squared_distance(box, block.reach[lane], block.goal_x[lane], block.goal_y[lane]);
    const double rest = block.length[lane] * block.length[lane] - a2 - b2;
    return rest * std::abs(rest) - 4.0 * a2 * b2;
  }
  static void copy(Block& to, std::size_t to_lane, const Block& from, std::size_t from_lane) {
    to.bounds.min_x[to_lane] = from.bounds.min_x[from_lane];
    to.bounds.min_y[to_lane] = from.bounds.min_y[from_lane];
    to.bounds.max_x[to_lane] = from.bounds.max_x[from_lane];
    to.bounds.max_y[to_lane] = from.bounds.max_y[from_lane];
    to.start_x[to_lane] = from.start_x[from_lane];
    to.start_y[to_lane] = from.start_y[from_lane];
    to.goal_x[to_lane] = from.goal_x[from_lane];
    to.goal_y[to_lane] = from.goal_y[from_lane];
    to.length[to_lane] = from.length[from_lane];
    to.reach[to_lane] = from.reach[from_lane];
    to.slot[to_lane] = from.slot[from_lane];
    to.handle[to_lane] = from.handle[from_lane];
  }

  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

}  // namespace waywright

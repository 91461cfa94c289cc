#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/point.hpp"

#include "base/bit_cast.hpp"
#include "base/ieee.hpp"

namespace waywright {

/// Converts positions and distances to floats, relative to a domain: a position in the domain gets coordinates from 0
/// to 1. So they are accurate wherever the domain lies, and however large it is.
class FloatFrame {
 public:
  /// A bound of the rounding errors of coordinates, and of some sums and distances of coordinates.
  static constexpr double kError = 0x1p-18;
  /// Coordinates beyond this bound become this bound.
  static constexpr double kLargest = 4.0;

  explicit FloatFrame(const Box& domain)
      : origin_(domain.min), scale_(1.0 / std::max(domain.width(), domain.height())) {
    const auto largest = [](const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); };
    slack_ = kError + 0x1p-40 * std::max(largest(domain.min), largest(domain.max)) * scale_;
  }

  /// The coordinates of a position, before the conversion to floats.
  [[nodiscard]] Point relative(const Point& p) const {
    return {std::clamp((p.x - origin_.x) * scale_, -kLargest, kLargest),
            std::clamp((p.y - origin_.y) * scale_, -kLargest, kLargest)};
  }
  [[nodiscard]] Box relative(const Box& box) const { return {relative(box.min), relative(box.max)}; }
  [[nodiscard]] double relative(double distance) const { return distance * scale_; }
  /// kError, and a bound of the rounding errors of positions in the domain. It is large if the domain is small and far
  /// from (0, 0).
  [[nodiscard]] double slack() const { return slack_; }
  /// Returns whether relative(p) has been cut off.
  [[nodiscard]] static bool is_far(const Point& relative) {
    return std::max(std::abs(relative.x), std::abs(relative.y)) >= kLargest;
  }

 private:
  Point origin_;
  double scale_;
  double slack_;
};

/// Rows of `kFields` floats, in blocks of 16 rows. A block stores the 16 values of the first field, then the 16 values
/// of the next field, and so on. The *lane* of a row is its place in its block, from 0 to 15. A test of all rows
/// computes several lanes at once, and reads little memory.
template <std::size_t kFields>
class FloatTable {
 public:
  static constexpr std::size_t kLanes = 16;
  using Lanes = std::array<float, kLanes>;
  using Row = std::array<float, kFields>;
  using Block = std::array<Lanes, kFields>;
  /// A set of lanes: bit i stands for lane i.
  using LaneSet = std::uint32_t;
  /// The set that contains only the lane. A table instead of a shift, so that the compiler computes several lanes at
  /// once.
  static constexpr std::array<LaneSet, kLanes> kOnly = [] {
    std::array<LaneSet, kLanes> sets{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) sets[lane] = LaneSet{1} << lane;
    return sets;
  }();

  /// The set with the lane, if the number is negative, otherwise the empty set. Looks at the sign bit, so that the
  /// compiler computes several lanes at once.
  static LaneSet lane_if_negative(std::size_t lane, float number) {
    return static_cast<LaneSet>(base::bit_cast<std::int32_t>(number) >> 31) & kOnly[lane];
  }

  /// Calls visit(lane) for each lane of a set: of a LaneSet, or of a larger set of the lanes of successive blocks.
  template <class Set, class Visit>
  static void for_each_lane(Set lanes, const Visit& visit) {
    for (; lanes != 0; lanes &= lanes - 1) visit(static_cast<std::size_t>(std::countr_zero(lanes)));
  }

  [[nodiscard]] std::size_t block_count() const { return (size_ + kLanes - 1) / kLanes; }
  [[nodiscard]] const Block& block(std::size_t i) const { return blocks_[i]; }
  /// The lanes of a block that contain a row.
  [[nodiscard]] LaneSet used_lanes(std::size_t block) const {
    const std::size_t count = std::min(size_ - block * kLanes, kLanes);
    return (LaneSet{2} << (count - 1)) - 1;
  }

  /// Allocates the memory that add() needs.
  void make_room() {
    if (blocks_.size() * kLanes == size_) blocks_.emplace_back();
  }
  /// Adds a row. Allocates nothing. Requires: make_room() was called.
  void add(const Row& row) {
    for (std::size_t field = 0; field < kFields; ++field) blocks_[size_ / kLanes][field][size_ % kLanes] = row[field];
    ++size_;
  }
  /// Removes the row `i`. The last row takes its place.
  void remove(std::size_t i) {
    --size_;
    for (std::size_t field = 0; field < kFields; ++field) {
      blocks_[i / kLanes][field][i % kLanes] = blocks_[size_ / kLanes][field][size_ % kLanes];
    }
    blocks_.resize(block_count());
  }

 private:
  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

}  // namespace waywright

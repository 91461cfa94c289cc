#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "waywright/point.hpp"

namespace waywright::clearance {

/// Boxes that contain all walls that an operation has inserted or removed. If the operation changed many items, the
/// object has no boxes, and then any wall may have changed.
class ChangedWalls {
 public:
  /// The largest number of boxes. The update of the bridges compares the bridges near an operation with each box.
  static constexpr std::size_t kMost = 8;

  /// Removes all boxes: no wall has changed.
  void clear() { count_ = 0; }
  /// Adds a box that contains the walls of an item.
  void add(const Box& box) {
    if (count_ < kMost) boxes_[count_] = box;
    if (count_ <= kMost) ++count_;
  }
  /// Says that any wall may have changed.
  void add_all() { count_ = kMost + 1; }

  /// Whether any wall may have changed. Then boxes() is not defined.
  [[nodiscard]] bool are_all() const { return count_ > kMost; }
  [[nodiscard]] std::span<const Box> boxes() const { return {boxes_.data(), count_}; }

 private:
  std::array<Box, kMost> boxes_{};
  std::size_t count_ = 0;
};

}  // namespace waywright::clearance

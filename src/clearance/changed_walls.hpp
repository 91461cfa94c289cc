#pragma once

#include <algorithm>
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
  /// Adds a box that contains the walls of an item. If another box is nearly the same, for example because an item has
  /// moved a little, one box replaces the two.
  void add(const Box& box) {
    for (std::size_t i = 0; i < count_ && !are_all(); ++i) {
      Box both = boxes_[i];
      both.expand(box.min);
      both.expand(box.max);
      if (size_of(both) > 1.25 * std::min(size_of(boxes_[i]), size_of(box))) continue;
      boxes_[i] = both;
      return;
    }
    if (count_ < kMost) boxes_[count_] = box;
    if (count_ <= kMost) ++count_;
  }
  /// Says that any wall may have changed.
  void add_all() { count_ = kMost + 1; }

  /// Whether any wall may have changed. Then boxes() is not defined.
  [[nodiscard]] bool are_all() const { return count_ > kMost; }
  [[nodiscard]] std::span<const Box> boxes() const { return {boxes_.data(), count_}; }

 private:
  [[nodiscard]] static double size_of(const Box& box) { return box.width() + box.height(); }

  std::array<Box, kMost> boxes_{};
  std::size_t count_ = 0;
};

}  // namespace waywright::clearance

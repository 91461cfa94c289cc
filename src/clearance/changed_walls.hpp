#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "memory/count.hpp"

namespace waywright::clearance {

/// Boxes that contain all walls that an operation has inserted or removed. If the operation changed very many items,
/// the object has no boxes, and then any wall may have changed.
class ChangedWalls {
 public:
  /// Removes all boxes. Afterwards no wall counts as changed.
  void clear() {
    boxes_.clear();
    widest_ = 0.0;
    are_all_ = false;
  }
  /// Adds a box that contains the walls of an item.
  void add(const Box& box) {
    if (boxes_.size() == kMost) add_all();
    if (!are_all_) boxes_.push_back(box);
  }
  /// Says that any wall may have changed.
  void add_all() {
    are_all_ = true;
    boxes_.clear();
  }
  /// Sorts the boxes from left to right. If two successive boxes are nearly the same, for example because an item has
  /// moved a little, one box replaces the two. Call this function before boxes_between(). Cost: n log n in the boxes.
  void sort() {
    std::sort(boxes_.begin(), boxes_.end(), [](const Box& p, const Box& q) { return p.min.x < q.min.x; });
    std::size_t count = 0;
    for (const Box& box : boxes_) {
      if (count == 0 || !merge(boxes_[count - 1], box)) boxes_[count++] = box;
    }
    boxes_.resize(count);
    for (const Box& box : boxes_) widest_ = std::max(widest_, box.width());
  }

  /// Whether any wall may have changed. Then the boxes say nothing.
  [[nodiscard]] bool are_all() const { return are_all_; }
  /// Returns all boxes that contain a position with an x coordinate between the two values, and perhaps other boxes.
  [[nodiscard]] std::span<const Box> boxes_between(double low, double high) const {
    if (boxes_.size() <= kFew) return boxes_;
    const auto is_left = [](const Box& box, double x) { return box.min.x < x; };
    const auto first = std::lower_bound(boxes_.begin(), boxes_.end(), low - 1.01 * widest_, is_left);
    const auto last = std::lower_bound(first, boxes_.end(), high, is_left);
    return std::span(boxes_).subspan(static_cast<std::size_t>(first - boxes_.begin()),
                                     static_cast<std::size_t>(last - first));
  }

  void count_memory(MemoryUse& use) const { memory::count_spare(use, boxes_); }
  /// Frees all memory. Afterwards no wall counts as changed.
  void release() {
    clear();
    memory::release(boxes_);
  }

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 14;  ///< the largest number of boxes
  static constexpr std::size_t kFew = 4;                      ///< boxes_between() returns all boxes if there are so few

  [[nodiscard]] static double size_of(const Box& box) { return box.width() + box.height(); }
  /// Makes `into` contain the other box, if the two are nearly the same. Returns whether they are.
  [[nodiscard]] static bool merge(Box& into, const Box& box) {
    Box both = into;
    both.expand(box.min);
    both.expand(box.max);
    if (size_of(both) > 1.25 * std::min(size_of(into), size_of(box))) return false;
    into = both;
    return true;
  }

  std::vector<Box> boxes_;
  double widest_ = 0.0;  ///< the largest width of a box
  bool are_all_ = false;
};

}  // namespace waywright::clearance

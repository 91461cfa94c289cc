#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "memory/count.hpp"

namespace waywright::clearance {

/// Boxes that contain all walls that an operation has inserted or removed. If the operation changed very many items,
/// the object has no boxes, and then every wall counts as changed. Many boxes form a tree: a node has a box that
/// contains the boxes of its two halves.
class ChangedWalls {
 public:
  /// Removes all boxes. Afterwards no wall counts as changed.
  void clear() {
    boxes_.clear();
    nodes_.clear();
    are_all_ = false;
  }
  /// Adds a box that contains the walls of an item.
  void add(const Box& box) {
    if (boxes_.size() == kMost) add_all();
    if (!are_all_) boxes_.push_back(box);
  }
  /// Makes every wall count as changed.
  void add_all() {
    are_all_ = true;
    boxes_.clear();
    nodes_.clear();
  }
  /// Sorts the boxes from left to right, and makes the tree. If two boxes that follow each other in this order are
  /// nearly the same, for example because an item has moved a little, one box replaces the two. Call this function
  /// after the last add(). Cost: n log n in the boxes.
  void make_tree() {
    std::sort(boxes_.begin(), boxes_.end(), [](const Box& p, const Box& q) { return p.min.x < q.min.x; });
    std::size_t count = 0;
    for (const Box& box : boxes_) {
      if (count == 0 || !merge(boxes_[count - 1], box)) boxes_[count++] = box;
    }
    boxes_.resize(count);
    nodes_.clear();
    if (count > kFew) add_nodes(0, 0, count);
  }

  /// Returns whether every wall counts as changed: add_all() was called, or there were too many boxes. Then there are
  /// no boxes.
  [[nodiscard]] bool are_all() const { return are_all_; }
  /// Returns whether test(box) is true for one of the boxes. Requires: if the test is true for a box, then it is true
  /// for each box that contains this box; make_tree() was called. Cost: O(log n) if the boxes do not overlap and the
  /// test is true for few of them.
  template <class Test>
  [[nodiscard]] bool is_any(Test&& test) const {
    return is_any(test, 0, 0, boxes_.size());
  }

  void count_memory(MemoryUse& use) const { memory::count_spare(use, boxes_, nodes_); }
  /// Frees all memory. Afterwards no wall counts as changed.
  void release() {
    clear();
    memory::release(boxes_);
    memory::release(nodes_);
  }

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 14;  ///< the largest number of boxes
  static constexpr std::size_t kFew = 4;                      ///< so few boxes need no nodes

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

  /// Makes the node for a range of boxes, and the nodes for its halves.
  void add_nodes(std::size_t node, std::size_t begin, std::size_t end) {
    Box bounds = boxes_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) {
      bounds.expand(boxes_[i].min);
      bounds.expand(boxes_[i].max);
    }
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    nodes_[node] = bounds;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return boxes_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (bounds.width() > bounds.height()) {
      std::nth_element(at(begin), at(middle), at(end), [](const Box& p, const Box& q) { return p.min.x < q.min.x; });
    } else {
      std::nth_element(at(begin), at(middle), at(end), [](const Box& p, const Box& q) { return p.min.y < q.min.y; });
    }
    if (middle - begin > kFew) add_nodes(2 * node + 1, begin, middle);
    if (end - middle > kFew) add_nodes(2 * node + 2, middle, end);
  }

  template <class Test>
  [[nodiscard]] bool is_any(Test& test, std::size_t node, std::size_t begin, std::size_t end) const {
    if (end - begin <= kFew) {
      for (std::size_t i = begin; i < end; ++i) {
        if (test(boxes_[i])) return true;
      }
      return false;
    }
    if (!test(nodes_[node])) return false;
    const std::size_t middle = begin + (end - begin) / 2;
    return is_any(test, 2 * node + 1, begin, middle) || is_any(test, 2 * node + 2, middle, end);
  }

  std::vector<Box> boxes_;
  std::vector<Box> nodes_;  ///< the children of node i are the nodes 2 i + 1 and 2 i + 2
  bool are_all_ = false;
};

}  // namespace waywright::clearance

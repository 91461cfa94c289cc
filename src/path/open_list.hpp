#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace waywright::path {

/// The open nodes of a search. pop() returns the node with the least bound. Of nodes with equal bounds, it returns the
/// node with the smallest number. (In most searches, this node was made first.) The list is a heap with four children
/// per node: it has fewer levels than a binary heap, and the children of a node are adjacent in memory.
class OpenList {
 public:
  void clear() { entries_.clear(); }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Requires: not empty.
  [[nodiscard]] double least_bound() const { return entries_.front().bound; }

  void push(double bound, std::uint32_t node) {
    const Entry entry{bound, node};
    std::size_t at = entries_.size();
    entries_.push_back(entry);
    while (at > 0) {
      const std::size_t parent = (at - 1) / kChildren;
      if (!comes_before(entry, entries_[parent])) break;
      entries_[at] = entries_[parent];
      at = parent;
    }
    entries_[at] = entry;
  }

  /// Requires: not empty.
  std::uint32_t pop() {
    const std::uint32_t top = entries_.front().node;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) sink(last);
    return top;
  }

 private:
  static constexpr std::size_t kChildren = 4;

  struct Entry {
    double bound;
    std::uint32_t node;
  };

  static bool comes_before(const Entry& p, const Entry& q) {
    return p.bound < q.bound || (p.bound == q.bound && p.node < q.node);
  }

  /// Puts `entry` into the heap, whose first entry is free, and moves smaller entries up.
  void sink(const Entry& entry) {
    const std::size_t count = entries_.size();
    std::size_t at = 0;
    for (std::size_t child = 1; child < count; child = kChildren * at + 1) {
      std::size_t least = child;
      for (std::size_t i = child + 1; i < count && i < child + kChildren; ++i) {
        if (comes_before(entries_[i], entries_[least])) least = i;
      }
      if (!comes_before(entries_[least], entry)) break;
      entries_[at] = entries_[least];
      at = least;
    }
    entries_[at] = entry;
  }

  std::vector<Entry> entries_;
};

}  // namespace waywright::path

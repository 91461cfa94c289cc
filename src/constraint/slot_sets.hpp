#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "constraint/item_hash.hpp"
#include "memory/count.hpp"

// Sets of items, as lists of their slots. The cost of making a set is the cost of sorting its list, however many
// polygons overlap.

namespace waywright::constraint {

/// Sorts the slots and removes duplicates.
inline void keep_one_of_each(std::vector<std::uint32_t>& slots) {
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
}

/// Sorts the slots. Keeps one copy of each for which keeps(slot, count) is true, where `count` is the number of copies
/// before.
template <class Keeps>
void keep_each_if(std::vector<std::uint32_t>& slots, Keeps&& keeps) {
  std::sort(slots.begin(), slots.end());
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < slots.size(); begin = end) {
    const std::uint32_t slot = slots[begin];
    while (end < slots.size() && slots[end] == slot) ++end;
    if (keeps(slot, end - begin)) slots[kept++] = slot;
  }
  slots.resize(kept);
}

/// Sorts the slots. Keeps one copy of each that occurs an odd number of times.
inline void keep_odd(std::vector<std::uint32_t>& slots) {
  keep_each_if(slots, [](std::uint32_t, std::size_t count) { return count % 2 == 1; });
}

/// A set of numbers below 2^32 - 1. Use one object for many sets, because it keeps its memory. The cost of clear() is
/// proportional to the number of elements.
class SlotSet {
 public:
  /// Adds a number. Returns whether it was not in the set yet.
  bool insert(std::uint32_t number) {
    if (3 * (buckets_.size() + 1) > 2 * table_.size()) grow();
    const std::size_t bucket = bucket_of(number);
    if (table_[bucket] == number) return false;
    buckets_.push_back(static_cast<std::uint32_t>(bucket));
    table_[bucket] = number;
    return true;
  }
  [[nodiscard]] bool contains(std::uint32_t number) const {
    return !buckets_.empty() && table_[bucket_of(number)] == number;
  }
  void clear() {
    for (const std::uint32_t bucket : buckets_) table_[bucket] = kEmpty;
    buckets_.clear();
  }

  void count_spare(MemoryUse& use) const { memory::count_spare(use, table_, buckets_); }
  /// Empties the set and frees its memory.
  void release() noexcept { memory::release(table_, buckets_); }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffff;

  /// The bucket of the number, or the empty bucket for it. Source: Knuth, *The Art of Computer Programming* 3, 6.4,
  /// algorithm L.
  [[nodiscard]] std::size_t bucket_of(std::uint32_t number) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t bucket = static_cast<std::size_t>(mix(number)) & mask;
    while (table_[bucket] != kEmpty && table_[bucket] != number) bucket = (bucket + 1) & mask;
    return bucket;
  }
  void grow() {
    std::vector<std::uint32_t> old(std::max<std::size_t>(2 * table_.size(), 64), kEmpty);
    buckets_.reserve(old.size());
    old.swap(table_);
    for (std::uint32_t& bucket : buckets_) {
      const std::uint32_t number = old[bucket];
      bucket = static_cast<std::uint32_t>(bucket_of(number));
      table_[bucket] = number;
    }
  }

  std::vector<std::uint32_t> table_;    ///< its size is 0 or a power of two; at most two thirds are in use
  std::vector<std::uint32_t> buckets_;  ///< by element: its bucket in the table
};

}  // namespace waywright::constraint

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/count.hpp"

namespace waywright::memory {

/// An array that adds elements at its end and drops elements at its start. The index of an element never changes: the
/// first element ever added has the index 0. Each function takes constant time, amortised over the added elements, and
/// only push_back() allocates.
template <class Value>
class SlidingArray {
 public:
  using Index = std::uint64_t;

  /// The index of the oldest element that the array still has. Equal to end() if it has none.
  [[nodiscard]] Index begin() const { return base_ + dropped_; }
  /// The index of the next element that push_back() adds.
  [[nodiscard]] Index end() const { return base_ + values_.size(); }
  /// Requires: begin() <= i < end().
  [[nodiscard]] const Value& operator[](Index i) const { return values_[static_cast<std::size_t>(i - base_)]; }
  [[nodiscard]] Value& operator[](Index i) { return values_[static_cast<std::size_t>(i - base_)]; }

  void push_back(const Value& value) { values_.push_back(value); }
  /// Removes the elements from index `i` on. Requires: begin() <= i <= end().
  void truncate(Index i) { values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(i - base_), values_.end()); }
  /// Drops the elements before index `i`. Requires: begin() <= i <= end().
  void drop_before(Index i) {
    dropped_ = static_cast<std::size_t>(i - base_);
    if (2 * dropped_ < values_.size() || dropped_ == 0) return;
    values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(dropped_));
    base_ = i;
    dropped_ = 0;
  }

  /// Adds the memory of the elements to `part`, and the rest to the spare memory.
  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const { count(use, part, values_); }
  /// Frees spare memory.
  void shrink_to_fit() { shrink(values_); }

 private:
  std::vector<Value> values_;
  Index base_ = 0;           ///< the index of the first element of `values_`
  std::size_t dropped_ = 0;  ///< the number of elements at the start of `values_` that are dropped
};

}  // namespace waywright::memory

#pragma once

#include <cstdint>

namespace waywright::memory {

/// The slots of a table that nobody uses, the one freed last first. The table itself holds the links: a free slot names
/// the next one, in the way that the table's owner chooses. So the list needs no memory, and pushing cannot fail.
class FreeList {
 public:
  static constexpr std::uint32_t kEnd = 0x7fffffff;  ///< what the last free slot names; no slot has this number

  [[nodiscard]] bool is_empty() const { return first_ == kEnd; }
  /// The slot that pop() takes next; kEnd if the list is empty.
  [[nodiscard]] std::uint32_t first() const { return first_; }

  /// Adds a slot. Returns what its link must name: the caller writes it.
  [[nodiscard]] std::uint32_t push(std::uint32_t slot) {
    const std::uint32_t next = first_;
    first_ = slot;
    return next;
  }
  /// Takes a slot. `next` is what the link of first() names. Requires: not empty.
  std::uint32_t pop(std::uint32_t next) {
    const std::uint32_t slot = first_;
    first_ = next;
    return slot;
  }

 private:
  std::uint32_t first_ = kEnd;
};

}  // namespace waywright::memory

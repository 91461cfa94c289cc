#pragma once

#include <cstdint>

namespace waywright::memory {

/// The unused slots of a table, as a linked list. The slot that was freed last comes first. The table itself stores the
/// links: each free slot contains the number of the next free slot, and the owner of the table decides where. So the
/// list needs no memory, and push() cannot fail.
class FreeList {
 public:
  static constexpr std::uint32_t kEnd = 0x7fffffff;  ///< the link of the last free slot; no slot has this number

  [[nodiscard]] bool is_empty() const { return first_ == kEnd; }
  /// The slot that pop() takes next; kEnd if the list is empty.
  [[nodiscard]] std::uint32_t first() const { return first_; }

  /// Adds a slot. Returns the link of this slot: the caller writes it into the table.
  [[nodiscard]] std::uint32_t push(std::uint32_t slot) {
    const std::uint32_t next = first_;
    first_ = slot;
    return next;
  }
  /// Takes the slot first() out of the list. `next` is the link of this slot. Requires: the list is not empty.
  std::uint32_t pop(std::uint32_t next) {
    const std::uint32_t slot = first_;
    first_ = next;
    return slot;
  }

  /// roll_back() takes the list back to the last begin(). The owner takes back the links in the table.
  void begin() { first_before_ = first_; }
  void roll_back() { first_ = first_before_; }

 private:
  std::uint32_t first_ = kEnd;
  std::uint32_t first_before_ = kEnd;
};

}  // namespace waywright::memory

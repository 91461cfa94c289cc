#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/array.hpp"
#include "memory/count.hpp"

namespace waywright::memory {

/// The undo log of one operation: a record of each change, the oldest first. A record contains the data from which the
/// change can be undone. Call add() before the change, because memory may run out in add(). roll_back() allocates
/// nothing.
///
///     journal.begin();                            // the operation starts
///     journal.add({i, values[i]});                // before each change
///     journal.roll_back([&](const Undo& undo) { values[undo.i] = undo.value; });
template <class Undo>
class Journal {
 public:
  /// Starts an operation: drops all records.
  void begin() { records_.clear(); }
  void add(const Undo& undo) { records_.push_back(undo); }
  /// Calls undo(record) for each record since begin(), the newest first, and drops them.
  template <class Function>
  void roll_back(Function&& undo) {
    while (!records_.empty()) {
      const Undo record = records_.back();
      records_.pop_back();
      undo(record);
    }
  }
  /// Calls visit(record) for each record since begin(), the oldest first.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Undo& record : records_) visit(record);
  }

  void count_memory(MemoryUse& use) const { count_spare(use, records_); }
  /// Drops all records and frees their memory.
  void release() noexcept { memory::release(records_); }

 private:
  std::vector<Undo> records_;
};

/// An array with an undo log: roll_back() takes back each write() and append() of an operation. One operation must not
/// use both append() and grow_to() on the same array.
///
///     array.begin();                // the operation starts
///     array.write(3, value);
///     array.append(value);
///     array.roll_back();            // both are undone
template <class Value>
class JournaledArray {
 public:
  JournaledArray() = default;
  explicit JournaledArray(Array<Value>&& values) : values_(std::move(values)), size_before_(values_.size()) {}

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] const Value& operator[](std::size_t i) const { return values_[i]; }

  void write(std::uint32_t i, const Value& value) {
    journal_.add({i, values_[i]});
    values_[i] = value;
  }
  void append(const Value& value) { values_.push_back(value); }

  /// Makes room for `count` elements.
  void reserve(std::size_t count) { values_.reserve(count); }

  // The next two functions make changes that roll_back() does not take back.

  /// Makes the array at least `size` long. New elements are copies of `value`.
  void grow_to(std::size_t size, const Value& value) {
    if (values_.size() >= size) return;
    values_.resize(size, value);
    size_before_ = size;
  }
  /// Returns an element, so that the caller can change it without a record.
  [[nodiscard]] Value& unrecorded(std::size_t i) { return values_[i]; }

  void begin() {
    journal_.begin();
    size_before_ = values_.size();
  }
  /// Takes back every write() and append() since begin(). Allocates nothing.
  void roll_back() {
    journal_.roll_back([&](const Undo& undo) { values_[undo.i] = undo.value; });
    values_.resize(size_before_);
  }
  /// Calls visit(i) for each write(i, ...) since begin(), the oldest first.
  template <class Visit>
  void for_each_written(Visit&& visit) const {
    journal_.for_each([&](const Undo& undo) { visit(undo.i); });
  }

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    count(use, part, values_);
    journal_.count_memory(use);
  }
  /// Frees the memory of the records. Requires: nothing has changed since begin().
  void release_records() { journal_.release(); }
  /// Frees spare memory and the memory of the records. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    shrink(values_);
    journal_.release();
  }

 private:
  struct Undo {
    std::uint32_t i;
    Value value;
  };

  Array<Value> values_;
  std::size_t size_before_ = 0;
  Journal<Undo> journal_;
};

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

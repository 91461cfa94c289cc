#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace waywright::watch {

/// Keeps the keys of all slots in ascending order. So it can list the keys of any set of slots in ascending order
/// without sorting them all: it sorts only keys that are new.
///
/// Each key has an *index* in an array of all keys. The first keys of the array ascend. New keys follow in any
/// order, and the class sorts them into the array when they are many.
class KeyOrder {
 public:
  /// Allocates the memory that the other functions need for one key more, and for this slot.
  void make_room(std::uint32_t slot);
  /// Adds the key of a slot. Requires: no slot has this key, and make_room() was called.
  void add(std::uint32_t slot, std::uint64_t key);
  /// Gives the key of the slot `from` to the slot `to`. Requires: make_room() was called for `to`.
  void move(std::uint32_t from, std::uint32_t to);
  /// Removes the key of a slot.
  void remove(std::uint32_t slot);

  /// Removes all marks.
  void clear_marks() { std::fill(marks_.begin(), marks_.end(), 0); }
  /// Marks a slot that has a key.
  void mark(std::uint32_t slot) {
    const std::uint32_t index = indices_[slot];
    marks_[index / kBits] |= std::uint64_t{1} << index % kBits;
  }
  /// Fills `keys` with the keys of the marked slots, ascending. Afterwards no slot is marked. Allocates nothing if
  /// `keys` has room for its result. Cost: linear in the result, plus n log n for new keys in it, plus one step for
  /// each 64 keys.
  void take_marked(std::vector<std::uint64_t>& keys);
  /// Replaces slots by their keys, ascending. Requires: no slot is marked.
  void replace_by_keys(std::vector<std::uint64_t>& slots) {
    if (slots.empty()) return;
    for (const std::uint64_t slot : slots) mark(static_cast<std::uint32_t>(slot));
    take_marked(slots);
  }

 private:
  static constexpr std::uint32_t kBits = 64;
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Entry {
    std::uint64_t key;
    std::uint32_t slot;
  };

  /// Sorts the new keys into the array, and drops the removed ones, if there are many of them. Cost: amortised O(log n)
  /// for each new or removed key.
  void sort_new();

  std::vector<std::uint64_t> keys_;     ///< by index
  std::vector<std::uint32_t> slots_;    ///< by index; kNone if the key was removed
  std::vector<std::uint32_t> indices_;  ///< by slot
  std::vector<std::uint64_t> marks_;    ///< a bit for each index
  std::size_t ascending_ = 0;           ///< the number of keys at the start of `keys_` that are known to ascend
  std::size_t removed_ = 0;             ///< the number of removed keys in `keys_`
  std::vector<std::uint64_t> new_;      ///< scratch, with room for all keys
  std::vector<Entry> entries_;          ///< scratch
};

inline void KeyOrder::make_room(std::uint32_t slot) {
  sort_new();
  if (marks_.size() * kBits <= keys_.size()) {
    const std::size_t words = 2 * marks_.size() + 1;
    keys_.reserve(words * kBits);
    slots_.reserve(words * kBits);
    new_.reserve(words * kBits);
    marks_.resize(words);
  }
  if (indices_.size() <= slot) indices_.resize(std::max<std::size_t>(slot + 1, indices_.capacity()));
}

inline void KeyOrder::add(std::uint32_t slot, std::uint64_t key) {
  const bool ascends = ascending_ == keys_.size() && (keys_.empty() || keys_.back() < key);
  indices_[slot] = static_cast<std::uint32_t>(keys_.size());
  keys_.push_back(key);
  slots_.push_back(slot);
  if (ascends) ++ascending_;
}

inline void KeyOrder::move(std::uint32_t from, std::uint32_t to) {
  indices_[to] = indices_[from];
  slots_[indices_[to]] = to;
}

inline void KeyOrder::remove(std::uint32_t slot) {
  slots_[indices_[slot]] = kNone;
  ++removed_;
}

inline void KeyOrder::take_marked(std::vector<std::uint64_t>& keys) {
  std::size_t count = 0;
  for (const std::uint64_t word : marks_) count += word == 0 ? 0 : static_cast<std::size_t>(std::popcount(word));
  keys.resize(count);
  std::uint64_t* to = keys.data();
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (marks_[i] == 0) continue;
    const std::uint64_t* const of_word = keys_.data() + i * kBits;
    for (std::uint64_t word = std::exchange(marks_[i], 0); word != 0; word &= word - 1) {
      *to++ = of_word[std::countr_zero(word)];
    }
  }
  if (ascending_ == keys_.size()) return;
  const auto middle = std::is_sorted_until(keys.begin(), keys.end());
  // Merges from the end, into the same array.
  auto old = static_cast<std::size_t>(middle - keys.begin());
  std::sort(middle, keys.end());
  new_.assign(middle, keys.end());
  std::size_t end = keys.size();
  for (std::size_t left = new_.size(); left != 0;) {
    const bool is_new = old == 0 || keys[old - 1] < new_[left - 1];
    keys[--end] = is_new ? new_[--left] : keys[--old];
  }
}

inline void KeyOrder::sort_new() {
  constexpr std::size_t kFew = 64;
  constexpr std::size_t kShare = 8;
  const std::size_t live = keys_.size() - removed_;
  if (keys_.size() - ascending_ + removed_ <= kFew + live / kShare) return;
  entries_.clear();
  std::size_t ascending = 0;
  for (std::size_t index = 0; index < keys_.size(); ++index) {
    if (slots_[index] != kNone) entries_.push_back({keys_[index], slots_[index]});
    if (index < ascending_) ascending = entries_.size();
  }
  const auto middle = entries_.begin() + static_cast<std::ptrdiff_t>(ascending);
  const auto is_less = [](const Entry& a, const Entry& b) { return a.key < b.key; };
  std::sort(middle, entries_.end(), is_less);
  std::inplace_merge(entries_.begin(), middle, entries_.end(), is_less);
  keys_.clear();
  slots_.clear();
  for (const auto& [key, slot] : entries_) {
    indices_[slot] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    slots_.push_back(slot);
  }
  ascending_ = keys_.size();
  removed_ = 0;
}

}  // namespace waywright::watch

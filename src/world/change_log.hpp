#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "waywright/change.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "memory/count.hpp"

namespace waywright {

/// Records where the last operations on a world changed walls: the bounding box of each item that they inserted or
/// removed. World::is_affected reads it.
class ChangeLog {
 public:
  /// The log keeps at least the last 2,048 boxes.
  static constexpr std::size_t kKept = 2048;

  /// Starts an operation.
  void begin() { boxes_.clear(); }
  /// Records an item that the operation inserts or removes. Call add_insertion() or add_removal() first, then
  /// add_point() for each point of the item.
  void add_insertion() { add_item().is_insertion = true; }
  void add_removal() { add_item().is_removal = true; }
  void add_point(const Point& p) {
    Box& box = boxes_.back().box;
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }

  /// Allocates the memory that commit() needs.
  void reserve() {
    if (entries_.size() + boxes_.size() > 2 * kKept) remove_oldest();
    if (entries_.capacity() < entries_.size() + boxes_.size()) entries_.reserve(2 * (entries_.size() + boxes_.size()));
  }
  /// Ends an operation that has succeeded. `version` is the new version of the world. Allocates nothing. Requires:
  /// reserve() was called.
  void commit(std::uint64_t version) {
    for (ChangedBox& box : boxes_) {
      box.version = version;
      entries_.push_back(box);
    }
  }

  /// Allocates the memory that follow() needs.
  void reserve_to_follow(const ChangeLog& other) {
    if (entries_.capacity() < other.entries_.size()) entries_.reserve(other.entries_.capacity());
  }
  /// Makes the log equal to what `other` has of the operations up to version `until`. Allocates nothing. Requires:
  /// reserve_to_follow() was called, and the boxes up to version min(since, until) that `other` has are the last ones
  /// up to this version in this log, too.
  void follow(const ChangeLog& other, std::uint64_t since, std::uint64_t until) {
    const std::ptrdiff_t common = count_until(other.entries_, std::min(since, until));
    entries_.erase(entries_.begin() + count_until(entries_, until), entries_.end());
    entries_.erase(entries_.begin(), entries_.end() - common);
    entries_.insert(entries_.end(), other.entries_.begin() + common,
                    other.entries_.begin() + count_until(other.entries_, until));
    complete_since_ = std::min(other.complete_since_, until);
  }

  /// Returns the boxes of the operations after version `since`, or nothing if the log does not have all of them.
  [[nodiscard]] std::optional<std::span<const ChangedBox>> since(std::uint64_t since) const {
    if (since < complete_since_) return std::nullopt;
    return std::span<const ChangedBox>(entries_).subspan(static_cast<std::size_t>(count_until(entries_, since)));
  }

  void count_memory(MemoryUse& use) const { memory::count_spare(use, entries_, boxes_); }
  /// Frees spare memory. The entries stay. Requires: no operation is in progress.
  void shrink_to_fit() {
    memory::shrink(entries_);
    memory::release(boxes_);
  }

 private:
  /// The largest number of boxes of one operation. If an operation inserts or removes more items, all further items
  /// share the last box.
  static constexpr std::size_t kBoxesOfOperation = 256;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Returns the number of entries of the operations up to this version.
  [[nodiscard]] static std::ptrdiff_t count_until(const std::vector<ChangedBox>& entries, std::uint64_t version) {
    const auto is_later = [](std::uint64_t at, const ChangedBox& entry) { return at < entry.version; };
    return std::upper_bound(entries.begin(), entries.end(), version, is_later) - entries.begin();
  }

  ChangedBox& add_item() {
    if (boxes_.size() < kBoxesOfOperation) boxes_.push_back({0, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}}});
    return boxes_.back();
  }

  void remove_oldest() {
    const auto kept = entries_.end() - static_cast<std::ptrdiff_t>(std::min(kKept, entries_.size()));
    if (kept != entries_.begin()) complete_since_ = (kept - 1)->version;
    entries_.erase(entries_.begin(), kept);
  }

  std::vector<ChangedBox> entries_;   ///< ascending by version
  std::uint64_t complete_since_ = 0;  ///< the log has the boxes of all operations after this version
  std::vector<ChangedBox> boxes_;     ///< boxes of the operation in progress
};

}  // namespace waywright

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/memory_use.hpp"

#include "memory/count.hpp"

namespace waywright {

/// Records which items the operations on a world have changed, for its replicas. The record may contain items that have
/// not changed: an operation that fails leaves its items here.
class ChangedItems {
 public:
  /// Makes an empty record. It will have all changes after `version`.
  explicit ChangedItems(std::uint64_t version) : complete_since_(version) {}

  /// Sets a number of items: `limit`, but at least half of kSmallestCapacity. If the record has more when it needs more
  /// memory, it drops the older half of them.
  void set_limit(std::size_t limit) { limit_ = std::max(limit, kSmallestCapacity / 2); }
  [[nodiscard]] std::size_t limit() const { return limit_; }
  /// Lets the record drop the changes up to `version`. Does nothing if it has dropped them already.
  void forget_until(std::uint64_t version);

  /// An item, and a version of the world that is not before its last change.
  struct Entry {
    std::uint64_t version;
    ItemId id;
  };

  /// Makes the record reach back to `version`. `changed` are the items that differ between the world of this version
  /// and the present world, and the record then contains them. The version of an item may be much later than its last
  /// change. (The record may lack an item that has changed since `version`, if a rewind has taken this change back.)
  /// Requires: the record does not reach back to `version`.
  void extend_to(std::uint64_t version, std::vector<Entry> changed);

  /// Records an item that an operation inserts or removes. `version` is the version of the world after this operation.
  /// Cost: amortised O(log n) in the items of the record.
  void add(ItemId id, std::uint64_t version) {
    if (version <= complete_since_) return;  // too many changes: the record lacks the changes of this operation
    if (entries_.size() == entries_.capacity()) make_room(version);
    if (version > complete_since_) entries_.push_back({version, id});
  }

  /// Returns whether the record reaches back to `version`: it has all items that have changed after this version,
  /// except those that it may lack after extend_to().
  [[nodiscard]] bool has_all_since(std::uint64_t version) const { return version >= complete_since_; }
  /// Writes the items that have changed after `version` to `ids`, in the order of their versions (see Entry).
  /// Items with the same version ascend by id. Requires: has_all_since(version).
  /// Cost: n log n in the changes after `version`.
  void since(std::uint64_t version, std::vector<ItemId>& ids);

  void count_memory(MemoryUse& use) const { memory::count_spare(use, entries_, found_); }

 private:
  /// Removes the changes up to the version `complete_since_`.
  void drop_forgotten();
  /// Keeps the last entry of each item only, and sorts by version and id.
  static void keep_last(std::vector<Entry>& entries);
  /// Keeps the last entry of each item only. If there are still too many, drops the oldest. `version` is the version
  /// after the operation in progress. Afterwards the array has room for one entry more.
  void make_room(std::uint64_t version);

  /// The capacity of `entries_` for the first entries.
  static constexpr std::size_t kSmallestCapacity = 1024;

  std::vector<Entry> entries_;    ///< ascending by version
  std::vector<Entry> found_;      ///< scratch
  std::uint64_t complete_since_;  ///< the version to which the record reaches back
  std::size_t limit_ = kSmallestCapacity / 2;
};

}  // namespace waywright

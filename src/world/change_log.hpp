#pragma once

#include <algorithm>
#include <atomic>
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
#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"
#include "nav/abstraction.hpp"
#include "path/looked_at.hpp"

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

/// The version of a world, and the faces that its operations have touched. A search in slices reads it to find out
/// whether it can continue in a world that has changed. A world and its searches share one log. A search can read the
/// log even after the world has been destroyed. The log records faces only while a search runs.
///
/// Threads: several threads may call add_search() and remove_search() at once. The other functions follow the rules of
/// World: while a thread calls one that is not const, no other thread may use the log.
class TouchLog {
 public:
  static constexpr std::uint64_t kWorldGone = std::numeric_limits<std::uint64_t>::max();

  TouchLog() = default;
  /// Makes the log of a world that starts with this version. It has no records of earlier versions.
  explicit TouchLog(std::uint64_t version) : version_(version), complete_since_(version) {}

  [[nodiscard]] std::uint64_t version() const { return version_; }
  void note_world_gone() { version_ = kWorldGone; }

  void add_search() { searches_.fetch_add(1, std::memory_order_relaxed); }
  void remove_search() { searches_.fetch_sub(1, std::memory_order_relaxed); }

  /// Records the faces that an operation has touched in the mesh. Allocates memory. If the operation is taken back
  /// afterwards, the records stay: a search may then start again although nothing has changed.
  void note_mesh(const constraint::ConstrainedTriangulation& triangulation);
  /// Records the faces whose entry in the abstraction has changed. Call it after note_mesh(). Allocates nothing: it
  /// uses the room that note_mesh() has made. If this room is too small, the operation counts as one that has touched
  /// every face.
  void note_abstraction(const nav::Abstraction& abstraction);
  /// Records that an operation has touched every face. Allocates nothing.
  void note_everything() { complete_since_ = version_ + 1; }
  /// Ends an operation that has succeeded.
  void commit() { ++version_; }

  /// Starts again at a version, without records of earlier versions. Allocates nothing.
  void restart(std::uint64_t version) {
    entries_.clear();
    version_ = version;
    complete_since_ = version;
  }

  /// Returns whether an operation after version `since` has touched a face at which the search has looked.
  [[nodiscard]] bool has_touched(const path::LookedAt& looked_at, std::uint64_t since) const;

  void count_memory(MemoryUse& use) const { memory::count_spare(use, entries_); }
  /// Frees spare memory. While a search runs, the entries stay.
  void shrink_to_fit();

 private:
  /// Records the faces that an operation has touched. Returns whether the log has room for all of them (kLongest).
  [[nodiscard]] bool add_touched_faces(const constraint::ConstrainedTriangulation& triangulation);

  /// The largest number of entries. If an operation would make the log longer, the operation empties the log, and all
  /// searches start again.
  static constexpr std::size_t kLongest = std::size_t{1} << 20;
  /// The number of entries for which note_mesh() makes room, so that note_abstraction() can add them.
  static constexpr std::size_t kSpare = 4096;

  /// A face that an operation has touched, and the version of the world after that operation.
  struct Entry {
    std::uint64_t version;
    mesh::Face face;
  };

  std::uint64_t version_ = 0;
  std::atomic<std::size_t> searches_ = 0;
  std::uint64_t complete_since_ = 0;  ///< the log has the faces of all operations after this version
  std::vector<Entry> entries_;        ///< by version, ascending
};

}  // namespace waywright

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "memory/sliding_array.hpp"

namespace waywright {

/// The history of a world: its last ticks, and each change of an item since the oldest of them, with the shape that the
/// item had before the change. The mesh depends only on the live items, so the history records nothing about the mesh.
///
/// An operation calls begin(), records each change before it makes it, and calls commit(). If the operation fails, it
/// does not call commit(). Then the next call of begin(), mark(), keep() or changed_since() deletes the records of this
/// operation.
class History {
 public:
  using Tick = std::uint64_t;

  /// Keeps the last `ticks` ticks from now on. With 0, drops the whole history.
  void keep(std::size_t ticks);
  /// Whether the world keeps a history.
  [[nodiscard]] bool is_kept() const { return limit_ != 0; }

  /// Marks the current state of the world as the next tick and returns the tick. `version` is the version of the world,
  /// and `largest_id` is the largest id that it has seen. If there are too many ticks now, drops the oldest. Requires:
  /// is_kept().
  Tick mark(std::uint64_t version, ItemId largest_id);

  void begin();
  /// Records that the operation inserts an item.
  void add_insertion(ItemId id);
  /// Records that the operation removes an item. Call add_ring() for each of its rings afterwards, and add_point() for
  /// each corner of the ring. Requires: is_recording(). The next two functions require this, too.
  void add_removal(ItemId id, ItemKind kind, FillRule fill);
  void add_ring();
  void add_point(const Point& point);
  void commit();
  /// Whether the history records changes: it has a tick.
  [[nodiscard]] bool is_recording() const { return marks_.begin() != marks_.end(); }

  /// An item that has changed since a tick.
  struct ChangedItem {
    ItemId id;
    std::uint64_t entry;       ///< the index of its first change since the tick, in `entries_`
    std::uint64_t last_entry;  ///< the index of its last change
  };

  /// Returns the error of a rewind to this tick, or nothing.
  [[nodiscard]] std::optional<Error> find_error(Tick tick) const;
  /// Returns the version of the world at a tick. Requires: find_error(tick) is nothing. The next three functions
  /// require this, too.
  [[nodiscard]] std::uint64_t version(Tick tick) const;
  /// Returns the largest id that the world had seen at a tick.
  [[nodiscard]] ItemId largest_id(Tick tick) const;
  /// Returns each item that has changed since the tick, once, ascending by id. Cost: n log n in the changes.
  [[nodiscard]] std::vector<ChangedItem> changed_since(Tick tick);
  /// Makes `tick` the last tick: drops all later ticks and all changes since this tick. Allocates nothing.
  void return_to(Tick tick);

  /// Whether the item was live at the tick that was passed to changed_since().
  [[nodiscard]] bool was_live(const ChangedItem& item) const { return entries_[item.entry].was_live; }
  /// Returns the shape that the item had at that tick. Requires: was_live(item).
  [[nodiscard]] Shape shape(const ChangedItem& item) const;

  /// Returns the version of the world at the first tick after the last change of the item, or nothing if no tick
  /// follows. Cost: O(log n) in the ticks.
  [[nodiscard]] std::optional<std::uint64_t> version_after(const ChangedItem& item) const;

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory.
  void shrink_to_fit();

 private:
  /// A change: the insertion of items that were not live, whose ids count up from `id`, or the removal of one item,
  /// whose shape lies in `ring_sizes_` and `points_`.
  struct Entry {
    ItemId id;
    std::uint64_t first_ring;
    std::uint64_t first_point;
    std::uint32_t count;
    ItemKind kind;
    FillRule fill;
    bool was_live;
  };
  struct Mark {
    std::uint64_t first_entry;  ///< the first change after this tick
    std::uint64_t version;
    ItemId largest_id;
  };
  /// The ends of the three arrays.
  struct Ends {
    std::uint64_t entries = 0;
    std::uint64_t ring_sizes = 0;
    std::uint64_t points = 0;
  };

  void drop_uncommitted() { truncate(committed_); }
  void truncate(const Ends& ends);
  void drop_oldest();

  // A tick is the index of its mark, plus 1.
  memory::SlidingArray<Mark> marks_;
  memory::SlidingArray<Entry> entries_;
  memory::SlidingArray<std::uint32_t> ring_sizes_;
  memory::SlidingArray<Point> points_;
  Ends committed_;
  std::size_t limit_ = 0;  ///< the largest number of ticks
};

}  // namespace waywright

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/world.hpp"

#include "base/compiler.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/arena.hpp"
#include "memory/count.hpp"
#include "mesh/index.hpp"
#include "nav/abstraction.hpp"
#include "world/history.hpp"
#include "world/layers.hpp"

namespace waywright {

/// The items that a world has now, or had at a tick of its history.
class ItemsAtTick {
 public:
  /// The items of now.
  explicit ItemsAtTick(const constraint::ConstrainedTriangulation& now) : now_(now) {}
  /// The items at a tick. `changed` is the answer of History::changed_since() for this tick.
  ItemsAtTick(const constraint::ConstrainedTriangulation& now, const History& history,
              std::span<const History::ChangedItem> changed)
      : now_(now), history_(&history), changed_(changed) {}

  /// Returns whether the item is one of these items. If it is, writes its shape to `shape`.
  [[nodiscard]] bool find(ItemId id, Shape& shape) const {
    const auto comes_before = [](const History::ChangedItem& item, ItemId other) { return item.id < other; };
    const auto found = std::lower_bound(changed_.begin(), changed_.end(), id, comes_before);
    if (found != changed_.end() && found->id == id) {
      if (!history_->was_live(*found)) return false;
      shape = history_->shape(*found);
      return true;
    }
    if (!now_.items().contains(id)) return false;
    fill_shape(now_, id, shape);
    return true;
  }

  /// Returns the answer of History::version_after(). Requires: changed() contains the item.
  [[nodiscard]] std::optional<std::uint64_t> version_after(const History::ChangedItem& item) const {
    return history_->version_after(item);
  }

  /// The items that have changed since the tick. Empty for the items of now.
  [[nodiscard]] std::span<const History::ChangedItem> changed() const { return changed_; }

 private:
  const constraint::ConstrainedTriangulation& now_;
  const History* history_ = nullptr;
  std::span<const History::ChangedItem> changed_;  ///< ascending by id
};

/// Prefetches the memory that a replica needs when it repeats changes of its world. In a large world, a change at a
/// random place spends most of its time waiting for memory, one address after the other. This class knows all items
/// before the first change. So it looks at all of them in turn, one step each, and the processor fetches the memory for
/// the next steps at the same time. It changes nothing, and answers do not depend on it.
class ReplicaPrefetch {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// The largest number of items for one call of run(): the cache has room for the surroundings of this many items.
  static constexpr std::size_t kItems = 16;

  /// Prefetches what the replica needs to remove its items with these ids, and to insert the items with these ids of
  /// the world. `abstraction` is the abstraction of the replica, or null.
  void run(const Triangulation& replica, const Triangulation& world, const nav::Abstraction* abstraction,
           std::span<const ItemId> ids);

  void count_memory(MemoryUse& use) const { memory::count_spare(use, corners_, new_corners_, starts_, spokes_); }

 private:
  void find_corners(const Triangulation& replica, const Triangulation& world, std::span<const ItemId> ids);
  void advance_spokes(const Triangulation& replica, const nav::Abstraction* abstraction);

  /// The spoke at which the prefetch around a corner has arrived.
  struct Spoke {
    mesh::HalfEdge h;
    mesh::HalfEdge first;  ///< the spoke at which it started
    mesh::Face before;     ///< the face of the spoke before `h`
  };

  std::vector<mesh::Vertex> corners_;      ///< the corners of the old shapes, as vertices of the replica
  std::vector<mesh::Vertex> new_corners_;  ///< the corners of the new shapes, as vertices of the world
  std::vector<mesh::Vertex> starts_;       ///< the vertices of the replica at which the walks to the new corners start
  std::vector<Spoke> spokes_;              ///< a spoke for each vertex of `corners_`
};

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

namespace detail {

/// A copy of a world, to which snapshots refer. It has up to two owners: the pool of the world, and all its handles
/// (WorldSnapshot) together. The last owner frees it. If no handle owns it, nobody reads the copy, and only the pool
/// can make new handles. So the thread that changes the world may then change the copy.
///
/// A replica serves either snapshots of the present or snapshots of ticks. Otherwise a program that publishes both in
/// turn would move each replica to and fro between the present and the ticks.
///
/// A replica may share pages with others: its arrays then lie in an arena (memory::Arena).
///
/// Threads: threads with a handle may call add_handle() and remove_handle() at any time. The other functions belong to
/// the thread that changes the world.
class Replica {
 public:
  /// Makes a replica that only the pool owns. `arena_of_copy` contains arrays of the copy, or is null. `base_number` is
  /// the number of the base whose pages the replica shares.
  Replica(World&& copy, std::unique_ptr<memory::Arena>&& arena_of_copy, std::uint32_t base_number, bool serves_ticks)
      : arena(std::move(arena_of_copy)),
        world(std::move(copy)),
        base_number_(base_number),
        serves_ticks_(serves_ticks) {}

  [[nodiscard]] bool serves_ticks() const { return serves_ticks_; }
  [[nodiscard]] std::uint32_t base_number() const { return base_number_; }

  /// Returns whether this replica is free: no snapshot refers to it, and the pool owns it.
  [[nodiscard]] bool is_free() const { return owners_.load(std::memory_order_acquire) == 1; }
  /// Adds the first handle. Requires: is_free().
  void add_first_handle() {
    handles_.store(1, std::memory_order_relaxed);
    owners_.store(2, std::memory_order_relaxed);
  }
  /// If the replica has a handle already, adds another one and returns true. Otherwise returns false.
  [[nodiscard]] bool add_handle_if_any();
  /// Adds a handle. Requires: the calling thread has a handle of this replica.
  void add_handle() { handles_.fetch_add(1, std::memory_order_relaxed); }
  void remove_handle() noexcept;
  /// Ends the ownership of one of the two owners: the pool calls it, and remove_handle() calls it for the last handle.
  /// If the other owner has called it before, frees this replica.
  void release() noexcept;
  /// Makes remove_handle() of the last handle of this replica call release() on `replica`, too. Requires: this replica
  /// has no handle yet.
  void release_with_last_handle(Replica* replica) { released_with_last_handle_ = replica; }
  /// Whether the replica can no longer follow the world, although the record of changes may reach back to its version
  /// (SnapshotPool::extend_record()).
  [[nodiscard]] bool is_too_old() const { return is_too_old_; }
  void note_too_old() { is_too_old_ = true; }

  const std::unique_ptr<memory::Arena> arena;  ///< null if the replica shares no pages; outlives `world`
  World world;

 private:
  ~Replica() = default;

  std::atomic<std::size_t> handles_ = 0;
  std::atomic<std::uint32_t> owners_ = 1;
  Replica* released_with_last_handle_ = nullptr;
  std::uint32_t base_number_;
  bool serves_ticks_;
  bool is_too_old_ = false;
};

}  // namespace detail

/// A state of a world that a replica can get: the present one, or that of a tick.
struct ReplicaState {
  std::optional<History::Tick> tick;  ///< or nothing for the present state
  std::uint64_t version;
  ItemId largest_id;             ///< the largest id that the world had seen
  std::size_t new_vertex_limit;  ///< of the world now
};

/// The scratch of World::Impl::follow(): the shapes of one item in the world and in the replica, and the memory of
/// ReplicaPrefetch.
struct ReplicaScratch {
  void count_memory(MemoryUse& use) const;

  Shape in_world;
  Shape in_replica;
  ReplicaPrefetch prefetch;
};

/// The replicas of a world, and the changes that they have not repeated yet. A replica *follows* the world if it
/// repeats these changes, or goes back to the state of a tick (World::Impl::follow()).
///
/// The first three replicas have memory of their own. When readers hold three of a kind, the pool makes a *base*: a
/// copy of the world that nobody reads and nobody changes. As long as there is a base, new replicas of a large world
/// can share pages with it. Such a replica takes memory only for what has changed since the pool made the base. But a
/// change takes longer if the system must copy a page for it. So a program whose readers hold one or two snapshots at
/// once gets replicas without shared pages.
///
/// Threads: the pool belongs to the thread that changes the world, but count_memory() is a query.
class SnapshotPool {
 public:
  /// Makes a pool without replicas for a world of this version.
  explicit SnapshotPool(std::uint64_t version) : changed_(version) {}
  ~SnapshotPool();
  SnapshotPool(const SnapshotPool&) = delete;
  SnapshotPool& operator=(const SnapshotPool&) = delete;

  /// Records an item that an operation inserts or removes. `version` is the version of the world after the operation.
  void note_changed(ItemId id, std::uint64_t version) { changed_.add(id, version); }

  /// If the pool has a replica with readers that has this state, adds a handle to it and returns it. Otherwise returns
  /// null.
  [[nodiscard]] detail::Replica* add_handle_of(const ReplicaState& state) const;
  /// Returns a free replica that can follow the world to this state and serves such states. `items` are the items of
  /// the state. Returns null if there is no such replica, or if a copy of the world would cost less. Of several such
  /// replicas, returns the one whose version is nearest to that of the state.
  [[nodiscard]] detail::Replica* find_free(const ReplicaState& state, const ItemsAtTick& items);
  /// Returns the items in which the replica that find_free() has returned may differ from the state. No item occurs
  /// twice.
  [[nodiscard]] const std::vector<ItemId>& changed() const { return ids_; }
  [[nodiscard]] ReplicaScratch& scratch() { return scratch_; }

  /// Takes a free replica out of the pool and frees it.
  void drop(detail::Replica* replica);
  /// Returns whether a new replica for this state may share pages, if the world is large.
  [[nodiscard]] bool may_share(const ReplicaState& state, const ItemsAtTick& items) const;
  /// The memory that a world must have so that its replicas share pages, in bytes.
  [[nodiscard]] std::size_t least_shared() const { return least_shared_; }
  /// Returns the base, if a copy of it can follow the world to the state with these items, and few items differ.
  /// Otherwise returns null. changed() then has the items that may differ. Requires: find_free() has been called for
  /// this state.
  [[nodiscard]] const detail::Replica* find_base(const ItemsAtTick& items);
  /// Returns whether to make a new base: not if too few replicas share the pages of the last one (kLeastSharing). But
  /// after an answer of false, the next answer is true, because the world may change less by then.
  [[nodiscard]] bool should_make_base();
  /// Replaces the base by a copy of the present world. `arena` contains arrays of the copy. If memory runs out, changes
  /// nothing.
  void set_base(World&& copy, std::unique_ptr<memory::Arena>&& arena);
  /// Frees the base, and lets no new replica share pages any more: the system refuses it.
  void stop_sharing();
  /// Makes a replica of a copy of the world, and adds it to the pool. `arena` contains arrays of the copy, or is null.
  /// If memory runs out, changes nothing.
  [[nodiscard]] detail::Replica* add(World&& copy, std::unique_ptr<memory::Arena>&& arena, bool serves_ticks);
  /// Prepares a replica for its first reader. Gives up the replicas that the pool no longer needs. `item_count` is the
  /// number of items of the world now. Allocates nothing. Requires: the replica is free.
  void hand_out(detail::Replica* replica, std::size_t item_count);

  void count_memory(MemoryUse& use) const;

  // For tests.

  /// Lets all new replicas share pages, also the first ones, and those of a small world.
  void share_always() {
    least_shared_ = 0;
    first_count_ = 0;
    least_sharing_ = 0;
  }
  /// Returns how many replicas that share pages the pool has made.
  [[nodiscard]] std::size_t sharing_count() const { return sharing_count_; }

 private:
  /// If the pool has more free replicas for the present than this number, or more for ticks, hand_out() gives up one of
  /// them.
  static constexpr std::size_t kMostFree = 2;
  /// The largest number of replicas that the pool owns. The last reader of an older replica that has readers frees it.
  static constexpr std::size_t kMost = 16;

  /// Let n be the number of items of the world. If more than kFewChanges + n / kItemsForEachChange items have changed,
  /// a copy of the world costs less than to follow it.
  static constexpr std::size_t kFewChanges = 64;
  /// See kFewChanges.
  static constexpr std::size_t kItemsForEachChange = 32;

  /// A world with less memory (in bytes) has no replicas that share pages: a copy takes less than a few milliseconds.
  static constexpr std::size_t kLeastShared = std::size_t{4} << 20;
  /// If more than `limit_` / kLimitDivisor items have changed since the pool made the base, it makes a new one. A
  /// replica repeats all changes since the base, in shared pages, where a change takes several times as long as
  /// elsewhere. So with a higher limit, replicas take more time and memory. With a lower limit, the pool makes more
  /// bases.
  static constexpr std::size_t kLimitDivisor = 16;
  /// If readers hold this many replicas of a kind, the pool may make the first base.
  static constexpr std::size_t kFirst = 3;
  /// If fewer replicas than this share the pages of a base when it becomes too old, the world changes too fast between
  /// the snapshots. A copy of the world then costs less than a new base.
  static constexpr std::size_t kLeastSharing = 4;

  using Replicas = std::vector<detail::Replica*>;

  /// Extends the record of changes, so that a replica with these items can follow the world later. `version` is its
  /// version. Does nothing if too many items have changed since this version.
  void extend_record(std::uint64_t version, const ItemsAtTick& items);
  /// Adds the items that have changed since the tick to `ids_`.
  void add_changed(const ItemsAtTick& items);
  /// Writes to `ids_` the items in which a world of this version may differ from the state with `items`. Returns
  /// whether they are at most `limit` more than items.changed(). Requires: the record reaches back to the version.
  [[nodiscard]] bool find_changed(std::uint64_t version, const ItemsAtTick& items, std::size_t limit);
  /// Returns the oldest of the replicas for which `matches(replica)` is true, or the end of the list.
  template <class Matches>
  [[nodiscard]] Replicas::iterator find_oldest(Matches&& matches);
  template <class Matches>
  [[nodiscard]] std::size_t count(Matches&& matches) const;
  /// Removes from the pool each replica that readers hold and that cannot follow the world any more. Then removes the
  /// oldest replica if the pool has kMost. Requires: the replica for hand_out() is not in the pool.
  void release_too_old();
  /// Takes one free replica that the pool does not need out of the pool and returns it: the oldest one that cannot
  /// follow the world or, if there are too many for the present or for ticks, the oldest of these; those that share
  /// pages come first. If there is none, returns the base if no replica shares pages, or if the base cannot follow the
  /// world. Otherwise returns null. `handed_out` is the replica for hand_out(), which is not in the pool.
  [[nodiscard]] detail::Replica* take_unneeded(const detail::Replica& handed_out);
  [[nodiscard]] bool can_follow(const detail::Replica& replica) const {
    const bool has_old_base = replica.arena != nullptr && replica.base_number() != base_number_;
    return !has_old_base && !replica.is_too_old() && changed_.has_all_since(replica.world.version());
  }

  Replicas replicas_;                ///< in no order
  detail::Replica* base_ = nullptr;  ///< or null
  std::size_t least_shared_ = kLeastShared;
  std::size_t first_count_ = kFirst;
  std::size_t least_sharing_ = kLeastSharing;
  bool can_share_ = base::kHasPageFiles;
  std::uint32_t base_number_ = 0;  ///< of `base_` or, if there is none, of the last base
  /// How many replicas that share the pages of the last base the pool has made, or a larger number: should_make_base().
  std::size_t sharing_base_ = kLeastSharing;
  std::size_t sharing_count_ = 0;  ///< how many replicas that share pages the pool has made
  ChangedItems changed_;
  std::size_t limit_ = kFewChanges;  ///< if more items have changed, a copy costs less
  std::vector<ItemId> ids_;          ///< the answer of changed()
  ReplicaScratch scratch_;
};

}  // namespace waywright

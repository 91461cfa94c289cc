#pragma once

#include <cstdint>

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup world
/// @{

class World;

namespace detail {

class Replica;

inline constexpr char kEmptySnapshot[] =
    "WorldSnapshot: this handle is empty: it was default-constructed, moved from or released";

}  // namespace detail

/// A handle of a *snapshot*. A snapshot is an immutable world: the state that a World had when its World::publish() was
/// called, or at an earlier tick (World::mark()). Readers on other threads query it while one thread changes the world.
/// The readers and this thread never wait for each other.
///
/// @code{.cpp}
/// WorldSnapshot snapshot = world.publish();  // give each reader a handle of its own: copy `snapshot`
/// world.remove(1).value();                   // waits for no reader, and no reader waits for it
/// const bool is_there = snapshot->contains(1);  // == true
/// const bool is_here = world.contains(1);       // == false
/// snapshot.release();
/// @endcode
///
/// To keep many earlier states, do not hold their snapshots: mark ticks, and publish a tick when a reader wants to read
/// it. The history of the world takes memory only for the items that have changed.
///
/// @code{.cpp}
/// world.keep_history(600);
/// const std::uint64_t tick = world.mark();
/// world.insert(house).value();
/// const std::size_t earlier = world.publish(tick).value()->item_count();  // == world.item_count() - 1
/// @endcode
///
/// Several handles may share one immutable world, which you reach with `->` and `*`. All const members of World work,
/// without a context or with one. They give the same answers as the world gave, also version(), is_affected() and
/// changes_since(). Only memory() and Path::time can differ. The snapshot of a tick has two further differences:
/// changes_since() and is_affected() know only the changed boxes (ChangedBox) that the world still had when the tick
/// was published, and new_vertex_limit() is that of the world at that moment. A PathWatch can read one snapshot after
/// the other: each of them counts as the world for which the watch was made. The immutable world has no history. To get
/// a world that you can change, call its World::clone().
///
/// If a reader still has a snapshot of the same state, World::publish() usually returns this snapshot. Each immutable
/// world is a *replica*: a copy of the original world. When the readers have released all handles of a replica, a later
/// call uses it again: the call repeats the later changes of the world in this replica, or goes back to a tick. The
/// world keeps the replicas that no reader holds, for later snapshots. A replica serves either snapshots of the present
/// or snapshots of ticks. Of each of these two kinds, the world needs at most two replicas that no reader holds. If it
/// has more, each call of World::publish() gives up one of them. To free a replica takes time. So publish() does not
/// free this one, but attaches it to the new snapshot: the thread that releases the last handle of this snapshot frees
/// the attached replica. Suppose that the readers release each snapshot when the next one exists. Then the third call
/// uses the replica of the first snapshot again and repeats the changes since the first call, the fourth call uses the
/// replica of the second snapshot, and so on. The first call makes a replica, because there is none yet. Later, a call
/// makes one if readers hold all replicas, or if no free replica can be updated, for example because too many items
/// have changed (see World::publish). After the first call, each operation also records the ids of the items that it
/// changes, 16 bytes for each. World::shrink_to_fit() frees the replicas that the world keeps for later snapshots.
///
/// The first three snapshots that readers hold at once take as much memory as a clone() each. On Linux, if the world
/// takes 4 MB or more, further snapshots can share pages of memory with one more copy of the world, the *base*. Such a
/// snapshot takes memory only for what has changed since the base was made: about 90 kB for each polygon that moves
/// among 10^6 vertices. (A replica that is used again also keeps the memory for its earlier changes.) When about n /
/// 512 of the n items have changed since the base, World::publish() makes a new base or a clone(). A base also keeps a
/// file open. On other systems, or if the system refuses the file, each snapshot takes as much memory as a clone(). So
/// does a replica that is attached to a snapshot, unless it shares pages. World::memory() counts shared pages once for
/// each replica.
///
/// When a thread has released or destroyed the last handle of an immutable world, the original world keeps the memory
/// of the immutable world for a later call of World::publish(). If the original world no longer needs this memory, or
/// has been destroyed before, the same thread frees it. A snapshot can exist longer than the original world. Do not use
/// a reference to the immutable world, or a PathSearch in it, after you have released the handle.
///
/// Threads: several threads may query one snapshot at once, each with its own QueryContext. Each handle belongs to one
/// thread at a time, like a std::shared_ptr: give each thread a handle of its own. Threads may copy, release and
/// destroy their handles while another thread calls any member of the world. To copy, release or destroy a handle never
/// waits for another thread.
class WAYWRIGHT_API WorldSnapshot {
 public:
  /// Makes an empty handle, which has no world.
  WorldSnapshot() noexcept = default;
  /// Makes another handle of the same immutable world.
  /// Cost: O(1). Allocates nothing.
  WorldSnapshot(const WorldSnapshot& other) noexcept;
  /// Moves the handle. `other` is empty afterwards.
  WorldSnapshot(WorldSnapshot&& other) noexcept : replica_(other.replica_) { other.replica_ = nullptr; }
  WorldSnapshot& operator=(const WorldSnapshot& other) noexcept;
  WorldSnapshot& operator=(WorldSnapshot&& other) noexcept;
  ~WorldSnapshot() { release(); }

  /// Makes the handle empty.
  /// Cost: O(1), or linear in the world if this handle is the last, and the world does not keep the memory or has
  /// attached a replica to the snapshot.
  void release() noexcept;

  /// Returns whether the handle is not empty.
  [[nodiscard]] explicit operator bool() const noexcept { return replica_ != nullptr; }
  /// Returns the immutable world.
  /// Requires: the handle is not empty.
  [[nodiscard]] const World& operator*() const;
  /// @copydoc operator*() const
  [[nodiscard]] const World* operator->() const { return &**this; }
  /// Returns the World::version() of the immutable world.
  /// Requires: the handle is not empty.
  [[nodiscard]] std::uint64_t version() const;

  /// Returns whether both handles share one immutable world, or are both empty.
  [[nodiscard]] bool operator==(const WorldSnapshot& other) const noexcept { return replica_ == other.replica_; }

 private:
  friend class World;
  /// Makes a handle. Requires: the caller has added this handle to the count of handles in `replica`.
  explicit WorldSnapshot(detail::Replica* replica) noexcept : replica_(replica) {}

  detail::Replica* replica_ = nullptr;
};

/// @}

}  // namespace waywright

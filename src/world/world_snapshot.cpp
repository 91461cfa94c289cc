#include "waywright/world_snapshot.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "waywright/world.hpp"

#include "base/compiler.hpp"
#include "base/float_environment.hpp"
#include "constraint/constrained_triangulation.inl"
#include "world/item_shape.hpp"
#include "world/snapshot_pool.hpp"
#include "world/world_impl.hpp"

// Snapshots for readers. A snapshot refers to a replica: a copy of the world. World::publish() makes a replica that
// nobody reads equal to the world.

namespace waywright {

namespace {

/// Commits an operation. GCC 12 warns of members without a value if it inlines this.
template <class Operation>
WAYWRIGHT_NO_INLINE void commit(Operation& operation) {
  operation.commit();
}

}  // namespace

bool World::Impl::follow_item(const Impl& other, ItemId id, ReplicaScratch& scratch) {
  const bool is_here = triangulation.items().contains(id);
  const bool is_there = other.triangulation.items().contains(id);
  if (!is_here && !is_there) return true;
  if (is_here) fill_shape(triangulation, id, scratch.in_replica);
  if (is_there) fill_shape(other.triangulation, id, scratch.in_world);
  if (is_here && is_there && scratch.in_replica == scratch.in_world) return true;
  Operation operation(*this, Operation::Kind::follow);
  if (is_here) operation.remove(id);
  if (is_there && operation.insert(scratch.in_world, id)) return false;
  commit(operation);
  return true;
}

// One operation for each item: it removes the old shape and inserts the new one while the memory of this place is in
// the cache. One operation for all items takes 5 to 10 % longer if they are far from each other.
bool World::Impl::follow(const Impl& other, std::span<const ItemId> changed, ReplicaScratch& scratch) {
  change_log.reserve_to_follow(other.change_log);
  if (touch_log.use_count() > 1) {
    // A search in an earlier snapshot refers to the log.
    auto fresh = std::make_shared<TouchLog>(version());
    touch_log->note_world_gone();
    touch_log = std::move(fresh);
  }
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (i % ReplicaPrefetch::kItems == 0) {
      const std::size_t count = std::min(changed.size() - i, ReplicaPrefetch::kItems);
      scratch.prefetch.run(triangulation, other.triangulation, kept_abstraction(), changed.subspan(i, count));
    }
    if (!follow_item(other, changed[i], scratch)) return false;
  }
  // Nothing can fail from here on.
  change_log.follow(other.change_log, version());
  touch_log->restart(other.version());
  triangulation.set_largest_id_seen(other.triangulation.items().largest_id_seen());
  limits = other.limits;
  return true;
}

WorldSnapshot World::publish() {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  if (!impl_->snapshots) impl_->snapshots = std::make_unique<SnapshotPool>(version());
  SnapshotPool& pool = *impl_->snapshots;
  detail::Replica* replica = pool.newest();
  const bool is_same = replica != nullptr && replica->world.version() == version() &&
                       replica->world.largest_id_seen() == largest_id_seen() &&
                       replica->world.new_vertex_limit() == new_vertex_limit();
  if (is_same && replica->add_handle_if_any()) return WorldSnapshot(replica);
  replica = pool.find_free();
  if (replica != nullptr && !replica->world.impl_->follow(*impl_, pool.changed(), pool.scratch())) {
    pool.drop(replica);
    replica = nullptr;
  }
  if (replica == nullptr) replica = pool.add(World(std::make_unique<Impl>(*impl_, History())));
  pool.hand_out(replica);
  replica->add_first_handle();
  return WorldSnapshot(replica);
}

WorldSnapshot::WorldSnapshot(const WorldSnapshot& other) noexcept : replica_(other.replica_) {
  if (replica_ != nullptr) replica_->add_handle();
}

WorldSnapshot& WorldSnapshot::operator=(const WorldSnapshot& other) noexcept { return *this = WorldSnapshot(other); }

WorldSnapshot& WorldSnapshot::operator=(WorldSnapshot&& other) noexcept {
  if (this == &other) return *this;
  release();
  replica_ = std::exchange(other.replica_, nullptr);
  return *this;
}

void WorldSnapshot::release() noexcept {
  if (replica_ != nullptr) std::exchange(replica_, nullptr)->remove_handle();
}

const World& WorldSnapshot::operator*() const {
  WAYWRIGHT_ASSERT(replica_ != nullptr, detail::kEmptySnapshot);
  return replica_->world;
}

std::uint64_t WorldSnapshot::version() const { return (**this).version(); }

}  // namespace waywright

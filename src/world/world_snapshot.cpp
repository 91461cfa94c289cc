#include "waywright/world_snapshot.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "base/compiler.hpp"
#include "base/float_environment.hpp"
#include "world/layers.hpp"
#include "world/snapshot_pool.hpp"
#include "world/world_impl.hpp"

// Snapshots for readers. A snapshot refers to a replica: a copy of the world. World::publish() takes a replica without
// readers and makes it equal to the world, or to the world at a tick.

namespace waywright {

namespace {

/// The limit of the vertices of a replica that follows the world is twice the number of vertices of both, plus this
/// number. See World::Impl::follow().
constexpr std::size_t kMoreVertices = 1024;

/// The spare room in the arena of a base, in bytes, apart from a share of the size of the world.
constexpr std::size_t kSpareInArena = std::size_t{1} << 20;

}  // namespace

bool World::Impl::follow_item(const ItemsAtTick& items, ItemId id, std::size_t most_vertices, ReplicaScratch& scratch) {
  const bool is_here = triangulation().items().contains(id);
  const bool is_there = items.find(id, scratch.in_world);
  if (!is_here && !is_there) return true;
  if (is_here) fill_shape(triangulation(), id, scratch.in_replica);
  if (is_here && is_there && scratch.in_replica == scratch.in_world) return true;
  Operation operation(*this, Operation::Kind::follow, most_vertices);
  if (is_here) operation.remove(id);
  if (is_there && operation.insert(scratch.in_world, id)) return false;
  operation.commit();
  return true;
}

void World::Impl::set_version(const Impl& other, std::uint64_t version) {
  change_log.follow(other.change_log, this->version(), version);
  touch_log->restart(version);
}

// One operation for each item: it removes the old shape and inserts the new one while the memory of this place is in
// the cache. One operation for all items takes 5 to 10 % longer if they are far from each other.
bool World::Impl::follow(const Impl& other, const ReplicaState& state, const ItemsAtTick& items,
                         std::span<const ItemId> changed, ReplicaScratch& scratch) {
  change_log.reserve_to_follow(other.change_log);
  if (touch_log.use_count() > 1) {
    // A search in an earlier snapshot refers to the log.
    auto fresh = std::make_shared<TouchLog>(version());
    touch_log->note_world_gone();
    touch_log = std::move(fresh);
  }
  // If memory runs out while this replica changes, it has the smaller one of two versions: its old version, and that of
  // `state`. Then SnapshotPool::find_free() finds all items in which this replica may differ from another state.
  if (state.version < version()) set_version(other, state.version);
  // Old shapes of some items may cross new shapes of others very often, although no state of the world has these
  // crossings. If they make more vertices than this limit, the function returns false, because a copy of the world
  // costs less.
  const std::size_t most_vertices =
      2 * (triangulation().topology().vertex_count() + other.triangulation().topology().vertex_count()) + kMoreVertices;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (i % ReplicaPrefetch::kItems == 0) {
      const std::size_t count = std::min(changed.size() - i, ReplicaPrefetch::kItems);
      scratch.prefetch.run(triangulation(), other.triangulation(), layers.abstraction(), changed.subspan(i, count));
    }
    if (!follow_item(items, changed[i], most_vertices, scratch)) return false;
  }
  // Nothing can fail from here on.
  set_version(other, state.version);
  layers.set_largest_id_seen(state.largest_id);
  limits = other.limits;
  return true;
}

detail::Replica* World::Impl::share(const ReplicaState& state) {
  if (!snapshots) snapshots = std::make_unique<SnapshotPool>(version());
  return snapshots->add_handle_of(state);
}

detail::Replica* World::Impl::add_replica(const ReplicaState& state) {
  auto copy = std::make_unique<Impl>(*this, History());
  if (state.tick) {
    copy->bring_back(history, *state.tick);
    copy->change_log = change_log;
    copy->set_version(*this, state.version);
  }
  return snapshots->add(World(std::move(copy)), nullptr, state.tick.has_value());
}

World World::Impl::copy_in(memory::Arena& arena) const {
  const memory::ArenaScope scope(arena);
  return World(std::make_unique<Impl>(*this, History()));
}

// The copy has the undo logs of the last operation. They are outside the arena, so each replica of the base would copy
// them. shrink_to_fit() frees them.
const detail::Replica* World::Impl::find_or_make_base(const ItemsAtTick& items, std::size_t bytes) {
  if (const detail::Replica* const base = snapshots->find_base(items)) return base;
  if (!snapshots->should_make_base()) return nullptr;
  std::unique_ptr<memory::Arena> arena = memory::Arena::make(bytes + bytes / 16 + kSpareInArena);
  if (arena == nullptr) {
    snapshots->stop_sharing();
    return nullptr;
  }
  World copy = copy_in(*arena);
  copy.shrink_to_fit();
  snapshots->set_base(std::move(copy), std::move(arena));
  return snapshots->find_base(items);
}

detail::Replica* World::Impl::add_sharing_replica(const ReplicaState& state, const ItemsAtTick& items) {
  if (!snapshots->may_share(state, items)) return nullptr;
  const std::size_t bytes = memory().total();
  if (bytes < snapshots->least_shared()) return nullptr;
  const detail::Replica* const base = find_or_make_base(items, bytes);
  if (base == nullptr) return nullptr;
  std::unique_ptr<memory::Arena> arena = base->arena->share();
  if (arena == nullptr) {
    snapshots->stop_sharing();
    return nullptr;
  }
  World copy = base->world.impl_->copy_in(*arena);  // destroyed before `arena`
  if (!copy.impl_->follow(*this, state, items, snapshots->changed(), snapshots->scratch())) return nullptr;
  return snapshots->add(std::move(copy), std::move(arena), state.tick.has_value());
}

detail::Replica* World::Impl::publish(const ReplicaState& state, const ItemsAtTick& items) {
  detail::Replica* replica = snapshots->find_free(state, items);
  if (replica != nullptr &&
      !replica->world.impl_->follow(*this, state, items, snapshots->changed(), snapshots->scratch())) {
    snapshots->drop(replica);
    replica = nullptr;
  }
  if (replica == nullptr) replica = add_sharing_replica(state, items);
  if (replica == nullptr) replica = add_replica(state);
  snapshots->hand_out(replica, triangulation().items().size());
  replica->add_first_handle();
  return replica;
}

WorldSnapshot World::publish() {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  const ReplicaState now{std::nullopt, version(), largest_id_seen(), new_vertex_limit()};
  if (detail::Replica* const shared = impl_->share(now)) return WorldSnapshot(shared);
  return WorldSnapshot(impl_->publish(now, ItemsAtTick(impl_->triangulation())));
}

Result<WorldSnapshot> World::publish(std::uint64_t tick) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  History& history = impl_->history;
  if (auto error = history.find_error(tick)) return *std::move(error);
  const ReplicaState then{tick, history.version(tick), history.largest_id(tick), new_vertex_limit()};
  if (detail::Replica* const shared = impl_->share(then)) return WorldSnapshot(shared);
  const std::vector<History::ChangedItem> changed = history.changed_since(tick);
  return WorldSnapshot(impl_->publish(then, ItemsAtTick(impl_->triangulation(), history, changed)));
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

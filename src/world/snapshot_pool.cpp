#include "world/snapshot_pool.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "memory/count.hpp"

namespace waywright {

namespace detail {

bool Replica::add_handle_if_any() {
  std::size_t handles = handles_.load(std::memory_order_relaxed);
  while (handles != 0) {
    if (handles_.compare_exchange_weak(handles, handles + 1, std::memory_order_relaxed)) return true;
  }
  return false;
}

// The subtractions from `handles_` have acquire and release order, so all queries of the readers happen before the last
// handle calls release(). release() subtracts from `owners_` with release order, and is_free() reads `owners_` with
// acquire order. So the queries also happen before the changes for the next snapshot.
void Replica::remove_handle() noexcept {
  if (handles_.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  if (Replica* const other = std::exchange(released_with_last_handle_, nullptr)) other->release();
  release();
}

void Replica::release() noexcept {
  if (owners_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace detail

using detail::Replica;

void ReplicaScratch::count_memory(MemoryUse& use) const {
  for (const Shape* const shape : {&in_world, &in_replica}) {
    use.spare += shape->rings.capacity() * sizeof(Point);
  }
  prefetch.count_memory(use);
}

SnapshotPool::~SnapshotPool() {
  for (Replica* const replica : replicas_) replica->release();
  if (base_ != nullptr) base_->release();
}

template <class Matches>
SnapshotPool::Replicas::iterator SnapshotPool::find_oldest(Matches&& matches) {
  auto oldest = replicas_.end();
  for (auto i = replicas_.begin(); i != replicas_.end(); ++i) {
    if (!matches(*i)) continue;
    if (oldest == replicas_.end() || (*i)->world.version() < (*oldest)->world.version()) oldest = i;
  }
  return oldest;
}

template <class Matches>
std::size_t SnapshotPool::count(Matches&& matches) const {
  return static_cast<std::size_t>(std::count_if(replicas_.begin(), replicas_.end(), matches));
}

Replica* SnapshotPool::add_handle_of(const ReplicaState& state) const {
  for (Replica* const replica : replicas_) {
    const World& world = replica->world;
    const bool is_equal = world.version() == state.version && world.largest_id_seen() == state.largest_id &&
                          world.new_vertex_limit() == state.new_vertex_limit;
    if (is_equal && replica->add_handle_if_any()) return replica;
  }
  return nullptr;
}

// A replica may have repeated a change that a rewind has taken back later. The extended record may lack this change. So
// a replica to which the record did not reach back before cannot follow the world afterwards, either.
void SnapshotPool::extend_record(std::uint64_t version, const ItemsAtTick& items) {
  if (changed_.has_all_since(version) || items.changed().size() > changed_.limit()) return;
  for (Replica* const replica : replicas_) {
    if (!can_follow(*replica)) replica->note_too_old();
  }
  if (base_ != nullptr && !can_follow(*base_)) base_->note_too_old();
  std::vector<ChangedItems::Entry> changed;
  for (const History::ChangedItem& item : items.changed()) {
    changed.push_back({items.version_after(item).value_or(std::numeric_limits<std::uint64_t>::max()), item.id});
  }
  changed_.extend_to(version, std::move(changed));
}

void SnapshotPool::add_changed(const ItemsAtTick& items) {
  for (const History::ChangedItem& item : items.changed()) ids_.push_back(item.id);
}

// If an item differs between the replica and a tick, it has changed since the tick (ItemsAtTick::changed()), or it is
// now as it was at the tick. In the second case it has changed since the version of the replica. The limit is higher
// for a tick: if the function returns null, the caller copies the world, and the copy must go back over the changes
// since the tick.
Replica* SnapshotPool::find_free(const ReplicaState& state, const ItemsAtTick& items) {
  extend_record(state.version, items);
  const auto distance = [&](const Replica* replica) {
    const std::uint64_t version = replica->world.version();
    return std::max(version, state.version) - std::min(version, state.version);
  };
  Replica* nearest = nullptr;
  for (Replica* const replica : replicas_) {
    if (replica->serves_ticks() != state.tick.has_value() || !replica->is_free() || !can_follow(*replica)) continue;
    if (nearest == nullptr || distance(replica) < distance(nearest)) nearest = replica;
  }
  return nearest != nullptr && find_changed(nearest->world.version(), items, limit_) ? nearest : nullptr;
}

bool SnapshotPool::find_changed(std::uint64_t version, const ItemsAtTick& items, std::size_t limit) {
  changed_.since(version, ids_);
  if (!items.changed().empty()) {
    add_changed(items);
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  }
  return ids_.size() <= limit + items.changed().size();
}

bool SnapshotPool::may_share(const ReplicaState& state, const ItemsAtTick& items) const {
  if (!can_share_ || items.changed().size() > limit_ / kLimitDivisor) return false;
  const auto is_held = [&](const Replica* replica) {
    return replica->serves_ticks() == state.tick.has_value() && !replica->is_free();
  };
  return base_ != nullptr || count(is_held) >= first_count_;
}

const Replica* SnapshotPool::find_base(const ItemsAtTick& items) {
  if (base_ == nullptr || !can_follow(*base_)) return nullptr;
  return find_changed(base_->world.version(), items, limit_ / kLimitDivisor) ? base_ : nullptr;
}

bool SnapshotPool::should_make_base() { return std::exchange(sharing_base_, least_sharing_) >= least_sharing_; }

// `new` allocates before it moves the arena into the replica. So if memory runs out, the caller still has the arena,
// and frees it after the copy.
void SnapshotPool::set_base(World&& copy, std::unique_ptr<memory::Arena>&& arena) {
  Replica* const base = new Replica(std::move(copy), std::move(arena), base_number_ + 1, false);
  if (Replica* const old = std::exchange(base_, base)) old->release();
  ++base_number_;
  sharing_base_ = 0;
}

void SnapshotPool::stop_sharing() {
  can_share_ = false;
  if (Replica* const old = std::exchange(base_, nullptr)) old->release();
}

void SnapshotPool::drop(Replica* replica) {
  replicas_.erase(std::find(replicas_.begin(), replicas_.end(), replica));
  replica->release();
}

Replica* SnapshotPool::add(World&& copy, std::unique_ptr<memory::Arena>&& arena, bool serves_ticks) {
  const bool is_sharing = arena != nullptr;
  replicas_.reserve(kMost + 1);
  replicas_.push_back(new Replica(std::move(copy), std::move(arena), base_number_, serves_ticks));
  if (is_sharing) {
    ++sharing_base_;
    ++sharing_count_;
  }
  return replicas_.back();
}

void SnapshotPool::hand_out(Replica* replica, std::size_t item_count) {
  replicas_.erase(std::find(replicas_.begin(), replicas_.end(), replica));
  release_too_old();
  replica->release_with_last_handle(take_unneeded(*replica));
  replicas_.push_back(replica);
  limit_ = kFewChanges + item_count / kItemsForEachChange;
  changed_.set_limit(limit_);
  const std::uint64_t oldest = (*find_oldest([](const Replica*) { return true; }))->world.version();
  changed_.forget_until(base_ == nullptr ? oldest : std::min(oldest, base_->world.version()));
}

void SnapshotPool::release_too_old() {
  std::erase_if(replicas_, [&](Replica* replica) {
    const bool is_kept = replica->is_free() || can_follow(*replica);
    if (!is_kept) replica->release();
    return !is_kept;
  });
  if (replicas_.size() < kMost) return;
  auto oldest = find_oldest([](const Replica* replica) { return !replica->is_free(); });
  if (oldest == replicas_.end()) oldest = find_oldest([](const Replica*) { return true; });
  (*oldest)->release();
  replicas_.erase(oldest);
}

Replica* SnapshotPool::take_unneeded(const Replica& handed_out) {
  const auto shares = [](const Replica* replica) { return replica->arena != nullptr; };
  auto oldest = find_oldest([&](const Replica* replica) { return replica->is_free() && !can_follow(*replica); });
  for (const bool of_ticks : {false, true}) {
    const auto is_spare = [&](const Replica* replica) {
      return replica->is_free() && replica->serves_ticks() == of_ticks;
    };
    if (oldest != replicas_.end() || count(is_spare) <= kMostFree) continue;
    oldest = find_oldest([&](const Replica* replica) { return is_spare(replica) && shares(replica); });
    if (oldest == replicas_.end()) oldest = find_oldest(is_spare);
  }
  if (oldest == replicas_.end()) {
    const bool is_shared = shares(&handed_out) || count(shares) != 0;
    const bool is_unneeded = base_ != nullptr && (!is_shared || !can_follow(*base_));
    return is_unneeded ? std::exchange(base_, nullptr) : nullptr;
  }
  Replica* const unneeded = *oldest;
  replicas_.erase(oldest);
  return unneeded;
}

void SnapshotPool::count_memory(MemoryUse& use) const {
  use.spare += sizeof(SnapshotPool);
  changed_.count_memory(use);
  scratch_.count_memory(use);
  memory::count_spare(use, replicas_, ids_);
  for (const Replica* const replica : replicas_) {
    if (replica->is_free()) use.spare += sizeof(Replica) + replica->world.memory().total();
  }
  if (base_ != nullptr) use.spare += sizeof(Replica) + base_->world.memory().total();
}

void ReplicaPrefetch::run(const Triangulation& replica, const Triangulation& world, const nav::Abstraction* abstraction,
                          std::span<const ItemId> ids) {
  constexpr int kSteps = 8;  // few vertices have more edges
  find_corners(replica, world, ids);
  const auto& geometry = world.triangulation().geometry();
  spokes_.clear();
  for (const mesh::Vertex v : corners_) {
    const mesh::HalfEdge h = replica.topology().outgoing(v);
    spokes_.push_back({h, h, mesh::face(h)});
    replica.triangulation().prefetch_star(v);
  }
  for (const mesh::Vertex v : new_corners_) replica.triangulation().prefetch_start(geometry.rounded(number(v)));
  advance_spokes(replica, abstraction);
  starts_.clear();
  for (const mesh::Vertex v : new_corners_) {
    const mesh::Vertex start = replica.triangulation().probable_start(geometry.rounded(number(v)));
    if (start == mesh::kNoVertex) continue;
    replica.triangulation().prefetch(start);
    starts_.push_back(start);
  }
  advance_spokes(replica, abstraction);
  for (const mesh::Vertex v : starts_) {
    if (replica.topology().is_live(v)) replica.topology().prefetch(replica.topology().outgoing(v));
  }
  for (int i = 2; i < kSteps; ++i) advance_spokes(replica, abstraction);
}

/// Fills `corners_` and `new_corners_`, and prefetches their positions.
void ReplicaPrefetch::find_corners(const Triangulation& replica, const Triangulation& world,
                                   std::span<const ItemId> ids) {
  for (const ItemId id : ids) {
    replica.items().prefetch_record(id);
    world.items().prefetch_record(id);
  }
  const auto has_sides = [](const Triangulation& triangulation, ItemId id) {
    const constraint::ItemTable& items = triangulation.items();
    return items.contains(id) && items.kind(items.slot(id)) != ItemKind::point;
  };
  for (const ItemId id : ids) {
    for (const Triangulation* each : {&replica, &world}) {
      if (has_sides(*each, id)) each->items().prefetch_sides(each->items().slot(id));
    }
  }
  corners_.clear();
  new_corners_.clear();
  for (const ItemId id : ids) {
    if (replica.items().contains(id)) {
      replica.items().for_each_corner(replica.items().slot(id), [&](mesh::Vertex v, bool) {
        corners_.push_back(v);
        replica.triangulation().prefetch(v);
        replica.prefetch_corner_uses(v);
      });
    }
    if (world.items().contains(id)) {
      world.items().for_each_corner(world.items().slot(id), [&](mesh::Vertex v, bool) {
        new_corners_.push_back(v);
        world.triangulation().prefetch(v);
      });
    }
  }
}

/// Replaces each spoke by the next one around its vertex, and prefetches what the changes read around its face. Drops
/// the spokes that have gone around their vertex.
void ReplicaPrefetch::advance_spokes(const Triangulation& replica, const nav::Abstraction* abstraction) {
  const mesh::TriangleMesh& mesh = replica.topology();
  std::size_t kept = 0;
  for (Spoke spoke : spokes_) {
    const mesh::HalfEdge h = spoke.h;
    replica.triangulation().prefetch(mesh.target(h));
    const mesh::HalfEdge beyond = mesh.twin(mesh::next(h));
    mesh.prefetch(beyond);
    mesh.prefetch_label(h);
    if (abstraction != nullptr) {
      abstraction->prefetch_component_of(mesh::face(h));
      abstraction->core().prefetch(mesh::face(h));
      abstraction->components().prefetch_component(spoke.before);
      abstraction->prefetch_component_of(mesh::face(beyond));
    }
    spoke.before = mesh::face(h);
    spoke.h = mesh.next_around(h);
    if (spoke.h == spoke.first) continue;
    mesh.prefetch(spoke.h);
    spokes_[kept++] = spoke;
  }
  spokes_.resize(kept);
}

void ChangedItems::forget_until(std::uint64_t version) { complete_since_ = std::max(complete_since_, version); }

// If an item has changed after `complete_since_`, the record has an entry for this change already. So no new entry
// needs a version after `complete_since_`, and the entries stay in ascending order.
void ChangedItems::extend_to(std::uint64_t version, std::vector<Entry> changed) {
  drop_forgotten();
  for (Entry& entry : changed) entry.version = std::min(entry.version, complete_since_);
  keep_last(changed);
  entries_.insert(entries_.begin(), changed.begin(), changed.end());
  complete_since_ = version;
}

void ChangedItems::since(std::uint64_t version, std::vector<ItemId>& ids) {
  const auto after = [](std::uint64_t since, const Entry& entry) { return since < entry.version; };
  found_.assign(std::upper_bound(entries_.begin(), entries_.end(), version, after), entries_.end());
  keep_last(found_);
  ids.clear();
  for (const Entry& entry : found_) ids.push_back(entry.id);
}

void ChangedItems::keep_last(std::vector<Entry>& entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.id != b.id ? a.id < b.id : a.version > b.version; });
  entries.erase(
      std::unique(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id == b.id; }),
      entries.end());
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.version != b.version ? a.version < b.version : a.id < b.id;
  });
}

void ChangedItems::drop_forgotten() {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.version <= complete_since_; });
}

void ChangedItems::make_room(std::uint64_t version) {
  drop_forgotten();
  keep_last(entries_);
  if (entries_.size() > limit_) {
    complete_since_ = entries_[entries_.size() / 2].version;
    drop_forgotten();
  }
  if (complete_since_ >= version) return;
  if (2 * entries_.size() >= entries_.capacity())
    entries_.reserve(std::max(kSmallestCapacity, 2 * entries_.capacity()));
}

}  // namespace waywright

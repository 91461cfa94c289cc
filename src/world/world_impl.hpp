#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "constraint/batch.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "path/ground.hpp"
#include "world/change_log.hpp"
#include "world/history.hpp"
#include "world/layers.hpp"
#include "world/operation.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/snapshot_pool.hpp"

namespace waywright {

inline constexpr char kInAttempt[] =
    "World: the question of World::attempt() must not change or clone the world, begin or continue a PathSearch, or "
    "make or update a PathWatch";

struct WAYWRIGHT_INTERNAL World::Impl {
  Impl(const Box& domain, const WorldOptions& options)
      : layers(constraint::ConstrainedTriangulation(domain), {options.keep_abstraction, options.keep_bridges}) {
    limits.of_operation = options.new_vertex_limit;
  }
  /// Makes a copy. The copy has its own TouchLog, its own context for queries and no snapshots. Its history is
  /// `kept_history`. Requires: no operation is under way.
  Impl(const Impl& other, const History& kept_history)
      : layers(other.layers),
        limits(other.limits),
        touch_log(std::make_shared<TouchLog>(other.version())),
        change_log(other.change_log),
        history(kept_history) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { touch_log->note_world_gone(); }

  /// Inserts a batch as one operation. If the world has no items, builds a new mesh. If the batch exceeds a limit,
  /// changes nothing and returns the error, with the index of an item of the batch.
  template <class Batch>
  [[nodiscard]] std::optional<Error> insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  /// Checks a batch of points whose ids ascend, and inserts it.
  [[nodiscard]] std::optional<Error> insert_points(const constraint::PointBatch& batch, const BulkOptions& options);
  /// Makes changes that a ChangeCheck has accepted. `ids` are the ids of their items. If an insertion exceeds a limit,
  /// returns the error; the operation must then be undone.
  [[nodiscard]] static std::optional<Error> make_changes(Operation& operation, std::span<const Change> changes,
                                                         std::span<const ItemId> ids);
  /// Brings back the items of a tick as one operation. `from` is the history of this world, or of the world of which it
  /// is a copy. Requires: the history has the tick.
  void bring_back(History& from, History::Tick tick);
  /// If a replica with readers has this state, adds a handle to it and returns it. Otherwise returns null.
  [[nodiscard]] detail::Replica* share(const ReplicaState& state);
  /// Returns a replica that had no readers, with this state and one handle. `items` are the items of the state.
  /// Requires: share() has returned null.
  [[nodiscard]] detail::Replica* publish(const ReplicaState& state, const ItemsAtTick& items);
  /// Adds a replica with this state to the pool: a copy of this world with memory of its own, or a copy that shares
  /// pages with other replicas. The second function returns null if such a copy has no advantage or is not possible.
  [[nodiscard]] detail::Replica* add_replica(const ReplicaState& state);
  [[nodiscard]] detail::Replica* add_sharing_replica(const ReplicaState& state, const ItemsAtTick& items);
  /// Returns a base of `snapshots` that differs little from the state with these items, or null if a new base has no
  /// advantage or is not possible. `bytes` is the memory of this world.
  [[nodiscard]] const detail::Replica* find_or_make_base(const ItemsAtTick& items, std::size_t bytes);
  /// Returns a copy of this world whose arrays are in an arena.
  [[nodiscard]] World copy_in(memory::Arena& arena) const;
  /// Gives this world a state of `other`, with these items. `changed` are the items that may differ. If memory runs
  /// out, some of these items may already be as in this state, and the version may be that of this state. The caller
  /// can then call the function again, with this state or another one. Returns true if it has succeeded. If the result
  /// is false, a state between the changes would have too many vertices, and this world must not be used any more.
  /// Requires: this world is a replica of `other`, and nobody reads it.
  [[nodiscard]] bool follow(const Impl& other, const ReplicaState& state, const ItemsAtTick& items,
                            std::span<const ItemId> changed, ReplicaScratch& scratch);
  /// Gives one item the shape that it has in `items`, or removes it. Returns false if the mesh would have more than
  /// `most_vertices`.
  [[nodiscard]] bool follow_item(const ItemsAtTick& items, ItemId id, std::size_t most_vertices,
                                 ReplicaScratch& scratch);
  /// Gives this replica a version of `other`, and the changed boxes up to this version. Allocates nothing. Requires:
  /// the requirements of ChangeLog::follow().
  void set_version(const Impl& other, std::uint64_t version);
  /// Records in `snapshots` an item that the operation in progress inserts or removes.
  void note_for_snapshots(ItemId id) {
    if (snapshots) snapshots->note_changed(id, version() + 1);
  }
  /// World::find_path() for a query without an error.
  void find_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  [[nodiscard]] std::uint64_t version() const { return touch_log->version(); }
  /// Returns the memory of this world without its replicas.
  [[nodiscard]] MemoryUse memory() const;
  [[nodiscard]] const constraint::ConstrainedTriangulation& triangulation() const { return layers.triangulation(); }
  [[nodiscard]] path::Ground ground() const { return layers.ground(); }

  Layers layers;
  constraint::VertexLimits limits;  ///< of each operation
  std::shared_ptr<TouchLog> touch_log = std::make_shared<TouchLog>();
  ChangeLog change_log;
  History history;
  constraint::Outline outline;  ///< scratch
  SpareContext spare_context;
  std::unique_ptr<SnapshotPool> snapshots;  ///< null until the first snapshot
  std::optional<Operation> attempt;         ///< the operation of World::attempt(), while its question runs
};

template <class Batch>
std::optional<Error> World::Operation::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  impl_.layers.insert_all(batch, team);
  if (impl_.triangulation().has_too_many_vertices()) return limit_error(impl_.triangulation(), batch);
  note_insertions(batch);
  return std::nullopt;
}

template <class Batch>
std::optional<Error> World::Operation::replace_all(const Batch& batch, ItemId largest_id,
                                                   const threads::ThreadTeam& team) {
  constraint::ConstrainedTriangulation made(impl_.triangulation().domain(), batch, team, limits_);
  if (made.has_too_many_vertices()) return limit_error(made, batch);
  made.mark_used(largest_id);
  made_ = std::make_unique<Layers>(std::move(made), impl_.layers.kept());
  return std::nullopt;
}

template <class Batch>
void World::Operation::note_insertions(const Batch& batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) note_insertion(batch.kind(i), batch.rings(i), batch.id(i));
}

/// Records an insertion. Points are not walls, so the change log does not record them.
template <class Rings>
void World::Operation::note_insertion(ItemKind kind, const Rings& rings, ItemId id) {
  if (kind_ == Kind::change) impl_.history.add_insertion(id);
  if (kind_ != Kind::attempt) impl_.note_for_snapshots(id);
  if (!is_logged() || kind == ItemKind::point) return;
  impl_.change_log.add_insertion();
  for (const auto& ring : rings) {
    for (const Point& p : ring) impl_.change_log.add_point(p);
  }
}

template <class Batch>
std::optional<Error> World::Impl::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  Operation operation(*this);
  std::optional<Error> error;
  if (triangulation().items().size() == 0) {
    operation.note_insertions(batch);
    error = operation.replace_all(batch, triangulation().items().largest_id_seen(), team);
  } else {
    error = operation.insert_all(batch, team);
  }
  if (!error) operation.commit();
  return error;
}

}  // namespace waywright

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

#include "clearance/clearance.hpp"
#include "clearance/widest.hpp"
#include "constraint/batch.hpp"
#include "constraint/exact_triangulation.hpp"
#include "nav/abstraction.hpp"
#include "world/change_log.hpp"
#include "world/history.hpp"
#include "world/limit_error.hpp"
#include "world/path_query_error.hpp"
#include "world/snapshot_pool.hpp"
#include "world/spare_context.hpp"
#include "world/touch_log.hpp"

namespace waywright {

inline constexpr char kInAttempt[] =
    "World: the question of World::attempt() must not change or clone the world, begin or continue a PathSearch, or "
    "make or update a PathWatch";

/// An operation on a world. If the object is destroyed before commit(), for example because memory runs out, its
/// destructor takes all changes back.
class WAYWRIGHT_INTERNAL World::Operation {
 public:
  enum class Kind : std::uint8_t {
    change,   ///< the history records the changes
    rewind,   ///< the history does not record the changes, and no limit applies: the world had these items before
    attempt,  ///< the caller calls update() and not commit(), so the destructor takes the changes back
    follow,   ///< a replica repeats a change of its world; history and ChangeLog do not record it
  };

  /// Starts an operation. If no limit of the world applies to it, the mesh may have `most_vertices` vertices
  /// afterwards.
  explicit Operation(Impl& impl, Kind kind = Kind::change, std::size_t most_vertices = constraint::kMostVertices);
  ~Operation();
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  // If an insertion exceeds a limit, the functions return the error. The operation must then be undone. The second
  // function sets the index of the error to the index of an item in the batch.
  [[nodiscard]] std::optional<Error> insert(const Shape& shape, ItemId id);
  template <class Batch>
  [[nodiscard]] std::optional<Error> insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  void remove(ItemId id);
  void set_largest_id_seen(ItemId id);
  /// Updates the bridges and the abstraction, so that all queries see the changes. Call it once, after all changes.
  void update();
  /// Calls update() and makes the changes final.
  void commit();

 private:
  void update_abstraction_of_walls();
  void note_inserted(ItemKind kind, ItemId id);
  void note_changed(ItemId id);
  [[nodiscard]] bool is_limited() const { return kind_ == Kind::change || kind_ == Kind::attempt; }

  Impl& impl_;
  Kind kind_;
  bool is_committed_ = false;
  bool has_made_abstraction_of_walls_ = false;
  constraint::ExactTriangulation::UndoGuard operation_;
  std::optional<clearance::Clearance::UndoGuard> clearance_operation_;
};

struct WAYWRIGHT_INTERNAL World::Impl {
  Impl(const Box& domain, const WorldOptions& options) : triangulation(domain) {
    limits.of_operation = options.new_vertex_limit;
    if (options.keep_abstraction) abstraction.emplace(triangulation);
    if (options.keep_bridges) clearance = std::make_unique<clearance::Clearance>(triangulation);
  }
  /// Makes a copy. The copy has its own TouchLog, its own context for queries and no snapshots. Its history is
  /// `kept_history`. Requires: no operation is under way.
  Impl(const Impl& other, const History& kept_history)
      : triangulation(other.triangulation),
        limits(other.limits),
        abstraction(other.abstraction),
        abstraction_of_walls(other.abstraction_of_walls),
        clearance(other.clearance ? std::make_unique<clearance::Clearance>(*other.clearance) : nullptr),
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
  /// Replaces all items by the items of a batch: builds a new triangulation and then replaces the old one. So the
  /// function is all or nothing without an undo log. `largest_id` is the largest id that the world has seen afterwards.
  /// If the batch exceeds a limit, changes nothing and returns the error. Requires: `change_log` contains the
  /// changes. The caller changes `history`.
  template <class Batch>
  [[nodiscard]] std::optional<Error> replace_all(const Batch& batch, ItemId largest_id,
                                                 const constraint::VertexLimits& made_limits,
                                                 const threads::ThreadTeam& team = {});
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
  // The next three functions record items in `change_log`: all items of a batch, one item that an operation inserts, or
  // one item that it removes.
  template <class Batch>
  void add_insertions_to_change_log(const Batch& batch);
  template <class Rings>
  void add_insertion_to_change_log(ItemKind kind, const Rings& rings);
  void add_removal_to_change_log(std::uint32_t slot);
  /// Records in `history` the shape of an item that an operation removes.
  void add_removal_to_history(std::uint32_t slot);
  /// Says which data the world keeps for path queries.
  [[nodiscard]] Kept kept() const { return {abstraction.has_value(), clearance != nullptr}; }
  // The queries behind the functions of World with these names. Requires: the query has no error.
  void find_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  void find_disc_paths_from(const ManyGoalsQuery& query, detail::QueryScratch& scratch, std::vector<Path>& paths) const;
  // The search for the path of a disc, in slices. Requires: the world does not change until the search is done. The
  // next two functions return whether the search is done.
  bool begin_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  /// Continues until `path.expansions` reaches `limit`.
  bool step_disc_path(std::size_t limit, detail::QueryScratch& scratch, Path& path) const;
  void fit_disc(const Point& centre, const Agent& agent, detail::QueryScratch& scratch, DiscFit& fit) const;
  void nearest_fit(const NearestFitQuery& query, detail::QueryScratch& scratch, NearestFit& fit) const;
  void widest_path(const Point& start, const Point& goal, detail::QueryScratch& scratch, WidestPath& widest) const;
  void write_widest(const clearance::WidestGap& gap, WidestPath& widest) const;
  // The steps of find_disc_paths_from() and begin_disc_path().
  [[nodiscard]] bool move_blocked_disc_ends(PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  [[nodiscard]] bool move_blocked_disc_end(PathQuery& query, bool is_start, const std::optional<Point>& other,
                                           detail::QueryScratch& scratch, Path& path) const;
  [[nodiscard]] std::optional<Point> find_disc_end(const PathQuery& query, const Point& end,
                                                   const std::optional<Point>& other,
                                                   detail::QueryScratch& scratch) const;
  void begin_disc_search(const PathQuery& query, detail::QueryScratch& scratch) const;
  /// nearest_fit() for a radius of 0, and for a radius above 0. The second function requires that the disc fits at the
  /// goal, if there is one.
  [[nodiscard]] std::optional<Point> nearest_free(const NearestFitQuery& query, detail::QueryScratch& scratch) const;
  [[nodiscard]] std::optional<Point> nearest_fit_of_disc(const NearestFitQuery& query,
                                                         detail::QueryScratch& scratch) const;
  [[nodiscard]] std::uint64_t version() const { return touch_log->version(); }
  /// Returns the memory of this world without its replicas.
  [[nodiscard]] MemoryUse memory() const;
  // The areas of points, for World::would_disconnect().
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> areas_of(PointSpan points, detail::QueryScratch& scratch) const;
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> areas_of(PointSpan points, const Agent& agent,
                                                                 detail::QueryScratch& scratch) const;
  /// Returns the abstraction, or null.
  [[nodiscard]] const nav::Abstraction* kept_abstraction() const { return abstraction ? &*abstraction : nullptr; }
  /// Returns the mesh in which the searches for discs run. Requires: the world keeps bridges.
  [[nodiscard]] const constraint::ExactTriangulation& mesh_of_discs() const {
    return clearance->triangulation_of_walls(triangulation);
  }
  /// Returns the abstraction of mesh_of_discs(), or null. Requires: the world keeps bridges.
  [[nodiscard]] const nav::Abstraction* kept_abstraction_for_discs() const {
    return abstraction_of_walls ? &*abstraction_of_walls : kept_abstraction();
  }

  /// The part of World::validate() for `abstraction_of_walls`.
  [[nodiscard]] std::optional<std::string> find_fault_in_abstraction_of_walls() const;

  constraint::ExactTriangulation triangulation;
  constraint::VertexLimits limits;  ///< of each operation
  std::optional<nav::Abstraction> abstraction;
  /// The abstraction of the second triangulation of `clearance`. It exists if `abstraction` and this triangulation do.
  std::optional<nav::Abstraction> abstraction_of_walls;
  std::unique_ptr<clearance::Clearance> clearance;  ///< null if the world keeps no bridges
  std::shared_ptr<TouchLog> touch_log = std::make_shared<TouchLog>();
  ChangeLog change_log;
  History history;
  mesh::TouchedFaces touched_faces;  ///< scratch of Operation::update()
  constraint::Outline outline;       ///< scratch
  SpareContext spare_context;
  std::unique_ptr<SnapshotPool> snapshots;  ///< null until the first snapshot
  std::optional<Operation> attempt;         ///< the operation of World::attempt(), while its question runs
};

inline World::Operation::Operation(Impl& impl, Kind kind, std::size_t most_vertices)
    : impl_(impl),
      kind_(kind),
      operation_(impl.triangulation,
                 is_limited() ? impl.limits : constraint::VertexLimits{.of_triangulation = most_vertices}) {
  if (impl_.abstraction) impl_.abstraction->begin();
  if (impl_.abstraction_of_walls) impl_.abstraction_of_walls->begin();
  if (impl_.clearance) clearance_operation_.emplace(*impl_.clearance);
  impl_.change_log.begin();
  impl_.history.begin();
}

// The destructors of the members take back the changes of the mesh and of the bridges.
inline World::Operation::~Operation() {
  if (is_committed_ || !impl_.abstraction) return;
  impl_.abstraction->roll_back();
  if (has_made_abstraction_of_walls_) {
    impl_.abstraction_of_walls.reset();
  } else if (impl_.abstraction_of_walls) {
    impl_.abstraction_of_walls->roll_back();
  }
}

inline std::optional<Error> World::Operation::insert(const Shape& shape, ItemId id) {
  if (kind_ == Kind::change) impl_.history.add_insertion(id);
  impl_.triangulation.insert(shape, id);
  if (impl_.triangulation.has_too_many_vertices()) return limit_error(impl_.triangulation.budget(), id);
  note_inserted(shape.kind, id);
  note_changed(id);
  if (kind_ != Kind::follow) impl_.add_insertion_to_change_log(shape.kind, shape.rings);
  return std::nullopt;
}

template <class Batch>
std::optional<Error> World::Operation::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  if (kind_ == Kind::change) {
    for (std::size_t i = 0; i < batch.size(); ++i) impl_.history.add_insertion(batch.id(i));
  }
  impl_.triangulation.insert_all(batch, team);
  if (impl_.triangulation.has_too_many_vertices()) return limit_error(impl_.triangulation, batch);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    note_inserted(batch.kind(i), batch.id(i));
    note_changed(batch.id(i));
  }
  if (kind_ != Kind::follow) impl_.add_insertions_to_change_log(batch);
  return std::nullopt;
}

inline void World::Operation::remove(ItemId id) {
  const std::uint32_t slot = impl_.triangulation.items().slot(id);
  if (kind_ == Kind::change) impl_.add_removal_to_history(slot);
  if (kind_ != Kind::follow) impl_.add_removal_to_change_log(slot);
  note_changed(id);
  if (impl_.abstraction && impl_.triangulation.items().is_polygon(slot)) impl_.abstraction->note_removed(slot);
  impl_.triangulation.remove(id);
}

inline void World::Operation::set_largest_id_seen(ItemId id) { impl_.triangulation.set_largest_id_seen(id); }

inline void World::Operation::update() {
  if (!impl_.clearance && !impl_.abstraction) return;
  const mesh::TouchedFaces::Guard guard(impl_.touched_faces);
  impl_.touched_faces.collect(impl_.triangulation.topology());
  if (impl_.clearance) impl_.clearance->update(impl_.triangulation, impl_.touched_faces);
  if (!impl_.abstraction) return;
  impl_.abstraction->update(impl_.triangulation, impl_.touched_faces);
  update_abstraction_of_walls();
}

inline void World::Operation::update_abstraction_of_walls() {
  if (!impl_.clearance || impl_.clearance->second_triangulation() == nullptr) return;
  const constraint::ExactTriangulation& walls = *impl_.clearance->second_triangulation();
  std::optional<nav::Abstraction>& abstraction = impl_.abstraction_of_walls;
  if (!abstraction) {
    abstraction.emplace(walls);
    has_made_abstraction_of_walls_ = true;
    return;
  }
  const auto changes = impl_.clearance->changes_of_walls();
  for (const std::uint32_t polygon : changes.removed) abstraction->note_removed(polygon);
  for (const std::uint32_t polygon : changes.inserted) abstraction->note_inserted(polygon);
  abstraction->update(walls, changes.touched);
}

inline void World::Operation::commit() {
  impl_.touch_log->note_mesh(impl_.triangulation);
  impl_.change_log.reserve();
  update();
  // Nothing can fail from here on.
  if (impl_.abstraction) {
    impl_.touch_log->note_abstraction(*impl_.abstraction);
    impl_.abstraction->commit();
    if (impl_.abstraction_of_walls) impl_.abstraction_of_walls->commit();
  }
  operation_.commit();
  if (clearance_operation_) clearance_operation_->commit();
  is_committed_ = true;
  if (kind_ == Kind::follow) return;
  impl_.touch_log->commit();
  impl_.change_log.commit(impl_.touch_log->version());
  impl_.history.commit();
}

inline void World::Operation::note_inserted(ItemKind kind, ItemId id) {
  if (impl_.abstraction && kind == ItemKind::polygon) {
    impl_.abstraction->note_inserted(impl_.triangulation.items().slot(id));
  }
}

inline void World::Operation::note_changed(ItemId id) {
  if (kind_ != Kind::attempt) impl_.note_for_snapshots(id);
  if (impl_.clearance) impl_.clearance->note_changed(impl_.triangulation, id);
}

template <class Batch>
std::optional<Error> World::Impl::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  if (triangulation.items().size() != 0) {
    Operation operation(*this);
    if (auto error = operation.insert_all(batch, team)) return error;
    operation.commit();
    return std::nullopt;
  }
  change_log.begin();
  add_insertions_to_change_log(batch);
  history.begin();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    history.add_insertion(batch.id(i));
    note_for_snapshots(batch.id(i));
  }
  if (auto error = replace_all(batch, triangulation.items().largest_id_seen(), limits, team)) return error;
  history.commit();
  return std::nullopt;
}

template <class Batch>
std::optional<Error> World::Impl::replace_all(const Batch& batch, ItemId largest_id,
                                              const constraint::VertexLimits& made_limits,
                                              const threads::ThreadTeam& team) {
  constraint::ExactTriangulation made(triangulation.domain(), batch, team, made_limits);
  if (made.has_too_many_vertices()) return limit_error(made, batch);
  made.mark_used(largest_id);
  change_log.reserve();
  std::unique_ptr<clearance::Clearance> made_clearance;
  if (clearance) made_clearance = std::make_unique<clearance::Clearance>(made);
  std::optional<nav::Abstraction> made_abstraction_of_walls;
  if (abstraction && made_clearance && made_clearance->second_triangulation() != nullptr) {
    made_abstraction_of_walls.emplace(*made_clearance->second_triangulation());
  }
  if (abstraction) abstraction = nav::Abstraction(made);
  // Nothing can fail from here on.
  abstraction_of_walls = std::move(made_abstraction_of_walls);
  clearance = std::move(made_clearance);
  triangulation = std::move(made);
  touch_log->note_everything();
  touch_log->commit();
  change_log.commit(touch_log->version());
  return std::nullopt;
}

template <class Batch>
void World::Impl::add_insertions_to_change_log(const Batch& batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    add_insertion_to_change_log(batch.kind(i), batch.rings(i));
  }
}

/// Points are not walls, so the log does not record them.
template <class Rings>
void World::Impl::add_insertion_to_change_log(ItemKind kind, const Rings& rings) {
  if (kind == ItemKind::point) return;
  change_log.add_insertion();
  for (const auto& ring : rings) {
    for (const Point& p : ring) change_log.add_point(p);
  }
}

}  // namespace waywright

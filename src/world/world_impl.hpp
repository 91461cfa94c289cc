#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "clearance/clearance.hpp"
#include "constraint/exact_triangulation.hpp"
#include "nav/abstraction.hpp"
#include "world/change_log.hpp"
#include "world/path_query_error.hpp"
#include "world/spare_context.hpp"
#include "world/touch_log.hpp"

namespace waywright {

struct WAYWRIGHT_INTERNAL World::Impl {
  Impl(const Box& domain, const WorldOptions& options) : triangulation(domain) {
    if (options.keep_abstraction) abstraction.emplace(triangulation);
    if (options.keep_bridges) clearance = std::make_unique<clearance::Clearance>(triangulation);
  }
  /// Makes a copy with a log and with contexts of its own. Requires: no operation is under way.
  Impl(const Impl& other)
      : triangulation(other.triangulation),
        abstraction(other.abstraction),
        clearance(other.clearance ? std::make_unique<clearance::Clearance>(*other.clearance) : nullptr),
        touch_log(std::make_shared<TouchLog>(other.version())),
        change_log(other.change_log) {}
  Impl& operator=(const Impl&) = delete;
  ~Impl() { touch_log->note_world_gone(); }

  /// Inserts a batch as one operation.
  template <class Batch>
  void insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  // The next three functions record items in `change_log`: all items of a batch, one item that an operation inserts, or
  // one item that it removes.
  template <class Batch>
  void note_changes(const Batch& batch);
  template <class Rings>
  void note_item(ItemKind kind, const Rings& rings);
  void note_removal(std::uint32_t slot);
  /// What the world keeps for path queries.
  [[nodiscard]] Kept kept() const { return {abstraction.has_value(), clearance != nullptr}; }
  // The queries behind the functions of World with these names. Requires: the query has no error.
  void find_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  void find_disc_paths_from(const ManyGoalsQuery& query, detail::QueryScratch& scratch, std::vector<Path>& paths) const;
  // The path of a disc, in slices. Requires: the world does not change until the search is done. Both functions return
  // whether the search is done.
  bool begin_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  /// Continues until `path.expansions` reaches `limit`.
  bool step_disc_path(std::size_t limit, detail::QueryScratch& scratch, Path& path) const;
  void fit_disc(const Point& centre, double radius, detail::QueryScratch& scratch, DiscFit& fit) const;
  void nearest_fit(const NearestFitQuery& query, detail::QueryScratch& scratch, NearestFit& fit) const;
  void widest_path(const Point& start, const Point& goal, detail::QueryScratch& scratch, WidestPath& widest) const;
  // The steps of find_disc_paths_from() and begin_disc_path().
  [[nodiscard]] bool free_disc_ends(PathQuery& query, detail::QueryScratch& scratch, Path& path) const;
  [[nodiscard]] bool free_disc_end(PathQuery& query, bool is_start, const std::optional<Point>& other,
                                   detail::QueryScratch& scratch, Path& path) const;
  [[nodiscard]] std::optional<Point> find_disc_end(const PathQuery& query, const Point& end,
                                                   const std::optional<Point>& other,
                                                   detail::QueryScratch& scratch) const;
  void set_disc_start(const Point& start, double radius, detail::QueryScratch& scratch) const;
  void begin_disc_search(const Point& goal, PathAlgorithm algorithm, detail::QueryScratch& scratch) const;
  /// nearest_fit() for a radius of 0, and for a radius above 0. The second function requires that the disc fits at the
  /// goal, if there is one.
  [[nodiscard]] std::optional<Point> nearest_free(const NearestFitQuery& query, detail::QueryScratch& scratch) const;
  [[nodiscard]] std::optional<Point> nearest_fit_of_disc(const NearestFitQuery& query,
                                                         detail::QueryScratch& scratch) const;
  [[nodiscard]] std::uint64_t version() const { return touch_log->version(); }
  /// Returns the abstraction, or null.
  [[nodiscard]] const nav::Abstraction* kept_abstraction() const { return abstraction ? &*abstraction : nullptr; }

  constraint::ExactTriangulation triangulation;
  std::optional<nav::Abstraction> abstraction;
  std::unique_ptr<clearance::Clearance> clearance;  ///< null if the world keeps no bridges
  std::shared_ptr<TouchLog> touch_log = std::make_shared<TouchLog>();
  ChangeLog change_log;
  constraint::Outline outline;  ///< scratch
  SpareContext spare_context;
};

/// An operation on a world. If the object is destroyed before commit(), for example because memory runs out, its
/// destructor takes all changes back.
class WAYWRIGHT_INTERNAL World::Operation {
 public:
  explicit Operation(Impl& impl) : impl_(impl), operation_(impl.triangulation) {
    if (impl_.abstraction) impl_.abstraction->begin();
    if (impl_.clearance) clearance_operation_.emplace(*impl_.clearance);
    impl_.change_log.begin();
  }

  void insert(const Shape& shape, ItemId id) {
    impl_.triangulation.insert(shape, id);
    note_inserted(shape.kind, id);
    note_changed(id);
    impl_.note_item(shape.kind, shape.rings);
  }
  template <class Batch>
  void insert_all(const Batch& batch, const threads::ThreadTeam& team = {}) {
    impl_.triangulation.insert_all(batch, team);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      note_inserted(batch.kind(i), batch.id(i));
      note_changed(batch.id(i));
    }
    impl_.note_changes(batch);
  }
  void remove(ItemId id) {
    const std::uint32_t slot = impl_.triangulation.items().slot(id);
    impl_.note_removal(slot);
    note_changed(id);
    if (impl_.abstraction && impl_.triangulation.items().is_polygon(slot)) impl_.abstraction->note_removed(slot);
    impl_.triangulation.remove(id);
  }
  void commit() {
    impl_.touch_log->note_mesh(impl_.triangulation);
    impl_.change_log.reserve();
    // If the abstraction cannot be updated, the destructor of `clearance_operation_` undoes the update of the bridges.
    if (impl_.clearance) impl_.clearance->update(impl_.triangulation);
    if (impl_.abstraction) {
      impl_.abstraction->update(impl_.triangulation);
      impl_.touch_log->note_abstraction(*impl_.abstraction);
    }
    // Nothing can fail from here on.
    operation_.commit();
    if (clearance_operation_) clearance_operation_->commit();
    impl_.touch_log->commit();
    impl_.change_log.commit(impl_.touch_log->version());
  }

 private:
  void note_inserted(ItemKind kind, ItemId id) {
    if (!impl_.abstraction || kind == ItemKind::point) return;
    impl_.abstraction->note_walls();
    if (kind == ItemKind::polygon) impl_.abstraction->note_inserted(impl_.triangulation.items().slot(id));
  }

  void note_changed(ItemId id) {
    if (impl_.clearance) impl_.clearance->note_changed(id);
  }

  Impl& impl_;
  constraint::ExactTriangulation::UndoGuard operation_;
  std::optional<clearance::Clearance::UndoGuard> clearance_operation_;
};

/// If the world has no items, the function builds a new triangulation and then replaces the old one. So the insertion
/// is all or nothing without an undo log.
template <class Batch>
void World::Impl::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  if (triangulation.items().size() != 0) {
    Operation operation(*this);
    operation.insert_all(batch, team);
    return operation.commit();
  }
  constraint::ExactTriangulation made(triangulation.domain(), batch, team);
  made.mark_used(triangulation.items().largest_id_seen());
  change_log.begin();
  note_changes(batch);
  change_log.reserve();
  std::unique_ptr<clearance::Clearance> made_clearance;
  if (clearance) made_clearance = std::make_unique<clearance::Clearance>(made);
  if (abstraction) abstraction = nav::Abstraction(made);
  // Nothing can fail from here on.
  clearance = std::move(made_clearance);
  triangulation = std::move(made);
  touch_log->note_everything();
  touch_log->commit();
  change_log.commit(touch_log->version());
}

template <class Batch>
void World::Impl::note_changes(const Batch& batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    note_item(batch.kind(i), batch.rings(i));
  }
}

/// Points are not walls, so the log does not record them.
template <class Rings>
void World::Impl::note_item(ItemKind kind, const Rings& rings) {
  if (kind == ItemKind::point) return;
  change_log.add_item();
  for (const auto& ring : rings) {
    for (const Point& p : ring) change_log.add_point(p);
  }
}

}  // namespace waywright

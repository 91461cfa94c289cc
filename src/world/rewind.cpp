#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "constraint/batch.hpp"
#include "world/history.hpp"
#include "world/layers.hpp"
#include "world/world_impl.hpp"

// The functions that bring back an earlier state of a world.

namespace waywright {

namespace {

constexpr char kNoLimitInRewind[] = "World::rewind: the world had these items before, so no limit can apply";
constexpr char kNoHistory[] = "World::mark: the world keeps no history; call keep_history() first";

using Triangulation = constraint::ConstrainedTriangulation;
using Batch = constraint::ShapeBatch;

/// The changes that bring back the items of a tick. An item whose shape has changed is in both lists.
struct ChangesBack {
  std::vector<ItemId> removed;
  std::vector<ItemId> inserted_ids;
  std::vector<Item> inserted;
};

/// Returns the changes from the items of the triangulation to the items of a tick. Requires: the history has the tick.
ChangesBack changes_back_to(History& history, History::Tick tick, const Triangulation& triangulation) {
  ChangesBack changes;
  Shape now;
  for (const History::ChangedItem& item : history.changed_since(tick)) {
    const bool is_live = triangulation.items().contains(item.id);
    if (!history.was_live(item)) {
      if (is_live) changes.removed.push_back(item.id);
      continue;
    }
    Shape before = history.shape(item);
    if (is_live) {
      fill_shape(triangulation, item.id, now);
      if (now == before) continue;
      changes.removed.push_back(item.id);
    }
    changes.inserted_ids.push_back(item.id);
    changes.inserted.push_back({item.id, std::move(before)});
  }
  return changes;
}

/// Returns whether most of the mesh belongs to the removed items. A new mesh of the items that stay then costs less
/// than the removals.
bool is_most_removed(const ChangesBack& changes, const Triangulation& triangulation) {
  std::size_t corners = 0;
  for (const ItemId id : changes.removed) {
    triangulation.items().for_each_corner(triangulation.items().slot(id), [&](mesh::Vertex, bool) { ++corners; });
  }
  return 2 * corners > triangulation.topology().vertex_count();
}

/// Adds to the inserted items each item of the triangulation that `changes.removed` does not contain.
void add_items_that_stay(ChangesBack& changes, const Triangulation& triangulation) {
  std::size_t next_removed = 0;  // both lists ascend
  for (const ItemId id : triangulation.items().ids()) {
    if (next_removed < changes.removed.size() && changes.removed[next_removed] == id) {
      ++next_removed;
      continue;
    }
    changes.inserted_ids.push_back(id);
    changes.inserted.push_back({id, {}});
    fill_shape(triangulation, id, changes.inserted.back().shape);
  }
}

}  // namespace

void World::keep_history(std::size_t ticks) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  impl_->history.keep(ticks);
}

std::uint64_t World::mark() {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  WAYWRIGHT_ASSERT(impl_->history.is_kept(), kNoHistory);
  return impl_->history.mark(version(), impl_->triangulation().items().largest_id_seen());
}

Result<void> World::rewind(std::uint64_t tick) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  if (auto error = impl_->history.find_error(tick)) return *std::move(error);
  impl_->bring_back(impl_->history, tick);
  impl_->history.return_to(tick);
  return {};
}

void World::Impl::bring_back(History& from, History::Tick tick) {
  ChangesBack changes = changes_back_to(from, tick, triangulation());
  Operation operation(*this, Operation::Kind::rewind);
  std::optional<Error> error;
  if (is_most_removed(changes, triangulation())) {
    operation.note_removals(changes.removed);
    operation.note_insertions(Batch{changes.inserted, changes.inserted_ids});
    add_items_that_stay(changes, triangulation());
    error = operation.replace_all(Batch{changes.inserted, changes.inserted_ids}, from.largest_id(tick));
  } else {
    for (const ItemId id : changes.removed) operation.remove(id);
    if (changes.inserted.size() == 1) {
      error = operation.insert(changes.inserted[0].shape, changes.inserted[0].id);
    } else if (!changes.inserted.empty()) {
      error = operation.insert_all(Batch{changes.inserted, changes.inserted_ids});
    }
    operation.set_largest_id_seen(from.largest_id(tick));
  }
  WAYWRIGHT_ASSERT(!error, kNoLimitInRewind);
  operation.commit();
}

}  // namespace waywright

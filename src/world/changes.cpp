#include <algorithm>
#include <utility>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "constraint/batch.hpp"
#include "world/change_check.hpp"
#include "world/world_impl.hpp"

// The functions that change a world. Each function first checks all its arguments, and then makes the change in one
// operation.

namespace waywright {

namespace {

constexpr char kNoThread[] =
    "BulkOptions: `threads` is 0, but it must be 1 or more, because it includes the calling thread";

/// Returns a team that calls `progress` only while less than `total` is done. The caller itself reports `total` at the
/// end.
threads::ThreadTeam team_of(const BulkOptions& options, std::size_t total) {
  threads::ThreadTeam::Report report;
  if (options.progress) {
    report = [&options, total](std::size_t done) {
      if (done < total) options.progress(done, total);
    };
  }
  return {std::min(options.threads, std::max(total, std::size_t{1})), std::move(report), options.jobs};
}

/// Returns a check for a single change.
ChangeCheck check_one(const constraint::ConstrainedTriangulation& triangulation) {
  return {triangulation, ChangeCheck::Record::no};
}

/// Returns the error in the change, or nothing. If the change is an insertion and `id` is null, sets `id` to the id
/// that the world will choose.
std::optional<Error> add_change(ChangeCheck& check, const Change& change, ItemId& id) {
  switch (change.kind) {
    case Change::Kind::insert:
      return check.add_insertion(change.shape, id);
    case Change::Kind::remove:
      return check.add_removal(id);
    case Change::Kind::replace:
      return check.add_replacement(id, change.shape);
  }
  return Error{ErrorCode::bad_shape, "the kind of a change is none of the values of Change::Kind", id, 0};
}

/// Returns the number of insertions with which the list begins.
std::size_t count_insertions(std::span<const Change> changes) {
  const auto end = std::find_if(changes.begin(), changes.end(),
                                [](const Change& change) { return change.kind != Change::Kind::insert; });
  return static_cast<std::size_t>(end - changes.begin());
}

/// Returns the error with the index `i` of the refused element in a list, and with the noun for the element in the
/// message.
Error in_list(const char* element, std::uint64_t i, Error error) {
  error.index = i;
  error.words.element_noun = element;
  return error;
}

/// Returns the id of the item of each change, or the error of the first change that the world refuses.
Result<std::vector<ItemId>> check_all(const constraint::ConstrainedTriangulation& triangulation,
                                      std::span<const Change> changes) {
  ChangeCheck check(triangulation, ChangeCheck::Record::yes);
  std::vector<ItemId> ids;
  ids.reserve(changes.size());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    ids.push_back(changes[i].id);
    if (auto error = add_change(check, changes[i], ids.back())) return in_list("change", i, *std::move(error));
  }
  return ids;
}

}  // namespace

Result<ItemId> World::insert(const Shape& shape, ItemId id) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  if (auto error = check_one(impl_->triangulation()).add_insertion(shape, id)) return *std::move(error);
  Operation operation(*impl_);
  if (auto error = operation.insert(shape, id)) return *std::move(error);
  operation.commit();
  return id;
}

Result<ItemId> World::insert_point(Point point, ItemId id) { return insert(Shape::point(point), id); }

Result<ItemId> World::insert_segment(Point a, Point b, ItemId id) { return insert(Shape::segment(a, b), id); }

Result<ItemId> World::insert_polyline(PointSpan points, ItemId id) { return insert(Shape::polyline(points), id); }

Result<ItemId> World::insert_polygon(Rings rings, ItemId id) { return insert(Shape::polygon(std::move(rings)), id); }

Result<void> World::remove(ItemId id) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  if (auto error = check_one(impl_->triangulation()).add_removal(id)) return *std::move(error);
  Operation operation(*impl_);
  operation.remove(id);
  operation.commit();
  return {};
}

Result<void> World::replace(ItemId id, const Shape& shape) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  if (auto error = check_one(impl_->triangulation()).add_replacement(id, shape)) return *std::move(error);
  Operation operation(*impl_);
  operation.remove(id);
  if (auto error = operation.insert(shape, id)) return *std::move(error);
  operation.commit();
  return {};
}

std::optional<Error> World::Impl::make_changes(Operation& operation, std::span<const Change> changes,
                                               std::span<const ItemId> ids) {
  for (std::size_t i = 0; i < changes.size();) {
    const std::size_t count = count_insertions(changes.subspan(i));
    std::optional<Error> error;
    if (count > 1) {
      error = operation.insert_all(constraint::ShapeBatch{changes.subspan(i, count), ids.subspan(i, count)});
    } else {
      if (changes[i].kind != Change::Kind::insert) operation.remove(ids[i]);
      if (changes[i].kind != Change::Kind::remove) error = operation.insert(changes[i].shape, ids[i]);
    }
    if (error) return in_list("change", i + error->index, *std::move(error));
    i += std::max(count, std::size_t{1});
  }
  return std::nullopt;
}

Result<std::vector<ItemId>> World::apply(std::span<const Change> changes) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  Result<std::vector<ItemId>> ids = check_all(impl_->triangulation(), changes);
  if (!ids) return ids;
  if (count_insertions(changes) == changes.size()) {
    auto error = impl_->insert_all(constraint::ShapeBatch{changes, *ids});
    if (error) return in_list("change", error->index, *std::move(error));
    return ids;
  }
  Operation operation(*impl_);
  if (auto error = Impl::make_changes(operation, changes, *ids)) return *std::move(error);
  operation.commit();
  return ids;
}

// Unlike apply(), an attempt makes an Operation even if all changes are insertions, because it must take them back.
Result<void> World::begin_attempt(std::span<const Change> changes) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  const Result<std::vector<ItemId>> ids = check_all(impl_->triangulation(), changes);
  if (!ids) return ids.error();
  detail::AttemptGuard guard(*this);
  Operation& operation = impl_->attempt.emplace(*impl_, Operation::Kind::attempt);
  if (auto error = Impl::make_changes(operation, changes, *ids)) return *std::move(error);
  operation.update();
  guard.release();
  return {};
}

void World::end_attempt() noexcept { impl_->attempt.reset(); }

Result<std::vector<ItemId>> World::insert_all(std::span<const Item> items, const BulkOptions& options) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  ChangeCheck check(impl_->triangulation(), ChangeCheck::Record::yes);
  std::vector<ItemId> ids;
  ids.reserve(items.size());
  std::size_t total = items.size();
  for (std::size_t i = 0; i < items.size(); ++i) {
    ids.push_back(items[i].id);
    if (auto error = check.add_insertion(items[i].shape, ids.back())) return in_list("item", i, *std::move(error));
    total += items[i].shape.rings.points().size();
  }
  WAYWRIGHT_ASSERT(options.threads >= 1, kNoThread);
  if (auto error = impl_->insert_all(constraint::ShapeBatch{items, ids}, team_of(options, total))) {
    return in_list("item", error->index, *std::move(error));
  }
  if (options.progress) options.progress(total, total);
  return ids;
}

std::optional<Error> World::Impl::insert_points(const constraint::PointBatch& batch, const BulkOptions& options) {
  WAYWRIGHT_ASSERT(!attempt, kInAttempt);
  const base::FloatEnvironment environment;
  ChangeCheck check(triangulation(), ChangeCheck::Record::no);
  if (auto error = check.add_points(batch)) return error;
  WAYWRIGHT_ASSERT(options.threads >= 1, kNoThread);
  if (auto error = insert_all(batch, team_of(options, batch.size()))) return error;
  if (options.progress) options.progress(batch.size(), batch.size());
  return std::nullopt;
}

Result<ItemId> World::insert_points(PointSpan points, ItemId first, const BulkOptions& options) {
  if (first.is_null()) first = {impl_->triangulation().items().largest_id_seen().value + 1};
  if (auto error = impl_->insert_points({points, first}, options)) return *std::move(error);
  return first;
}

Result<void> World::insert_points_as(PointSpan points, std::span<const ItemId> ids, const BulkOptions& options) {
  if (auto error = impl_->insert_points({points, {}, ids}, options)) return *std::move(error);
  return {};
}

}  // namespace waywright

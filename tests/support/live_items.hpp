#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"
#include "waywright/world.hpp"

namespace waywright::test {

/// One call on a world: World::apply for a batch, otherwise World::insert, remove or replace for its single change.
struct Step {
  std::vector<Change> changes;
  bool is_batch = false;
};

/// Returns whether a world accepts this coordinate.
[[nodiscard]] inline bool is_legal_coordinate(double value) {
  return value == 0.0 || (std::fabs(value) >= 0x1p-100 && std::fabs(value) <= 0x1p100);
}

/// The items that a world must have after some steps, stored in a plain map.
class LiveItems {
 public:
  explicit LiveItems(const Box& domain) : domain_(domain) {}

  /// Makes the step's changes and returns the ids of their items. If a world must refuse one of the changes, returns
  /// the reason and changes nothing.
  Result<std::vector<ItemId>> apply(const Step& step) {
    LiveItems after = *this;
    std::vector<ItemId> ids;
    for (const Change& change : step.changes) {
      ItemId id = change.id;
      if (change.kind == Change::Kind::insert && id.is_null()) id = {after.largest_.value + 1};
      if (const auto code = after.refusal(change, id)) return Error{*code, {}, id, 0};
      if (change.kind == Change::Kind::remove) {
        after.items_.erase(id);
      } else {
        after.items_.insert_or_assign(id, change.shape);
      }
      after.largest_ = std::max(after.largest_, id);
      ids.push_back(id);
    }
    *this = std::move(after);
    return ids;
  }

  [[nodiscard]] const std::map<ItemId, Shape>& items() const { return items_; }
  [[nodiscard]] const Box& domain() const { return domain_; }
  /// The largest id that an item or reserve() has had.
  [[nodiscard]] ItemId largest() const { return largest_; }
  /// World::reserve_ids().
  void reserve(ItemId last) { largest_ = std::max(largest_, last); }

 private:
  [[nodiscard]] std::optional<ErrorCode> refusal(const Change& change, ItemId id) const {
    const bool is_live = items_.contains(id);
    if (change.kind != Change::Kind::insert && !is_live) return ErrorCode::unknown_id;
    if (change.kind == Change::Kind::remove) return std::nullopt;
    if (id.value > ItemId::kLargest) return ErrorCode::bad_id;
    if (change.kind == Change::Kind::insert && is_live) return ErrorCode::id_in_use;
    for (const PointSpan& ring : change.shape.rings) {
      for (const Point& p : ring) {
        if (!is_legal_coordinate(p.x) || !is_legal_coordinate(p.y)) return ErrorCode::coordinate_range;
        const bool is_inside =
            p.x >= domain_.min.x && p.x <= domain_.max.x && p.y >= domain_.min.y && p.y <= domain_.max.y;
        if (!is_inside) return ErrorCode::out_of_domain;
      }
    }
    return std::nullopt;
  }

  Box domain_;
  std::map<ItemId, Shape> items_;
  ItemId largest_;
};

/// Returns a new world with only these items, inserted from the last id to the first.
[[nodiscard]] inline World fresh_world(const LiveItems& live, const WorldOptions& options = {}) {
  World world = World::create(live.domain(), options).value();
  for (auto at = live.items().rbegin(); at != live.items().rend(); ++at) world.insert(at->second, at->first).value();
  return world;
}

/// Performs the step on a world.
[[nodiscard]] inline Result<std::vector<ItemId>> perform(World& world, const Step& step) {
  if (step.is_batch) return world.apply(step.changes);
  const Change& change = step.changes.front();
  if (change.kind == Change::Kind::insert) {
    const Result<ItemId> inserted = world.insert(change.shape, change.id);
    if (!inserted) return inserted.error();
    return std::vector<ItemId>{*inserted};
  }
  const Result<void> done =
      change.kind == Change::Kind::remove ? world.remove(change.id) : world.replace(change.id, change.shape);
  if (!done) return done.error();
  return std::vector<ItemId>{change.id};
}

/// Returns a shape as World::shape returns it: without points that equal the point before them, with 0 for -0, and with
/// a fill rule only for polygons.
[[nodiscard]] inline Shape merged(Shape shape) {
  if (shape.kind != ItemKind::polygon) shape.fill = FillRule::even_odd;
  std::vector<std::vector<Point>> rings = shape.rings;
  for (std::vector<Point>& ring : rings) {
    for (Point& p : ring) p = {p.x + 0.0, p.y + 0.0};
    if (shape.kind == ItemKind::segment) continue;
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    if (shape.kind == ItemKind::polygon && ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  }
  return {shape.kind, rings, shape.fill};
}

}  // namespace waywright::test

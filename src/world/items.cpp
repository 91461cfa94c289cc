#include "waywright/world.hpp"

#include "constraint/item_queries.hpp"
#include "world/change_check.hpp"
#include "world/layers.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// The functions that read the items of a world.

namespace waywright {

void fill_shape(const constraint::ConstrainedTriangulation& triangulation, ItemId id, Shape& shape) {
  const constraint::ItemTable& items = triangulation.items();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const std::uint32_t slot = items.slot(id);
  std::size_t count = 0;
  items.for_each_corner(slot, [&](mesh::Vertex, bool) { ++count; });
  shape.kind = items.kind(slot);
  shape.fill = items.fill(slot);
  const bool is_one_point = shape.kind == ItemKind::segment && count == 1;
  shape.rings.clear();
  shape.rings.reserve(is_one_point ? 2 : count);
  bool starts_ring = true;
  items.for_each_corner(slot, [&](mesh::Vertex corner, bool ends_ring) {
    if (starts_ring) shape.rings.start_ring();
    shape.rings.add_point(geometry.rounded(number(corner)));
    starts_ring = ends_ring;
  });
  if (is_one_point) shape.rings.add_point(shape.rings[0][0]);
}

ItemId World::largest_id_seen() const { return impl_->triangulation().items().largest_id_seen(); }

Result<void> World::reserve_ids(ItemId last) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  if (last.is_null() || last.value > ItemId::kLargest) return Error{ErrorCode::bad_id, {}, last, 0};
  impl_->layers.mark_used(last);
  return {};
}

bool World::contains(ItemId id) const { return impl_->triangulation().items().contains(id); }

std::size_t World::item_count() const { return impl_->triangulation().items().size(); }

std::vector<ItemId> World::item_ids() const { return impl_->triangulation().items().ids(); }

void World::item_ids(std::vector<ItemId>& ids) const { impl_->triangulation().items().ids(ids); }

Result<void> World::shape(ItemId id, Shape& shape) const {
  if (!contains(id)) return unknown_id_error(id);
  fill_shape(impl_->triangulation(), id, shape);
  return {};
}

Result<Shape> World::shape(ItemId id) const {
  Shape shape;
  if (auto done = this->shape(id, shape); !done) return done.error();
  return shape;
}

void World::items(QueryContext& context, std::vector<Item>& items) const {
  std::vector<ItemId>& ids = context.scratch_->items->ids;
  item_ids(ids);
  items.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    items[i].id = ids[i];
    fill_shape(impl_->triangulation(), ids[i], items[i].shape);
  }
}

std::vector<Item> World::items() const {
  QueryContext context;
  std::vector<Item> items;
  this->items(context, items);
  return items;
}

}  // namespace waywright

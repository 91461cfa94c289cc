#include "world/operation.hpp"

#include "world/world_impl.hpp"

namespace waywright {

World::Operation::Operation(Impl& impl, Kind kind, std::size_t most_vertices)
    : impl_(impl),
      kind_(kind),
      limits_(is_limited() ? impl.limits : constraint::VertexLimits{.of_triangulation = most_vertices}) {
  impl_.layers.begin(limits_);
  impl_.change_log.begin();
  impl_.history.begin();
}

World::Operation::~Operation() {
  if (!is_committed_) impl_.layers.roll_back();
}

std::optional<Error> World::Operation::insert(const Shape& shape, ItemId id) {
  impl_.layers.insert(shape, id);
  if (impl_.triangulation().has_too_many_vertices()) return limit_error(impl_.triangulation().budget(), id);
  note_insertion(shape.kind, shape.rings, id);
  return std::nullopt;
}

void World::Operation::remove(ItemId id) {
  note_removal(impl_.triangulation().items().slot(id));
  impl_.layers.remove(id);
}

void World::Operation::note_removals(std::span<const ItemId> ids) {
  for (const ItemId id : ids) note_removal(impl_.triangulation().items().slot(id));
}

/// Records the removal of an item. Requires: the item is still there.
void World::Operation::note_removal(std::uint32_t slot) {
  if (kind_ == Kind::change) add_removal_to_history(slot);
  if (kind_ != Kind::attempt) impl_.note_for_snapshots(impl_.triangulation().items().id(slot));
  if (is_logged()) add_removal_to_change_log(slot);
}

void World::Operation::add_removal_to_history(std::uint32_t slot) {
  if (!impl_.history.is_recording()) return;
  const constraint::ItemTable& items = impl_.triangulation().items();
  const exact::Geometry& geometry = impl_.triangulation().triangulation().geometry();
  impl_.history.add_removal(items.id(slot), items.kind(slot), items.fill(slot));
  bool starts_ring = true;
  items.for_each_corner(slot, [&](mesh::Vertex corner, bool ends_ring) {
    if (starts_ring) impl_.history.add_ring();
    impl_.history.add_point(geometry.rounded(number(corner)));
    starts_ring = ends_ring;
  });
}

void World::Operation::add_removal_to_change_log(std::uint32_t slot) {
  const constraint::ItemTable& items = impl_.triangulation().items();
  if (items.kind(slot) == ItemKind::point) return;
  const exact::Geometry& geometry = impl_.triangulation().triangulation().geometry();
  items.outline(slot, impl_.outline);
  impl_.change_log.add_removal();
  for (const mesh::Vertex v : impl_.outline.corners) impl_.change_log.add_point(geometry.rounded(number(v)));
}

void World::Operation::set_largest_id_seen(ItemId id) { impl_.layers.set_largest_id_seen(id); }

void World::Operation::update() {
  if (!made_) impl_.layers.update();
}

void World::Operation::commit() {
  if (made_) {
    impl_.touch_log->note_everything();
  } else {
    impl_.touch_log->note_mesh(impl_.triangulation());
  }
  impl_.change_log.reserve();
  update();
  // Nothing can fail from here on.
  const nav::Abstraction* const abstraction = impl_.layers.abstraction();
  if (!made_ && abstraction != nullptr) impl_.touch_log->note_abstraction(*abstraction);
  impl_.layers.commit();
  if (made_) impl_.layers = std::move(*made_);
  is_committed_ = true;
  if (!is_logged()) return;
  impl_.touch_log->commit();
  impl_.change_log.commit(impl_.touch_log->version());
  impl_.history.commit();
}

}  // namespace waywright

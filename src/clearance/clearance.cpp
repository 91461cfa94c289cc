#include "clearance/clearance.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "constraint/canonical.hpp"
#include "memory/count.hpp"

namespace waywright::clearance {

namespace {

using Triangulation = Clearance::Triangulation;

/// Returns whether the item has a ring with one corner.
bool has_loose_ring(const constraint::ItemTable& items, std::uint32_t slot) {
  bool is_loose = false;
  std::size_t count = 0;
  items.for_each_corner(slot, [&](mesh::Vertex, bool ends_ring) {
    ++count;
    if (!ends_ring) return;
    is_loose = is_loose || count == 1;
    count = 0;
  });
  return is_loose;
}

/// Makes `shape` the shape of the item without its loose rings. Returns whether the item has other rings.
bool take_walls(const Triangulation& world, std::uint32_t slot, constraint::Outline& outline, Shape& shape) {
  const constraint::ItemTable& items = world.items();
  const exact::Geometry& geometry = world.triangulation().geometry();
  shape.rings.clear();
  if (items.kind(slot) == ItemKind::point) return false;
  shape.kind = items.kind(slot);
  shape.fill = items.fill(slot);
  items.outline(slot, outline);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : outline.ring_ends) {
    if (end - begin > 1) {
      shape.rings.start_ring();
      for (std::uint32_t i = begin; i < end; ++i) shape.rings.add_point(geometry.rounded(number(outline.corners[i])));
    }
    begin = end;
  }
  return !shape.rings.empty();
}

/// Returns the triangulation of the walls of all items.
std::unique_ptr<Triangulation> walls_of(const Triangulation& world) {
  constraint::Outline outline;
  Item item;
  std::vector<Item> items;
  std::vector<ItemId> ids;
  for (const ItemId id : world.items().ids()) {
    if (!take_walls(world, world.items().slot(id), outline, item.shape)) continue;
    items.push_back({id, item.shape});
    ids.push_back(id);
  }
  return std::make_unique<Triangulation>(world.domain(), constraint::ShapeBatch{items, ids});
}

bool has_any_loose_ring(const Triangulation& world) {
  const std::vector<ItemId> ids = world.items().ids();
  return std::any_of(ids.begin(), ids.end(),
                     [&](ItemId id) { return has_loose_ring(world.items(), world.items().slot(id)); });
}

}  // namespace

Clearance::Clearance(const Triangulation& world, const SearchLimits& limits) {
  if (has_any_loose_ring(world)) walls_ = walls_of(world);
  bridges_ = std::make_unique<Bridges>(triangulation_of_walls(world), limits);
}

std::uint64_t Clearance::new_state() {
  static std::atomic<std::uint64_t> last = 0;
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

// The operation changes the triangulation of the world after this call. No query runs until the operation has ended or
// has called update().
void Clearance::begin() {
  state_ = new_state();
  changed_.clear();
  changed_walls_.clear();
  removed_polygons_.clear();
  inserted_polygons_.clear();
  are_bridges_changed_ = false;
}

void Clearance::note_changed(const Triangulation& world, ItemId id) {
  changed_.push_back(id);
  if (changed_walls_.are_all()) return;
  const constraint::ItemTable& items = world.items();
  const exact::Geometry& geometry = world.triangulation().geometry();
  std::optional<Box> box;
  items.for_each_corner(items.slot(id), [&](mesh::Vertex corner, bool) {
    const Point& p = geometry.rounded(number(corner));
    if (!box) box = Box{p, p};
    box->expand(p);
  });
  if (box) changed_walls_.add(*box);
}

void Clearance::update(const Triangulation& world, const mesh::TouchedFaces& touched) {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  state_ = new_state();
  if (!walls_ && is_any_changed_loose(world)) return make_walls(world);
  changed_walls_.make_tree();
  if (walls_) {
    update_walls(world);
    touched_guard_.emplace(touched_walls_);
    touched_walls_.collect(walls_->topology());
    bridges_->update(*walls_, touched_walls_, changed_walls_);
  } else {
    bridges_->update(world, touched, changed_walls_);
  }
  are_bridges_changed_ = true;
}

bool Clearance::is_any_changed_loose(const Triangulation& world) const {
  const constraint::ItemTable& items = world.items();
  return std::any_of(changed_.begin(), changed_.end(),
                     [&](ItemId id) { return items.contains(id) && has_loose_ring(items, items.slot(id)); });
}

void Clearance::make_walls(const Triangulation& world) {
  std::unique_ptr<Triangulation> walls = walls_of(world);
  old_bridges_ = std::exchange(bridges_, std::make_unique<Bridges>(*walls, bridges_->limits()));
  walls_ = std::move(walls);
}

/// Makes the operation's changes in the second triangulation. A replacement is a removal and an insertion.
void Clearance::update_walls(const Triangulation& world) {
  walls_guard_.emplace(*walls_);
  const constraint::ItemTable& items = walls_->items();
  for (const ItemId id : changed_) {
    if (!items.contains(id)) continue;
    if (items.is_polygon(items.slot(id))) removed_polygons_.push_back(items.slot(id));
    walls_->remove(id);
  }
  insert_walls(world);
  for (const ItemId id : changed_) {
    if (items.contains(id) && items.is_polygon(items.slot(id))) inserted_polygons_.push_back(items.slot(id));
  }
}

/// Inserts the changed items of the world into the second triangulation.
void Clearance::insert_walls(const Triangulation& world) {
  std::vector<Item> items;
  std::vector<ItemId> ids;
  for (const ItemId id : changed_) {
    if (!world.items().contains(id) || !take_walls(world, world.items().slot(id), outline_, shape_)) continue;
    if (changed_.size() == 1) return walls_->insert(shape_, id);
    items.push_back({id, shape_});
    ids.push_back(id);
  }
  if (!items.empty()) walls_->insert_all(constraint::ShapeBatch{items, ids});
}

void Clearance::commit() {
  if (walls_guard_) walls_guard_->commit();
  walls_guard_.reset();
  touched_guard_.reset();
  old_bridges_.reset();
  bridges_->commit();
}

void Clearance::roll_back() {
  state_ = new_state();
  touched_guard_.reset();
  if (old_bridges_) {
    bridges_ = std::move(old_bridges_);
    walls_.reset();
    return;
  }
  if (are_bridges_changed_) bridges_->roll_back();
  walls_guard_.reset();
}

std::optional<std::string> Clearance::find_fault(const Triangulation& world) const {
  if (walls_) {
    if (auto fault = walls_->find_fault()) return "the mesh of the walls: " + *std::move(fault);
    if (constraint::dump(*walls_) != constraint::dump(*walls_of(world))) {
      return "the mesh of the walls differs from one that is built from the items";
    }
  } else if (has_any_loose_ring(world)) {
    return "an item has a ring with one corner, but the walls have no mesh of their own";
  }
  return bridges_->find_fault(triangulation_of_walls(world));
}

void Clearance::count_memory(MemoryUse& use) const {
  bridges_->count_memory(use);
  use.spare += sizeof(Clearance) + sizeof(Bridges);
  memory::count_spare(use, changed_, removed_polygons_, inserted_polygons_, outline_.corners, outline_.ring_ends);
  changed_walls_.count_memory(use);
  touched_walls_.count_memory(use);
  use.spare += shape_.rings.capacity() * sizeof(Point);
  if (!walls_) return;
  MemoryUse of_walls;
  walls_->count_memory(of_walls);
  use.spare += of_walls.spare;
  use.bridges += sizeof(Triangulation) + of_walls.total() - of_walls.spare;
}

void Clearance::shrink_to_fit(const Triangulation& world) {
  memory::release(changed_, removed_polygons_, inserted_polygons_, outline_.corners, outline_.ring_ends);
  changed_walls_.release();
  touched_walls_.release();
  shape_ = {};
  if (walls_ && !has_any_loose_ring(world)) {
    bridges_ = std::make_unique<Bridges>(world, bridges_->limits());
    walls_.reset();
  }
  state_ = new_state();  // the numbers of slots may have changed
  if (walls_) walls_->shrink_to_fit();
  bridges_->shrink_to_fit();
}

}  // namespace waywright::clearance

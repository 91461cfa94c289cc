#include "world/layers.hpp"

#include <algorithm>

#include "constraint/batch.hpp"
#include "constraint/canonical.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"

namespace waywright {

namespace {

using Triangulation = Layer::Triangulation;

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

bool has_any_loose_ring(const Triangulation& triangulation) {
  const std::vector<ItemId> ids = triangulation.items().ids();
  return std::any_of(ids.begin(), ids.end(),
                     [&](ItemId id) { return has_loose_ring(triangulation.items(), triangulation.items().slot(id)); });
}

/// Makes `shape` the shape of the item without its loose rings. Returns whether the item has other rings.
bool take_walls(const Triangulation& triangulation, std::uint32_t slot, constraint::Outline& outline, Shape& shape) {
  const constraint::ItemTable& items = triangulation.items();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
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
Triangulation walls_of(const Triangulation& triangulation) {
  constraint::Outline outline;
  Item item;
  std::vector<Item> items;
  std::vector<ItemId> ids;
  for (const ItemId id : triangulation.items().ids()) {
    if (!take_walls(triangulation, triangulation.items().slot(id), outline, item.shape)) continue;
    items.push_back({id, item.shape});
    ids.push_back(id);
  }
  return {triangulation.domain(), constraint::ShapeBatch{items, ids}};
}

}  // namespace

Layer::Layer(Triangulation triangulation, const Kept& kept, const clearance::SearchLimits& limits)
    : triangulation_(std::move(triangulation)) {
  if (kept.has_abstraction) abstraction_.emplace(triangulation_);
  if (kept.has_bridges) bridges_ = std::make_unique<clearance::Bridges>(triangulation_, limits);
}

Layer::Layer(const Layer& other)
    : triangulation_(other.triangulation_),
      abstraction_(other.abstraction_),
      bridges_(other.bridges_ ? std::make_unique<clearance::Bridges>(*other.bridges_) : nullptr) {}

Layer& Layer::operator=(Layer&& other) noexcept {
  triangulation_ = std::move(other.triangulation_);
  abstraction_ = std::move(other.abstraction_);
  bridges_ = std::move(other.bridges_);
  return *this;
}

void Layer::begin(const constraint::VertexLimits& limits) {
  operation_.emplace(triangulation_, limits);
  if (abstraction_) abstraction_->begin();
  changed_walls_.clear();
  are_bridges_updated_ = false;
}

void Layer::insert(const Shape& shape, ItemId id) {
  triangulation_.insert(shape, id);
  if (!triangulation_.has_too_many_vertices()) note_inserted(id);
}

void Layer::note_inserted(ItemId id) {
  if (!abstraction_ && !bridges_) return;
  const std::uint32_t slot = triangulation_.items().slot(id);
  if (abstraction_ && triangulation_.items().is_polygon(slot)) abstraction_->note_inserted(slot);
  note_box(slot);
}

void Layer::remove(ItemId id) {
  const std::uint32_t slot = triangulation_.items().slot(id);
  if (abstraction_ && triangulation_.items().is_polygon(slot)) abstraction_->note_removed(slot);
  note_box(slot);
  triangulation_.remove(id);
}

/// Notes the bounding box of an item that the operation inserts or removes. Cost: linear in the corners.
void Layer::note_box(std::uint32_t slot) {
  if (!bridges_ || changed_walls_.are_all()) return;
  const exact::Geometry& geometry = triangulation_.triangulation().geometry();
  std::optional<Box> box;
  triangulation_.items().for_each_corner(slot, [&](mesh::Vertex corner, bool) {
    const Point& p = geometry.rounded(number(corner));
    if (!box) box = Box{p, p};
    box->expand(p);
  });
  if (box) changed_walls_.add(*box);
}

void Layer::update() {
  if (!abstraction_ && !bridges_) return;
  const mesh::TouchedFaces::Guard guard(touched_);
  touched_.collect(triangulation_.topology());
  if (bridges_) {
    changed_walls_.make_tree();
    bridges_->update(triangulation_, touched_, changed_walls_);
    are_bridges_updated_ = true;
  }
  if (abstraction_) abstraction_->update(triangulation_, touched_);
}

void Layer::commit() {
  if (abstraction_) abstraction_->commit();
  if (bridges_) bridges_->commit();
  operation_->commit();
  operation_.reset();
}

void Layer::roll_back() noexcept {
  if (abstraction_) abstraction_->roll_back();
  if (bridges_ && are_bridges_updated_) bridges_->roll_back();
  operation_.reset();  // rolls back the mesh
}

std::optional<std::string> Layer::find_fault() const {
  auto fault = triangulation_.find_fault();
  if (!fault && abstraction_) fault = abstraction_->find_fault(triangulation_);
  if (!fault && bridges_) fault = bridges_->find_fault(triangulation_);
  return fault;
}

void Layer::count_memory(MemoryUse& use) const {
  triangulation_.count_memory(use);
  if (abstraction_) abstraction_->count_memory(use);
  if (bridges_) {
    bridges_->count_memory(use);
    use.spare += sizeof(clearance::Bridges);
  }
  changed_walls_.count_memory(use);
  touched_.count_memory(use);
}

void Layer::shrink_to_fit() {
  triangulation_.shrink_to_fit();
  if (abstraction_) abstraction_->shrink_to_fit();
  if (bridges_) bridges_->shrink_to_fit();
  changed_walls_.release();
  touched_.release();
}

Layers::Layers(Triangulation triangulation, const Kept& kept, const clearance::SearchLimits& limits)
    : keeps_bridges_(kept.has_bridges), all_(std::move(triangulation), {kept.has_abstraction, false}) {
  if (!keeps_bridges_) return;
  if (has_any_loose_ring(this->triangulation())) {
    walls_ = make_walls(limits);
  } else {
    all_.set_bridges(std::make_unique<clearance::Bridges>(this->triangulation(), limits));
  }
}

Layers::Layers(const Layers& other)
    : keeps_bridges_(other.keeps_bridges_),
      all_(other.all_),
      walls_(other.walls_ ? std::make_unique<Layer>(*other.walls_) : nullptr) {}

Layers& Layers::operator=(Layers&& other) noexcept {
  keeps_bridges_ = other.keeps_bridges_;
  all_ = std::move(other.all_);
  walls_ = std::move(other.walls_);
  return *this;
}

path::Ground Layers::ground() const {
  if (!keeps_bridges_) return {triangulation(), abstraction(), nullptr, nullptr, nullptr};
  const Layer& walls = layer_of_bridges();
  return {triangulation(), abstraction(), &walls.triangulation(), walls.abstraction(), walls.bridges()};
}

std::unique_ptr<Layer> Layers::make_walls(const clearance::SearchLimits& limits) const {
  return std::make_unique<Layer>(walls_of(triangulation()), kept(), limits);
}

void Layers::begin(const constraint::VertexLimits& limits) {
  changed_.clear();
  is_walls_open_ = false;
  all_.begin(limits);
}

void Layers::update() {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  if (keeps_bridges_ && !walls_ && is_any_changed_loose()) {
    std::unique_ptr<Layer> walls = make_walls(all_.bridges()->limits());
    old_bridges_ = all_.take_bridges();
    walls_ = std::move(walls);
  } else if (walls_) {
    update_walls();
  }
  all_.update();
}

bool Layers::is_any_changed_loose() const {
  const constraint::ItemTable& items = triangulation().items();
  return std::any_of(changed_.begin(), changed_.end(),
                     [&](ItemId id) { return items.contains(id) && has_loose_ring(items, items.slot(id)); });
}

/// Makes the operation's changes in the layer of the walls. A replacement is a removal and an insertion.
void Layers::update_walls() {
  walls_->begin({});
  is_walls_open_ = true;
  for (const ItemId id : changed_) {
    if (walls_->triangulation().items().contains(id)) walls_->remove(id);
  }
  std::vector<Item> items;
  std::vector<ItemId> ids;
  const constraint::ItemTable& of_world = triangulation().items();
  for (const ItemId id : changed_) {
    if (!of_world.contains(id) || !take_walls(triangulation(), of_world.slot(id), outline_, shape_)) continue;
    if (changed_.size() == 1) {
      walls_->insert(shape_, id);
      break;
    }
    items.push_back({id, shape_});
    ids.push_back(id);
  }
  if (!items.empty()) walls_->insert_all(constraint::ShapeBatch{items, ids});
  walls_->update();
}

void Layers::commit() {
  all_.commit();
  if (is_walls_open_) walls_->commit();
  is_walls_open_ = false;
  old_bridges_.reset();
}

void Layers::roll_back() noexcept {
  if (old_bridges_) {
    walls_.reset();
    all_.roll_back();
    all_.set_bridges(std::move(old_bridges_));
    return;
  }
  if (is_walls_open_) walls_->roll_back();
  is_walls_open_ = false;
  all_.roll_back();
}

std::optional<std::string> Layers::find_fault() const {
  if (auto fault = all_.find_fault()) return fault;
  if (!keeps_bridges_) return std::nullopt;
  if (layer_of_bridges().bridges() == nullptr) return "the world has no bridges";
  if (!walls_) {
    if (!has_any_loose_ring(triangulation())) return std::nullopt;
    return "an item has a ring with one corner, but the walls have no mesh of their own";
  }
  if (auto fault = walls_->find_fault()) return "the mesh of the walls: " + *std::move(fault);
  if (constraint::dump(walls_->triangulation()) != constraint::dump(walls_of(triangulation()))) {
    return "the mesh of the walls differs from one that is built from the items";
  }
  return std::nullopt;
}

void Layers::count_memory(MemoryUse& use) const {
  all_.count_memory(use);
  memory::count_spare(use, changed_, outline_.corners, outline_.ring_ends);
  use.spare += shape_.rings.capacity() * sizeof(Point);
  if (!walls_) return;
  MemoryUse of_walls;
  walls_->count_memory(of_walls);
  use.spare += of_walls.spare;
  use.abstraction += of_walls.abstraction;
  use.bridges += sizeof(Layer) + of_walls.total() - of_walls.spare - of_walls.abstraction;
}

void Layers::shrink_to_fit() {
  memory::release(changed_, outline_.corners, outline_.ring_ends);
  shape_ = {};
  if (walls_ && !has_any_loose_ring(triangulation())) {
    all_.set_bridges(std::make_unique<clearance::Bridges>(triangulation(), walls_->bridges()->limits()));
    walls_.reset();
  }
  all_.shrink_to_fit();
  if (walls_) walls_->shrink_to_fit();
}

}  // namespace waywright

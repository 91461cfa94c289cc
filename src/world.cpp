#include "waywright/world.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/float_environment.hpp"
#include "constraint/batch.hpp"
#include "constraint/canonical.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/item_queries.hpp"
#include "io/dump.hpp"
#include "io/sha256.hpp"
#include "point_error.hpp"
#include "query_scratch.hpp"
#include "world_impl.hpp"

namespace waywright {

QueryContext::QueryContext() : scratch_(std::make_unique<detail::QueryScratch>()) {}
QueryContext::~QueryContext() = default;
QueryContext::QueryContext(QueryContext&&) noexcept = default;
QueryContext& QueryContext::operator=(QueryContext&&) noexcept = default;

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

namespace {

/// A mesh may not outgrow its 31-bit half-edge indices: 2^31 / 6 vertices. This keeps half of that for crossings, which
/// nobody can count before they are made.
constexpr std::size_t kLargestPointCount = std::size_t{1} << 27;

constexpr char kNoThread[] = "BulkOptions: `threads` is 0; the calling thread is one";

std::optional<Error> find_arity_error(const Shape& shape) {
  const auto refuse = [](detail::ErrorWords message) {
    return Error{ErrorCode::empty_shape, std::move(message), {}, 0};
  };
  if (shape.rings.empty()) return refuse("a shape needs a ring of points");
  for (const PointSpan& ring : shape.rings) {
    if (ring.empty()) return refuse("a ring needs at least one point");
  }
  if (shape.kind == ItemKind::polygon) return std::nullopt;
  if (shape.rings.size() != 1) return refuse("only a polygon has more than one ring");
  const std::size_t count = shape.rings[0].size();
  if (shape.kind == ItemKind::point && count != 1) return refuse("a point needs exactly one point");
  if (shape.kind == ItemKind::segment && count != 2) return refuse("a segment needs exactly two points");
  return std::nullopt;
}

Error too_large() { return {ErrorCode::too_large, "the world has too many vertices", {}, 0}; }

std::optional<Error> find_shape_error(const Box& domain, const Shape& shape, std::size_t vertex_count) {
  if (auto error = find_arity_error(shape)) return error;
  const std::span<const Point> points = shape.rings.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto error = find_point_error(domain, points[i], i)) return error;
  }
  if (vertex_count + points.size() > kLargestPointCount) return too_large();
  return std::nullopt;
}

Error about(ItemId id, Error error) {
  error.item = id;
  return error;
}

Error bad_id(ItemId id) { return {ErrorCode::bad_id, {}, id, 0}; }

Error id_in_use(ItemId id) { return {ErrorCode::id_in_use, {}, id, 0}; }

Error unknown_id(ItemId id) {
  return {id.value > ItemId::kLargest ? ErrorCode::bad_id : ErrorCode::unknown_id, {}, id, 0};
}

/// Makes the error's index, which has been set to the position of a list's element, a part of the message.
Error in_list(const char* element, Error error) {
  error.words.list = element;
  return error;
}

/// Checks changes one after the other against the ids and the size that the ones before will have left.
class BatchCheck {
 public:
  BatchCheck(const World& world, const constraint::ItemTable& items)
      : world_(world), items_(items), largest_(items.largest_id_seen()), vertices_(world.vertex_count()) {}

  /// What is wrong with the change, its position in the error's index; or nothing, and the change is counted in.
  [[nodiscard]] std::optional<Error> add(const Change& change) {
    if (change.kind == Change::Kind::insert) return add_insertion(change.shape, change.id);
    if (!is_alive(change.id)) return refuse(unknown_id(change.id));
    if (change.kind == Change::Kind::replace) {
      if (auto error = count_in(change.shape)) return refuse(about(change.id, *std::move(error)));
    } else {
      changed_[change.id] = false;
    }
    ids_.push_back(change.id);
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Error> add_insertion(const Shape& shape, ItemId id) {
    if (id.is_null()) id = {largest_.value + 1};
    if (id.value > ItemId::kLargest) return refuse(bad_id(id));
    if (id <= largest_ && is_alive(id)) return refuse(id_in_use(id));
    if (auto error = count_in(shape)) return refuse(about(id, *std::move(error)));
    if (id > largest_) {
      largest_ = id;
      fresh_.push_back(id);
    } else {
      changed_[id] = true;
    }
    ids_.push_back(id);
    return std::nullopt;
  }

  /// Of all shapes.
  [[nodiscard]] std::size_t point_count() const { return vertices_ - world_.vertex_count(); }
  /// Of each change's item.
  [[nodiscard]] std::span<const ItemId> ids() const { return ids_; }
  [[nodiscard]] std::vector<ItemId> take_ids() { return std::move(ids_); }

 private:
  [[nodiscard]] std::optional<Error> refuse(Error error) const {
    error.index = ids_.size();
    return error;
  }
  [[nodiscard]] std::optional<Error> count_in(const Shape& shape) {
    if (auto error = find_shape_error(world_.domain(), shape, vertices_)) return error;
    vertices_ += shape.rings.points().size();
    return std::nullopt;
  }
  [[nodiscard]] bool is_alive(ItemId id) const {
    const auto found = changed_.find(id);
    if (found != changed_.end()) return found->second;
    return items_.contains(id) || std::binary_search(fresh_.begin(), fresh_.end(), id);
  }

  const World& world_;
  const constraint::ItemTable& items_;
  ItemId largest_;
  std::size_t vertices_;
  std::vector<ItemId> ids_;
  std::vector<ItemId> fresh_;                 ///< inserted under an id above all before; so they ascend
  std::unordered_map<ItemId, bool> changed_;  ///< of other ids that were changed, whether they are alive now
};

/// Of a segment that a query is about.
std::optional<Error> find_ends_error(const Box& domain, const Point& from, const Point& to) {
  if (auto error = find_point_error(domain, from, 0, "the start")) return error;
  return find_point_error(domain, to, 1, "the end");
}

/// What is reported is less than `total` until all is done.
locate::Crew crew_of(const BulkOptions& options, std::size_t total) {
  locate::Crew::Report report;
  if (options.progress) {
    report = [&options, total](std::size_t done) {
      if (done < total) options.progress(done, total);
    };
  }
  return {options.threads, std::move(report), options.jobs};
}

/// Fills `shape` with that of a live item, for its memory.
void fill_shape(const constraint::ExactTriangulation& triangulation, ItemId id, Shape& shape) {
  const constraint::ItemTable& items = triangulation.items();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const std::uint32_t slot = items.slot(id);
  std::size_t count = 0;
  items.for_each_corner(slot, [&](mesh::Vertex, bool) { ++count; });
  shape.kind = items.kind(slot);
  shape.fill = items.fill(slot);
  const bool is_a_place = shape.kind == ItemKind::segment && count == 1;
  shape.rings.clear();
  shape.rings.reserve(is_a_place ? 2 : count);
  bool starts_ring = true;
  items.for_each_corner(slot, [&](mesh::Vertex corner, bool ends_ring) {
    if (starts_ring) shape.rings.start_ring();
    shape.rings.add_point(geometry.nearest(number(corner)));
    starts_ring = ends_ring;
  });
  if (is_a_place) shape.rings.add_point(shape.rings[0][0]);
}

}  // namespace

void World::Impl::note_removal(std::uint32_t slot) {
  if (triangulation.items().kind(slot) == ItemKind::point) return;
  triangulation.items().outline(slot, outline);
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  change_log.add_item();
  for (const mesh::Vertex v : outline.corners) change_log.add_point(geometry.nearest(number(v)));
}

Result<World> World::create(const Box& domain, const WorldOptions& options) {
  const base::FloatEnvironment environment;
  if (auto error = find_range_error(domain.min, 0, "the domain's min")) return *std::move(error);
  if (auto error = find_range_error(domain.max, 1, "the domain's max")) return *std::move(error);
  if (!(domain.min.x < domain.max.x && domain.min.y < domain.max.y)) {
    return Error{ErrorCode::bad_domain, "a domain needs min.x < max.x and min.y < max.y", {}, 0};
  }
  const Box normalised{{domain.min.x + 0.0, domain.min.y + 0.0}, {domain.max.x + 0.0, domain.max.y + 0.0}};
  return World(std::make_unique<Impl>(normalised, options));
}

const Box& World::domain() const { return impl_->triangulation.domain(); }

Result<ItemId> World::insert(const Shape& shape, ItemId id) {
  const base::FloatEnvironment environment;
  const constraint::ItemTable& items = impl_->triangulation.items();
  if (id.is_null()) id = {items.largest_id_seen().value + 1};
  if (id.value > ItemId::kLargest) return bad_id(id);
  if (items.contains(id)) return id_in_use(id);
  if (auto error = find_shape_error(domain(), shape, vertex_count())) return about(id, *std::move(error));
  Operation operation(*impl_);
  operation.insert(shape, id);
  operation.commit();
  return id;
}

Result<ItemId> World::insert_point(Point point, ItemId id) { return insert(Shape::point(point), id); }

Result<ItemId> World::insert_segment(Point a, Point b, ItemId id) { return insert(Shape::segment(a, b), id); }

Result<ItemId> World::insert_polyline(PointSpan points, ItemId id) { return insert(Shape::polyline(points), id); }

Result<ItemId> World::insert_polygon(Rings rings, ItemId id) { return insert(Shape::polygon(std::move(rings)), id); }

Result<void> World::remove(ItemId id) {
  const base::FloatEnvironment environment;
  if (!contains(id)) return unknown_id(id);
  Operation operation(*impl_);
  operation.remove(id);
  operation.commit();
  return {};
}

Result<void> World::replace(ItemId id, const Shape& shape) {
  const base::FloatEnvironment environment;
  if (!contains(id)) return unknown_id(id);
  if (auto error = find_shape_error(domain(), shape, vertex_count())) return about(id, *std::move(error));
  Operation operation(*impl_);
  operation.remove(id);
  operation.insert(shape, id);
  operation.commit();
  return {};
}

// All that can be wrong is found out before the first change.
Result<std::vector<ItemId>> World::apply(std::span<const Change> changes) {
  const base::FloatEnvironment environment;
  BatchCheck check(*this, impl_->triangulation.items());
  bool is_all_insertions = true;
  for (const Change& change : changes) {
    if (auto error = check.add(change)) return in_list("change", *std::move(error));
    is_all_insertions = is_all_insertions && change.kind == Change::Kind::insert;
  }
  const std::span<const ItemId> ids = check.ids();
  if (is_all_insertions) {
    impl_->insert_all(constraint::ShapeBatch<Change>{changes, ids});
    return check.take_ids();
  }
  Operation operation(*impl_);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    std::size_t end = i;
    while (end < changes.size() && changes[end].kind == Change::Kind::insert) ++end;
    if (end > i + 1) {
      operation.insert_all(constraint::ShapeBatch<Change>{changes.subspan(i, end - i), ids.subspan(i, end - i)});
      i = end - 1;
      continue;
    }
    if (changes[i].kind != Change::Kind::insert) operation.remove(ids[i]);
    if (changes[i].kind != Change::Kind::remove) operation.insert(changes[i].shape, ids[i]);
  }
  operation.commit();
  return check.take_ids();
}

Result<std::vector<ItemId>> World::insert_all(std::span<const Item> items, const BulkOptions& options) {
  const base::FloatEnvironment environment;
  BatchCheck check(*this, impl_->triangulation.items());
  for (const Item& item : items) {
    if (auto error = check.add_insertion(item.shape, item.id)) return in_list("item", *std::move(error));
  }
  WAYWRIGHT_ASSERT(options.threads >= 1, kNoThread);
  const std::size_t total = check.point_count() + items.size();
  impl_->insert_all(constraint::ShapeBatch<Item>{items, check.ids()}, crew_of(options, total));
  if (options.progress) options.progress(total, total);
  return check.take_ids();
}

Result<ItemId> World::insert_points(PointSpan points, ItemId first, const BulkOptions& options) {
  const base::FloatEnvironment environment;
  const constraint::ItemTable& items = impl_->triangulation.items();
  const ItemId largest = items.largest_id_seen();
  if (first.is_null()) first = {largest.value + 1};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ItemId id{first.value + i};
    const auto refuse = [&](Error error) {
      error.index = i;
      return about(id, std::move(error));
    };
    if (id.value > ItemId::kLargest || id < first) return refuse(bad_id(id));
    if (id <= largest && items.contains(id)) return refuse(id_in_use(id));
    if (auto error = find_point_error(domain(), points[i], i)) return refuse(*std::move(error));
  }
  if (vertex_count() + points.size() > kLargestPointCount) return about(first, too_large());
  WAYWRIGHT_ASSERT(options.threads >= 1, kNoThread);
  impl_->insert_all(constraint::PointBatch{points, first}, crew_of(options, points.size()));
  if (options.progress) options.progress(points.size(), points.size());
  return first;
}

bool World::contains(ItemId id) const { return impl_->triangulation.items().contains(id); }

std::size_t World::item_count() const { return impl_->triangulation.items().size(); }

std::vector<ItemId> World::item_ids() const { return impl_->triangulation.items().ids(); }

void World::item_ids(std::vector<ItemId>& ids) const { impl_->triangulation.items().ids(ids); }

Result<void> World::shape(ItemId id, Shape& shape) const {
  if (!contains(id)) return unknown_id(id);
  fill_shape(impl_->triangulation, id, shape);
  return {};
}

Result<Shape> World::shape(ItemId id) const {
  Shape shape;
  if (auto done = this->shape(id, shape); !done) return done.error();
  return shape;
}

void World::items(QueryContext& context, std::vector<Item>& items) const {
  std::vector<ItemId>& ids = context.scratch_->items.ids;
  item_ids(ids);
  items.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    items[i].id = ids[i];
    fill_shape(impl_->triangulation, ids[i], items[i].shape);
  }
}

std::vector<Item> World::items() const {
  QueryContext context;
  std::vector<Item> items;
  this->items(context, items);
  return items;
}

std::size_t World::vertex_count() const { return impl_->triangulation.topology().vertex_count() - 1; }

// Each vertex on the border makes one of the ghost faces. A triangulated sphere has 2 V - 4 faces.
std::size_t World::triangle_count() const {
  const mesh::TriangleMesh& mesh = impl_->triangulation.topology();
  std::size_t border = 0;
  mesh.for_each_outgoing(impl_->triangulation.triangulation().ghost(), [&](mesh::HalfEdge) { ++border; });
  return mesh.face_count() - border;
}

Result<void> World::locate(Point point, QueryContext& context, Location& location) const {
  const base::FloatEnvironment environment;
  const Impl& impl = *impl_;
  const constraint::ExactTriangulation& triangulation = impl.triangulation;
  if (auto error = find_point_error(triangulation.domain(), point, 0, "the point")) return *std::move(error);
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  const locate::Located place = delaunay.locate(point);
  constexpr std::array<Place, 3> kPlaces = {Place::vertex, Place::edge, Place::face};
  const auto spot = static_cast<std::size_t>(place.spot);
  location.at = kPlaces[spot];
  location.corner_count = spot + 1;
  std::array<mesh::Vertex, 3> corners = {mesh.origin(place.h), mesh.target(place.h), mesh.apex(place.h)};
  const auto end = corners.begin() + static_cast<std::ptrdiff_t>(location.corner_count);
  const auto before = [&](mesh::Vertex p, mesh::Vertex q) { return delaunay.comes_before(p, q); };
  std::rotate(corners.begin(), std::min_element(corners.begin(), end, before), end);
  for (std::size_t i = 0; i < location.corner_count; ++i) {
    location.corners[i] = delaunay.geometry().nearest(number(corners[i]));
  }
  location.inside.clear();
  path::KeptCover& cover = context.scratch_->cover;
  cover.use(impl.kept_abstraction());
  for (const std::uint32_t item : cover.of_place(triangulation, place)) {
    location.inside.push_back(triangulation.items().id(item));
  }
  std::sort(location.inside.begin(), location.inside.end());
  return {};
}

Result<Location> World::locate(Point point) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  Location location;
  if (auto done = locate(point, *context, location); !done) return done.error();
  return location;
}

Result<void> World::items_at(Point point, QueryContext& context, std::vector<ItemId>& items) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), point, 0, "the point")) return *std::move(error);
  detail::QueryScratch& scratch = *context.scratch_;
  scratch.cover.use(impl_->kept_abstraction());
  constraint::items_at(impl_->triangulation, scratch.cover, point, scratch.items, items);
  return {};
}

Result<std::vector<ItemId>> World::items_at(Point point) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<ItemId> items;
  if (auto done = items_at(point, *context, items); !done) return done.error();
  return items;
}

Result<void> World::items_crossed(Point from, Point to, QueryContext& context, std::vector<CrossedItem>& items) const {
  const base::FloatEnvironment environment;
  if (auto error = find_ends_error(domain(), from, to)) return *std::move(error);
  constraint::items_crossed(impl_->triangulation, from, to, context.scratch_->items, items);
  return {};
}

Result<std::vector<CrossedItem>> World::items_crossed(Point from, Point to) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<CrossedItem> items;
  if (auto done = items_crossed(from, to, *context, items); !done) return done.error();
  return items;
}

Result<void> World::ray(Point from, Point to, RayHit& hit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_ends_error(domain(), from, to)) return *std::move(error);
  constraint::first_wall(impl_->triangulation, from, to, hit);
  return {};
}

Result<RayHit> World::ray(Point from, Point to) const {
  RayHit hit;
  if (auto done = ray(from, to, hit); !done) return done.error();
  return hit;
}

Result<void> World::items_in(const Box& box, QueryContext& context, std::vector<ItemId>& items) const {
  const base::FloatEnvironment environment;
  if (auto error = find_range_error(box.min, 0, "the box's min")) return *std::move(error);
  if (auto error = find_range_error(box.max, 1, "the box's max")) return *std::move(error);
  if (box.min.x > box.max.x || box.min.y > box.max.y) {
    return Error{ErrorCode::bad_domain, "a box needs min.x <= max.x and min.y <= max.y", {}, 0};
  }
  items.clear();
  if (!box.overlaps(domain())) return {};
  detail::QueryScratch& scratch = *context.scratch_;
  scratch.cover.use(impl_->kept_abstraction());
  constraint::items_in(impl_->triangulation, scratch.cover, box, scratch.items, items);
  return {};
}

Result<std::vector<ItemId>> World::items_in(const Box& box) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<ItemId> items;
  if (auto done = items_in(box, *context, items); !done) return done.error();
  return items;
}

MemoryUse World::memory() const {
  MemoryUse use;
  use.spare = sizeof(Impl) + sizeof(TouchLog);
  impl_->triangulation.count_memory(use);
  impl_->change_log.count_memory(use);
  impl_->touch_log->count_memory(use);
  memory::count_spare(use, impl_->outline.corners, impl_->outline.ring_ends);
  if (impl_->abstraction) impl_->abstraction->count_memory(use);
  return use;
}

void World::shrink_to_fit() {
  impl_->triangulation.shrink_to_fit();
  if (impl_->abstraction) impl_->abstraction->shrink_to_fit();
  impl_->change_log.shrink_to_fit();
  impl_->touch_log->shrink_to_fit();
  impl_->spare_context.release();
  memory::release(impl_->outline.corners, impl_->outline.ring_ends);
}

Validation World::validate() const {
  const base::FloatEnvironment environment;
  auto fault = impl_->triangulation.find_fault();
  if (!fault && impl_->abstraction) fault = impl_->abstraction->find_fault(impl_->triangulation);
  if (!fault) return {};
  return {false, *std::move(fault)};
}

ItemsHash World::items_hash() const { return {impl_->triangulation.items().hash()}; }

MeshHash World::mesh_hash() const { return {io::sha256(dump())}; }

void World::snapshot(QueryContext& context, MeshSnapshot& snapshot) const {
  const base::FloatEnvironment environment;
  constraint::take_snapshot(impl_->triangulation, context.scratch_->order, snapshot);
}

MeshSnapshot World::snapshot() const {
  QueryContext context;
  MeshSnapshot snapshot;
  this->snapshot(context, snapshot);
  return snapshot;
}

std::string World::dump() const {
  const base::FloatEnvironment environment;
  return io::dump(impl_->triangulation);
}

}  // namespace waywright

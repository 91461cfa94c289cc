#include "support/scene_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"
#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "support/oracle_adapter.hpp"
#include "support/point_text.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Fault = std::optional<std::string>;

std::string item_name(ItemId id) { return "item " + std::to_string(id.value); }

class WorldCheck {
 public:
  WorldCheck(const Scene& scene, Flavour flavour, std::uint64_t seed)
      : scene_(scene), flavour_(flavour), random_(seed), oracle_(oracle::to_oracle(scene)) {}

  SceneReport run() {
    report_.fault = first_fault();
    return report_;
  }

 private:
  Fault first_fault() {
    Result<World> world = World::create(scene_.domain);
    if (!world) return "create: " + world.error().message();
    if (const Fault fault = insert_all(*world)) return fault;
    const std::string dump = world->dump();
    report_.vertices = world->vertex_count();
    if (const Fault fault = oracle_.check_dump(dump)) return "dump: " + *fault;
    if (const Fault fault = check_counts(*world, dump)) return fault;
    if (const Fault fault = check_snapshot(*world)) return fault;
    if (const Fault fault = check_locations(*world, dump)) return fault;
    if (const Fault fault = check_refusals(*world, dump)) return fault;
    if (const Fault fault = check_at_once(dump)) return fault;
    return check_other_order(dump);
  }

  Fault insert_all(World& world) {
    for (const Item& item : scene_.items) {
      const Result<ItemId> inserted = world.insert(item.shape, item.id);
      ++report_.operations;
      if (!inserted) return "insert of " + item_name(item.id) + ": " + inserted.error().message();
      if (*inserted != item.id) return "insert of " + item_name(item.id) + " returned " + item_name(*inserted);
      const Validation validation = world.validate();
      if (!validation.ok) return "validate after " + item_name(item.id) + ": " + validation.fault;
    }
    return std::nullopt;
  }

  Fault check_counts(const World& world, std::string_view dump) const {
    if (world.vertex_count() != oracle_.vertex_count()) return "vertex_count is wrong";
    const std::string triangles = "\ntriangles " + std::to_string(world.triangle_count()) + "\n";
    if (dump.find(triangles) == std::string_view::npos) return "triangle_count is not the dump's";
    if (world.item_count() != scene_.items.size()) return "item_count is wrong";
    std::vector<ItemId> ids;
    for (const Item& item : scene_.items) {
      ids.push_back(item.id);
      if (!world.contains(item.id)) return "contains denies " + item_name(item.id);
    }
    std::sort(ids.begin(), ids.end());
    if (world.item_ids() != ids) return "item_ids is wrong";
    return std::nullopt;
  }

  // The caller has checked the dump. This compares only what the snapshot reports independently.
  Fault check_snapshot(const World& world) const {
    const MeshSnapshot snapshot = world.snapshot();
    if (oracle::to_oracle(snapshot.vertices) != oracle_.nearest_vertices()) {
      return "snapshot: vertices are not the nearest doubles";
    }
    if (snapshot.triangles.size() != world.triangle_count()) return "snapshot: wrong count of triangles";
    std::vector<oracle::OracleConstraint> constraints;
    for (const MeshSnapshot::ConstrainedEdge& edge : snapshot.constraints) {
      auto& constraint = constraints.emplace_back();
      constraint.from = edge.vertices[0];
      constraint.to = edge.vertices[1];
      for (std::uint32_t i = 0; i < edge.id_count; ++i) {
        constraint.ids.push_back(snapshot.ids.at(edge.first_id + i).value);
      }
    }
    if (constraints != oracle_.expected().constraints) return "snapshot: constrained edges are wrong";
    return std::nullopt;
  }

  std::vector<Point> points_to_locate() {
    std::vector<Point> points;
    for (std::size_t i = 0; i < 8; ++i) points.push_back(random_point(flavour_, scene_.domain, random_));
    for (std::size_t i = 0; i < 8 && !scene_.items.empty(); ++i) {
      const Item& item = scene_.items[random_.below(scene_.items.size())];
      const auto& ring = item.shape.rings[random_.below(item.shape.rings.size())];
      const std::size_t at = random_.below(ring.size());
      const Point corner = ring[at];
      const Point next = ring[(at + 1) % ring.size()];
      const auto middle = [](double a, double b) {
        const double value = a + (b - a) / 2.0;
        return std::fabs(value) < 0x1p-100 ? 0.0 : value;
      };
      points.push_back(corner);
      points.push_back({middle(corner.x, next.x), middle(corner.y, next.y)});
    }
    // The doubles nearest to vertices lie on them or very close to them.
    const auto& vertices = oracle_.nearest_vertices();
    for (std::size_t i = 0; i < 4; ++i) {
      const oracle::OraclePoint p = vertices[random_.below(vertices.size())];
      const bool legal = (p.x == 0.0 || std::fabs(p.x) >= 0x1p-100) && (p.y == 0.0 || std::fabs(p.y) >= 0x1p-100);
      if (legal) points.push_back({p.x, p.y});
    }
    return points;
  }

  Fault check_locations(const World& world, std::string_view dump) {
    const std::vector<Point> points = points_to_locate();
    const auto expected = oracle_.locate(dump, oracle::to_oracle(points));
    QueryContext context;
    Location location;
    for (std::size_t i = 0; i < points.size(); ++i) {
      ++report_.operations;
      const std::string where = "locate " + text_of(points[i]) + ": ";
      const Result<void> located = world.locate(points[i], context, location);
      if (!located) return where + located.error().message();
      if (static_cast<int>(location.kind) != static_cast<int>(expected[i].kind))
        return where + "wrong kind of location";
      const std::vector<Point> vertices(location.vertices.begin(),
                                        location.vertices.begin() + static_cast<std::ptrdiff_t>(location.vertex_count));
      if (oracle::to_oracle(vertices) != expected[i].vertices) return where + "wrong vertices";
      std::vector<std::uint64_t> polygons;
      for (const ItemId id : location.polygons) polygons.push_back(id.value);
      if (polygons != oracle_.covering_polygons(oracle::to_oracle(points[i]))) return where + "wrong polygons";
    }
    return std::nullopt;
  }

  Fault check_refusal(World& world, const Shape& shape, ItemId id, ErrorCode code, std::string_view dump) {
    ++report_.operations;
    const std::string name = "a refused insertion (" + std::string(to_string(code)) + ")";
    const Result<ItemId> inserted = world.insert(shape, id);
    if (inserted) return name + " went in";
    if (inserted.error().code != code) return name + " is refused as " + std::string(to_string(inserted.error().code));
    if (world.dump() != dump || world.item_count() != scene_.items.size()) return name + " changed the world";
    return std::nullopt;
  }

  Fault check_refusals(World& world, std::string_view dump) {
    const Point good = scene_.domain.min;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Point outside{scene_.domain.max.x, std::nextafter(scene_.domain.max.y, 0x1p101)};
    const bool in_range = outside.y <= 0x1p100 && std::fabs(outside.y) >= 0x1p-100;
    const ErrorCode outside_code = in_range ? ErrorCode::out_of_domain : ErrorCode::coordinate_range;
    // The valid points come first. A refused insertion must leave none of them behind.
    const Point other = scene_.domain.max;
    const std::vector<std::pair<Shape, ErrorCode>> refused{
        {{ItemKind::segment, {{good, {nan, good.y}}}}, ErrorCode::coordinate_range},
        {{ItemKind::polyline, {{good, other, {good.x, 0x1.8p100}}}}, ErrorCode::coordinate_range},
        {{ItemKind::point, {{{0x1p-101, good.y}}}}, ErrorCode::coordinate_range},
        {{ItemKind::polygon, {{good, other, {good.x, other.y}}, {good, outside}}}, outside_code},
        {{ItemKind::polyline, {{}}}, ErrorCode::bad_shape},
        {{ItemKind::polygon, {}}, ErrorCode::bad_shape},
        {{ItemKind::polygon, {{good, other}, {}}}, ErrorCode::bad_shape}};
    ItemId unused{1};
    while (world.contains(unused)) ++unused.value;
    for (const auto& [shape, code] : refused) {
      if (const Fault fault = check_refusal(world, shape, unused, code, dump)) return fault;
    }
    const Shape diagonal{ItemKind::segment, {{good, other}}};
    if (const Fault fault = check_refusal(world, diagonal, {ItemId::kLargest + 1}, ErrorCode::bad_id, dump))
      return fault;
    if (scene_.items.empty()) return std::nullopt;
    const ItemId taken = scene_.items[random_.below(scene_.items.size())].id;
    return check_refusal(world, diagonal, taken, ErrorCode::id_in_use, dump);
  }

  Fault check_other_order(std::string_view dump) {
    std::vector<Item> items = scene_.items;
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random_.below(i)]);
    Result<World> world = World::create(scene_.domain);
    if (!world) return "create: " + world.error().message();
    for (const Item& item : items) {
      ++report_.operations;
      if (!world->insert(item.shape, item.id))
        return "in another order, the insertion of " + item_name(item.id) + " fails";
    }
    if (world->dump() != dump) return "in another order, the items give another dump";
    return std::nullopt;
  }

  // Inserts all items in one operation, into an empty world and into a world with the first third of them.
  Fault check_at_once(std::string_view dump) {
    for (const std::size_t before : {std::size_t{0}, scene_.items.size() / 3}) {
      Result<World> world = World::create(scene_.domain);
      if (!world) return "create: " + world.error().message();
      const std::span<const Item> items = scene_.items;
      for (const Item& item : items.first(before)) (void)world->insert(item.shape, item.id);
      const Result<std::vector<ItemId>> ids = world->insert_all(items.subspan(before));
      report_.operations += items.size();
      if (!ids) return "insert_all: " + ids.error().message();
      for (std::size_t i = before; i < items.size(); ++i) {
        if ((*ids)[i - before] != items[i].id) return "insert_all returned another id for " + item_name(items[i].id);
        const Result<Shape> shape = world->shape(items[i].id);
        if (!shape || *shape != *world_shape(items[i])) return "the shape of " + item_name(items[i].id) + " is wrong";
      }
      const Validation validation = world->validate();
      if (!validation.ok) return "validate after insert_all: " + validation.fault;
      if (world->dump() != dump) return "inserted at once, the items give another dump";
    }
    return std::nullopt;
  }

  /// Returns the item's shape as a world of its own returns it.
  Result<Shape> world_shape(const Item& item) const {
    World world = World::create(scene_.domain).value();
    (void)world.insert(item.shape, item.id);
    return world.shape(item.id);
  }

  const Scene& scene_;
  Flavour flavour_;
  Random random_;
  oracle::Oracle oracle_;
  SceneReport report_;
};

}  // namespace

SceneReport check_scene(const Scene& scene, Flavour flavour, std::uint64_t seed) {
  return WorldCheck(scene, flavour, seed).run();
}

}  // namespace waywright::test

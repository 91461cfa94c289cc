#include <algorithm>
#include <array>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "constraint/item_queries.hpp"
#include "nav/abstraction.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Queries about points, segments and boxes.

namespace waywright {

namespace {

/// Returns the error in the two ends of a query's segment, or nothing.
std::optional<Error> find_ends_error(const Box& domain, const Point& from, const Point& to) {
  if (auto error = find_point_error(domain, from, 0, "the start")) return error;
  return find_point_error(domain, to, 1, "the end");
}

}  // namespace

Result<void> World::locate(Point point, QueryContext& context, Location& location) const {
  const base::FloatEnvironment environment;
  const Impl& impl = *impl_;
  const constraint::ConstrainedTriangulation& triangulation = impl.triangulation();
  if (auto error = find_point_error(triangulation.domain(), point, 0, "the point")) return *std::move(error);
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  const locate::Located located = delaunay.locate(point);
  constexpr std::array<LocationKind, 3> kKinds = {LocationKind::vertex, LocationKind::edge, LocationKind::face};
  const auto kind = static_cast<std::size_t>(located.kind);
  location.kind = kKinds[kind];
  location.vertex_count = kind + 1;
  std::array<mesh::Vertex, 3> vertices = {mesh.origin(located.h), mesh.target(located.h), mesh.apex(located.h)};
  const auto end = vertices.begin() + static_cast<std::ptrdiff_t>(location.vertex_count);
  const auto before = [&](mesh::Vertex p, mesh::Vertex q) { return delaunay.comes_before(p, q); };
  std::rotate(vertices.begin(), std::min_element(vertices.begin(), end, before), end);
  for (std::size_t i = 0; i < location.vertex_count; ++i) {
    location.vertices[i] = delaunay.geometry().rounded(number(vertices[i]));
  }
  location.polygons.clear();
  nav::ComponentCoverFinder& cover_finder = *context.scratch_->cover_finder;
  cover_finder.use(impl.layers.abstraction());
  for (const std::uint32_t item : cover_finder.of_location(triangulation, located)) {
    location.polygons.push_back(triangulation.items().id(item));
  }
  std::sort(location.polygons.begin(), location.polygons.end());
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
  scratch.cover_finder->use(impl_->layers.abstraction());
  constraint::items_at(impl_->triangulation(), *scratch.cover_finder, point, *scratch.items, items);
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
  constraint::items_crossed(impl_->triangulation(), from, to, *context.scratch_->items, items);
  return {};
}

Result<std::vector<CrossedItem>> World::items_crossed(Point from, Point to) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<CrossedItem> items;
  if (auto done = items_crossed(from, to, *context, items); !done) return done.error();
  return items;
}

Result<void> World::items_in(const Box& box, QueryContext& context, std::vector<ItemId>& items) const {
  const base::FloatEnvironment environment;
  if (auto error = find_box_error(box)) return *std::move(error);
  items.clear();
  if (!box.overlaps(domain())) return {};
  detail::QueryScratch& scratch = *context.scratch_;
  scratch.cover_finder->use(impl_->layers.abstraction());
  constraint::items_in(impl_->triangulation(), *scratch.cover_finder, box, *scratch.items, items);
  return {};
}

Result<std::vector<ItemId>> World::items_in(const Box& box) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<ItemId> items;
  if (auto done = items_in(box, *context, items); !done) return done.error();
  return items;
}

}  // namespace waywright

#include <algorithm>
#include <limits>
#include <span>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "world/path_query_error.hpp"
#include "world/point_error.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Queries about discs.

namespace waywright {

namespace {

/// Appends the ids of items by slot.
void append_ids(const constraint::ItemTable& items, std::span<const std::uint32_t> slots, std::vector<ItemId>& ids) {
  for (const std::uint32_t slot : slots) ids.push_back(items.id(slot));
}

/// Sorts a list and removes repeated elements.
void keep_one_of_each(std::vector<ItemId>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

Error no_bridges_error() {
  return {ErrorCode::no_bridges,
          "the query needs a world that keeps its bridges: create it with the option keep_bridges",
          {},
          0};
}

}  // namespace

Result<void> World::fit_disc(Point centre, const Agent& agent, QueryContext& context, DiscFit& fit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), centre, 0, "the centre")) return *std::move(error);
  if (auto error = find_agent_error(agent)) return *std::move(error);
  impl_->fit_disc(centre, agent, *context.scratch_, fit);
  return {};
}

void World::Impl::fit_disc(const Point& centre, const Agent& agent, detail::QueryScratch& scratch, DiscFit& fit) const {
  fit.items.clear();
  if (agent.radius > 0.0) {
    std::vector<std::uint32_t>& slots = scratch.items.slots;
    slots.clear();
    scratch.near_walls.find_items(triangulation, centre, agent.radius, slots);
    append_ids(triangulation.items(), slots, fit.items);
  }
  scratch.cover_finder.use(kept_abstraction());
  const locate::Located located = triangulation.triangulation().locate(centre);
  append_ids(triangulation.items(), scratch.cover_finder.strictly_covering(triangulation, located), fit.items);
  keep_one_of_each(fit.items);
  fit.fits = fit.items.empty();
}

Result<DiscFit> World::fit_disc(Point centre, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  DiscFit fit;
  if (auto done = fit_disc(centre, agent, *context, fit); !done) return done.error();
  return fit;
}

Result<void> World::ray(Point from, Point to, const Agent& agent, QueryContext& context, RayHit& hit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), from, 0, "the start")) return *std::move(error);
  if (auto error = find_point_error(domain(), to, 1, "the end")) return *std::move(error);
  if (auto error = find_agent_error(agent)) return *std::move(error);
  if (agent.radius == 0.0) {
    constraint::first_wall(impl_->triangulation, from, to, hit);
  } else {
    context.scratch_->swept_disc.find_first_wall(impl_->triangulation, {from, to, agent.radius}, hit);
  }
  return {};
}

Result<RayHit> World::ray(Point from, Point to, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  RayHit hit;
  if (auto done = ray(from, to, agent, *context, hit); !done) return done.error();
  return hit;
}

Result<void> World::widest_path(Point start, Point goal, const Agent& /*agent*/, QueryContext& context,
                                WidestPath& widest) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), start, 0, "the start")) return *std::move(error);
  if (auto error = find_point_error(domain(), goal, 1, "the goal")) return *std::move(error);
  if (!impl_->clearance) return no_bridges_error();
  impl_->widest_path(start, goal, *context.scratch_, widest);
  return {};
}

void World::Impl::widest_path(const Point& start, const Point& goal, detail::QueryScratch& scratch,
                              WidestPath& widest) const {
  scratch.cover_finder.use(kept_abstraction());
  const auto is_inside_polygon = [&](const Point& end) {
    return scratch.cover_finder.is_strictly_inside(triangulation, triangulation.triangulation().locate(end));
  };
  auto& gap = scratch.widest_gap;
  gap.clear();
  const constraint::ExactTriangulation& walls = clearance->triangulation_of_walls(triangulation);
  if (!is_inside_polygon(start) && !is_inside_polygon(goal)) {
    scratch.widest_gap_finder.find(walls, clearance->bridges(), scratch.near_walls, start, goal, gap);
  }
  write_widest(gap, widest);
}

void World::Impl::write_widest(const clearance::WidestGap& gap, WidestPath& widest) const {
  const constraint::ItemTable& items = mesh_of_discs().items();
  widest.is_connected = gap.is_connected;
  widest.is_limited = gap.is_limited;
  const bool is_unlimited = gap.is_connected && !gap.is_limited;
  widest.radius = is_unlimited ? std::numeric_limits<double>::infinity() : gap.radius;
  widest.from = gap.from;
  widest.to = gap.to;
  widest.from_items.clear();
  widest.to_items.clear();
  append_ids(items, gap.from_items, widest.from_items);
  append_ids(items, gap.to_items, widest.to_items);
  keep_one_of_each(widest.from_items);
  keep_one_of_each(widest.to_items);
}

Result<WidestPath> World::widest_path(Point start, Point goal, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  WidestPath widest;
  if (auto done = widest_path(start, goal, agent, *context, widest); !done) return done.error();
  return widest;
}

Result<void> World::bridges(const Box& box, QueryContext& context, BridgeList& list) const {
  const base::FloatEnvironment environment;
  if (auto error = find_box_error(box)) return *std::move(error);
  if (!impl_->clearance) return no_bridges_error();
  const clearance::Clearance& clearance = *impl_->clearance;
  const constraint::ExactTriangulation& walls = clearance.triangulation_of_walls(impl_->triangulation);
  nav::ComponentCoverFinder& cover_finder = context.scratch_->cover_finder;
  cover_finder.use(impl_->kept_abstraction_for_discs());
  context.scratch_->bridge_lister.list(walls, clearance.bridges(), cover_finder, box, list);
  return {};
}

Result<BridgeList> World::bridges(const Box& box) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  BridgeList list;
  if (auto done = bridges(box, *context, list); !done) return done.error();
  return list;
}

}  // namespace waywright

#include <optional>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "clearance/bridge_lister.hpp"
#include "clearance/widest.hpp"
#include "constraint/item_queries.hpp"
#include "nav/abstraction.hpp"
#include "path/fit_finder.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Queries about discs.

namespace waywright {

namespace {

Error no_bridges_error() {
  return {ErrorCode::no_bridges,
          "the query needs a world that keeps its bridges: create it with the option keep_bridges",
          {},
          0};
}

std::optional<Error> find_nearest_fit_error(const Box& domain, const Kept& kept, const NearestFitQuery& query) {
  if (auto error = find_point_error(domain, query.point, 0, "the point")) return error;
  if (auto error = find_agent_error(query.agent)) return error;
  if (!(query.limit >= 0.0)) {
    return Error{ErrorCode::bad_distance, "the limit is negative or not a number", {}, 0};
  }
  if (!query.goal) return std::nullopt;
  if (auto error = find_point_error(domain, *query.goal, 1, "the goal")) return error;
  if (query.agent.radius > 0.0 && !kept.has_bridges) {
    return Error{
        ErrorCode::no_bridges,
        "a goal and a radius above 0 need a world that keeps its bridges: create it with the option keep_bridges",
        {},
        0};
  }
  if (query.agent.radius == 0.0 && !kept.has_abstraction) {
    return Error{ErrorCode::not_supported, "a goal and the radius 0 need a world that keeps its abstraction", {}, 0};
  }
  return std::nullopt;
}

}  // namespace

Result<void> World::fit_disc(Point centre, const Agent& agent, QueryContext& context, DiscFit& fit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), centre, 0, "the centre")) return *std::move(error);
  if (auto error = find_agent_error(agent)) return *std::move(error);
  context.scratch_->fits->fit(impl_->ground(), centre, agent, fit);
  return {};
}

Result<DiscFit> World::fit_disc(Point centre, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  DiscFit fit;
  if (auto done = fit_disc(centre, agent, *context, fit); !done) return done.error();
  return fit;
}

Result<void> World::nearest_fit(const NearestFitQuery& query, QueryContext& context, NearestFit& fit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_nearest_fit_error(domain(), impl_->layers.kept(), query)) return *std::move(error);
  context.scratch_->fits->find_nearest(impl_->ground(), query, fit);
  return {};
}

Result<NearestFit> World::nearest_fit(const NearestFitQuery& query) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  NearestFit fit;
  if (auto done = nearest_fit(query, *context, fit); !done) return done.error();
  return fit;
}

Result<void> World::ray(Point from, Point to, const Agent& agent, QueryContext& context, RayHit& hit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), from, 0, "the start")) return *std::move(error);
  if (auto error = find_point_error(domain(), to, 1, "the end")) return *std::move(error);
  if (auto error = find_agent_error(agent)) return *std::move(error);
  if (agent.radius == 0.0) {
    constraint::first_wall(impl_->triangulation(), from, to, hit);
  } else {
    context.scratch_->swept_disc->find_first_wall(impl_->triangulation(), {from, to, agent.radius}, hit);
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
  if (!impl_->layers.kept().has_bridges) return no_bridges_error();
  const path::Ground ground = impl_->ground();
  path::FitFinder& fits = *context.scratch_->fits;
  if (fits.fits(ground, start, {}) && fits.fits(ground, goal, {})) {
    context.scratch_->widest_gap_finder->find(*ground.walls, *ground.bridges, fits.near_walls(), start, goal, widest);
  } else {
    clearance::clear(widest);  // an end lies in the interior of a polygon
  }
  return {};
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
  if (!impl_->layers.kept().has_bridges) return no_bridges_error();
  const path::Ground ground = impl_->ground();
  nav::ComponentCoverFinder& cover_finder = *context.scratch_->cover_finder;
  cover_finder.use(ground.abstraction_of_walls);
  context.scratch_->bridge_lister->list(*ground.walls, *ground.bridges, cover_finder, box, list);
  return {};
}

Result<BridgeList> World::bridges(const Box& box) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  BridgeList list;
  if (auto done = bridges(box, *context, list); !done) return done.error();
  return list;
}

}  // namespace waywright

#include <limits>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "world/path_query_error.hpp"
#include "world/point_error.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// The query for the nearest position to a point, among all positions where a disc fits.

namespace waywright {

namespace {

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

Result<void> World::nearest_fit(const NearestFitQuery& query, QueryContext& context, NearestFit& fit) const {
  const base::FloatEnvironment environment;
  if (auto error = find_nearest_fit_error(domain(), impl_->kept(), query)) return *std::move(error);
  impl_->nearest_fit(query, *context.scratch_, fit);
  return {};
}

Result<NearestFit> World::nearest_fit(const NearestFitQuery& query) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  NearestFit fit;
  if (auto done = nearest_fit(query, *context, fit); !done) return done.error();
  return fit;
}

void World::Impl::nearest_fit(const NearestFitQuery& query, detail::QueryScratch& scratch, NearestFit& fit) const {
  fit = {};
  if (query.agent.radius > 0.0 && query.goal) {
    fit_disc(*query.goal, query.agent, scratch, scratch.fit);
    if (!scratch.fit.fits) return;
  }
  const auto found = query.agent.radius > 0.0 ? nearest_fit_of_disc(query, scratch) : nearest_free(query, scratch);
  if (found) fit = {true, *found, distance(query.point, *found)};
}

std::optional<Point> World::Impl::nearest_fit_of_disc(const NearestFitQuery& query,
                                                      detail::QueryScratch& scratch) const {
  scratch.cover_finder.use(kept_abstraction());
  const clearance::NearestFit::Query of_disc{query.point, query.agent.radius, query.limit};
  if (!query.goal) {
    return scratch.nearest_fit.find(triangulation, scratch.cover_finder, scratch.near_walls, of_disc, nullptr);
  }
  const constraint::ExactTriangulation& walls = clearance->triangulation_of_walls(triangulation);
  const auto cell = scratch.near_walls.find_cell(walls, clearance->bridges(), *query.goal);
  const clearance::NearestFit::Goal goal{walls, clearance->bridges(), *cell};
  return scratch.nearest_fit.find(triangulation, scratch.cover_finder, scratch.near_walls, of_disc, &goal);
}

std::optional<Point> World::Impl::nearest_free(const NearestFitQuery& query, detail::QueryScratch& scratch) const {
  nav::ComponentCoverFinder& cover_finder = scratch.cover_finder;
  cover_finder.use(kept_abstraction());
  path::FreePositions::Connection connection;
  if (query.goal) {
    scratch.goal_faces = cover_finder.open_faces(triangulation, triangulation.triangulation().locate(*query.goal));
    if (scratch.goal_faces.empty()) return std::nullopt;
    connection = {&abstraction->components(), &scratch.goal_faces};
  }
  const locate::Located location = triangulation.triangulation().locate(query.point);
  for (const mesh::HalfEdge h : cover_finder.open_faces(triangulation, location)) {
    if (connection.contains(h)) return query.point;
  }
  if (query.limit == 0.0) return std::nullopt;
  return scratch.free_positions.nearest(triangulation, cover_finder, query.point, location, query.limit, connection);
}

}  // namespace waywright

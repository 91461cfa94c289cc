#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <utility>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "constraint/boxes.hpp"
#include "nav/abstraction.hpp"
#include "path/finder.hpp"
#include "path/pieces.hpp"
#include "path/polyline_walk.hpp"
#include "threads/thread_team.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Path queries.

namespace waywright {

namespace {

/// Returns whether `concerns(box)` is true for one of the boxes. `boxes` is an answer of World::changes_since(). Also
/// returns true if the world does not have the boxes.
template <class Concerns>
bool has_box(const std::optional<std::span<const ChangedBox>>& boxes, const Concerns& concerns) {
  return !boxes ||
         std::any_of(boxes->begin(), boxes->end(), [&](const ChangedBox& entry) { return concerns(entry.box); });
}

bool meets(std::span<const Point> points, const Box& box) {
  const constraint::BoxTest test(box);
  if (points.size() == 1) return test.contains(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (test.meets(exact::explicit_position(points[i - 1]), exact::explicit_position(points[i]))) return true;
  }
  return false;
}

}  // namespace

void World::Impl::find_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  scratch.finder->begin(ground(), query, path);
  scratch.finder->step(path::kToTheEnd, path);
}

Result<void> World::find_path(const PathQuery& query, QueryContext& context, Path& path) const {
  const base::FloatEnvironment environment;
  if (auto error = find_query_error(domain(), impl_->layers.kept(), query)) return *std::move(error);
  impl_->find_path(query, *context.scratch_, path);
  return {};
}

Result<Path> World::find_path(const PathQuery& query) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  Path path;
  if (auto done = find_path(query, *context, path); !done) return done.error();
  return path;
}

// Checks all queries before it searches for the first path, so that an error leaves nothing half done.
Result<void> World::find_paths(std::span<const PathQuery> queries, std::span<QueryContext> contexts,
                               std::vector<Path>& paths, JobSystem* jobs) const {
  const base::FloatEnvironment environment;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (auto error = find_query_error(domain(), impl_->layers.kept(), queries[i])) {
      error->index = i;
      error->words.element_noun = "query";
      return *std::move(error);
    }
  }
  WAYWRIGHT_ASSERT(!contexts.empty(), "World::find_paths: there is no context, or the number of threads is 0");
  paths.resize(queries.size());
  const threads::ThreadTeam team(std::clamp(queries.size(), std::size_t{1}, contexts.size()), {}, jobs);
  team.for_each_index(queries.size(), [&](std::size_t thread, std::size_t i) {
    impl_->find_path(queries[i], *contexts[thread].scratch_, paths[i]);
  });
  return {};
}

Result<std::vector<Path>> World::find_paths(std::span<const PathQuery> queries, std::size_t threads,
                                            JobSystem* jobs) const {
  std::vector<QueryContext> contexts(
      std::min({threads, std::max(queries.size(), std::size_t{1}), threads::ThreadTeam::kMostThreads}));
  std::vector<Path> paths;
  if (auto done = find_paths(queries, contexts, paths, jobs); !done) return done.error();
  return paths;
}

Result<void> World::find_paths_from(const ManyGoalsQuery& query, QueryContext& context,
                                    std::vector<Path>& paths) const {
  const base::FloatEnvironment environment;
  if (auto error = find_point_error(domain(), query.start, 0, "the start")) return *std::move(error);
  for (std::size_t i = 0; i < query.goals.size(); ++i) {
    if (auto error = find_point_error(domain(), query.goals[i], i + 1, {"goal", i})) return *std::move(error);
  }
  if (auto error = find_agent_error(impl_->layers.kept(), query.agent)) return *std::move(error);
  if (auto error = find_tolerance_error(query.end_tolerance)) return *std::move(error);
  context.scratch_->finder->find_all(impl_->ground(), query, paths);
  return {};
}

Result<std::vector<Path>> World::find_paths_from(const ManyGoalsQuery& query) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  std::vector<Path> paths;
  if (auto done = find_paths_from(query, *context, paths); !done) return done.error();
  return paths;
}

double World::default_end_tolerance() const {
  const base::FloatEnvironment environment;
  return path::default_end_tolerance(domain());
}

Result<bool> World::is_clear(std::span<const Point> points, const Agent& agent, QueryContext& context) const {
  const base::FloatEnvironment environment;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto error = find_point_error(domain(), points[i], i, {"point", i})) return *std::move(error);
  }
  if (auto error = find_agent_error(agent)) return *std::move(error);
  if (agent.radius > 0.0) {
    return Error{ErrorCode::not_supported, "is_clear supports only point agents: the radius is above 0", {}, 0};
  }
  context.scratch_->cover_finder->use(impl_->layers.abstraction());
  return context.scratch_->polyline_walk->is_clear(impl_->triangulation(), *context.scratch_->cover_finder, points);
}

Result<bool> World::is_clear(std::span<const Point> points, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  return is_clear(points, agent, *context);
}

Result<bool> World::is_clear(const Point& from, const Point& to, const Agent& agent, QueryContext& context) const {
  const std::array<Point, 2> ends = {from, to};
  return is_clear(ends, agent, context);
}

Result<bool> World::is_clear(const Point& from, const Point& to, const Agent& agent) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  return is_clear(from, to, agent, *context);
}

bool World::is_affected(std::span<const Point> points, std::uint64_t since, const Agent& agent) const {
  const base::FloatEnvironment environment;
  return !points.empty() && has_box(changes_since(since), [&](const Box& box) {
    return agent.radius > 0.0 ? path::may_touch(points, agent.radius, box) : meets(points, box);
  });
}

bool World::is_affected(const Path& path, std::uint64_t since) const {
  const base::FloatEnvironment environment;
  if (path.status == PathStatus::found && path.points.empty() && path.pieces.empty()) {
    return has_box(changes_since(since), [](const Box&) { return true; });
  }
  if (path.pieces.empty()) return is_affected(path.points, since);
  return has_box(changes_since(since),
                 [&](const Box& box) { return path::may_touch(path.pieces, path.agent.radius, box); });
}

std::optional<std::span<const ChangedBox>> World::changes_since(std::uint64_t since) const {
  if (since > version()) return std::nullopt;
  return impl_->change_log.since(since);
}

void World::find_affected(std::span<const Path> paths, std::uint64_t since, std::vector<std::size_t>& affected) const {
  affected.clear();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (is_affected(paths[i], since)) affected.push_back(i);
  }
}

}  // namespace waywright

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "locate/crew.hpp"
#include "point_error.hpp"
#include "query_scratch.hpp"
#include "world_impl.hpp"

namespace waywright {

namespace {

constexpr std::size_t kToTheEnd = std::numeric_limits<std::size_t>::max();

std::optional<Error> find_radius_error(double radius) {
  if (!(radius >= 0.0) || !std::isfinite(radius)) {
    return Error{ErrorCode::bad_radius, "the radius is negative or not finite", {}, 0};
  }
  if (radius > 0.0) {
    return Error{ErrorCode::not_supported, "paths for a radius above 0 are not supported yet", {}, 0};
  }
  return std::nullopt;
}

std::optional<Error> find_query_error(const World& world, bool keeps_abstraction, const PathQuery& query) {
  if (auto error = find_point_error(world.domain(), query.start, 0, "the start")) return error;
  if (auto error = find_point_error(world.domain(), query.goal, 1, "the goal")) return error;
  if (auto error = find_radius_error(query.radius)) return error;
  if (query.algorithm == PathAlgorithm::tra && !keeps_abstraction) {
    return Error{ErrorCode::not_supported, "the path algorithm tra needs a world that keeps its abstraction", {}, 0};
  }
  return std::nullopt;
}

}  // namespace

Result<void> World::find_path(const PathQuery& query, QueryContext& context, Path& path) const {
  if (auto error = find_query_error(*this, impl_->abstraction.has_value(), query)) return *std::move(error);
  path::Finder& finder = context.scratch_->finder;
  finder.begin(impl_->triangulation, impl_->kept_abstraction(), query, path);
  finder.step(kToTheEnd, path);
  return {};
}

Result<Path> World::find_path(const PathQuery& query) const {
  QueryContext context;
  Path path;
  if (auto done = find_path(query, context, path); !done) return done.error();
  return path;
}

// Every query is checked before the first is searched, so that an error leaves nothing half done.
Result<void> World::find_paths(std::span<const PathQuery> queries, std::span<QueryContext> contexts,
                               std::vector<Path>& paths) const {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (auto error = find_query_error(*this, impl_->abstraction.has_value(), queries[i])) {
      error->index = i;
      error->message = "query " + std::to_string(i) + ": " + error->message;
      return *std::move(error);
    }
  }
  paths.resize(queries.size());
  const locate::Crew crew(std::clamp(queries.size(), std::size_t{1}, contexts.size()), {});
  crew.take_turns(queries.size(), [&](std::size_t thread, std::size_t i) {
    path::Finder& finder = contexts[thread].scratch_->finder;
    finder.begin(impl_->triangulation, impl_->kept_abstraction(), queries[i], paths[i]);
    finder.step(kToTheEnd, paths[i]);
  });
  return {};
}

Result<std::vector<Path>> World::find_paths(std::span<const PathQuery> queries, std::size_t threads) const {
  std::vector<QueryContext> contexts(threads);
  std::vector<Path> paths;
  if (auto done = find_paths(queries, contexts, paths); !done) return done.error();
  return paths;
}

Result<void> World::find_paths_from(const ManyGoalsQuery& query, QueryContext& context,
                                    std::vector<Path>& paths) const {
  if (auto error = find_point_error(domain(), query.start, 0, "the start")) return *std::move(error);
  for (std::size_t i = 0; i < query.goals.size(); ++i) {
    const auto find_error = [&](std::string_view name) {
      return find_point_error(domain(), query.goals[i], i + 1, name);
    };
    if (find_error("a goal")) return *find_error("goal " + std::to_string(i));
  }
  if (auto error = find_radius_error(query.radius)) return *std::move(error);
  context.scratch_->finder.find_all(impl_->triangulation, impl_->kept_abstraction(), query, paths);
  return {};
}

Result<std::vector<Path>> World::find_paths_from(const ManyGoalsQuery& query) const {
  QueryContext context;
  std::vector<Path> paths;
  if (auto done = find_paths_from(query, context, paths); !done) return done.error();
  return paths;
}

std::uint64_t World::version() const { return *impl_->version; }

struct WAYWRIGHT_INTERNAL PathSearch::Impl {
  std::shared_ptr<const std::uint64_t> world_version;  ///< null while no search is running
  std::uint64_t version = 0;                           ///< the world's when the search began
  path::Finder finder;
  Path path;
};

PathSearch::PathSearch() : impl_(std::make_unique<Impl>()) {}
PathSearch::~PathSearch() = default;
PathSearch::PathSearch(PathSearch&&) noexcept = default;
PathSearch& PathSearch::operator=(PathSearch&&) noexcept = default;

Result<void> PathSearch::begin(const World& world, const PathQuery& query) {
  cancel();
  if (auto error = find_query_error(world, world.impl_->abstraction.has_value(), query)) return *std::move(error);
  impl_->finder.begin(world.impl_->triangulation, world.impl_->kept_abstraction(), query, impl_->path);
  impl_->world_version = world.impl_->version;
  impl_->version = world.version();
  return {};
}

// While a step lasts, no search is running: one that memory runs out in is given up.
Result<bool> PathSearch::step(std::size_t expansions) {
  if (!is_running()) return true;
  std::shared_ptr<const std::uint64_t> world_version = std::move(impl_->world_version);
  if (*world_version != impl_->version) {
    return Error{ErrorCode::world_changed, "the world has changed or gone since the search began", {}, 0};
  }
  const bool is_done = impl_->finder.step(expansions, impl_->path);
  if (!is_done) impl_->world_version = std::move(world_version);
  return is_done;
}

const Path& PathSearch::path() const { return impl_->path; }

void PathSearch::cancel() { impl_->world_version = nullptr; }

bool PathSearch::is_running() const { return impl_->world_version != nullptr; }

}  // namespace waywright

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "base/float_environment.hpp"
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

std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance) {
  if (!tolerance || *tolerance >= 0.0) return std::nullopt;
  return Error{ErrorCode::bad_distance, "the end tolerance is negative or not a number", {}, 0};
}

std::optional<Error> find_query_error(const Box& domain, bool keeps_abstraction, const PathQuery& query) {
  if (auto error = find_point_error(domain, query.start, 0, "the start")) return error;
  if (auto error = find_point_error(domain, query.goal, 1, "the goal")) return error;
  if (auto error = find_radius_error(query.radius)) return error;
  if (auto error = find_tolerance_error(query.end_tolerance)) return error;
  if (query.algorithm == PathAlgorithm::tra && !keeps_abstraction) {
    return Error{ErrorCode::not_supported, "the path algorithm tra needs a world that keeps its abstraction", {}, 0};
  }
  return std::nullopt;
}

}  // namespace

Result<void> World::find_path(const PathQuery& query, QueryContext& context, Path& path) const {
  const base::FloatEnvironment environment;
  const Impl& impl = *impl_;
  const path::Abstraction* const abstraction = impl.kept_abstraction();
  if (auto error = find_query_error(impl.triangulation.domain(), abstraction != nullptr, query)) {
    return *std::move(error);
  }
  path::Finder& finder = context.scratch_->finder;
  finder.begin(impl.triangulation, abstraction, query, path);
  finder.step(kToTheEnd, path);
  return {};
}

Result<Path> World::find_path(const PathQuery& query) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  Path path;
  if (auto done = find_path(query, *context, path); !done) return done.error();
  return path;
}

// Every query is checked before the first is searched, so that an error leaves nothing half done.
Result<void> World::find_paths(std::span<const PathQuery> queries, std::span<QueryContext> contexts,
                               std::vector<Path>& paths, JobSystem* jobs) const {
  const base::FloatEnvironment environment;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (auto error = find_query_error(domain(), impl_->abstraction.has_value(), queries[i])) {
      error->index = i;
      error->words.list = "query";
      return *std::move(error);
    }
  }
  WAYWRIGHT_ASSERT(!contexts.empty(), "World::find_paths: there is no context, or the number of threads is 0");
  paths.resize(queries.size());
  const locate::Crew crew(std::clamp(queries.size(), std::size_t{1}, contexts.size()), {}, jobs);
  crew.take_turns(queries.size(), [&](std::size_t thread, std::size_t i) {
    path::Finder& finder = contexts[thread].scratch_->finder;
    finder.begin(impl_->triangulation, impl_->kept_abstraction(), queries[i], paths[i]);
    finder.step(kToTheEnd, paths[i]);
  });
  return {};
}

Result<std::vector<Path>> World::find_paths(std::span<const PathQuery> queries, std::size_t threads,
                                            JobSystem* jobs) const {
  std::vector<QueryContext> contexts(threads);
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
  if (auto error = find_radius_error(query.radius)) return *std::move(error);
  if (auto error = find_tolerance_error(query.end_tolerance)) return *std::move(error);
  context.scratch_->finder.find_all(impl_->triangulation, impl_->kept_abstraction(), query, paths);
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

Result<bool> World::is_clear(std::span<const Point> points, QueryContext& context) const {
  const base::FloatEnvironment environment;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto error = find_point_error(domain(), points[i], i, {"point", i})) return *std::move(error);
  }
  context.scratch_->cover.use(impl_->kept_abstraction());
  return context.scratch_->polyline_walk.is_clear(impl_->triangulation, context.scratch_->cover, points);
}

Result<bool> World::is_clear(std::span<const Point> points) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  return is_clear(points, *context);
}

Result<bool> World::is_clear(const Point& from, const Point& to, QueryContext& context) const {
  const std::array<Point, 2> ends = {from, to};
  return is_clear(ends, context);
}

Result<bool> World::is_clear(const Point& from, const Point& to) const {
  const SpareContext::Loan context = impl_->spare_context.borrow();
  return is_clear(from, to, *context);
}

bool World::is_affected(std::span<const Point> points, std::uint64_t since) const {
  const base::FloatEnvironment environment;
  return !points.empty() && impl_->change_log.meets(points, since);
}

void World::find_affected(std::span<const Path> paths, std::uint64_t since, std::vector<std::size_t>& affected) const {
  affected.clear();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (is_affected(paths[i].points, since)) affected.push_back(i);
  }
}

std::uint64_t World::version() const { return impl_->touch_log->version(); }

struct WAYWRIGHT_INTERNAL PathSearch::Impl {
  ~Impl() { stop(); }

  void start(const World::Impl& searched) {
    world = &searched;
    touch_log = searched.touch_log;
    version = touch_log->version();
    touch_log->add_search();
  }
  void stop() {
    if (touch_log != nullptr) touch_log->remove_search();
    touch_log = nullptr;
  }
  void begin() { finder.begin(world->triangulation, world->kept_abstraction(), query, path, &looked_at); }
  /// Makes the search one of the world as it is now.
  void catch_up() {
    if (version == touch_log->version()) return;
    finder.cover_mesh();
    const bool is_concerned = touch_log->has_touched(looked_at, version) || finder.has_covered_end();
    version = touch_log->version();
    if (!is_concerned) return;
    ++restarts;
    begin();
  }

  /// Stops the search at its end, unless there is more to search: also where memory runs out.
  class Step {
   public:
    explicit Step(Impl& impl) : impl_(impl) { impl_.is_done = true; }
    ~Step() {
      if (impl_.is_done) impl_.stop();
    }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Impl& impl_;
  };

  std::shared_ptr<TouchLog> touch_log;  ///< null while no search is running
  const World::Impl* world = nullptr;   ///< stays where it is as long as its log does not say that it has gone
  std::uint64_t version = 0;            ///< of the world that the search belongs to
  PathQuery query;
  path::Finder finder;
  path::LookedAt looked_at;
  Path path;
  std::size_t restarts = 0;
  bool is_done = false;
};

PathSearch::PathSearch() : impl_(std::make_unique<Impl>()) {}
PathSearch::~PathSearch() = default;
PathSearch::PathSearch(PathSearch&&) noexcept = default;
PathSearch& PathSearch::operator=(PathSearch&&) noexcept = default;

Result<void> PathSearch::begin(const World& world, const PathQuery& query) {
  const base::FloatEnvironment environment;
  cancel();
  if (auto error = find_query_error(world.domain(), world.impl_->abstraction.has_value(), query))
    return *std::move(error);
  impl_->query = query;
  impl_->restarts = 0;
  impl_->world = &*world.impl_;
  impl_->begin();
  impl_->start(*world.impl_);
  return {};
}

// While a step lasts, no search is running: one that memory runs out in is given up.
Result<bool> PathSearch::step(std::size_t expansions) {
  const base::FloatEnvironment environment;
  if (!is_running()) return true;
  if (impl_->touch_log->version() == TouchLog::kGone) {
    cancel();
    return Error{ErrorCode::world_gone, "the world has gone since the search began", {}, 0};
  }
  const Impl::Step step(*impl_);
  impl_->catch_up();
  impl_->is_done = impl_->finder.step(expansions, impl_->path);
  return impl_->is_done;
}

const Path& PathSearch::path() const { return impl_->path; }

std::size_t PathSearch::restarts() const { return impl_->restarts; }

void PathSearch::cancel() { impl_->stop(); }

bool PathSearch::is_running() const { return impl_->touch_log != nullptr; }

}  // namespace waywright

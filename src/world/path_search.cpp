#include "waywright/path_search.hpp"

#include <memory>
#include <span>
#include <vector>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "path/finder.hpp"
#include "path/fit_finder.hpp"
#include "path/looked_at.hpp"
#include "world/change_log.hpp"
#include "world/query_errors.hpp"
#include "world/world_impl.hpp"

namespace waywright {

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
  [[nodiscard]] bool is_for_disc() const { return query.agent.radius > 0.0; }
  void begin() {
    windows.clear();
    const path::Ground ground = world->ground();
    walls = ground.walls;
    finder.begin(ground, query, path, &looked_at);
    if (records_windows) finder.record_windows(windows);
  }
  /// Continues the search in the current version of the world. Restarts it if a change concerns it, or if
  /// World::shrink_to_fit() has freed the mesh in which it runs.
  void adapt_to_changes() {
    const bool has_lost_mesh = is_for_disc() && walls != world->ground().walls;
    if (version == touch_log->version() && !has_lost_mesh) return;
    const bool must_begin_again = finder.must_begin_again([&] { return touch_log->has_touched(looked_at, version); });
    version = touch_log->version();
    if (!must_begin_again) return;
    ++restarts;
    begin();
  }
  /// The guard of one step. When the step ends, stops the search if it is done. The constructor sets `is_done` to true.
  /// So if memory runs out during the step, the search stops, too.
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

  std::shared_ptr<TouchLog> touch_log;  ///< null unless a search is running
  const World::Impl* world = nullptr;   ///< stays at this address until `touch_log` says that the world is gone
  std::uint64_t version = 0;            ///< of the world when the search last saw it
  const constraint::ConstrainedTriangulation* walls = nullptr;  ///< the mesh in which a search for a disc runs
  PathQuery query;
  path::FitFinder fits;
  path::Finder finder{fits};
  path::LookedAt looked_at;
  Path path;
  bool wants_windows = false;
  bool records_windows = false;  ///< `wants_windows` at the start of the search
  std::vector<SearchWindow> windows;
  std::size_t restarts = 0;
  bool is_done = false;
};

PathSearch::PathSearch() : impl_(std::make_unique<Impl>()) {}
PathSearch::~PathSearch() = default;
PathSearch::PathSearch(PathSearch&&) noexcept = default;
PathSearch& PathSearch::operator=(PathSearch&&) noexcept = default;

Result<void> PathSearch::begin(const World& world, const PathQuery& query) {
  WAYWRIGHT_ASSERT(!world.impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  cancel();
  if (auto error = find_query_error(world.domain(), world.impl_->layers.kept(), query)) return *std::move(error);
  impl_->query = query;
  impl_->records_windows = impl_->wants_windows;
  impl_->restarts = 0;
  impl_->world = &*world.impl_;
  impl_->begin();
  impl_->start(*world.impl_);
  return {};
}

// If memory runs out during a step, Impl::Step cancels the search.
Result<bool> PathSearch::step(std::size_t expansions) {
  const base::FloatEnvironment environment;
  if (!is_running()) return true;
  if (impl_->touch_log->version() == TouchLog::kWorldGone) {
    cancel();
    return Error{ErrorCode::world_gone, "the world has gone since the search began", {}, 0};
  }
  WAYWRIGHT_ASSERT(!impl_->world->attempt, kInAttempt);
  const Impl::Step step(*impl_);
  impl_->adapt_to_changes();
  impl_->is_done = impl_->finder.step(expansions, impl_->path);
  return impl_->is_done;
}

const Path& PathSearch::path() const { return impl_->path; }

std::size_t PathSearch::restarts() const { return impl_->restarts; }

void PathSearch::record_windows(bool wanted) { impl_->wants_windows = wanted; }

std::span<const SearchWindow> PathSearch::windows() const { return impl_->windows; }

void PathSearch::cancel() { impl_->stop(); }

bool PathSearch::is_running() const { return impl_->touch_log != nullptr; }

}  // namespace waywright

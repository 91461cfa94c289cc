#pragma once

#include <cstddef>
#include <vector>

#include "waywright/path.hpp"

#include "path/disc_finder.hpp"
#include "path/fit_finder.hpp"
#include "path/ground.hpp"
#include "path/point_finder.hpp"

namespace waywright::path {

/// Answers path queries for agents of any radius, in one call or in slices. Use one object for many queries, because it
/// keeps its memory.
class Finder {
 public:
  /// `fits` must exist as long as this object.
  explicit Finder(FitFinder& fits) : disc_(fits) {}

  /// Starts a search. Requires: the query has no error; the ground does not change until the search is done or
  /// cancelled. PointFinder::begin() says what `looked_at` is for; the search for a disc ignores it.
  void begin(const Ground& ground, const PathQuery& query, Path& path, LookedAt* looked_at = nullptr) {
    is_for_disc_ = query.agent.radius > 0.0;
    if (is_for_disc_) {
      disc_.begin(ground, query, path);
    } else {
      point_.begin(ground, query, path, looked_at);
    }
  }
  /// See PointFinder::record_windows(). The search for a disc has no windows.
  void record_windows(std::vector<SearchWindow>& windows) {
    if (!is_for_disc_) point_.record_windows(windows);
  }
  /// Continues the search until it has made `expansions` further expansions, or a few more. Returns whether the search
  /// is done. `path` is then the best path so far.
  bool step(std::size_t expansions, Path& path) {
    return is_for_disc_ ? disc_.step(expansions, path) : point_.step(expansions, path);
  }
  /// Call it before step() if the world has changed since the last step. Returns whether the search must begin again.
  /// `has_touched()` says whether a change has touched a face at which the search has looked. The search for a disc
  /// does not record what it has looked at, so every change concerns it.
  template <class HasTouched>
  [[nodiscard]] bool must_begin_again(HasTouched&& has_touched) {
    if (is_for_disc_) return true;
    point_.grow_to_mesh();
    return has_touched() || point_.has_covered_end();
  }

  /// Finds the shortest path to each goal. Requires: the query has no error.
  void find_all(const Ground& ground, const ManyGoalsQuery& query, std::vector<Path>& paths) {
    if (query.agent.radius > 0.0) {
      disc_.find_all(ground, query, paths);
    } else {
      point_.find_all(ground, query, paths);
    }
  }

 private:
  bool is_for_disc_ = false;
  PointFinder point_;
  DiscFinder disc_;
};

}  // namespace waywright::path

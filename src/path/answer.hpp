#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

#include "waywright/path.hpp"

namespace waywright::path {

/// The number of expansions of a search without a limit.
inline constexpr std::size_t kToTheEnd = std::numeric_limits<std::size_t>::max();

/// Returns a + b, or the largest number if the sum is larger.
[[nodiscard]] constexpr std::size_t saturating_add(std::size_t a, std::size_t b) {
  return b > kToTheEnd - a ? kToTheEnd : a + b;
}

/// The clock of a search, and its budget.
class SearchClock {
 public:
  /// Starts the clock if the query wants the time, or limits it.
  void begin(const PathQuery& query) {
    budget_ = query.budget;
    wants_time_ = query.wants_time;
    if (wants_time_ || has_time_limit()) begun_ = Clock::now();
  }
  /// Returns whether the search has found a path, and its budget is used up.
  [[nodiscard]] bool is_over(const Path& path) const {
    return path.status == PathStatus::found && (path.expansions >= budget_.expansions || is_time_over());
  }
  /// Returns the number of expansions at which the search looks at its budget again: after `slice` expansions, or
  /// sooner.
  [[nodiscard]] std::size_t next_look(const Path& path, std::size_t slice) const {
    const std::size_t look = saturating_add(path.expansions, slice);
    return path.status == PathStatus::found ? std::min(look, budget_.expansions) : look;
  }
  /// Writes the time since begin(), if the query wants it.
  void write_time(Path& path) const {
    if (wants_time_) path.time = Clock::now() - begun_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool has_time_limit() const { return budget_.time != std::chrono::nanoseconds::max(); }
  [[nodiscard]] bool is_time_over() const { return has_time_limit() && Clock::now() - begun_ >= budget_.time; }

  PathBudget budget_;
  bool wants_time_ = false;
  Clock::time_point begun_;
};

/// Makes `path` the answer of a search that has not found anything yet. Keeps the memory of its lists.
inline void reset(Path& path) {
  path.status = PathStatus::no_path;
  path.length = 0.0;
  path.lower_bound = 0.0;
  path.agent = {};
  path.points.clear();
  path.pieces.clear();
  path.channel.clear();
  path.expansions = 0;
  path.time = {};
  path.moved_start.reset();
  path.moved_goal.reset();
  path.blockers.clear();
  path.widest.reset();
  path.ends.reset();
}

}  // namespace waywright::path

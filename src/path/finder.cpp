#include "path/finder.hpp"

#include <algorithm>

namespace waywright::path {

namespace {

/// Triangles between two looks at the clock.
constexpr std::size_t kSlice = 256;

std::size_t add_or_stay_largest(std::size_t a, std::size_t b) {
  return b > std::numeric_limits<std::size_t>::max() - a ? std::numeric_limits<std::size_t>::max() : a + b;
}

}  // namespace

void Finder::begin(const Triangulation& triangulation, const Abstraction* abstraction, const PathQuery& query,
                   Path& path) {
  query_ = query;
  if (query.wants_time || has_time_limit()) start_time_ = Clock::now();
  path.status = PathStatus::no_path;
  path.length = 0.0;
  path.lower_bound = 0.0;
  path.points.clear();
  path.channel.clear();
  path.expansions = 0;
  path.time = {};
  const std::optional<PathStatus> known = ends_.find(triangulation, abstraction, query.start, query.goal);
  is_done_ = known.has_value();
  is_searched_ = !is_done_;
  if (is_done_) {
    path.status = *known;
    if (path.status == PathStatus::found) write_straight_path(path);
    finish(path);
    return;
  }
  if (query.algorithm == PathAlgorithm::ta) {
    ta_.begin(triangulation, ends_);
  } else if (query.algorithm == PathAlgorithm::tra) {
    tra_.begin(triangulation, *abstraction, ends_);
  } else {
    optimal_.begin(triangulation, ends_, query.wants_channel);
  }
}

bool Finder::step(std::size_t expansions, Path& path) {
  const std::size_t limit = add_or_stay_largest(path.expansions, expansions);
  while (!is_done_ && path.expansions < limit) {
    is_done_ = search(limit, path);
    if (is_done_) finish(path);
  }
  return is_done_;
}

bool Finder::search(std::size_t limit, Path& path) {
  if (query_.algorithm == PathAlgorithm::optimal) return optimal_.step(limit, path);
  if (query_.algorithm == PathAlgorithm::tra) {
    tra_.find(path);
    return true;
  }
  return is_over_budget(path) || ta_.step(std::min(limit, add_or_stay_largest(path.expansions, kSlice)), path);
}

bool Finder::is_over_budget(const Path& path) const {
  if (path.status != PathStatus::found) return false;
  return path.expansions >= query_.budget.expansions ||
         (has_time_limit() && Clock::now() - start_time_ >= query_.budget.time);
}

bool Finder::has_time_limit() const { return query_.budget.time != std::chrono::nanoseconds::max(); }

void Finder::write_straight_path(Path& path) const {
  path.length = distance(query_.start, query_.goal);
  path.lower_bound = path.length;
  path.points = {query_.start, query_.goal};
}

void Finder::finish(Path& path) const {
  if (query_.wants_channel && is_searched_ && path.status == PathStatus::found) {
    if (query_.algorithm == PathAlgorithm::ta) {
      ta_.write_channel(path);
    } else if (query_.algorithm == PathAlgorithm::tra) {
      tra_.write_channel(path);
    } else {
      optimal_.write_channel(path);
    }
  }
  if (query_.wants_time) path.time = Clock::now() - start_time_;
}

}  // namespace waywright::path

#pragma once

#include <chrono>
#include <cstddef>

#include "waywright/path.hpp"

#include "path/ends.hpp"
#include "path/optimal.hpp"
#include "path/ta_star.hpp"
#include "path/tra_star.hpp"

namespace waywright::path {

/// Carries out path queries, in one go or in slices. An object to keep for its memory.
class Finder {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Starts a search. Requires: both ends lie in the domain, the algorithm is a supported one, `tra` only with an
  /// abstraction; the triangulation stays as it is until the search is done or given up.
  void begin(const Triangulation& triangulation, const Abstraction* abstraction, const PathQuery& query, Path& path);
  /// Searches on, by at most `expansions` triangles or a few more. Returns whether the search is done. `path` is the
  /// best so far.
  bool step(std::size_t expansions, Path& path);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool is_over_budget(const Path& path) const;
  [[nodiscard]] bool has_time_limit() const;
  void write_straight_path(Path& path) const;
  [[nodiscard]] bool search(std::size_t limit, Path& path);
  void finish(Path& path) const;

  PathQuery query_;
  bool is_done_ = true;
  bool is_searched_ = false;  ///< whether there was anything to search
  Clock::time_point start_time_;
  Ends ends_;
  TaStar ta_;
  Optimal optimal_;
  TraStar tra_;
};

}  // namespace waywright::path

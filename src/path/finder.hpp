#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

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
  /// abstraction; both stay as they are until the search is done or given up. If `looked_at` is not null, the search
  /// notes there at which faces it looks. Then the mesh may change as long as none of these is touched: by a face that
  /// is made, rebuilt or freed and has a corner in common with it, or by another place in the abstraction.
  void begin(const Triangulation& triangulation, const nav::Abstraction* abstraction, const PathQuery& query,
             Path& path, LookedAt* looked_at = nullptr);
  /// Searches on, by at most `expansions` triangles or a few more. Returns whether the search is done. `path` is the
  /// best so far.
  bool step(std::size_t expansions, Path& path);

  /// To be called before step() if the mesh has changed since the last step: makes room for what it has got.
  void cover_mesh();
  /// Whether an end of a search that is not done has come to lie in a polygon.
  [[nodiscard]] bool has_covered_end() { return !is_done_ && ends_.are_covered(); }

  /// Finds the shortest path to each goal. Requires: all points lie in the domain.
  void find_all(const Triangulation& triangulation, const nav::Abstraction* abstraction, const ManyGoalsQuery& query,
                std::vector<Path>& paths);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool search(std::size_t limit, Path& path);
  [[nodiscard]] bool search_ta(std::size_t limit, Path& path);
  [[nodiscard]] bool search_optimal(std::size_t limit, Path& path);
  void settle(bool wants_points, std::size_t& expansions, std::vector<Path>& paths);
  void begin_optimal(double known_length);
  void look_at_ends();
  void write_straight(bool wants_channel, Path& path) const;
  [[nodiscard]] bool is_over_budget(const Path& path) const;
  [[nodiscard]] bool has_time_limit() const;
  void finish(Path& path) const;

  const Triangulation* triangulation_ = nullptr;
  const nav::Abstraction* abstraction_ = nullptr;  ///< or null
  LookedAt* looked_at_ = nullptr;                  ///< or null
  PathQuery query_;
  bool is_done_ = true;
  bool is_searched_ = false;  ///< whether there was anything to search
  bool is_proving_ = false;   ///< whether `ta` has no more channels of its own, and `optimal` searches on
  double ta_bound_ = 0.0;     ///< what `ta` has proven
  Clock::time_point start_time_;
  Ends ends_;
  TaStar ta_;
  TraStar tra_;
  Optimal optimal_;
  std::vector<std::size_t> searched_;  ///< of many goals, those that are not settled yet
};

}  // namespace waywright::path

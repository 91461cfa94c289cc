#pragma once

#include <cstddef>
#include <vector>

#include "waywright/path.hpp"

#include "path/answer.hpp"
#include "path/ground.hpp"
#include "path/optimal.hpp"
#include "path/point_ends.hpp"
#include "path/ta_star.hpp"
#include "path/tra_star.hpp"

namespace waywright::path {

/// Finds the paths of point agents. Use one object for many queries, because it keeps its memory.
class PointFinder {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Starts a search. Requires: both ends lie in the domain; for `tra`, there is an abstraction; the ground does not
  /// change until the search is done or cancelled.
  ///
  /// If `looked_at` is not null, the search records in it the faces at which it looks. Then the mesh may change during
  /// the search, as long as no change touches one of these faces. A change touches a face f if it makes, rebuilds or
  /// frees a face that shares a vertex with f, or if it changes the entry of f in the abstraction.
  void begin(const Ground& ground, const PathQuery& query, Path& path, LookedAt* looked_at = nullptr);
  /// Call this after begin(): if the algorithm is `optimal`, the search appends each window that it follows to
  /// `windows`.
  /// Requires: the search records the faces at which it looks.
  void record_windows(std::vector<SearchWindow>& windows) {
    if (!is_done_ && query_.algorithm == PathAlgorithm::optimal) optimal_.record_windows(windows);
  }
  /// Continues the search until it has entered `expansions` further triangles, or a few more. Returns whether the
  /// search is done. `path` is then the best path so far.
  bool step(std::size_t expansions, Path& path);

  /// Makes room for faces and vertices that were added to the mesh. Call it before step() if the mesh has changed since
  /// the last step.
  void grow_to_mesh();
  /// Returns whether the search is not done and a polygon now covers one of its ends.
  [[nodiscard]] bool has_covered_end() { return !is_done_ && ends_.are_covered(); }

  /// Finds the shortest path to each goal. Requires: all points lie in the domain.
  void find_all(const Ground& ground, const ManyGoalsQuery& query, std::vector<Path>& paths);

 private:
  [[nodiscard]] bool search(std::size_t limit, Path& path);
  [[nodiscard]] bool search_ta(std::size_t limit, Path& path);
  [[nodiscard]] bool search_optimal(std::size_t limit, Path& path);
  void find_pending_paths(bool wants_points, std::size_t& expansions, std::vector<Path>& paths);
  void begin_optimal(double known_length);
  [[nodiscard]] Optimal::Start search_start() const {
    return {ends_.start(), ends_.start_location().kind, ends_.start_faces()};
  }
  void look_at_ends();
  void write_straight(bool wants_channel, Path& path) const;
  void finish(Path& path) const;

  const Triangulation* triangulation_ = nullptr;
  const nav::Abstraction* abstraction_ = nullptr;  ///< or null
  LookedAt* looked_at_ = nullptr;                  ///< or null
  PathQuery query_;
  bool is_done_ = true;
  bool is_searched_ = false;  ///< whether a search was necessary
  bool is_proving_ = false;   ///< whether `ta` has followed all channels, and `optimal` continues the search
  double ta_bound_ = 0.0;     ///< the lower bound that `ta` has proven
  SearchClock clock_;
  PointEnds ends_;
  TaStar ta_;
  TraStar tra_;
  Optimal optimal_;
  std::vector<std::size_t>
      pending_goals_;  ///< in a query of many goals: the goals for which find_pending_paths() will search
};

}  // namespace waywright::path

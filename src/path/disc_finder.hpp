#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/path.hpp"

#include "clearance/disc_passage.hpp"
#include "path/answer.hpp"
#include "path/disc_channel.hpp"
#include "path/disc_ends.hpp"
#include "path/disc_guide.hpp"
#include "path/disc_line.hpp"
#include "path/disc_map.hpp"
#include "path/disc_optimal.hpp"
#include "path/disc_string.hpp"
#include "path/fit_finder.hpp"
#include "path/ground.hpp"

namespace waywright::path {

/// Finds the paths of discs. Use one object for many queries, because it keeps its memory.
///
/// If the disc can move straight from the start to the goal, no stage runs. The stages of `optimal`:
/// - `guide`: the guide searches for a path of a point agent. If there is none, the disc has no path either. If there
///   is a string through its channel, the stage `channel` does not run.
/// - `channel`: searches for a channel of the disc, and for a string through it. If there is no channel, there is no
///   path.
/// - `distances`: the guide continues, and finds all distances that the search for the shortest path needs. Without a
///   string, this stage does not run.
/// - `shortest`: searches for the shortest path. It leaves out everything that is longer than the string.
///
/// `ta` and `tra` start with the stage `channel`. `tra` needs the stages after it only if it finds no string through
/// its channel. `ta` also needs them if its budget is not used up.
class DiscFinder {
 public:
  /// `fits` must exist as long as this object.
  explicit DiscFinder(FitFinder& fits) : fits_(fits) {}

  /// Starts a search. Requires: both ends lie in the domain; the radius is above 0; the ground has bridges, and does
  /// not change until the search is done or cancelled.
  void begin(const Ground& ground, const PathQuery& query, Path& path);
  /// Continues the search until it has made `expansions` further expansions, or a few more. Returns whether the search
  /// is done. `path` is then the best path so far.
  bool step(std::size_t expansions, Path& path);
  /// Finds the shortest path to each goal. Requires: as begin(), for each goal.
  void find_all(const Ground& ground, const ManyGoalsQuery& query, std::vector<Path>& paths);

 private:
  enum class Stage : std::uint8_t { guide, channel, distances, shortest };
  enum class Outcome : std::uint8_t { running, found, none };

  void begin_search(const Ground& ground, const PathQuery& query);
  [[nodiscard]] bool find_straight();
  void begin_guide() { guide_.begin(*map_, ends_, start_, goal_); }
  void begin_distances();
  void begin_shortest(const GuideDistances* distances);
  void step_guide(std::size_t limit, Path& path);
  void step_channel(std::size_t limit, Path& path);
  void step_distances(std::size_t limit, Path& path);
  void step_shortest(std::size_t limit, Path& path);
  [[nodiscard]] bool find_string(std::span<const mesh::HalfEdge> exits, mesh::HalfEdge goal_face);
  [[nodiscard]] bool is_over_budget(const Path& path) const {
    return algorithm_ == PathAlgorithm::ta && clock_.is_over(path);
  }
  [[nodiscard]] bool ends_by_budget(std::size_t& limit, const Path& path);
  void look_at_passage(const Path& path);
  [[nodiscard]] bool search(std::size_t limit, Path& path);
  void write_path(double lower_bound, Path& path) const;

  FitFinder& fits_;
  SearchClock clock_;
  PathAlgorithm algorithm_ = PathAlgorithm::optimal;
  Point start_;
  Point goal_;
  Outcome outcome_ = Outcome::none;
  std::optional<DiscMap> map_;  ///< the stages refer to it and to `ends_`
  DiscEnds ends_;
  Stage stage_ = Stage::channel;
  double length_ = 0.0;             ///< the length of `pieces_`; infinity as long as the search has found no path
  clearance::DiscPassage passage_;  ///< decides whether there is a path, while the stages search for it
  std::size_t next_look_ = 0;       ///< the search looks at `passage_` when Path::expansions has reached this number
  DiscLine line_;
  bool has_guide_ = false;  ///< false if the two ends lie in one face: then the stages of the guide do not run
  DiscGuide guide_;
  DiscChannel channel_;
  DiscString string_;
  DiscOptimal shortest_;
  std::vector<DiscPiece> pieces_;
  WidestPath widest_;
};

}  // namespace waywright::path

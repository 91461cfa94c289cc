#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "waywright/clearance.hpp"
#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "random.hpp"

namespace waywright::bench {

/// Which units ask for a path in a tick, and how.
enum class CrowdMode : std::uint8_t {
  tra,          ///< all, one after the other, with PathAlgorithm::tra
  two_threads,  ///< all, with PathAlgorithm::tra and World::find_paths on two threads
  affected,     ///< with PathAlgorithm::tra, those whose path an operation affects, and those without a path
  optimal,      ///< all, one after the other, with PathAlgorithm::optimal
};

/// Returns the mode with this name: `tra`, `two_threads`, `affected`, `optimal`.
[[nodiscard]] std::optional<CrowdMode> crowd_mode(std::string_view name);

/// The times and results of one tick of a game. The times are wall-clock times in seconds.
struct Tick {
  double update_seconds = 0.0;        ///< of the operation that changes the buildings
  std::vector<double> path_seconds;   ///< of the searches, for each radius; in `two_threads` one entry for all units
  std::vector<std::size_t> searches;  ///< the number of searches, in entries as in `path_seconds`
  std::array<std::size_t, 4> statuses{};  ///< the number of units with each PathStatus, after the searches
};

/// A game on a map. Units of several radii stand at random positions where they fit. Each has a random goal where it
/// fits. A tick removes the 10 oldest of 100 buildings and inserts 10 others of 4 to 8 corners, in one operation. Then
/// units ask for paths from where they stand. The buildings, the units and their goals are the same in each mode.
class Game {
 public:
  /// Inserts the scene and 100 buildings, chooses 1,000 units, and lets each of them ask once.
  /// Requires: a scene that a world accepts, with free ground for a disc of each radius.
  Game(const Scene& scene, std::span<const double> radii, CrowdMode mode);

  /// Plays one tick.
  [[nodiscard]] Tick play();

  /// Tests the answers of 25 units, also the paths that they have kept since an earlier tick. Returns the number of
  /// wrong answers. An answer is wrong if the disc does not fit at one of 65 positions on its path, if the path does
  /// not connect start and goal, if an end counts as blocked where the disc fits, or if there is no path where
  /// World::widest_path says that the disc gets through.
  [[nodiscard]] std::size_t count_wrong_answers();

  [[nodiscard]] const World& world() const { return world_; }

 private:
  /// Adds the insertion of a building at a random position where the circle around it fits in the world and meets no
  /// unit.
  void add_building(std::vector<Change>& changes);
  /// Lets the units ask one after the other, and measures the units of each radius.
  void ask_in_turn(std::uint64_t since, Tick& tick);
  [[nodiscard]] bool must_ask(const Path& path, std::uint64_t since) const;
  /// Returns whether a circle overlaps a unit.
  [[nodiscard]] bool meets_unit(const Point& centre, double radius) const;
  /// Returns a random position where a disc fits.
  [[nodiscard]] Point fitting_position(double radius);
  [[nodiscard]] bool is_right(std::size_t unit);
  [[nodiscard]] bool fits(const Point& centre, double radius);

  World world_;
  std::vector<double> radii_;
  CrowdMode mode_;
  Random random_{17};
  std::deque<ItemId> buildings_;  // oldest first
  std::uint64_t next_building_ = 0;
  std::vector<PathQuery> queries_;  // one for each unit; units of equal radii follow each other
  std::vector<Path> paths_;
  std::vector<QueryContext> contexts_;
  DiscFit fit_;
  WidestPath widest_;
  std::size_t ticks_ = 0;
};

}  // namespace waywright::bench

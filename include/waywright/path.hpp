#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "waywright/export.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// How a path is searched for.
enum class PathAlgorithm : std::uint8_t {
  ta,   ///< triangulation A* (Demyen and Buro 2006): A* over triangles, then the funnel; betters its path on request
  tra,  ///< triangulation reduction A* (Demyen and Buro 2006): a good path for very little; for crowds
  optimal,  ///< the shortest path there is (after Polyanya: Cui, Harabor and Grastien 2017)
};

/// The algorithm as the world script names it: `ta`, `tra`, `optimal`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(PathAlgorithm algorithm);
/// The algorithm of that name; nothing where none has it.
[[nodiscard]] WAYWRIGHT_API std::optional<PathAlgorithm> path_algorithm(std::string_view name);

/// How far `ta` goes on after its first path: until no path can be shorter or the first of these is spent. The other
/// algorithms do not ask.
struct PathBudget {
  /// Triangles entered in all. With 0 the first path is the answer.
  std::size_t expansions = 0;
  /// Since the search began. An answer that this cut short depends on the clock, others never do.
  std::chrono::nanoseconds time = std::chrono::nanoseconds::max();

  /// Until no path can be shorter.
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
};

/// Asks for a path of a disc from start to goal.
struct PathQuery {
  Point start;
  Point goal;
  double radius = 0.0;  ///< of the agent, >= 0; only 0 is supported yet
  PathAlgorithm algorithm = PathAlgorithm::optimal;
  PathBudget budget{};
  bool wants_channel = false;  ///< whether the answer names the edges that the path crosses
  bool wants_time = false;     ///< whether the answer says how long the search took
};

/// How a search ended. No path is an answer, not an error.
enum class PathStatus : std::uint8_t {
  found,
  start_blocked,  ///< the start lies strictly inside a polygon
  goal_blocked,   ///< the goal lies strictly inside a polygon
  no_path,        ///< both ends are free, and walls part them
};

/// The status as the world script prints it: `found`, `start-blocked`, `goal-blocked`, `no-path`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(PathStatus status);

/// An edge of the mesh that a path crosses, as seen on the way; nearest doubles.
struct Portal {
  Point left;
  Point right;

  friend bool operator==(const Portal&, const Portal&) = default;
};

/// A path and what finding it took. Reuse one object for many queries: its memory is kept.
struct Path {
  PathStatus status = PathStatus::no_path;
  double length = 0.0;               ///< Euclidean; 0 unless found
  double lower_bound = 0.0;          ///< no path is shorter: the length itself where it is proven; 0 unless found
  std::vector<Point> points;         ///< from start to goal, the corners between them; empty unless found
  std::vector<Portal> channel;       ///< the edges crossed, from start to goal; empty unless found and asked for
  std::size_t expansions = 0;        ///< triangles entered by the search
  std::chrono::nanoseconds time{0};  ///< that the search took; 0 unless asked for
};

/// Asks for the shortest paths from one start to many goals.
struct ManyGoalsQuery {
  Point start;
  std::span<const Point> goals;
  double radius = 0.0;        ///< of the agent, >= 0; only 0 is supported yet
  bool wants_points = false;  ///< whether the answers have points, or only status and length
};

}  // namespace waywright

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
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// How a path is searched for.
enum class PathAlgorithm : std::uint8_t {
  ta,       ///< a quick first path that can be bettered (PathBudget): triangulation A* (Demyen and Buro 2006)
  tra,      ///< a good path for very little time, for crowds: triangulation reduction A* (Demyen and Buro 2006)
  optimal,  ///< the shortest path there is: after Polyanya (Cui, Harabor and Grastien 2017)
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
  /// How far the search may move a blocked start or goal: it takes the nearest free place instead, if that is no
  /// farther. A place that a program computes on a path can lie inside a polygon by a rounding error; the default
  /// allows for that, also for places kept as `float`. It is World::default_end_tolerance(). With 0 a blocked end stays
  /// blocked. At least 0, infinity included.
  std::optional<double> end_tolerance{};
};

/// How a search ended. No path is an answer, not an error.
enum class PathStatus : std::uint8_t {
  found,
  start_blocked,  ///< the start lies strictly inside a polygon, and no free place is near enough to take instead
  goal_blocked,   ///< the same of the goal
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

/// A start or goal that was blocked, and the free place that the search took instead.
struct MovedEnd {
  Point from;
  Point to;

  friend bool operator==(const MovedEnd&, const MovedEnd&) = default;
};

/// A position on a path.
struct PathPosition {
  Point at;                 ///< the place
  Point heading;            ///< the direction of the path there, of length 1; (0, 0) on a path of one point
  std::size_t segment = 0;  ///< the place lies between points[segment] and points[segment + 1]
  double before = 0.0;      ///< the length of the path up to points[segment]
  double distance = 0.0;    ///< the length of the path up to the place
};

/// How a program keeps the coordinates of its units.
enum class Precision : std::uint8_t {
  float64,  ///< as `double`
  float32,  ///< as `float`
};

/// A path and what finding it took. Reuse one object for many queries: its memory is kept.
struct WAYWRIGHT_API Path {
  PathStatus status = PathStatus::no_path;
  double length = 0.0;                  ///< Euclidean; 0 unless found
  double lower_bound = 0.0;             ///< no path is shorter: the length itself where it is proven; 0 unless found
  std::vector<Point> points;            ///< from start to goal, the corners between them; empty unless found
  std::vector<Portal> channel;          ///< the edges crossed, from start to goal; empty unless found and asked for
  std::size_t expansions = 0;           ///< triangles entered by the search
  std::chrono::nanoseconds time{0};     ///< that the search took; 0 unless asked for
  std::optional<MovedEnd> moved_start;  ///< set if the search moved the start: `points` begin at its `to`
  std::optional<MovedEnd> moved_goal;   ///< set if the search moved the goal: `points` end at its `to`
  /// The polygons that have the blocked end strictly inside, ascending. Empty unless the status is start_blocked or
  /// goal_blocked.
  std::vector<ItemId> blockers;

  /// The position at `distance` from the start, along the path. A smaller distance than 0 gives the start, a larger one
  /// than the length gives the goal. A query may start there: the place lies on the path or, where it must be rounded,
  /// next to it on the side that the nearer turn of the path keeps free of walls. (Only if walls without thickness lie
  /// along one straight piece on both of its sides can the place fall on the far side of one of them.) The coordinates
  /// fit into the precision without further rounding; so, if a side of the domain is no float, a place on it can come
  /// to lie beyond it with Precision::float32. NaN counts as 0. Requires: `points` is not empty. Cost: linear in the
  /// corners before the position.
  [[nodiscard]] PathPosition at(double distance, Precision precision = Precision::float64) const;
  /// The position `step` farther on than `from`, which this path gave. What moves a unit each tick. Requires: `points`
  /// is not empty, and has not changed since. Cost: linear in the corners that the step passes; of a negative step,
  /// linear in the corners before the position.
  [[nodiscard]] PathPosition advance(const PathPosition& from, double step,
                                     Precision precision = Precision::float64) const;
  /// The position on the path that is nearest to `place`; of several, the first. For a unit that was pushed off its
  /// path, which should lie in the domain. Requires: `points` is not empty. Cost: linear in the corners.
  [[nodiscard]] PathPosition nearest(const Point& place, Precision precision = Precision::float64) const;
};

/// Asks for the shortest paths from one start to many goals.
struct ManyGoalsQuery {
  Point start;
  std::span<const Point> goals;
  double radius = 0.0;                    ///< of the agent, >= 0; only 0 is supported yet
  bool wants_points = false;              ///< whether the answers have points, or only status and length
  std::optional<double> end_tolerance{};  ///< as PathQuery::end_tolerance, for the start and for each goal
};

}  // namespace waywright

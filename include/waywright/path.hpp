#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "waywright/agent.hpp"
#include "waywright/clearance.hpp"
#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup paths
/// @{

/// A search algorithm for paths. docs/paths.md says when to choose which algorithm.
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (`optimal`);
/// Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (`ta` and `tra`).
enum class PathAlgorithm : std::uint8_t {
  ta,       ///< a first path, and a better one with a PathBudget: triangulation A* (Demyen and Buro 2006)
  tra,      ///< a good path in very little time, useful for crowds: triangulation reduction A* (Demyen and Buro 2006)
  optimal,  ///< the shortest path: a variant of the algorithm Polyanya (Cui, Harabor and Grastien 2017)
};

/// Returns the name of an algorithm in world scripts: `ta`, `tra`, `optimal`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(PathAlgorithm algorithm);
/// Returns the algorithm with this name, or nothing if there is none.
[[nodiscard]] WAYWRIGHT_API std::optional<PathAlgorithm> path_algorithm(std::string_view name);

/// The limits of a search by PathAlgorithm::ta. The search always finds a first path, if there is one. It then
/// continues until it has proven that no path is shorter, or until it reaches one of the two limits. The other
/// algorithms ignore the budget.
///
/// @code{.cpp}
/// const PathBudget budget{.expansions = PathBudget::kNoLimit, .time = std::chrono::milliseconds(2)};
/// const Path best =
///     world.find_path({.start = start, .goal = goal, .algorithm = PathAlgorithm::ta, .budget = budget}).value();
/// std::printf("%g, and no path is shorter than %g\n", best.length, best.lower_bound);
/// @endcode
struct PathBudget {
  /// The number of triangles that the whole search may enter, including the search for the first path. For a query with
  /// a radius above 0, the member limits Path::expansions. If the number is 0, the first path is the answer.
  std::size_t expansions = 0;
  /// The largest time since the start of the search. The time between the slices of a PathSearch counts, too. If this
  /// limit ends the search, the answer depends on the clock. In all other cases the answer does not depend on the
  /// clock.
  std::chrono::nanoseconds time = std::chrono::nanoseconds::max();

  /// The value of `expansions` for a search without a limit on triangles.
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
};

/// A query for a path from start to goal, for World::find_path and PathSearch.
///
/// @code{.cpp}
/// const PathQuery query{.start = start, .goal = goal, .algorithm = PathAlgorithm::tra, .end_tolerance = 5.0};
/// const Path answer = world.find_path(query).value();
/// @endcode
struct PathQuery {
  Point start;
  Point goal;
  /// The agent that moves: a point, or a disc with a radius. For a disc, the world must keep its bridges
  /// (WorldOptions::keep_bridges), and the path is in Path::pieces. The first path of PathAlgorithm::ta is then the
  /// path of PathAlgorithm::tra.
  ///
  /// The library decides exactly whether the disc fits at an end, and whether it passes a gap. It computes everything
  /// else in doubles. Let m be the largest magnitude of a coordinate of the domain, and r the radius. Then a path may
  /// come nearer to a wall than r, but at most by the larger of m / 2^50 and r / 2^34. If r is below m / 2^48, the
  /// search may find no path although there is one. So choose a domain that is not much larger than the area of the
  /// items.
  Agent agent{};
  PathAlgorithm algorithm = PathAlgorithm::optimal;
  PathBudget budget{};
  bool wants_channel = false;  ///< whether the answer contains Path::channel
  bool wants_time = false;     ///< whether the answer contains Path::time
  /// The largest distance by which the search may move the start or the goal; two reasons to do so follow below. If a
  /// program computes a position on a path, a rounding error can put this position inside a polygon. The default,
  /// World::default_end_tolerance(), allows for these errors, also if the program keeps coordinates as `float`. If the
  /// value is 0, the search moves no end. The value must be 0 or more; infinity is allowed. If the domain is much
  /// larger than the area that the items fill, the default is too large for the items: then set the tolerance.
  ///
  /// If the search has moved an end, it sets Path::moved_start or Path::moved_goal. There are two reasons to move an
  /// end:
  /// - Polygons cover all triangles around the end, so no path can start or end there. The search then takes the
  ///   nearest free position within the tolerance. If the world keeps its abstraction, the search prefers free
  ///   positions that are connected with the other end.
  /// - Walls separate start and goal, but the start or the goal lies so near to a wall that a rounding error may have
  ///   put it beyond the wall: its distance from the wall is at most World::default_end_tolerance() and at most the
  ///   tolerance. The search then moves this end across the wall, if this connects start and goal. This requires a
  ///   world that keeps its abstraction.
  ///
  /// If the radius is above 0 and the disc does not fit at an end, the search takes the position that
  /// World::nearest_fit() finds within the tolerance. It prefers positions from which the disc can move to the other
  /// end. The second of the two reasons does not apply to discs.
  std::optional<double> end_tolerance{};
};

/// The outcome of a search. "No path" is an answer, not an error.
enum class PathStatus : std::uint8_t {
  found,  ///< there is a path
  /// The start lies strictly inside a polygon, or a wall is nearer to the start than the radius. The search found no
  /// position within the tolerance to which it could move the start.
  start_blocked,
  goal_blocked,  ///< the goal lies strictly inside a polygon or too near to a wall, as for `start_blocked`
  no_path,       ///< no path connects the start and the goal, and the status is none of those above
};

/// Returns the name of a status in the output of world scripts: `found`, `start-blocked`, `goal-blocked`, `no-path`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(PathStatus status);

/// An edge of the mesh that a path crosses: an element of Path::channel. Seen from an agent on the path, `left` is the
/// left end of the edge and `right` is its right end. Each coordinate is rounded to the nearest double.
///
/// @code{.cpp}
/// path = world.find_path({.start = start, .goal = goal, .wants_channel = true}).value();
/// for (const Portal& portal : path.channel) draw_line(portal.left, portal.right);
/// @endcode
struct Portal {
  Point left;
  Point right;

  friend bool operator==(const Portal&, const Portal&) = default;
};

/// A piece of the path of a disc's centre: an element of Path::pieces.
///
/// @code{.cpp}
/// World yard = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
/// yard.insert_segment({50, 0}, {50, 60}, 1).value();
/// const Path around = yard.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
/// const bool turns = around.pieces[1].kind == PathPiece::Kind::arc;  // == true
/// const Point centre = around.pieces[1].centre;                      // == Point{50, 60}
/// @endcode
struct PathPiece {
  /// The kind of a piece.
  enum class Kind : std::uint8_t { line, arc };

  Kind kind = Kind::line;
  Point from;           ///< where the piece starts
  Point to;             ///< where it ends: the next piece starts there
  Point centre;         ///< of an arc: the centre of its circle, a corner of an item or of the domain
  double radius = 0.0;  ///< of an arc: the radius of the agent
  /// Of an arc: the direction from the centre to `from`, in radians from the direction of x, counter-clockwise, from
  /// -pi to pi.
  double start_angle = 0.0;
  /// Of an arc: `start_angle` plus the angle of the turn if the arc turns left, minus this angle if it turns right.
  double end_angle = 0.0;

  friend bool operator==(const PathPiece&, const PathPiece&) = default;
};

/// A start or goal that the search moved: `from` is the point in the query, `to` is the point where the path starts or
/// ends instead.
///
/// @code{.cpp}
/// const Path moved = world.find_path({.start = {41, 50}, .goal = goal, .end_tolerance = 2.0}).value();
/// const Point start_of_path = moved.moved_start->to;  // == Point{40, 50}
/// @endcode
struct MovedEnd {
  Point from;
  Point to;

  friend bool operator==(const MovedEnd&, const MovedEnd&) = default;
};

/// The ends of a query, and how far the search may move them: an element of Path.
///
/// @code{.cpp}
/// const Path answer_of_query = world.find_path({.start = start, .goal = goal}).value();
/// const Point asked = answer_of_query.ends->goal;  // == goal
/// @endcode
struct QueryEnds {
  Point start;
  Point goal;
  std::optional<double> end_tolerance;  ///< PathQuery::end_tolerance
  /// Whether World::find_paths_from() gave the answer: ManyGoalsQuery::end_tolerance says how it moves the start.
  bool has_many_goals = false;

  friend bool operator==(const QueryEnds&, const QueryEnds&) = default;
};

/// A position on a path. Path::at, Path::advance and Path::nearest return it.
///
/// @code{.cpp}
/// path = world.find_path({.start = start, .goal = goal}).value();
/// PathPosition position = path.at(0);
/// while (position.distance < path.length) position = path.advance(position, 1.5);  // one step in each tick
/// const Point end = position.at;  // == goal
/// @endcode
struct PathPosition {
  Point at;       ///< the point at this position
  Point heading;  ///< the direction of the path there, of length 1; (0, 0) on a path of length 0
  /// The position lies between points[segment] and points[segment + 1] of the path or, if the path has pieces, on
  /// pieces[segment].
  std::size_t segment = 0;
  double before = 0.0;    ///< the length of the path from its start to the start of this segment or piece
  double distance = 0.0;  ///< the length of the path from its start to this position
};

/// The type in which a program keeps coordinates.
enum class Precision : std::uint8_t {
  float64,  ///< as `double`
  float32,  ///< as `float`
};

/// The answer to a path query: the path, and facts about the search. If you reuse one object for many queries, it keeps
/// its memory.
///
/// @code{.cpp}
/// world.find_path({.start = start, .goal = goal}, context, path).value();
/// if (path.status != PathStatus::found) {
///   std::printf("%s\n", to_string(path.status).data());
///   return;
/// }
/// const std::size_t turns = path.points.size() - 2;  // == 2
/// std::printf("%g long, now at %s\n", path.length, to_string(path.at(25).at).c_str());
/// @endcode
struct WAYWRIGHT_API Path {
  PathStatus status = PathStatus::no_path;
  double length = 0.0;  ///< the Euclidean length; 0 if there is no path
  /// No path is shorter than this number. It equals `length` if the search has proven that the path is the shortest. It
  /// is 0 if there is no path.
  double lower_bound = 0.0;
  Agent agent;  ///< the agent of the query
  /// The start, the turns of the path and the goal. The list is empty if there is no path, if the query has a radius
  /// above 0, or if ManyGoalsQuery::wants_points is false. If the path turns at a crossing of two sides, the point of
  /// this turn has the rounded coordinates of the crossing. For this reason, if a point of a polyline has the rounded
  /// coordinates of a crossing, World::is_clear() also lets the agent turn at the exact crossing.
  std::vector<Point> points;
  /// The lines and arcs from the start to the goal, if the query has a radius above 0. The list is empty if the radius
  /// is 0, if there is no path, or if ManyGoalsQuery::wants_points is false. If start and goal are equal, there is one
  /// line of length 0. No wall is nearer to a position on the pieces than the radius, up to rounding errors
  /// (PathQuery::agent).
  std::vector<PathPiece> pieces;
  /// The edges that the path crosses, in order. The list is empty if there is no path, if PathQuery::wants_channel is
  /// false, or if the query has a radius above 0: the lines and arcs may leave the channel of the search.
  std::vector<Portal> channel;
  /// The number of triangles that the search entered. If the query has a radius above 0, the member also counts the
  /// straight lines to a next turn, or to the goal, that the search has examined. PathAlgorithm::tra counts only the
  /// triangles at which it had a choice. For a disc, `tra` can also pause in a long series of triangles without a
  /// choice, if a path through other triangles seems to be shorter. Then the member also counts the triangle at which
  /// the search continues later. If the straight segment from the start to the goal of a point agent meets no wall, and
  /// no vertex between its ends, the member is the number of edges that this segment crosses. If the query has a radius
  /// above 0 and the status is no_path, the member is 0: how long the search takes to find this out depends on earlier
  /// queries.
  std::size_t expansions = 0;
  /// The time from the start of the search to its end. The time between the slices of a PathSearch counts, too. It is 0
  /// if PathQuery::wants_time is false.
  std::chrono::nanoseconds time{0};
  std::optional<MovedEnd> moved_start;  ///< set if the search moved the start; the path starts at moved_start->to
  std::optional<MovedEnd> moved_goal;   ///< set if the search moved the goal; the path ends at moved_goal->to
  /// The polygons in whose interior the blocked end lies, ascending. With a radius above 0, the list contains all items
  /// that stop the disc there: see DiscFit::items. The list is empty unless the status is start_blocked or
  /// goal_blocked.
  std::vector<ItemId> blockers;
  /// The radius of the largest disc that can move from start to goal, and the gap that stops every larger disc. The
  /// search sets this member if the query has a radius above 0, the status is no_path, and a smaller disc can move from
  /// start to goal.
  std::optional<WidestPath> widest;
  /// The ends in the query. Each query sets this member. A PathWatch reads it if there is no path: then it knows when
  /// a path becomes possible.
  std::optional<QueryEnds> ends;

  /// Returns the position at `distance` from the start, along the path. A distance below 0 gives the start, and a
  /// distance above the length gives the goal. NaN counts as 0.
  ///
  /// You can use the result as the start of a path query. If doubles can express the exact position on the path, the
  /// result is this position. Otherwise the function rounds it to the left or to the right of the path, so that the
  /// result does not lie beyond a wall. A path turns around walls. So near a left turn, these walls lie to the left of
  /// the path, and the function rounds to the right. Near a right turn it rounds to the left. Between two turns, the
  /// nearer one decides. There are two exceptions. If walls touch one straight piece of the path from the left and from
  /// the right, the result can lie beyond one of them. And on a path without turns, the function rounds to nearest.
  ///
  /// The coordinates are doubles or floats, as `precision` says. With Precision::float32 the result can lie outside the
  /// domain, if the border of the domain has a coordinate that no `float` can express.
  ///
  /// On the path of a disc, the function rounds to nearest. A wall can be nearer to the position than the radius, by at
  /// most the sum of two errors: the error of the path (PathQuery::agent), and the rounding error of the position.
  /// With Precision::float64, the rounding error is a few units in the last place of the radius or of the largest
  /// coordinate of the path, whichever is larger. With Precision::float32, it is at most the distance between two
  /// neighbouring floats at the larger coordinate of the position. So a disc that touches a wall may not fit exactly at
  /// the position, see World::fit_disc. The heading has no jumps, because the lines touch the arcs.
  /// Requires: the path has points or pieces.
  /// Cost: linear in the turns (for a disc, the pieces) before the position.
  [[nodiscard]] PathPosition at(double distance, Precision precision = Precision::float64) const;
  /// Returns the position that lies `step` farther along the path than `from`. Use it to move a unit in each tick. The
  /// function rounds the result as at() does. NaN counts as 0.
  /// Requires: a function of this path returned `from`, and the path has not changed since then.
  /// Cost: linear in the turns that the step passes; for a negative step, linear in the turns before the position.
  [[nodiscard]] PathPosition advance(const PathPosition& from, double step,
                                     Precision precision = Precision::float64) const;
  /// Returns the position on the path that is nearest to `point`. If several positions are equally near, the function
  /// returns the first of them. Use it for a unit that has left its path. `point` should lie in the domain. The
  /// function rounds the result as at() does.
  /// Requires: the path has points or pieces.
  /// Cost: linear in the turns.
  [[nodiscard]] PathPosition nearest(const Point& point, Precision precision = Precision::float64) const;

  /// Returns the path as points, for programs that cannot use arcs. For a point agent, the result is `points`. For a
  /// disc, the points are the ends of all pieces and, on each arc, as few points between its ends as the tolerance
  /// allows, without points that equal the point before them. All points lie on the path, up to
  /// rounding errors. No position on the straight segments between them is farther than `tolerance` from the path. So
  /// no wall is nearer to these segments than the radius minus the tolerance. A tolerance above half the radius counts
  /// as half the radius, so that the segments never touch a wall. If the path has no points and no pieces, the result
  /// is empty.
  ///
  /// @code{.cpp}
  /// World yard = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  /// yard.insert_segment({50, 0}, {50, 60}, 1).value();
  /// const Path around = yard.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
  /// const std::size_t coarse = around.polyline(1.0).value().size();   // == 4
  /// const std::size_t fine = around.polyline(0.05).value().size();    // == 7
  /// @endcode
  ///
  /// Errors: bad_distance, if `tolerance` is negative, not a number, or below 2^-20 times the radius (a whole circle
  /// has 2,275 segments at this tolerance).
  /// Cost: linear in the points of the result.
  [[nodiscard]] Result<std::vector<Point>> polyline(double tolerance) const;
  /// Writes the points to `line`. Allocates nothing once `line` is large enough.
  /// @copydetails polyline(double) const
  [[nodiscard]] Result<void> polyline(double tolerance, std::vector<Point>& line) const;
};

/// A query for the shortest paths from one start to many goals, for World::find_paths_from.
///
/// @code{.cpp}
/// const std::vector<Point> depots = {{90, 50}, {90, 90}, {10, 90}};
/// const std::vector<Path> paths = world.find_paths_from({.start = start, .goals = depots}).value();
/// for (const Path& to_depot : paths) std::printf("%g\n", to_depot.length);
/// @endcode
///
/// Cost: for fewer than 256 goals, the cost of one path for each goal. For 256 goals or more, one search from the start
/// finds all paths. Its cost depends on the number of triangles that are nearer to the start than the farthest goal.
/// Each further goal adds little to this cost. For a radius above 0, the cost is always the cost of one path for each
/// goal.
struct ManyGoalsQuery {
  Point start;
  std::span<const Point> goals;
  Agent agent{};              ///< like PathQuery::agent
  bool wants_points = false;  ///< whether the answers have points or pieces, besides status and length
  /// Like PathQuery::end_tolerance, for the start and for each goal. With the radius 0 there is one difference for the
  /// start, because all paths begin at the same point: the search moves the start only if polygons cover all triangles
  /// around it, and does not prefer positions that are connected with a goal.
  std::optional<double> end_tolerance{};
};

/// A window that a search has followed: an element of PathSearch::windows. A window is the piece of an edge of the mesh
/// that is visible from its *root*, through the triangles that the search has crossed. The root is the start of the
/// path, or a turn of the path.
///
/// For each window, the search enters one triangle. The windows of several roots can lie beside each other on one edge,
/// if the roots are consecutive turns of one path, for example around the corners of a convex obstacle. (The first of
/// these roots may be the start of the path.) The search may enter the triangle with all these windows in one step. The
/// windows of such a step follow each other in the list. Usually the triangle lies beyond the edge, as seen from the
/// root. Directly after a turn, it lies between the root and the edge: the root is one of its vertices, and the edge is
/// opposite to this vertex.
///
/// The coordinates are rounded: use them only for pictures. The search itself decides exactly, without these
/// coordinates. The ends of the interval are the positions where two rays from the root meet the edge. If a ray is
/// nearly parallel to the edge, so that doubles cannot express where they meet, then the end of the edge on the same
/// side (left or right) is the end of the interval.
struct SearchWindow {
  Point root;           ///< the last turn of the path, or its start
  Portal edge;          ///< the whole edge; left and right as seen from the root
  Portal interval;      ///< the piece of the edge that is visible from the root
  double length = 0.0;  ///< the length of the path from the start to the root
  double bound = 0.0;   ///< up to rounding, no path through the window to the goal is shorter than this

  friend bool operator==(const SearchWindow&, const SearchWindow&) = default;
};

/// @}

}  // namespace waywright

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "waywright/point.hpp"

/// Two oracles for paths of discs among walls. They use no code of the library except the struct Point, and they share
/// no code with each other.
///
/// The scene is a list of walls. The centre c of a disc of radius r > 0 may lie where dist(c, wall) >= r for every
/// wall, and moves continuously among these positions. The four sides of a domain are walls like all others: the caller
/// adds them.
namespace waywright::test::disc {

/// Closed segments. They may cross, overlap, touch and repeat. A segment of length zero is ignored.
struct Walls {
  std::vector<std::pair<Point, Point>> segments;
};

// Connectivity, in rationals without any tolerance

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x;
  Rational y;

  friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};

/// Returns the squared distance from a point to a segment, which may have length zero.
[[nodiscard]] Rational squared_distance(const Point& position, const Point& from, const Point& to);
/// Returns the squared diameter of the largest disc that fits at both positions. Requires: there is a wall.
[[nodiscard]] Rational largest_at(const Walls& walls, const Point& start, const Point& goal);

/// The segment from an end of a wall to an end of a wall, or to the foot of the perpendicular on a wall, strictly
/// inside this wall. The open disc that has the segment as a diameter meets no wall, and the length is positive.
/// Crossings of walls are not ends of bridges.
///
/// A bridge blocks the radius r if its squared length is less than 4 r^2. Theorem: two positions where the disc fits
/// are connected for r if and only if the walls and the blocking bridges do not separate them. Reason: a bridge is a
/// path of steepest ascent of the clearance, up to its middle. So no such path crosses a bridge, and a cell of the
/// walls and blocking bridges has no saddle of the clearance below r.
struct Bridge {
  RationalPoint from;        ///< an end of a wall
  RationalPoint to;          ///< an end of a wall, or a foot
  Rational squared_length;   ///< positive
  std::size_t from_end = 0;  ///< 2 i for the first point of wall i, 2 i + 1 for its second point
  bool is_foot = false;      ///< whether `to` is a foot
  std::size_t to_end = 0;    ///< like from_end; for a foot: the index of the wall
};

/// Returns all bridges, each segment once: if several wall ends lie at one position, the bridge names the first one. If
/// an end of a wall lies at a foot, the bridge is between two ends.
[[nodiscard]] std::vector<Bridge> bridges(const Walls& walls);

/// Returns whether dist(position, wall) >= r for every wall.
[[nodiscard]] bool fits(const Walls& walls, Point position, double r);

/// The largest disc that can move between two positions.
struct Widest {
  /// Whether a bridge limits the disc. If not, walls and bridges do not separate the two positions: every disc that
  /// fits at both positions can move between them.
  bool is_limited = false;
  /// The squared length of the narrowest bridge of the widest path, if is_limited. Discs of exactly this squared
  /// diameter still pass.
  Rational squared_diameter;
};

/// The exact connectivity of a scene. The object computes the bridges once, and keeps each arrangement that it builds.
class Connectivity {
 public:
  explicit Connectivity(Walls walls);
  ~Connectivity();
  Connectivity(Connectivity&&) noexcept;
  Connectivity& operator=(Connectivity&&) noexcept;

  [[nodiscard]] const std::vector<Bridge>& bridges() const;
  /// See fits() above.
  [[nodiscard]] bool fits(Point position, double r) const;
  /// Returns whether both positions are free and connected for the radius r: whether they lie in the same cell of the
  /// arrangement of all walls and all bridges that block r.
  [[nodiscard]] bool connected(Point start, Point goal, double r) const;
  /// Returns the widest disc that can move from start to goal, if both ends are taken as free for every radius. Returns
  /// nothing if the walls alone separate start and goal, or if one of them lies on a wall. A position on a bridge
  /// belongs to the cells on the left and on the right of the bridge.
  ///
  /// The function works on the arrangement of the walls and all bridges, and `connected` on another arrangement for
  /// each radius. If both ends are free for r, then connected(start, goal, r) == (result && (!result->is_limited ||
  /// 4 r^2 <= result->squared_diameter)).
  [[nodiscard]] std::optional<Widest> widest(Point start, Point goal) const;

 private:
  struct Cache;
  std::unique_ptr<Cache> cache_;
};

/// See Connectivity::connected.
[[nodiscard]] bool connected(const Walls& walls, Point start, Point goal, double r);
/// See Connectivity::widest.
[[nodiscard]] std::optional<Widest> widest_squared_diameter(const Walls& walls, Point start, Point goal);

// Shortest paths, in long double

/// A straight piece of a path, or an arc.
struct Piece {
  bool is_arc = false;
  Point from;  ///< of a straight piece
  Point to;    ///< of a straight piece
  Point centre;
  double radius = 0.0;
  /// In radians from the direction of x. The centre of the disc moves counter-clockwise if end_angle > start_angle.
  double start_angle = 0.0;
  double end_angle = 0.0;

  [[nodiscard]] static Piece line(Point from, Point to);
  [[nodiscard]] static Piece arc(Point centre, double radius, double start_angle, double end_angle);
};

struct ShortestPath {
  double length = 0.0;
  std::vector<Piece> pieces;  ///< without pieces of length zero; none if start and goal are equal
};

/// The fraction of the radius by which a piece of `shortest` may come too near to a wall. `shortest` adds 2^-58 of the
/// scene's extent, or 2^-47 where a long double is a double. Reason: on many paths the exact clearance of a piece is
/// the radius. Then the rounding errors decide whether the computed clearance is less. Without a tolerance, they would
/// remove pieces along walls and around touching circles. The errors are smaller than the addition.
///
/// If a bridge is shorter than 2 r by less than the tolerance, or the clearance of an end is less than r by less than
/// the tolerance, `shortest` may find a path that the disc cannot take. Use `connected` to decide these cases.
inline constexpr double kShortestTolerance = 1e-12;

/// Returns the shortest path from start to goal of the centre of a disc of radius r: brute force over the circles of
/// radius r around all ends of walls, their common tangents, their tangents from start and goal, and their arcs.
/// Returns nothing if there is no path.
[[nodiscard]] std::optional<ShortestPath> shortest_path(const Walls& walls, Point start, Point goal, double r);
/// Returns the length of the shortest path.
[[nodiscard]] std::optional<double> shortest(const Walls& walls, Point start, Point goal, double r);

// A check of paths

struct PathReport {
  std::string fault;       ///< the first fault, or empty
  double length = 0.0;     ///< the sum of the lengths of the pieces
  double clearance = 0.0;  ///< the smallest distance from a piece to a wall; infinity without walls
};

/// Checks a path of a disc's centre: the pieces join end to end; the first one begins at start and the last one ends at
/// goal; every piece has the clearance r (1 - 1e-9). Two positions join if they are nearer than 1e-9 of the extent of
/// the scene. Both tolerances add four units in the last place of the largest coordinate. A path without pieces is good
/// if start and goal are equal and free.
[[nodiscard]] PathReport check_path(const Walls& walls, Point start, Point goal, double r,
                                    const std::vector<Piece>& pieces);

}  // namespace waywright::test::disc

#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/point.hpp"

#include "base/ieee.hpp"

// Positions on the lines and arcs of a disc's path (Path::pieces), in doubles. All functions give the same bits on
// every machine.

namespace waywright::path {

[[nodiscard]] double length_of(const PathPiece& piece);
/// Returns the sum of the lengths, added from the first piece to the last.
[[nodiscard]] double length_of(std::span<const PathPiece> pieces);

/// Returns the position at the distance `along` from the start of a piece: exactly PathPiece::from if `along` is 0 or
/// less, exactly PathPiece::to if it is the length or more.
[[nodiscard]] Point position_at(const PathPiece& piece, double along);
/// Returns the direction of the path, of length 1, at the distance `along` from the start of piece `i`. Takes the
/// direction of a line from an arc next to it, if there is one: the line touches this arc, and a short line has no
/// exact direction of its own. Returns (0, 0) if the path has no length.
[[nodiscard]] Point heading_at(std::span<const PathPiece> pieces, std::size_t i, double along);

/// The position on a piece that is nearest to a point.
struct NearestOnPiece {
  double along = 0.0;     ///< the length of the piece from its start to the position
  double distance = 0.0;  ///< the distance of the position from the point
};
/// Returns the position on a piece that is nearest to a point. If several positions are equally near, returns the first
/// of them.
[[nodiscard]] NearestOnPiece nearest_on(const PathPiece& piece, const Point& point);

/// The smallest tolerance of a polyline, as a share of the radius. A whole circle then has 2,275 chords.
inline constexpr double kSmallestTolerance = 0x1p-20;

/// Returns the smallest number of chords that replace an arc, if no position on a chord may be farther than `tolerance`
/// from the arc. A tolerance above half the radius counts as half the radius. Requires: `tolerance` is at least
/// kSmallestTolerance times the radius.
[[nodiscard]] std::size_t chord_count(const PathPiece& arc, double tolerance);
/// Appends the points of a polyline: the ends of all pieces and, of each arc, the ends of its chords. Leaves out a
/// point that equals the point before it. The tolerance is as for chord_count().
void append_polyline(std::span<const PathPiece> pieces, double tolerance, std::vector<Point>& points);

/// Returns whether a closed box comes so near to the path of a disc that the disc may touch it. The result can also be
/// true if the distance is larger than the radius: by a 32nd of the radius at arcs, and by rounding errors. It is never
/// false if the disc touches the box.
[[nodiscard]] bool may_touch(std::span<const PathPiece> pieces, double radius, const Box& box);
/// Returns whether an agent that moves along a polyline may touch a closed box. The result can also be true if the
/// distance is larger than the radius, by less than rounding errors. It is never false if the agent touches the box.
[[nodiscard]] bool may_touch(std::span<const Point> polyline, double radius, const Box& box);

/// Returns the vector of length 1 at the angle `angle` + `rest`, in radians: (cosine, sine). `rest` is a correction, at
/// most 2^-40. Each coordinate has an error below 2^-51 if `angle` is at most 2^19. Uses only operations that IEEE 754
/// rounds correctly, as path/tangent.hpp does.
///
/// Subtracts the nearest multiple of pi / 2 in two steps, then sums the two power series. The first subtraction is
/// exact: kFirst has 33 bits, so its product with a whole number up to 2^20 is a double, and it is near to `angle`.
[[nodiscard]] inline Point unit_vector(double angle, double rest = 0.0) {
  constexpr double kFirst = 0x1.921fb544p+0;  // kFirst + kSecond is pi / 2, with an error below 2^-87
  constexpr double kSecond = 0x1.0b4611a626331p-34;
  constexpr double kInverse = 0x1.45f306dc9c883p-1;  // 2 / pi
  const double quarters = std::floor(angle * kInverse + 0.5);
  const double small = (angle - quarters * kFirst) + (rest - quarters * kSecond);
  const double square = small * small;
  double sine = 1.0;
  for (int n = 16; n >= 2; n -= 2) sine = 1.0 - square / (n * (n + 1)) * sine;
  sine *= small;
  double cosine = 1.0;
  for (int n = 16; n >= 2; n -= 2) cosine = 1.0 - square / (n * (n - 1)) * cosine;
  const double quadrant = quarters - 4.0 * std::floor(quarters / 4.0);
  if (quadrant == 1.0) return {-sine, cosine};
  if (quadrant == 2.0) return {-cosine, -sine};
  if (quadrant == 3.0) return {sine, -cosine};
  return {cosine, sine};
}

}  // namespace waywright::path

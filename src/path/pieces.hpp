#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/point.hpp"

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

}  // namespace waywright::path

#pragma once

#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "path/disc_map.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// A piece of the path of a disc's centre: a straight line, then an arc around the vertex at its end. The last piece
/// has no arc.
struct DiscPiece {
  Point from;
  Point to;
  Point centre;         ///< the centre of the arc
  int turn = kNoTurn;   ///< the direction in which the arc turns; kNoTurn if there is no arc
  Point direction;      ///< the direction of the line, which is the direction of the path at the start of the arc
  Point end_direction;  ///< the direction of the path at the end of the arc
};

/// A pivot of a path, and the direction of the line that leaves it.
struct DiscStop {
  Pivot pivot;
  Point departure;
};

/// Returns the length of the arc around a pivot at which a path arrives in one direction and leaves in another. A
/// turn in the wrong direction is a rounding error and counts as no turn.
[[nodiscard]] double arc_length(const Pivot& pivot, const Point& arrival, const Point& departure, double radius);

/// Writes the pieces of a path. `stops` contains the start and the pivots of the path. The last line ends at `goal`.
/// All positions of `stops` and `goal` are relative to the origin of the map.
void write_disc_pieces(const DiscMap& map, std::span<const DiscStop> stops, const Point& goal,
                       std::vector<DiscPiece>& pieces);

}  // namespace waywright::path

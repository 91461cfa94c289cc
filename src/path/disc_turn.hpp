#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "mesh/triangle_mesh.hpp"
#include "path/disc_map.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// How far the path of a disc can turn around a vertex.
struct TurnLimit {
  double order = 2.0;  ///< turning_order() from the direction of arrival to the last possible direction
  /// A half-edge that starts at the other end of the wall or of the narrow gap that limits the turn. kNoHalfEdge if no
  /// vertex limits the turn.
  mesh::HalfEdge corner = mesh::kNoHalfEdge;
};

/// The margin for rounding of two tests. A path cannot turn so far if the order of a direction exceeds the limit by
/// more than this. A path *turns back* at a pivot if it would turn against the pivot's direction: the cross product of
/// the directions of arrival and departure, times the turn, is below minus this number. (For small angles, the order
/// and this product are nearly equal.)
inline constexpr double kTurnsBack = 0x1p-23;

/// Returns whether a direction lies beyond the limit of a turn: then a path that arrives at the pivot in the
/// direction `arrival` cannot leave it in the direction `departure`.
[[nodiscard]] inline bool is_beyond(const TurnLimit& limit, const Pivot& pivot, const Point& arrival,
                                    const Point& departure) {
  const double order = turning_order(arrival, departure, pivot.turn);
  return pivot.turn != kNoTurn && order > limit.order + kTurnsBack && order < 4.0 - kTurnsBack;
}

/// Returns the corner at the same vertex that contains a direction. Looks at `corner` first, and then at the other
/// corners against the direction of the turn. Returns kNoHalfEdge if the direction leads out of the domain.
[[nodiscard]] mesh::HalfEdge corner_towards(const DiscMap& map, mesh::HalfEdge corner, const Point& direction,
                                            int turn);

/// Visits the corners of faces around the vertex of a pivot, one after the other, in the direction of the turn: up to
/// a wall or a gap that is too narrow, or until the path has turned by 180 degrees. Calls visit(corner, spoke, order)
/// for each corner: the turn leaves the corner across the edge `spoke`, whose direction has the order `order`. Returns
/// how far the path can turn. `arrival` is the direction in which the path reaches the pivot, and `corner` is the
/// corner that contains the position of the disc at this time.
///
/// The *order* of a direction is a number that says how far the path has turned when it has this direction: 0 for the
/// direction of arrival, 1 after 90 degrees, and 2 after 180 degrees. The direction from the vertex to the position of
/// arrival has the order -1, and the orders grow from there. (turning_order() gives them modulo 4, from 0 to 4.)
template <class Visit>
[[nodiscard]] TurnLimit turn_around(const DiscMap& map, const Pivot& pivot, const Point& arrival, mesh::HalfEdge corner,
                                    Visit&& visit) {
  const mesh::TriangleMesh& mesh = map.mesh();
  const int turn = pivot.turn;
  double order = -1.0;
  mesh::HalfEdge at = corner;
  do {
    // `spoke` is the edge at the vertex to which the turn comes next.
    const mesh::HalfEdge spoke = turn == kTurnLeft ? mesh.next_around(at) : at;
    // The orders of the spokes grow. If the first spoke points to the position of arrival, its order is -1, but
    // rounding may make it a little smaller.
    const double end_order = turning_order(arrival, map.position(mesh.target(spoke)) - pivot.centre, turn);
    order = end_order - 4.0 >= order - kTurnsBack ? std::max(order, end_order - 4.0) : end_order;
    visit(at, spoke, order);
    if (const auto foot = map.narrow_bridge_foot(at)) {
      // A foot bridge does not limit the turn if its foot lies before the position of arrival.
      const double foot_order = turning_order(arrival, *foot - pivot.centre, turn);
      const double reach = (foot_order > order ? foot_order - 4.0 : foot_order) + 1.0;
      if (reach >= 0.0) return {reach, mesh::kNoHalfEdge};
    }
    if (order > 2.0) break;
    // The path can turn until it runs along a wall, or until the disc's centre reaches a narrow gap.
    if (map.is_closed(spoke)) return {mesh.is_fixed(spoke) ? order : order + 1.0, mesh.twin(spoke)};
    at = turn == kTurnLeft ? spoke : mesh.previous_around(at);
  } while (at != corner);
  return {};
}

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

#include "path/disc_turn.hpp"

#include <cstddef>

namespace waywright::path {

using mesh::HalfEdge;

HalfEdge corner_towards(const DiscMap& map, HalfEdge corner, const Point& direction, int turn) {
  const mesh::TriangleMesh& mesh = map.mesh();
  const Point from = map.position(mesh.origin(corner));
  const auto contains = [&](HalfEdge h) {
    return !map.triangulation.triangulation().is_ghost_face(h) &&
           cross(map.position(mesh.target(h)) - from, direction) >= 0.0 &&
           cross(map.position(mesh.apex(h)) - from, direction) < 0.0;
  };
  HalfEdge at = corner;
  do {
    if (contains(at)) return at;
    at = turn == kTurnLeft ? mesh.previous_around(at) : mesh.next_around(at);
  } while (at != corner);
  return mesh::kNoHalfEdge;
}

double arc_length(const Pivot& pivot, const Point& arrival, const Point& departure, double radius) {
  if (pivot.turn == kNoTurn || departure == arrival) return 0.0;
  const double angle = turning_angle(arrival, departure, pivot.turn);
  return angle < 2 * kPi - 1.0 ? radius * angle : 0.0;
}

void write_disc_pieces(const DiscMap& map, std::span<const DiscStop> stops, const Point& goal,
                       std::vector<DiscPiece>& pieces) {
  const auto has_arc = [&](std::size_t i) {
    return arc_length(stops[i].pivot, stops[i - 1].departure, stops[i].departure, map.radius) != 0.0;
  };
  pieces.clear();
  bool has_arc_here = false;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Pivot& pivot = stops[i].pivot;
    const Point& direction = stops[i].departure;
    const bool has_next = i + 1 < stops.size();
    // If the path does not turn at a pivot, the two lines there are one line.
    if (i == 0 || direction != stops[i - 1].departure) {
      const Point& touching = i > 0 && !has_arc_here ? stops[i - 1].departure : direction;
      pieces.emplace_back().from = touching_position(pivot, touching, map.exact_radius) + map.origin;
    }
    DiscPiece& piece = pieces.back();
    piece.direction = direction;
    piece.to = (has_next ? touching_position(stops[i + 1].pivot, direction, map.exact_radius) : goal) + map.origin;
    if (!has_next) continue;
    piece.centre = stops[i + 1].pivot.centre + map.origin;
    has_arc_here = has_arc(i + 1);
    piece.turn = has_arc_here ? stops[i + 1].pivot.turn : kNoTurn;
    piece.end_direction = stops[i + 1].departure;
  }
  // The last line has no arc.
  if (!pieces.empty()) pieces.back().turn = kNoTurn;
}

}  // namespace waywright::path

#include "path/disc_turn.hpp"

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

}  // namespace waywright::path

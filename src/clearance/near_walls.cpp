#include "clearance/near_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/ieee.hpp"
#include "clearance/walls.hpp"
#include "constraint/distances.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// Bounds of a distance.
struct DistanceBounds {
  double least;
  double most;
};

/// Returns bounds of the distance from (0, 0) to the segment that starts at `from` and runs along the vector `along`.
/// `from` and `along` are rounded differences of points. Each coordinate of these points may be wrong by `rounding`.
DistanceBounds bound_distance(const Point& from, const Point& along, double rounding) {
  constexpr double kUnit = 0x1p-48;  // 32 times the unit of rounding: more than the errors of these formulas
  const double squared_length = along.x * along.x + along.y * along.y;
  const double dot = -(from.x * along.x + from.y * along.y);
  const double share = dot <= 0.0 ? 0.0 : dot >= squared_length ? 1.0 : dot / squared_length;
  const double x = from.x + share * along.x;
  const double y = from.y + share * along.y;
  const double extent = std::abs(from.x) + std::abs(from.y) + std::abs(along.x) + std::abs(along.y);
  const double slack = kUnit * extent + 4.0 * rounding;
  const double distance = std::sqrt(x * x + y * y);
  return {distance - slack, distance + slack};
}

/// Computes distances from a point to edges in doubles, with bounds of their errors.
class Distances {
 public:
  Distances(const constraint::ConstrainedTriangulation& triangulation, const Point& point)
      : mesh_(triangulation.topology()),
        geometry_(triangulation.triangulation().geometry()),
        point_(point),
        rounding_(constraint::largest_rounding(triangulation)) {}

  [[nodiscard]] DistanceBounds to(HalfEdge h) const {
    const Point& a = geometry_.rounded(number(mesh_.origin(h)));
    const Point& b = geometry_.rounded(number(mesh_.target(h)));
    return bound_distance({a.x - point_.x, a.y - point_.y}, {b.x - a.x, b.y - a.y}, rounding_);
  }

 private:
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  Point point_;
  double rounding_;
};

}  // namespace

/// Calls visit(h) for each edge h of each face that it enters, once for each such face. Starts at the location of the
/// point, and enters the face beyond an edge h if enters(h).
template <class Enters, class Visit>
void NearWalls::flood(const Triangulation& triangulation, const Point& point, Enters&& enters, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  visited_.grow_to(mesh.face_slots());
  stamp_.next(1, visited_);
  const HalfEdge start = triangulation.triangulation().locate(point).h;
  const auto look = [&](HalfEdge h) {
    visit(h);
    if (enters(h)) to_enter_.push_back(mesh.twin(h));
  };
  to_enter_.clear();
  visited_[number(mesh::face(start))] = stamp_.value();
  for (const HalfEdge h : {start, mesh::next(start), mesh::previous(start)}) look(h);
  while (!to_enter_.empty()) {
    const HalfEdge h = to_enter_.back();
    to_enter_.pop_back();
    if (triangulation.triangulation().is_ghost_face(h)) continue;
    if (std::exchange(visited_[number(mesh::face(h))], stamp_.value()) == stamp_.value()) continue;
    visit(h);
    for (const HalfEdge other : {mesh::next(h), mesh::previous(h)}) look(other);
  }
}

bool NearWalls::has_no_nearer_wall(const Triangulation& triangulation, const Point& point, double radius) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const Distances distances(triangulation, point);
  bool is_clear = true;
  const auto is_near = [&](HalfEdge h) { return is_clear && distances.to(h).least < radius; };
  flood(
      triangulation, point, [&](HalfEdge h) { return !mesh.is_fixed(h) && is_near(h); },
      [&](HalfEdge h) {
        if (!mesh.is_fixed(h) || !is_near(h)) return;
        const constraint::Side& side = triangulation.any_side(h);
        is_clear = exact::compare_distance(point, geometry.rounded(number(side.from)),
                                           geometry.rounded(number(side.to)), radius) >= 0;
      });
  return is_clear;
}

void NearWalls::find_items(const Triangulation& triangulation, const Point& point, double radius,
                           std::vector<std::uint32_t>& items) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const Distances distances(triangulation, point);
  const auto is_near = [&](HalfEdge h) { return distances.to(h).least < radius; };
  flood(triangulation, point, is_near, [&](HalfEdge h) {
    if (!mesh.is_fixed(h) || !is_near(h)) return;
    triangulation.for_each_side(h, [&](const constraint::Side& side) {
      const auto order = exact::compare_distance(point, geometry.rounded(number(side.from)),
                                                 geometry.rounded(number(side.to)), radius);
      if (order < 0) items.push_back(side.item);
    });
  });
}

/// Collects in `candidates_` the walls that may be nearest to the point.
void NearWalls::find_candidates(const Triangulation& triangulation, const Point& point) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Distances distances(triangulation, point);
  double most = std::numeric_limits<double>::infinity();
  candidates_.clear();
  flood(
      triangulation, point, [&](HalfEdge h) { return !mesh.is_fixed(h) && distances.to(h).least <= most; },
      [&](HalfEdge h) {
        if (!mesh.is_fixed(h)) return;
        const DistanceBounds distance = distances.to(h);
        if (distance.least > most) return;
        most = std::min(most, distance.most);
        candidates_.push_back({h, distance.least});
      });
  std::erase_if(candidates_, [&](const Candidate& candidate) { return candidate.least > most; });
  // A point in the middle of a bridge has two nearest walls, on the borders of two cells. The positions of the walls,
  // not their indices, determine the order.
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto key = [&](const Candidate& candidate) {
    const Point& from = geometry.rounded(number(mesh.origin(candidate.wall)));
    const Point& to = geometry.rounded(number(mesh.target(candidate.wall)));
    return std::tie(from.x, from.y, to.x, to.y);
  };
  std::sort(candidates_.begin(), candidates_.end(),
            [&](const Candidate& p, const Candidate& q) { return key(p) < key(q); });
}

// Two pieces of one side have the same line, so the distance to the whole side does not say which of them is nearest.
// The foot of the perpendicular decides: the foot lies on the nearest piece. A crossing is never nearest: the angles
// there are less than 180 degrees.
std::optional<CellEdge> NearWalls::find_cell(const Triangulation& triangulation, const Bridges& bridges,
                                             const Point& point) {
  find_candidates(triangulation, point);
  WallLine nearest = wall_line(triangulation, candidates_.front().wall);
  for (const Candidate& candidate : candidates_) {
    const WallLine line = wall_line(triangulation, candidate.wall);
    if (exact::compare_distances(point, line.from, line.to, nearest.from, nearest.to) < 0) nearest = line;
  }
  if (exact::compare_distance(point, nearest.from, nearest.to, 0.0) == 0) return std::nullopt;
  for (const Candidate& candidate : candidates_) {
    const WallLine line = wall_line(triangulation, candidate.wall);
    if (exact::compare_distances(point, line.from, line.to, nearest.from, nearest.to) != 0) continue;
    if (const auto cell = find_cell_at(triangulation, bridges, point, candidate.wall)) return cell;
  }
  return std::nullopt;
}

/// The wall is a piece of a side. Let q be the position on this side that is nearest to the point. If q lies on the
/// wall, returns an edge of the cell that contains the point. Otherwise returns nothing.
std::optional<CellEdge> NearWalls::find_cell_at(const Triangulation& triangulation, const Bridges& bridges,
                                                const Point& point, HalfEdge wall) const {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const WallLine line = wall_line(triangulation, wall);
  const Vertex from = triangulation.topology().origin(wall);
  const Vertex to = triangulation.topology().target(wall);
  const Sign before = exact::dot(point, geometry.exact(number(from)), line.from, line.to);
  const Sign after = exact::dot(point, geometry.exact(number(to)), line.from, line.to);
  if (before == Sign::negative && after == Sign::positive) {
    // The search may have come around the end of the wall. Then the point lies right of the half-edge.
    const bool is_on_left = geometry.orientation(exact::Geometry::view(line.from), exact::Geometry::view(line.to),
                                                 exact::Geometry::view(point)) == Sign::positive;
    return cell_at_wall(triangulation, bridges, point, is_on_left ? wall : triangulation.topology().twin(wall));
  }
  const auto is_at = [&](Vertex v, const Point& end) {
    return geometry.is_explicit(number(v)) && geometry.rounded(number(v)) == end;
  };
  if (before == Sign::zero || (before == Sign::positive && is_at(from, line.from))) {
    return cell_at_vertex(triangulation, bridges, point, from);
  }
  if (after == Sign::zero || (after == Sign::negative && is_at(to, line.to))) {
    return cell_at_vertex(triangulation, bridges, point, to);
  }
  return std::nullopt;
}

CellEdge NearWalls::cell_at_wall(const Triangulation& triangulation, const Bridges& bridges, const Point& point,
                                 HalfEdge wall) {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const WallLine line = wall_line(triangulation, wall);
  const std::uint32_t last = bridges.last_foot_before(wall, [&](std::uint32_t foot) {
    const Vertex v = triangulation.topology().origin(bridges.corner_of(foot));
    return exact::dot(geometry.rounded(number(v)), point, line.from, line.to) != Sign::negative;
  });
  return {CellEdge::Kind::wall, wall, last};
}

CellEdge NearWalls::cell_at_vertex(const Triangulation& triangulation, const Bridges& bridges, const Point& point,
                                   Vertex v) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto orientation = [&](Vertex to) {
    return geometry.orientation(geometry.view(number(v)), geometry.view(number(to)), exact::Geometry::view(point));
  };
  // Whether the direction from the vertex to the point leads into the face of `h`, or along this half-edge.
  const auto leads_to_point = [&](HalfEdge h) {
    return !triangulation.triangulation().is_ghost_face(h) && orientation(mesh.target(h)) != Sign::negative &&
           orientation(mesh.apex(h)) == Sign::negative;
  };
  HalfEdge corner = mesh.outgoing(v);
  while (!leads_to_point(corner)) corner = mesh.next_around(corner);
  if (const std::uint32_t foot = bridges.foot_at(corner); foot != Bridges::kNone) {
    const WallLine line = wall_line(triangulation, bridges.wall_of(foot));
    const bool is_clockwise_of_bridge =
        exact::dot(geometry.rounded(number(v)), point, line.from, line.to) == Sign::negative;
    if (!is_clockwise_of_bridge) return {CellEdge::Kind::foot_down, corner, foot};
  }
  return Cells(triangulation, bridges).first_clockwise(corner);
}

}  // namespace waywright::clearance

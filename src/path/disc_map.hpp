#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "clearance/bridges.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/distances.hpp"
#include "exact/gap.hpp"
#include "nav/two_core.hpp"

namespace waywright::path {

/// Returns a lower bound of the magnitude of cross(u, v): the function subtracts more than the rounding errors.
[[nodiscard]] inline double least_cross(const Point& u, const Point& v) {
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  return std::max(0.0, std::abs(left - right) - 0x1p-48 * (std::abs(left) + std::abs(right)));
}

/// The input of a search for the path of a disc: the walls of a world, their bridges, and the radius of the disc.
class DiscMap {
 public:
  /// `two_core` is the two-core of the triangulation, or null. The search uses it to leave out dead ends.
  DiscMap(const constraint::ConstrainedTriangulation& triangulation_of_walls, const clearance::Bridges& all_bridges,
          double radius_of_disc, const Point& start, const nav::TwoCore* two_core = nullptr)
      : triangulation(triangulation_of_walls), bridges(all_bridges), core(two_core), exact_radius(radius_of_disc) {
    const Box& domain = triangulation.domain();
    const double extent = std::max(domain.max.x - domain.min.x, domain.max.y - domain.min.y);
    const double largest = std::max({-domain.min.x, -domain.min.y, domain.max.x, domain.max.y});
    const bool is_far = largest > kFar * extent;
    if (is_far) origin = start;
    const double unit = 0x1p-50 * (is_far ? extent : largest);
    const double rounding = std::max(unit, constraint::largest_rounding(triangulation));
    radius = std::max(exact_radius, kLeastRoundings * rounding);
    explicit_slack = std::max(0x1p-34 * radius, unit);
    slack = std::max(explicit_slack, rounding);
    const double shorter = std::max(0.0, exact_radius - slack);
    const double longer = exact_radius + slack;
    surely_short = 4.0 * shorter * shorter;
    surely_long = 4.0 * longer * longer;
  }

  const constraint::ConstrainedTriangulation& triangulation;
  const clearance::Bridges& bridges;
  const nav::TwoCore* core;
  double exact_radius;
  /// The radius for computations in doubles. It is the exact radius, unless this radius is so small that in doubles a
  /// position at this distance from a vertex equals the vertex. Then the member is a larger radius.
  double radius;
  /// All positions of a search are relative to this point. It is (0, 0), so that positions of vertices are exact,
  /// except in domains far from (0, 0). There it is the start, so that positions near it are precise.
  Point origin;
  /// If the squared length of an edge is smaller than this number, the disc fits at no position on the edge.
  double surely_short;
  /// If the squared length of an edge is larger than this number, the edge is not too short for the disc. Then the
  /// search does not need the exact decision.
  double surely_long;

  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return triangulation.topology(); }
  /// The position of a vertex, relative to `origin`.
  [[nodiscard]] Point position(mesh::Vertex v) const {
    return triangulation.triangulation().geometry().rounded(number(v)) - origin;
  }

  /// The search accepts a path if no wall is nearer to it than the radius minus this number. The number allows for
  /// rounding. It is the larger one of a small share of the radius and the rounding error of a coordinate.
  double slack;
  double explicit_slack;  ///< like `slack`, but only for walls between explicit vertices
  [[nodiscard]] double least_distance() const { return radius - slack; }

  /// Returns whether this disc cannot pass between the two ends of the edge: the edge is a wall, or a bridge that is
  /// shorter than the disc is wide. The decision is exact.
  [[nodiscard]] bool is_closed(mesh::HalfEdge h) const {
    if (mesh().is_fixed(h)) return true;
    if (!bridges.is_bridge(h)) return false;
    const exact::Geometry& geometry = triangulation.triangulation().geometry();
    const Point& from = geometry.rounded(number(mesh().origin(h)));
    const Point& to = geometry.rounded(number(mesh().target(h)));
    if (squared_length(to - from) > surely_long) return false;
    return exact::compare_to_diameter({from, to, to}, exact_radius) < 0;
  }

  /// Returns is_closed(h). `squared` is the squared length of the edge. For most edges, this length is enough for the
  /// decision, and the function does not ask whether the edge is a bridge.
  [[nodiscard]] bool is_closed(mesh::HalfEdge h, double squared) const {
    return mesh().is_fixed(h) || (squared <= surely_long && is_closed(h));
  }

  /// Returns true only if no foot bridge that starts at the origin of `corner` and runs into its face is shorter than
  /// the disc is wide. Such a bridge crosses the opposite edge of the face or ends on it. So it is at least as long as
  /// the distance from the origin to the line of this edge: the cross product of the other two edges, divided by the
  /// length of this edge. `surely_long` allows for the rounding of positions: a bridge starts at an explicit vertex, so
  /// only the ends of the edge may be rounded.
  [[nodiscard]] bool is_foot_surely_long(mesh::HalfEdge corner) const {
    const Point from = position(mesh().origin(corner));
    const Point to_target = position(mesh().target(corner)) - from;
    const Point to_apex = position(mesh().apex(corner)) - from;
    const double cross = least_cross(to_target, to_apex);
    return cross * cross > surely_long * squared_length(to_apex - to_target);
  }

  /// Returns the foot, relative to `origin`, of the bridge that starts at the origin of `corner`, runs into its face
  /// and is shorter than the disc is wide. Returns nothing if there is no such bridge.
  [[nodiscard]] std::optional<Point> narrow_bridge_foot(mesh::HalfEdge corner) const {
    const std::uint32_t foot = bridges.foot_at(corner);
    if (foot == clearance::Bridges::kNone) return std::nullopt;
    const exact::Gap gap = foot_gap(corner, foot);
    if (exact::compare_to_diameter(gap, exact_radius) >= 0) return std::nullopt;
    return exact::end_of(gap) - origin;
  }
  /// Returns whether narrow_bridge_foot() returns a foot.
  [[nodiscard]] bool has_narrow_bridge_foot(mesh::HalfEdge corner) const {
    const std::uint32_t foot = bridges.foot_at(corner);
    return foot != clearance::Bridges::kNone && !is_foot_surely_long(corner) &&
           exact::compare_to_diameter(foot_gap(corner, foot), exact_radius) < 0;
  }

 private:
  [[nodiscard]] exact::Gap foot_gap(mesh::HalfEdge corner, std::uint32_t foot) const {
    const exact::Geometry& geometry = triangulation.triangulation().geometry();
    const constraint::Side& side = triangulation.any_side(bridges.wall_of(foot));
    return {geometry.rounded(number(mesh().origin(corner))), geometry.rounded(number(side.from)),
            geometry.rounded(number(side.to))};
  }

  static constexpr double kLeastRoundings = 4.0;  ///< `radius` is at least this many times the rounding of a position
  /// A domain is far from (0, 0) if its largest coordinate is more than this many times its extent.
  static constexpr double kFar = 4.0;
};

}  // namespace waywright::path

#pragma once

#include <optional>

#include "clearance/bridges.hpp"
#include "constraint/exact_triangulation.hpp"
#include "exact/gap.hpp"
#include "nav/two_core.hpp"

namespace waywright::path {

/// The input of a search for the path of a disc: the walls of a world, their bridges, and the radius of the disc. The
/// search uses positions relative to `origin`, which the caller chooses near the query, so that doubles are precise far
/// from (0, 0).
struct DiscMap {
  const constraint::ExactTriangulation& walls;
  const clearance::Bridges& bridges;
  double radius;
  Point origin;
  const nav::TwoCore* core = nullptr;  ///< of the walls, or null: the search leaves out dead ends

  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return walls.topology(); }
  /// The position of a vertex, relative to `origin`.
  [[nodiscard]] Point position(mesh::Vertex v) const {
    return walls.triangulation().geometry().rounded(number(v)) - origin;
  }

  /// Returns whether no disc passes between the two ends of the edge: the edge is a wall, or a bridge that is shorter
  /// than the disc is wide. The decision is exact.
  [[nodiscard]] bool is_closed(mesh::HalfEdge h) const {
    if (mesh().is_fixed(h)) return true;
    if (!bridges.is_bridge(h)) return false;
    const exact::Geometry& geometry = walls.triangulation().geometry();
    const Point& from = geometry.rounded(number(mesh().origin(h)));
    const Point& to = geometry.rounded(number(mesh().target(h)));
    return exact::compare_to_diameter({from, to, to}, radius) < 0;
  }
  /// Returns the foot of the bridge that starts at the origin of `corner`, runs into the face of `corner` and is
  /// shorter than the disc is wide, relative to `origin`. Returns nothing if there is no such bridge.
  [[nodiscard]] std::optional<Point> closed_foot(mesh::HalfEdge corner) const {
    const std::uint32_t foot = bridges.foot_at(corner);
    if (foot == clearance::Bridges::kNone) return std::nullopt;
    const exact::Geometry& geometry = walls.triangulation().geometry();
    const constraint::Side& side = walls.any_side(bridges.foot(foot).wall);
    const exact::Gap gap{geometry.rounded(number(mesh().origin(corner))), geometry.rounded(number(side.from)),
                         geometry.rounded(number(side.to))};
    if (exact::compare_to_diameter(gap, radius) >= 0) return std::nullopt;
    return exact::end(gap) - origin;
  }
};

}  // namespace waywright::path

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle/dump_text.hpp"
#include "oracle/oracle_impl.hpp"

namespace waywright::oracle {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns, for the edge from each corner k of a triangle to the next corner, where the position lies: 1 inside, 0 on
/// the edge's line, -1 outside.
std::array<int, 3> orientations_of(const Arrangement& arrangement, const Triangle& t, const ExactPosition& position) {
  const auto& v = arrangement.vertices;
  std::array<int, 3> orientations{};
  for (std::size_t k = 0; k < 3; ++k) orientations[k] = orientation(v[t[k]], v[t[(k + 1) % 3]], position);
  return orientations;
}

bool touches(const std::array<int, 3>& orientations) {
  return orientations[0] >= 0 && orientations[1] >= 0 && orientations[2] >= 0;
}

OracleLocation location_of(const Arrangement& arrangement, const std::vector<Triangle>& triangles,
                           const ExactPosition& p) {
  for (const Triangle& t : triangles) {
    const std::array<int, 3> orientations = orientations_of(arrangement, t, p);
    if (!touches(orientations)) continue;
    std::vector<std::uint32_t> corners(t.begin(), t.end());
    for (std::size_t k = 0; k < 3; ++k) {
      // A position on an edge is not at the opposite corner.
      if (orientations[k] == 0) std::erase(corners, t[(k + 2) % 3]);
    }
    if (corners.size() == 2) std::sort(corners.begin(), corners.end());
    OracleLocation location{static_cast<OracleLocation::Kind>(corners.size() - 1), {}};
    for (const std::uint32_t corner : corners) location.vertices.push_back(arrangement.near_vertices[corner]);
    return location;
  }
  return {};
}

bool is_free(const std::vector<Solid>& solids, const Arrangement& arrangement, const Triangle& t) {
  const auto& v = arrangement.vertices;
  const ExactPosition inner = Grid::midpoint(v[t[0]], Grid::midpoint(v[t[1]], v[t[2]]));
  return std::none_of(solids.begin(), solids.end(),
                      [&](const Solid& solid) { return relation_to_rings(solid, inner).inside_after; });
}

/// Returns the triangles across the edges of each triangle, -1 across walls.
std::vector<std::array<int, 3>> neighbours_of(const Arrangement& arrangement, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> across;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      across[{triangles[i][(k + 1) % 3], triangles[i][k]}] = static_cast<int>(i);
    }
  }
  for (const OracleConstraint& constraint : arrangement.constraints) {
    across.erase({constraint.from, constraint.to});
    across.erase({constraint.to, constraint.from});
  }
  std::vector<std::array<int, 3>> neighbours;
  for (const Triangle& t : triangles) {
    std::array<int, 3>& own = neighbours.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = across.find({t[k], t[(k + 1) % 3]});
      own[k] = found == across.end() ? -1 : found->second;
    }
  }
  return neighbours;
}

}  // namespace

std::vector<OracleLocation> Oracle::locate(std::string_view text, const std::vector<OraclePoint>& points) const {
  std::string fault;
  const auto dump = read_dump(text, fault);
  std::vector<OracleLocation> locations;
  for (const OraclePoint& p : points) {
    locations.push_back(location_of(impl_->arrangement, dump->triangles, impl_->arrangement.grid.point(p)));
  }
  return locations;
}

bool Oracle::connected(std::string_view text, OraclePoint from, OraclePoint to) const {
  if (from == to) return true;
  std::string fault;
  const auto dump = read_dump(text, fault);
  const Arrangement& arrangement = impl_->arrangement;
  const ExactPosition start = arrangement.grid.point(from);
  const ExactPosition goal = arrangement.grid.point(to);
  const auto neighbours = neighbours_of(arrangement, dump->triangles);
  std::vector<bool> seen(dump->triangles.size(), false);
  std::vector<std::size_t> open;
  const auto enter = [&](std::size_t i) {
    if (seen[i]) return;
    seen[i] = true;
    if (is_free(impl_->solids, arrangement, dump->triangles[i])) open.push_back(i);
  };
  for (std::size_t i = 0; i < dump->triangles.size(); ++i) {
    if (touches(orientations_of(arrangement, dump->triangles[i], start))) enter(i);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (touches(orientations_of(arrangement, dump->triangles[i], goal))) return true;
    for (const int neighbour : neighbours[i]) {
      if (neighbour >= 0) enter(static_cast<std::size_t>(neighbour));
    }
  }
  return false;
}

}  // namespace waywright::oracle

#include "oracle/first_wall.hpp"

#include <algorithm>
#include <utility>

#include "oracle/arrangement.hpp"

namespace waywright::oracle {
namespace {

/// Returns the points where a segment meets a wall. If the segment overlaps the wall, returns the two ends of the
/// overlap.
std::vector<ExactPosition> meetings(const Grid& grid, const Wall& wall, const ExactPosition& from,
                                    const ExactPosition& to) {
  const ExactPosition& a = wall.exact_a;
  const ExactPosition& b = wall.exact_b;
  if (cross_properly(a, b, from, to)) return {grid.crossing(a, b, from, to)};
  std::vector<ExactPosition> positions;
  for (const ExactPosition* end : {&from, &to}) {
    if (on_segment(a, b, *end)) positions.push_back(*end);
  }
  for (const ExactPosition* end : {&a, &b}) {
    if (on_segment(from, to, *end)) positions.push_back(*end);
  }
  return positions;
}

OracleHit first_wall(const Arrangement& arrangement, const OracleRay& ray) {
  const ExactPosition from = arrangement.grid.point(ray.from);
  const ExactPosition to = arrangement.grid.point(ray.to);
  const bool forward = compare_xy(from, to) <= 0;
  std::vector<ExactPosition> positions;
  for (const Wall& wall : arrangement.walls) {
    for (ExactPosition& position : meetings(arrangement.grid, wall, from, to)) positions.push_back(std::move(position));
  }
  if (positions.empty()) return {};
  const ExactPosition& first = *std::min_element(positions.begin(), positions.end(), [&](const auto& a, const auto& b) {
    return forward ? compare_xy(a, b) < 0 : compare_xy(a, b) > 0;
  });
  OracleHit result{true, arrangement.grid.nearest(first), {}};
  for (const Wall& wall : arrangement.walls) {
    if (!on_segment(wall.exact_a, wall.exact_b, first)) continue;
    result.ids.insert(result.ids.end(), wall.ids.begin(), wall.ids.end());
  }
  std::sort(result.ids.begin(), result.ids.end());
  result.ids.erase(std::unique(result.ids.begin(), result.ids.end()), result.ids.end());
  return result;
}

}  // namespace

std::vector<OracleHit> first_walls(OracleScene scene, const std::vector<OracleRay>& rays) {
  // The scene contains the ends of the rays as points, so the grid contains them all.
  for (const OracleRay& ray : rays) scene.items.push_back({0, OracleKind::polyline, {{ray.from}, {ray.to}}});
  const Arrangement arrangement(scene);
  std::vector<OracleHit> hits;
  for (const OracleRay& ray : rays) hits.push_back(first_wall(arrangement, ray));
  return hits;
}

}  // namespace waywright::oracle

#include "oracle/arrangement.hpp"

#include <algorithm>
#include <tuple>

namespace waywright::oracle {
namespace {

std::vector<OraclePoint> all_corners(const OracleScene& scene) {
  std::vector<OraclePoint> corners;
  for (const OraclePoint& p : corners_of(scene.domain)) corners.push_back(without_negative_zero(p));
  for (const OracleItem& item : scene.items) {
    for (const auto& ring : item.rings) {
      for (const OraclePoint& p : ring) corners.push_back(without_negative_zero(p));
    }
  }
  const auto by_xy = [](const OraclePoint& p, const OraclePoint& q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); };
  std::sort(corners.begin(), corners.end(), by_xy);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

std::array<OraclePoint, 4> corners_of(const OracleBox& domain) {
  return {domain.min, {domain.max.x, domain.min.y}, domain.max, {domain.min.x, domain.max.y}};
}

OraclePoint without_negative_zero(OraclePoint p) { return {p.x + 0.0, p.y + 0.0}; }

Arrangement::Arrangement(const OracleScene& scene) {
  const std::vector<OraclePoint> corners = all_corners(scene);
  grid = Grid(corners);
  collect_walls(scene);
  merge_vertices(corners, find_crossings());
  for (Wall& wall : walls) find_vertices_on(wall);
  collect_constraints();
}

void Arrangement::collect_walls(const OracleScene& scene) {
  using Side = std::tuple<double, double, double, double, std::uint64_t>;
  std::vector<Side> sides;
  const auto add = [&](OraclePoint p, OraclePoint q, std::uint64_t id) {
    const OraclePoint a = without_negative_zero(p);
    const OraclePoint b = without_negative_zero(q);
    if (a == b) return;
    const auto forward = std::tie(a.x, a.y) < std::tie(b.x, b.y);
    sides.push_back(forward ? Side{a.x, a.y, b.x, b.y, id} : Side{b.x, b.y, a.x, a.y, id});
  };
  const auto box = corners_of(scene.domain);
  for (std::size_t i = 0; i < 4; ++i) add(box[i], box[(i + 1) % 4], 0);
  for (const OracleItem& item : scene.items) {
    for (const auto& ring : item.rings) {
      for (std::size_t i = 1; i < ring.size(); ++i) add(ring[i - 1], ring[i], item.id);
      if (item.kind == OracleKind::polygon) add(ring.back(), ring.front(), item.id);
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  for (const auto& [ax, ay, bx, by, id] : sides) {
    const OraclePoint a{ax, ay};
    const OraclePoint b{bx, by};
    if (walls.empty() || walls.back().a != a || walls.back().b != b) {
      walls.push_back({a, b, grid.point(a), grid.point(b), {}, {}});
    }
    walls.back().ids.push_back(id);
  }
}

// Walls are sorted by the x of their left ends, so a wall meets no wall that starts to the right of its right end.
std::vector<Arrangement::Crossing> Arrangement::find_crossings() const {
  std::vector<Crossing> crossings;
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    const Wall& first = walls[i];
    const auto [first_low, first_high] = std::minmax(first.a.y, first.b.y);
    for (std::uint32_t j = i + 1; j < walls.size() && walls[j].a.x <= first.b.x; ++j) {
      const Wall& second = walls[j];
      const auto [second_low, second_high] = std::minmax(second.a.y, second.b.y);
      if (second_high < first_low || first_high < second_low) continue;
      if (!cross_properly(first.exact_a, first.exact_b, second.exact_a, second.exact_b)) continue;
      crossings.push_back({i, j, grid.crossing(first.exact_a, first.exact_b, second.exact_a, second.exact_b)});
    }
  }
  return crossings;
}

void Arrangement::merge_vertices(const std::vector<OraclePoint>& corners, std::vector<Crossing> crossings) {
  std::vector<ExactPosition> positions;
  for (const OraclePoint& p : corners) positions.push_back(grid.point(p));
  for (Crossing& crossing : crossings) positions.push_back(std::move(crossing.at));
  std::vector<std::uint32_t> order(positions.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const int sign = compare_xy(positions[i], positions[j]);
    return sign != 0 ? sign < 0 : i < j;
  });
  std::vector<std::uint32_t> vertex_of(positions.size());
  for (const std::uint32_t i : order) {
    if (vertices.empty() || compare_xy(vertices.back(), positions[i]) != 0) {
      near_vertices.push_back(grid.nearest(positions[i]));
      vertices.push_back(positions[i]);
      if (i >= corners.size()) ++crossing_count;
    }
    vertex_of[i] = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const std::uint32_t vertex = vertex_of[corners.size() + i];
    walls[crossings[i].first_wall].vertices.push_back(vertex);
    walls[crossings[i].second_wall].vertices.push_back(vertex);
  }
}

std::pair<std::size_t, std::size_t> Arrangement::vertices_between(double min_x, double max_x) const {
  // Rounding keeps the order, so the nearest doubles are sorted by x too. A vertex just outside the range may round
  // into it.
  const auto first = std::lower_bound(near_vertices.begin(), near_vertices.end(), min_x,
                                      [](const OraclePoint& p, double x) { return p.x < x; });
  const auto last = std::upper_bound(near_vertices.begin(), near_vertices.end(), max_x,
                                     [](double x, const OraclePoint& p) { return x < p.x; });
  return {static_cast<std::size_t>(first - near_vertices.begin()),
          static_cast<std::size_t>(last - near_vertices.begin())};
}

void Arrangement::find_vertices_on(Wall& wall) const {
  std::vector<std::uint32_t> known = std::move(wall.vertices);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  wall.vertices.clear();
  auto next_known = known.begin();
  const auto [first, last] = vertices_between(wall.a.x, wall.b.x);
  for (std::size_t i = first; i < last; ++i) {
    const bool is_known = next_known != known.end() && *next_known == i;
    if (is_known) ++next_known;
    if (is_known || on_segment(wall.exact_a, wall.exact_b, vertices[i])) {
      wall.vertices.push_back(static_cast<std::uint32_t>(i));
    }
  }
}

void Arrangement::collect_constraints() {
  using Piece = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>;
  std::vector<Piece> pieces;
  for (const Wall& wall : walls) {
    // Along a segment, the vertices come in (x, y) order, which is the order of their indices.
    for (std::size_t i = 1; i < wall.vertices.size(); ++i) {
      for (const std::uint64_t id : wall.ids) pieces.push_back({wall.vertices[i - 1], wall.vertices[i], id});
    }
  }
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  for (const auto& [from, to, id] : pieces) {
    if (constraints.empty() || constraints.back().from != from || constraints.back().to != to) {
      constraints.push_back({from, to, {}});
    }
    constraints.back().ids.push_back(id);
  }
}

}  // namespace waywright::oracle

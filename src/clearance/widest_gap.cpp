#include "clearance/widest_gap.hpp"

#include "clearance/bridge_items.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

void WidestGapFinder::find(const constraint::ExactTriangulation& triangulation, const Bridges& bridges,
                           NearWalls& near_walls, const Point& start, const Point& goal, WidestGap& result) {
  result.clear();
  const auto start_cell = near_walls.find_cell(triangulation, bridges, start);
  if (!start_cell) return;
  const auto goal_cell = near_walls.find_cell(triangulation, bridges, goal);
  if (!goal_cell) return;
  write_gap(triangulation, bridges, search_.find(Cells(triangulation, bridges), *start_cell, *goal_cell), result);
}

void write_gap(const constraint::ExactTriangulation& triangulation, const Bridges& bridges, const Narrowest& narrowest,
               WidestGap& result) {
  result.clear();
  const Cells cells(triangulation, bridges);
  result.is_connected = narrowest.is_connected;
  if (!narrowest.gate) return;
  const CellEdge& gate = *narrowest.gate;
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Gap gap = cells.canonical_gap(gate);
  result.is_limited = true;
  result.radius = exact::largest_radius(gap);
  result.from = gap.from;
  result.to = exact::end_of(gap);
  const bool starts_at_origin =
      gap.from == triangulation.triangulation().geometry().rounded(number(mesh.origin(gate.h)));
  const mesh::Vertex from = starts_at_origin ? mesh.origin(gate.h) : mesh.target(gate.h);
  const mesh::Vertex to = starts_at_origin ? mesh.target(gate.h) : mesh.origin(gate.h);
  const auto add_to = [&](std::uint32_t slot) { result.to_items.push_back(slot); };
  for_each_item_at(triangulation, from, [&](std::uint32_t slot) { result.from_items.push_back(slot); });
  if (gate.kind == CellEdge::Kind::bridge) {
    for_each_item_at(triangulation, to, add_to);
  } else {
    for_each_item_on(triangulation, bridges.wall_of(gate.foot), add_to);
  }
}

}  // namespace waywright::clearance

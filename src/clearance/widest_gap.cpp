#include "clearance/widest_gap.hpp"

#include "exact/gap.hpp"

namespace waywright::clearance {

using mesh::HalfEdge;
using mesh::Vertex;

namespace {

using Slots = std::vector<std::uint32_t>;

void append_items_on(const constraint::ExactTriangulation& triangulation, HalfEdge wall, Slots& slots) {
  triangulation.for_each_side(wall, [&](const constraint::Side& side) { slots.push_back(side.item); });
}

void append_items_at(const constraint::ExactTriangulation& triangulation, Vertex v, Slots& slots) {
  triangulation.topology().for_each_outgoing(v, [&](HalfEdge h) {
    if (triangulation.topology().is_fixed(h)) append_items_on(triangulation, h, slots);
  });
}

}  // namespace

void WidestGapFinder::find(const constraint::ExactTriangulation& triangulation, const Bridges& bridges,
                           NearWalls& near_walls, const Point& start, const Point& goal, WidestGap& result) {
  result.clear();
  const auto start_cell = near_walls.find_cell(triangulation, bridges, start);
  if (!start_cell) return;
  const auto goal_cell = near_walls.find_cell(triangulation, bridges, goal);
  if (!goal_cell) return;
  const Cells cells(triangulation, bridges);
  const Narrowest narrowest = search_.find(cells, *start_cell, *goal_cell);
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
  append_items_at(triangulation, starts_at_origin ? mesh.origin(gate.h) : mesh.target(gate.h), result.from_items);
  if (gate.kind == CellEdge::Kind::bridge) {
    append_items_at(triangulation, starts_at_origin ? mesh.target(gate.h) : mesh.origin(gate.h), result.to_items);
  } else {
    append_items_on(triangulation, bridges.foot(gate.foot).wall, result.to_items);
  }
}

}  // namespace waywright::clearance

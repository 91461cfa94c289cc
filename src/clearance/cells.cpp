#include "clearance/cells.hpp"

#include <tuple>
#include <utility>

namespace waywright::clearance {

using mesh::HalfEdge;
using mesh::Vertex;
using Kind = CellEdge::Kind;

CellEdge Cells::next(const CellEdge& edge) const {
  switch (edge.kind) {
    case Kind::bridge:
      return next_at_corner(mesh::next(edge.h));
    case Kind::foot_down:
      return {Kind::wall, bridges_.wall_of(edge.foot), edge.foot};
    case Kind::foot_up:
      return first_clockwise(edge.h);
    case Kind::wall:
      break;
  }
  const std::uint32_t foot =
      edge.foot == Bridges::kNone ? bridges_.first_foot_on(edge.h) : bridges_.next_foot(edge.foot);
  if (foot != Bridges::kNone) return {Kind::foot_up, bridges_.corner_of(foot), foot};
  return next_at_corner(mesh::next(edge.h));
}

/// The border has reached the origin of `corner`, along the other edge of this corner. Clockwise from there come the
/// foot bridge in the corner, if there is one, and then the edge of `corner` itself.
CellEdge Cells::next_at_corner(HalfEdge corner) const {
  if (const std::uint32_t foot = bridges_.foot_at(corner); foot != Bridges::kNone)
    return {Kind::foot_down, corner, foot};
  return first_clockwise(corner);
}

CellEdge Cells::first_clockwise(HalfEdge h) const {
  for (;;) {
    if (mesh_.is_fixed(h)) return {Kind::wall, h, Bridges::kNone};
    if (bridges_.is_bridge(h)) return {Kind::bridge, h, Bridges::kNone};
    h = mesh_.previous_around(h);
    if (const std::uint32_t foot = bridges_.foot_at(h); foot != Bridges::kNone) return {Kind::foot_down, h, foot};
  }
}

CellEdge Cells::across(const CellEdge& gate) const {
  if (gate.kind == Kind::bridge) return {Kind::bridge, mesh_.twin(gate.h), gate.foot};
  return {gate.kind == Kind::foot_down ? Kind::foot_up : Kind::foot_down, gate.h, gate.foot};
}

Vertex Cells::origin(const CellEdge& edge) const {
  const bool starts_at_foot = edge.kind == Kind::foot_up || (edge.kind == Kind::wall && edge.foot != Bridges::kNone);
  return starts_at_foot ? mesh::kNoVertex : mesh_.origin(edge.h);
}

exact::Gap Cells::gap(const CellEdge& gate) const {
  const exact::Geometry& geometry = triangulation_.triangulation().geometry();
  const auto position_of = [&](Vertex v) { return geometry.rounded(number(v)); };
  const Point& from = position_of(mesh_.origin(gate.h));
  if (gate.kind == Kind::bridge) return {from, position_of(mesh_.target(gate.h)), position_of(mesh_.target(gate.h))};
  const constraint::Side& side = triangulation_.any_side(bridges_.wall_of(gate.foot));
  return {from, position_of(side.from), position_of(side.to)};
}

exact::Gap Cells::canonical_gap(const CellEdge& gate) const {
  const auto comes_before = [](const Point& p, const Point& q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); };
  exact::Gap result = gap(gate);
  if (gate.kind == Kind::bridge) {
    if (comes_before(result.a, result.from)) std::swap(result.from, result.a);
    result.b = result.a;
    return result;
  }
  const exact::Geometry& geometry = triangulation_.triangulation().geometry();
  bool is_first = true;
  triangulation_.for_each_side(bridges_.wall_of(gate.foot), [&](const constraint::Side& side) {
    Point a = geometry.rounded(number(side.from));
    Point b = geometry.rounded(number(side.to));
    if (comes_before(b, a)) std::swap(a, b);
    const bool is_better = is_first || comes_before(a, result.a) || (a == result.a && comes_before(b, result.b));
    if (!is_better) return;
    result.a = a;
    result.b = b;
    is_first = false;
  });
  return result;
}

// Bridges are no walls, so the half-edges of both can share one range of numbers.
std::uint32_t Cells::key(const CellEdge& edge) const {
  if (edge.foot == Bridges::kNone) return number(edge.h);
  return 3 * mesh_.face_slots() + 2 * edge.foot + (edge.kind == Kind::foot_up ? 1 : 0);
}

}  // namespace waywright::clearance

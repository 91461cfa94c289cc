#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;

double BridgeFinder::largest_rounding(const Box& domain) {
  return 0x1p-52 *
         std::max({std::abs(domain.min.x), std::abs(domain.min.y), std::abs(domain.max.x), std::abs(domain.max.y)});
}

Gap BridgeFinder::gap_to_wall(HalfEdge corner, HalfEdge wall) const {
  const constraint::Side& side = triangulation_.any_side(wall);
  return {position_of(mesh_.origin(corner)), position_of(side.from), position_of(side.to)};
}

// If the circle contains an end of the border edge, the test is a sign. Both cases are frequent.
bool BridgeFinder::may_circle_meet(HalfEdge h, HalfEdge border) const {
  const Vertex p = mesh_.origin(border);
  const Vertex q = mesh_.target(border);
  for (const HalfEdge at : {h, mesh::next(h), mesh::previous(h)}) {
    const Vertex v = mesh_.origin(at);
    if (v != p && v != q) continue;
    return circle_of(at).may_enter(position_of(v == p ? q : p), rounding_);
  }
  return may_touch(circle_of(h), border);
}

bool BridgeFinder::may_disc_meet(HalfEdge h, HalfEdge border) const {
  const Vertex p = mesh_.origin(border);
  const Vertex q = mesh_.target(border);
  const Vertex u = mesh_.origin(h);
  const Vertex v = mesh_.target(h);
  if (u == p || u == q) return !is_not_acute(v, u, u == p ? q : p);
  if (v == p || v == q) return !is_not_acute(u, v, v == p ? q : p);
  const Point& to = position_of(v);
  return may_touch(Disc::of_edge(position_of(u), to, rounding_), border);
}

// If the apex of a face lies in the closed disc, a wall does, too, because every vertex is the end of a wall. This test
// rejects nearly all edges that are no bridges.
bool BridgeFinder::is_bridge(HalfEdge h) {
  const Vertex u = mesh_.origin(h);
  const Vertex v = mesh_.target(h);
  if (!is_explicit(u) || !is_explicit(v)) return false;
  const HalfEdge twin = mesh_.twin(h);
  for (const HalfEdge at : {h, twin}) {
    const Vertex apex = mesh_.apex(at);
    const Point& p = position_of(apex);
    if (is_explicit(apex) && exact::dot(p, position_of(u), p, position_of(v)) != Sign::positive) return false;
  }
  const Gap gap = gap_along(h);
  const Candidate candidate{gap, u, v, Disc::of_gap(gap.from, gap.a, gap.b)};
  scratch_.to_enter.clear();
  scratch_.begin();
  (void)scratch_.visit(mesh::face(h));
  (void)scratch_.visit(mesh::face(twin));
  for (const HalfEdge at : {h, twin}) {
    if (!enter(candidate, mesh::next(at)) || !enter(candidate, mesh::previous(at))) return false;
  }
  return is_clear(candidate);
}

// Let w be the origin of `corner`, and x and y the other two vertices of its face. The disc of a bridge from w to a
// foot f contains x exactly if the angle at x between w and f is at least 90 degrees. x is the end of a wall, so this
// angle is acute, and so is the angle at y. Hence f lies on w's side of two lines: of the line through x that is
// perpendicular to the edge from w to x, and of the line through y that is perpendicular to the edge from w to y. f
// also lies beyond the edge from x to y. If the angle of the face at x or at y is not acute, no position satisfies all
// three conditions. Otherwise, these positions are a triangle: its corners are x, y and the position opposite to w on
// the circle through w, x and y, because both lines meet there. So f lies in that circle, too.
//
// The segment from w to f lies in the angle of the face at w. Beyond the edge from x to y, it lies in the triangle. So
// the search crosses only edges that meet the triangle and that are visible from w. It leaves out an edge if both ends
// lie beyond one of the two lines, or if the edge does not meet the circle.
HalfEdge BridgeFinder::find_wall(HalfEdge corner) {
  const Vertex w = mesh_.origin(corner);
  if (!may_have_foot(corner) || !is_explicit(w)) return mesh::kNoHalfEdge;
  const HalfEdge opposite = mesh::next(corner);
  if (mesh_.is_fixed(opposite)) return is_bridge_to(corner, opposite) ? opposite : mesh::kNoHalfEdge;
  const Vertex x = mesh_.origin(opposite);
  const Vertex y = mesh_.target(opposite);
  std::optional<Disc> circle;
  const auto may_cross = [&](HalfEdge exit) {
    const Vertex p = mesh_.origin(exit);
    const Vertex q = mesh_.target(exit);
    // x and y lie on their own lines.
    if ((p == x || is_not_acute(w, x, p)) && (q == x || is_not_acute(w, x, q))) return false;
    if ((p == y || is_not_acute(w, y, p)) && (q == y || is_not_acute(w, y, q))) return false;
    if (!circle) circle = circle_of(corner);
    return may_touch(*circle, exit);
  };
  auto& to_cross = scratch_.to_cross;
  to_cross.assign({{mesh_.twin(opposite), y, x}});
  while (!to_cross.empty()) {
    const BridgeScratch::View view = to_cross.back();
    to_cross.pop_back();
    const HalfEdge left_exit = mesh::previous(view.entry);
    const HalfEdge right_exit = mesh::next(view.entry);
    const bool may_exit_left = may_cross(left_exit);
    const bool may_exit_right = may_cross(right_exit);
    if (!may_exit_left && !may_exit_right) continue;
    const Vertex apex = mesh_.apex(view.entry);
    const bool sees_left = side(w, view.left, apex) == Sign::negative;
    const bool sees_right = side(w, view.right, apex) == Sign::positive;
    const auto look = [&](HalfEdge exit, Vertex left, Vertex right) {
      if (mesh_.is_fixed(exit)) return is_bridge_to(corner, exit);
      to_cross.push_back({mesh_.twin(exit), left, right});
      return false;
    };
    if (may_exit_left && sees_left && look(left_exit, view.left, sees_right ? apex : view.right)) return left_exit;
    if (may_exit_right && sees_right && look(right_exit, sees_left ? apex : view.left, view.right)) return right_exit;
  }
  return mesh::kNoHalfEdge;
}

bool BridgeFinder::is_bridge_to(HalfEdge corner, HalfEdge wall) {
  const Gap gap = gap_to_wall(corner, wall);
  if (!has_foot_on(gap, corner, wall)) return false;
  const Candidate candidate{gap, mesh_.origin(corner), mesh::kNoVertex, Disc::of_gap(gap.from, gap.a, gap.b)};
  const HalfEdge opposite = mesh::next(corner);
  if (is_blocked_by(candidate, mesh_.origin(opposite)) || is_blocked_by(candidate, mesh_.target(opposite)))
    return false;
  scratch_.to_enter.clear();
  scratch_.begin();
  (void)scratch_.visit(mesh::face(corner));
  return enter(candidate, corner) && enter(candidate, opposite) && enter(candidate, mesh::previous(corner)) &&
         is_clear(candidate);
}

Sign BridgeFinder::side_of_foot(const Gap& gap, Vertex v) const {
  return exact::dot(gap.from, geometry_.exact(number(v)), gap.a, gap.b);
}

/// Returns whether the foot lies strictly inside the wall, and the gap leaves the face of `corner` through the edge
/// from x to y that is opposite to the corner's origin w. The wall has w on its left. Consider the line of the gap: the
/// wall's origin and x lie left of it, and the wall's target and y right of it, or the reverse.
bool BridgeFinder::has_foot_on(const Gap& gap, HalfEdge corner, HalfEdge wall) const {
  const Sign sign = side_of_foot(gap, mesh_.origin(wall));
  return sign != Sign::zero && side_of_foot(gap, mesh_.target(wall)) == -sign &&
         side_of_foot(gap, mesh_.target(corner)) == sign && side_of_foot(gap, mesh_.apex(corner)) == -sign;
}

/// Returns whether the closed disc of the gap touches the wall elsewhere than at the ends of the gap. It tests a whole
/// side that lies on the wall: then all points are explicit, and if another piece of the side touches the disc, the gap
/// is no bridge either.
bool BridgeFinder::is_blocked_by(const Gap& gap, HalfEdge wall) const {
  const constraint::Side& side = triangulation_.any_side(wall);
  return exact::touches(gap, position_of(side.from), position_of(side.to));
}

/// Returns whether no wall in the faces that the search enters, and in the faces beyond, touches the closed disc. The
/// search starts with the half-edges in `to_enter`.
bool BridgeFinder::is_clear(const Candidate& candidate) {
  auto& to_enter = scratch_.to_enter;
  while (!to_enter.empty()) {
    const HalfEdge h = to_enter.back();
    to_enter.pop_back();
    if (!scratch_.visit(mesh::face(h))) continue;
    if (is_blocked_by(candidate, mesh_.apex(h))) return false;
    if (!enter(candidate, mesh::next(h)) || !enter(candidate, mesh::previous(h))) return false;
  }
  return true;
}

/// Looks at an edge of a face that the search has entered. Returns false if it is a wall that touches the closed disc.
bool BridgeFinder::enter(const Candidate& candidate, HalfEdge h) {
  if (!may_enter(candidate, h)) return true;
  if (mesh_.is_fixed(h)) return !is_blocked_by(candidate.gap, h);
  scratch_.to_enter.push_back(mesh_.twin(h));
  return true;
}

/// Returns false only if no position of the edge lies in the closed disc, except an end of the candidate. An edge that
/// starts at an end of the candidate contains a position strictly inside the disc, or no other position of the disc.
bool BridgeFinder::may_enter(const Candidate& candidate, HalfEdge h) const {
  const Vertex p = mesh_.origin(h);
  const Vertex q = mesh_.target(h);
  if (p == candidate.from || q == candidate.from) {
    return candidate.disc.may_enter(position_of(p == candidate.from ? q : p), rounding_);
  }
  if (p == candidate.to) return !is_not_acute(candidate.from, p, q);
  if (q == candidate.to) return !is_not_acute(candidate.from, q, p);
  return may_touch(candidate.disc, h);
}

}  // namespace waywright::clearance

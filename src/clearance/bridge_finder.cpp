#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <cmath>

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;
using Seen = BridgeScratch::Seen;
using View = BridgeScratch::View;

Gap BridgeFinder::gap_to_wall(HalfEdge corner, HalfEdge wall) const {
  const constraint::Side& side = triangulation_.any_side(wall);
  return {position_of(mesh_.origin(corner)), position_of(side.from), position_of(side.to)};
}

// Often the face of `h` and the edge `border` have a vertex in common. Then the circle passes through an end of
// `border`, and the sign of one dot product is the answer.
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
  return may_touch(disc_of(h), border);
}

// If the apex of a face lies in the closed disc, a wall does, too, because every vertex is the end of a wall. This test
// rejects nearly all edges that are no bridges.
bool BridgeFinder::is_bridge(HalfEdge h) {
  const Vertex u = mesh_.origin(h);
  const Vertex v = mesh_.target(h);
  if (!is_explicit(u) || !is_explicit(v)) return false;
  const HalfEdge twin = mesh_.twin(h);
  const Vertex left = mesh_.apex(h);
  const Vertex right = mesh_.apex(twin);
  const bool contains_left = is_not_acute(u, left, v);
  const bool contains_right = is_not_acute(u, right, v);
  if (contains_left | contains_right) return false;
  for (const Vertex apex : {left, right}) {
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

// Let w be the origin of `corner`, and f the foot of a bridge from w. The disc of the bridge contains a vertex v
// exactly if the angle at v between w and f is at least 90 degrees. Each vertex is the end of a wall, so the disc
// contains no vertex except w, and this angle is acute for every other vertex v: the line through v that is
// perpendicular to the segment from w to v does not separate f from w.
//
// Let the bridge cross an edge from p to q, or end on it. As seen from w, f lies between p and q, and on the edge or
// beyond. If the angle at p between w and q is not acute, then the line through p separates f from w. So the angles at
// p and q are acute. The search crosses only such edges. They are visible from w, and the first one is the edge from x
// to y that is opposite to the corner. The search also leaves out an edge if both ends lie beyond the line through x,
// or both beyond the line through y. The two lines meet on the circle through w, x and y, at the position opposite to
// w. So the search does not leave this circle.
HalfEdge BridgeFinder::find_wall(HalfEdge corner) {
  const Vertex w = mesh_.origin(corner);
  if (!may_have_foot(corner) || !is_explicit(w)) return mesh::kNoHalfEdge;
  const HalfEdge opposite = mesh::next(corner);
  if (mesh_.is_fixed(opposite)) return is_bridge_to(corner, opposite) ? opposite : mesh::kNoHalfEdge;
  const Seen x = seen_from(position_of(w), mesh_.origin(opposite));
  const Seen y = seen_from(position_of(w), mesh_.target(opposite));
  scratch_.to_cross.clear();
  View view{mesh_.twin(opposite), mesh_.target(opposite), mesh_.origin(opposite), y, x};
  for (;;) {
    const HalfEdge wall = cross(corner, x, y, view);
    if (wall != mesh::kNoHalfEdge) return wall;
    if (view.entry != mesh::kNoHalfEdge) continue;
    if (scratch_.to_cross.empty()) return mesh::kNoHalfEdge;
    view = scratch_.to_cross.back();
    scratch_.to_cross.pop_back();
  }
}

/// Looks at the two edges beyond the view. Returns the first one that is the wall, or kNoHalfEdge. Replaces the view by
/// the view through an edge that a bridge may cross, or sets its `entry` to kNoHalfEdge. If both edges may be crossed,
/// stores the second view in `to_cross`. The operators & and | avoid branches that are hard to predict.
HalfEdge BridgeFinder::cross(HalfEdge corner, const Seen& x, const Seen& y, View& view) {
  const Vertex w = mesh_.origin(corner);
  const Vertex apex = mesh_.apex(view.entry);
  Seen seen = seen_from(position_of(w), apex);
  seen.beyond = std::uint32_t{is_not_acute(x, seen)} | std::uint32_t{is_not_acute(y, seen)} << 1;
  const bool may_cross_left = may_cross(seen, view.entry_left);
  const bool may_cross_right = may_cross(seen, view.entry_right);
  const HalfEdge left = mesh::previous(view.entry);
  const HalfEdge right = mesh::next(view.entry);
  view.entry = mesh::kNoHalfEdge;
  if (!(may_cross_left | may_cross_right)) return mesh::kNoHalfEdge;
  const bool sees_left = orientation(w, view.left, apex) == Sign::negative;
  const bool sees_right = orientation(w, view.right, apex) == Sign::positive;
  const bool is_left_wall = may_cross_left && sees_left && mesh_.is_fixed(left);
  const bool is_right_wall = may_cross_right && sees_right && mesh_.is_fixed(right);
  if (is_left_wall && is_bridge_to(corner, left)) return left;
  if (is_right_wall && is_bridge_to(corner, right)) return right;
  const bool crosses_left = may_cross_left && sees_left && !is_left_wall;
  const bool crosses_right = may_cross_right && sees_right && !is_right_wall;
  const Vertex middle_left = sees_left ? apex : view.left;
  const Vertex middle_right = sees_right ? apex : view.right;
  if (crosses_left) {
    if (crosses_right) {
      scratch_.to_cross.push_back({mesh_.twin(right), middle_left, view.right, seen, view.entry_right});
    }
    view = {mesh_.twin(left), view.left, middle_right, view.entry_left, seen};
  } else if (crosses_right) {
    view = {mesh_.twin(right), middle_left, view.right, seen, view.entry_right};
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

// A constructed vertex lies strictly inside both of its sides. If one of these sides ends at the start of the gap, the
// other end of this side gives the same sign, and needs no integers. In worlds of rectangles, this is frequent.
Sign BridgeFinder::side_of_foot(const Gap& gap, Vertex v) const {
  const exact::ExactPoint point = geometry_.exact(number(v));
  if (!point.is_explicit()) {
    for (const exact::PointPair* const line : {point.ab, point.cd}) {
      if (gap.from == line->a) return exact::dot(gap.from, line->b, gap.a, gap.b);
      if (gap.from == line->b) return exact::dot(gap.from, line->a, gap.a, gap.b);
    }
  }
  return exact::dot(gap.from, point, gap.a, gap.b);
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
  const Vertex p = mesh_.origin(h);
  const Vertex q = mesh_.target(h);
  if (p == candidate.from || p == candidate.to) return enter_at_end(candidate, h, p, q);
  if (q == candidate.from || q == candidate.to) return enter_at_end(candidate, h, q, p);
  return !may_touch(candidate.disc, h) || enter_untested(candidate, h);
}

/// Looks at an edge from an end of the candidate to `v`. Such an edge contains a position strictly inside the disc, or
/// no position of the disc except the end.
bool BridgeFinder::enter_at_end(const Candidate& candidate, HalfEdge h, Vertex end, Vertex v) {
  if (candidate.to == mesh::kNoVertex || !is_explicit(v)) {
    return !candidate.may_enter_from(end, position_of(v), rounding_) || enter_untested(candidate, h);
  }
  const Point& from = position_of(end);
  const Point& to = end == candidate.from ? candidate.gap.a : candidate.gap.from;
  if (exact::dot(from, position_of(v), from, to) != Sign::positive) return true;
  if (mesh_.is_fixed(h)) return false;
  scratch_.to_enter.push_back(mesh_.twin(h));
  return true;
}

/// Does the same as enter(), without the test in doubles.
bool BridgeFinder::enter_untested(const Candidate& candidate, HalfEdge h) {
  if (mesh_.is_fixed(h)) return !is_blocked_by(candidate.gap, h);
  scratch_.to_enter.push_back(mesh_.twin(h));
  return true;
}

}  // namespace waywright::clearance

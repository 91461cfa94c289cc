#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <cmath>

#include "base/compiler.hpp"

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;
using Seen = BridgeScratch::Seen;
using VisibleEdge = BridgeScratch::VisibleEdge;
using Around = BridgeScratch::Around;
using Beyond = BridgeScratch::Beyond;

namespace {

/// Returns false only if the angle between two successive edges of a face is at least 90 degrees. `before` and `after`
/// are the vectors of the two edges, around the face: their dot product is negative if the angle is acute. Each
/// coordinate of a vertex may be wrong by `rounding`.
bool may_be_acute(const Point& before, const Point& after, double rounding) {
  const double x = before.x * after.x;
  const double y = before.y * after.y;
  if (x + y < 0.0) return true;
  const double extent = std::abs(before.x) + std::abs(before.y) + std::abs(after.x) + std::abs(after.y);
  return x + y < 0x1p-48 * (std::abs(x) + std::abs(y)) + 4.0 * rounding * (extent + 4.0 * rounding);
}

}  // namespace

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

/// Notes the face beyond an edge. Returns false if the edge is a wall that touches the closed disc.
WAYWRIGHT_ALWAYS_INLINE bool BridgeFinder::enter(const Candidate& candidate, HalfEdge h, const Around& origin,
                                                 const Around& target) {
  if (mesh_.is_fixed(h)) return !is_blocked_by(candidate.gap, h);
  scratch_.to_clear.push_back({mesh_.twin(h), target, origin});
  return true;
}

/// Looks at an edge, whose ends are `origin` and `target`, relative to the centre. Returns false if it is a wall that
/// touches the closed disc. An edge at an end of the candidate contains a position strictly inside the disc, or no
/// position of the disc except the end.
WAYWRIGHT_ALWAYS_INLINE bool BridgeFinder::is_clear_at(const Candidate& candidate, HalfEdge h, const Around& origin,
                                                       const Around& target) {
  const Vertex p = mesh_.origin(h);
  const Vertex q = mesh_.target(h);
  bool may_meet = false;
  if (p == candidate.from || p == candidate.to) {
    may_meet = candidate.may_enter_from(p, position_of(q), rounding_);
  } else if (q == candidate.from || q == candidate.to) {
    may_meet = candidate.may_enter_from(q, position_of(p), rounding_);
  } else {
    may_meet = may_touch(candidate, origin, target);
  }
  return !may_meet || enter(candidate, h, origin, target);
}

/// Looks at a face that the disc may meet. Returns false if its apex lies in the closed disc, or if one of the two
/// edges of the apex is a wall that touches the disc.
bool BridgeFinder::is_clear_in(const Candidate& candidate, const Beyond& beyond) {
  const HalfEdge h = beyond.entry;
  if (!scratch_.visit(mesh::face(h))) return true;
  const Vertex v = mesh_.apex(h);
  const Around apex = around(candidate, v);
  if (!(apex.square > candidate.limit) && is_blocked_by(candidate, v)) return false;
  return is_clear_at(candidate, mesh::next(h), beyond.target, apex) &&
         is_clear_at(candidate, mesh::previous(h), apex, beyond.origin);
}

void BridgeFinder::note_angles(mesh::Face f) {
  const HalfEdge h = mesh::first(f);
  const Point& a = position_of(mesh_.origin(h));
  const Point& b = position_of(mesh_.target(h));
  const Point& c = position_of(mesh_.apex(h));
  const Point ab = b - a;
  const Point bc = c - b;
  const Point ca = a - c;
  const unsigned acute = (may_be_acute(ca, ab, rounding_) ? 1U : 0U) | (may_be_acute(ab, bc, rounding_) ? 2U : 0U) |
                         (may_be_acute(bc, ca, rounding_) ? 4U : 0U);
  scratch_.acute[number(f)] = static_cast<std::uint8_t>(acute);
}

// If the apex of a face lies in the closed disc, the end of a wall lies in it, because every vertex is the end of a
// wall. This test rejects nearly all edges that are no bridges.
bool BridgeFinder::is_bridge(HalfEdge h) {
  const Vertex u = mesh_.origin(h);
  const Vertex v = mesh_.target(h);
  if (!is_explicit(u) || !is_explicit(v)) return false;
  const HalfEdge twin = mesh_.twin(h);
  for (const Vertex apex : {mesh_.apex(h), mesh_.apex(twin)}) {
    const Point& p = position_of(apex);
    const bool is_acute = is_explicit(apex) ? exact::dot(p, position_of(u), p, position_of(v)) == Sign::positive
                                            : !is_not_acute(u, apex, v);
    if (!is_acute) return false;
  }
  const Candidate candidate = candidate_of(gap_along(h), u, v);
  const Around at_u = around(candidate, u);
  const Around at_v = around(candidate, v);
  scratch_.to_clear.clear();
  scratch_.begin();
  return is_clear_in(candidate, {h, at_u, at_v}) && is_clear_in(candidate, {twin, at_v, at_u}) && is_clear(candidate);
}

// Let w be the origin of `corner`, and f the foot of a bridge from w. The disc of the bridge contains a vertex v
// exactly if the angle at v between w and f is at least 90 degrees. Each vertex is the end of a wall, so the disc
// contains no vertex except w, and this angle is acute for every other vertex v: the line through v that is
// perpendicular to the segment from w to v does not separate f from w.
//
// Let the bridge cross an edge from p to q, or end on it. Seen from w, f lies between p and q, and it lies on the edge
// or beyond the edge. If the angle at p between w and q is not acute, then the line through p separates f from w. So
// the angles at p and q are acute. The search crosses only such edges. They are visible from w, and the first one is
// the edge from x to y that is opposite to the corner. The search also leaves out an edge if both ends lie beyond the
// line through x, or both beyond the line through y. The two lines meet on the circle through w, x and y, at the
// position opposite to w. So the search does not leave this circle.
HalfEdge BridgeFinder::find_wall(HalfEdge corner) {
  const Vertex w = mesh_.origin(corner);
  if (!is_explicit(w)) return mesh::kNoHalfEdge;
  const HalfEdge opposite = mesh::next(corner);
  if (mesh_.is_fixed(opposite)) return is_bridge_to(corner, opposite) ? opposite : mesh::kNoHalfEdge;
  const Vertex x = mesh_.origin(opposite);
  const Vertex y = mesh_.target(opposite);
  const HalfEdge entry = mesh_.twin(opposite);
  const Vertex z = mesh_.apex(entry);
  const bool crosses_right = !is_not_acute(w, x, z);
  const bool crosses_left = !is_not_acute(w, y, z);
  if (!(crosses_left | crosses_right)) return mesh::kNoHalfEdge;
  const Point from = position_of(w);
  auto& seen = scratch_.seen;
  seen.clear();
  seen.push_back(seen_from(from, x));
  seen.push_back(seen_from(from, y));
  Seen apex = seen_from(from, z);
  apex.beyond = beyond_lines(apex);
  const bool sees_left = is_left_of(w, seen[1], apex);
  const bool sees_right = is_left_of(w, apex, seen[0]);
  const Choice first{crosses_left && sees_left, crosses_right && sees_right, sees_left, sees_right};
  scratch_.to_cross.clear();
  VisibleEdge visible{entry, 1, 0, 1, 0};
  for (HalfEdge wall = go_on(corner, apex, first, visible);; wall = cross(corner, from, visible)) {
    if (wall != mesh::kNoHalfEdge) return wall;
    if (visible.entry != mesh::kNoHalfEdge) continue;
    if (scratch_.to_cross.empty()) return mesh::kNoHalfEdge;
    visible = scratch_.to_cross.back();
    scratch_.to_cross.pop_back();
  }
}

/// Looks at the apex of the face beyond a visible edge. Returns the first of the two edges of the apex that is the
/// wall, or kNoHalfEdge. Replaces `visible` by one of these two edges, if a bridge may cross it. Otherwise sets its
/// `entry` to kNoHalfEdge.
WAYWRIGHT_ALWAYS_INLINE HalfEdge BridgeFinder::cross(HalfEdge corner, const Point& from, VisibleEdge& visible) {
  const auto& seen = scratch_.seen;
  Seen apex = seen_from(from, mesh_.apex(visible.entry));
  bool crosses_left = may_cross(apex, seen[visible.entry_left]);
  bool crosses_right = may_cross(apex, seen[visible.entry_right]);
  if (!(crosses_left | crosses_right)) {  // one branch that is easier to predict than two
    visible.entry = mesh::kNoHalfEdge;
    return mesh::kNoHalfEdge;
  }
  apex.beyond = beyond_lines(apex);
  const Vertex w = mesh_.origin(corner);
  const bool sees_left = is_left_of(w, seen[visible.left], apex);
  const bool sees_right = is_left_of(w, apex, seen[visible.right]);
  crosses_left = crosses_left && sees_left && (apex.beyond & seen[visible.entry_left].beyond) == 0;
  crosses_right = crosses_right && sees_right && (apex.beyond & seen[visible.entry_right].beyond) == 0;
  return go_on(corner, apex, {crosses_left, crosses_right, sees_left, sees_right}, visible);
}

/// Continues through the edges of the apex that `choice` names, as cross() describes. If there are two, stores the
/// second one in `to_cross`. find_wall() calls this function for the first face.
WAYWRIGHT_ALWAYS_INLINE HalfEdge BridgeFinder::go_on(HalfEdge corner, const Seen& apex, Choice choice,
                                                     VisibleEdge& visible) {
  const HalfEdge left = mesh::previous(visible.entry);
  const HalfEdge right = mesh::next(visible.entry);
  visible.entry = mesh::kNoHalfEdge;
  if (choice.crosses_left && mesh_.is_fixed(left)) {
    if (is_bridge_to(corner, left)) return left;
    choice.crosses_left = false;
  }
  if (choice.crosses_right && mesh_.is_fixed(right)) {
    if (is_bridge_to(corner, right)) return right;
    choice.crosses_right = false;
  }
  if (!choice.crosses_left && !choice.crosses_right) return mesh::kNoHalfEdge;
  const auto at = static_cast<std::uint32_t>(scratch_.seen.size());
  scratch_.seen.push_back(apex);
  const VisibleEdge beyond_right{mesh_.twin(right), choice.sees_left ? at : visible.left, visible.right, at,
                                 visible.entry_right};
  if (!choice.crosses_left) {
    visible = beyond_right;
    return mesh::kNoHalfEdge;
  }
  if (choice.crosses_right) scratch_.to_cross.push_back(beyond_right);
  visible = {mesh_.twin(left), visible.left, choice.sees_right ? at : visible.right, visible.entry_left, at};
  return mesh::kNoHalfEdge;
}

bool BridgeFinder::is_bridge_to(HalfEdge corner, HalfEdge wall) {
  const Gap gap = gap_to_wall(corner, wall);
  if (!has_foot_on(gap, corner, wall)) return false;
  const Vertex w = mesh_.origin(corner);
  const Vertex x = mesh_.target(corner);
  const Vertex y = mesh_.apex(corner);
  const Candidate candidate = candidate_of(gap, w, mesh::kNoVertex);
  if (is_blocked_by(candidate, x) || is_blocked_by(candidate, y)) return false;
  const Around at_w = around(candidate, w);
  const Around at_x = around(candidate, x);
  const Around at_y = around(candidate, y);
  scratch_.to_clear.clear();
  scratch_.begin();
  (void)scratch_.visit(mesh::face(corner));
  return is_clear_at(candidate, corner, at_w, at_x) && enter(candidate, mesh::next(corner), at_x, at_y) &&
         is_clear_at(candidate, mesh::previous(corner), at_y, at_w) && is_clear(candidate);
}

// A constructed vertex lies strictly inside both of its sides. If one of these sides ends at the start of the gap, the
// other end of this side gives the same sign, and needs no integers. In worlds of rectangles, this is frequent.
Sign BridgeFinder::side_of_foot(const Gap& gap, Vertex v) const {
  if (is_explicit(v)) return exact::dot(gap.from, position_of(v), gap.a, gap.b);
  const exact::ExactPoint point = geometry_.exact(number(v));
  for (const exact::PointPair* const line : {point.ab, point.cd}) {
    if (gap.from == line->a) return exact::dot(gap.from, line->b, gap.a, gap.b);
    if (gap.from == line->b) return exact::dot(gap.from, line->a, gap.a, gap.b);
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

/// Returns whether no wall in the faces of `to_clear`, and in those to which the search continues, touches the closed
/// disc.
bool BridgeFinder::is_clear(const Candidate& candidate) {
  auto& to_clear = scratch_.to_clear;
  while (!to_clear.empty()) {
    const Beyond beyond = to_clear.back();
    to_clear.pop_back();
    if (!is_clear_in(candidate, beyond)) return false;
  }
  return true;
}

}  // namespace waywright::clearance

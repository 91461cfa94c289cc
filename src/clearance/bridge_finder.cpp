#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <cmath>

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;

Gap BridgeFinder::gap_to_wall(HalfEdge corner, HalfEdge wall) const {
  const constraint::Side& side = triangulation_.any_side(wall);
  return {position_of(mesh_.origin(corner)), position_of(side.from), position_of(side.to)};
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
  scratch_.to_enter.assign({h, twin});
  scratch_.begin();
  return is_clear(gap, Disc::of_gap(gap.from, gap.a, gap.b));
}

// Let w be the origin of `corner`, and x and y the other two vertices of its face. Invert the plane about w. The disc
// of the bridge becomes a half-plane that contains no vertices, so x and y lie on its near side. Hence the ray from w
// along the bridge meets the line through x and y before it meets the image of the foot: the foot lies inside the
// circle through w, x and y. That circle contains no visible vertex. So only walls that cross it can have the foot, and
// the search crosses only edges that cross the circle and that are visible from w.
HalfEdge BridgeFinder::find_wall(HalfEdge corner) {
  const Vertex w = mesh_.origin(corner);
  if (!is_explicit(w)) return mesh::kNoHalfEdge;
  const HalfEdge opposite = mesh::next(corner);
  if (mesh_.is_fixed(opposite)) return is_bridge_to(corner, opposite) ? opposite : mesh::kNoHalfEdge;
  const Disc circle = circle_of(corner);
  auto& to_cross = scratch_.to_cross;
  to_cross.assign({{mesh_.twin(opposite), mesh_.target(opposite), mesh_.origin(opposite)}});
  while (!to_cross.empty()) {
    const BridgeScratch::View view = to_cross.back();
    to_cross.pop_back();
    const Vertex apex = mesh_.apex(view.entry);
    const bool sees_left = side(w, view.left, apex) == Sign::negative;
    const bool sees_right = side(w, view.right, apex) == Sign::positive;
    const auto look = [&](HalfEdge exit, Vertex left, Vertex right) {
      if (!may_touch(circle, exit)) return false;
      if (mesh_.is_fixed(exit)) return is_bridge_to(corner, exit);
      to_cross.push_back({mesh_.twin(exit), left, right});
      return false;
    };
    const HalfEdge left_exit = mesh::previous(view.entry);
    const HalfEdge right_exit = mesh::next(view.entry);
    if (sees_left && look(left_exit, view.left, sees_right ? apex : view.right)) return left_exit;
    if (sees_right && look(right_exit, sees_left ? apex : view.left, view.right)) return right_exit;
  }
  return mesh::kNoHalfEdge;
}

bool BridgeFinder::is_bridge_to(HalfEdge corner, HalfEdge wall) {
  const Gap gap = gap_to_wall(corner, wall);
  if (!has_foot_on(gap, corner, wall)) return false;
  const Disc disc = Disc::of_gap(gap.from, gap.a, gap.b);
  scratch_.to_enter.clear();
  scratch_.begin();
  (void)scratch_.visit(mesh::face(corner));
  return enter(gap, disc, corner) && enter(gap, disc, mesh::next(corner)) && enter(gap, disc, mesh::previous(corner)) &&
         is_clear(gap, disc);
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
bool BridgeFinder::is_clear(const Gap& gap, const Disc& disc) {
  auto& to_enter = scratch_.to_enter;
  while (!to_enter.empty()) {
    const HalfEdge h = to_enter.back();
    to_enter.pop_back();
    if (!scratch_.visit(mesh::face(h))) continue;
    if (!enter(gap, disc, mesh::next(h)) || !enter(gap, disc, mesh::previous(h))) return false;
  }
  return true;
}

/// Looks at an edge of a face that the search has entered. Returns false if it is a wall that touches the closed disc.
bool BridgeFinder::enter(const Gap& gap, const Disc& disc, HalfEdge h) {
  if (!may_touch(disc, h)) return true;
  if (mesh_.is_fixed(h)) return !is_blocked_by(gap, h);
  scratch_.to_enter.push_back(mesh_.twin(h));
  return true;
}

}  // namespace waywright::clearance

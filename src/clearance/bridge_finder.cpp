#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;

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
    const Disc circle =
        Disc::of_triangle(position_of(v), position_of(mesh_.target(at)), position_of(mesh_.apex(at)), rounding_);
    return circle.may_enter(position_of(v == p ? q : p), rounding_);
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

/// Returns whether no wall in the face of `entry`, and in the faces to which the search continues from there, touches
/// the closed disc. If the disc touches very many faces, the tree decides about all walls. Requires: the disc may touch
/// the edge of `entry`.
bool BridgeFinder::is_clear_beyond(const Candidate& candidate, HalfEdge entry) {
  if (is_surely_clear_) return true;
  if (mesh_.is_fixed(entry)) return !is_blocked_by(candidate.gap, entry);
  auto& to_test = scratch_.to_test;
  to_test.clear();
  NearVertex origin = near_vertex(candidate, mesh_.origin(entry));
  NearVertex target = near_vertex(candidate, mesh_.target(entry));
  for (;;) {
    bool goes_left = false;
    bool goes_right = false;
    const HalfEdge left = mesh::previous(entry);
    const HalfEdge right = mesh::next(entry);
    const NearVertex apex = near_vertex(candidate, mesh_.origin(left));
    if (scratch_.visit(mesh::face(entry))) {
      if (++face_count_ > face_limit_) return is_surely_clear_ = is_clear_of_all_walls(candidate, nullptr);
      if (!(apex.square > candidate.limit) && is_blocked_by(candidate, apex.vertex)) return false;
      goes_left = may_enter(candidate, apex, origin);
      goes_right = may_enter(candidate, target, apex);
    }
    if (goes_left && mesh_.is_fixed(left)) {
      if (is_blocked_by(candidate.gap, left)) return false;
      goes_left = false;
    }
    if (goes_right && mesh_.is_fixed(right)) {
      if (is_blocked_by(candidate.gap, right)) return false;
      goes_right = false;
    }
    if (goes_right) {
      if (goes_left) to_test.push_back(mesh_.twin(left));
      entry = mesh_.twin(right);
      origin = apex;
    } else if (goes_left) {
      entry = mesh_.twin(left);
      target = apex;
    } else {
      if (to_test.empty()) return true;
      entry = to_test.back();
      to_test.pop_back();
      origin = near_vertex(candidate, mesh_.origin(entry));
      target = near_vertex(candidate, mesh_.target(entry));
    }
  }
}

// The angle between two successive edges of the face is acute if the dot product of their vectors is negative.
unsigned BridgeFinder::acute_angles(mesh::Face f) const {
  const HalfEdge h = mesh::first(f);
  const Point& a = position_of(mesh_.origin(h));
  const Point& b = position_of(mesh_.target(h));
  const Point& c = position_of(mesh_.apex(h));
  const auto may_be_acute = [&](const Point& before, const Point& after) {
    const double x = before.x * after.x;
    const double y = before.y * after.y;
    const double extent = std::abs(before.x) + std::abs(before.y) + std::abs(after.x) + std::abs(after.y);
    const double error = 0x1p-48 * (std::abs(x) + std::abs(y)) + 4.0 * rounding_ * (extent + 4.0 * rounding_);
    return static_cast<unsigned>(x + y < error);
  };
  return may_be_acute(a - c, b - a) | may_be_acute(b - a, c - b) << 1 | may_be_acute(c - b, a - c) << 2;
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
  begin_candidate();
  return is_clear_beyond(candidate, h) && is_clear_beyond(candidate, twin);
}

HalfEdge BridgeFinder::find_wall(HalfEdge corner) {
  if (starts_no_bridge(mesh_.origin(corner))) return mesh::kNoHalfEdge;
  const HalfEdge opposite = mesh::next(corner);
  const HalfEdge wall = mesh_.is_fixed(opposite) ? opposite : follow_diameter(corner);
  if (wall == kTooFar) return wall;
  return wall != mesh::kNoHalfEdge && is_bridge_to(corner, wall) ? wall : mesh::kNoHalfEdge;
}

/// Returns the only wall on which a foot bridge from the corner may end; kNoHalfEdge if there is none; or kTooFar after
/// SearchLimits::edges.
///
/// Let w be the origin of `corner`, x and y the other vertices of its face, C the circle through the three, and D the
/// position of C opposite to w. All vectors start at w. Let f be the foot of a bridge from w. The disc of the bridge
/// contains a vertex v exactly if the angle at v between w and f is at least 90 degrees. Each vertex is the end of a
/// wall, so the disc contains no vertex except w, and this angle is acute for every other vertex v: f . v < v^2. Then:
///
/// 1. f is a x + b y with a, b > 0. Because D . x = x^2 and D . y = y^2, f^2 = a f . x + b f . y is less than D . f.
///    So D lies strictly beyond the line of the wall, and the segment from w to D meets this line at a position g
///    before D.
/// 2. The segment from w to D is a diameter of C. So C consists of the positions p with p^2 = D . p, and p lies
///    strictly inside C if p^2 < D . p. By point 1, f lies strictly inside C. The position g lies strictly between w
///    and D, so it lies strictly inside C, too. So the triangle w f g, except for w, lies strictly inside C. It
///    contains no other vertex: if a ray from w turned from f to g, the first vertex that it met would be visible from
///    the face, but no visible vertex lies strictly inside the circle of a face.
/// 3. So g lies on the wall, too, and the segment from w to g crosses the same edges as the bridge. The function
///    follows the segment from w to D to the first wall.
///
/// The function also stops at an edge that no bridge meets. If a bridge meets an edge, the segment from w to g meets
/// this edge, too (point 3), and D lies beyond g (point 1). So D lies beyond the line through the edge. At each end v
/// of the edge, the angle between the edge and the direction to w is acute. Otherwise f, which lies on the edge or
/// beyond it, would not satisfy the inequality f . v < v^2.
HalfEdge BridgeFinder::follow_diameter(HalfEdge corner) const {
  const Point from = position_of(mesh_.origin(corner));
  const auto vector_to = [&](Vertex v) { return Diameter::vector(position_of(v) - from, errors_); };
  HalfEdge exit = mesh::next(corner);
  HalfEdge entry = mesh_.twin(exit);
  std::array<Diameter::Vector, 3> vertices{vector_to(mesh_.origin(exit)), vector_to(mesh_.target(exit)),
                                           vector_to(mesh_.apex(entry))};
  Diameter::Vector* right = &vertices[0];  // the ends of `exit`
  Diameter::Vector* left = &vertices[1];
  Diameter::Vector* apex = &vertices[2];
  const bool may_cross_right = Diameter::may_cross(*right, *apex);
  const bool may_cross_left = Diameter::may_cross(*apex, *left);
  if (!(may_cross_right | may_cross_left)) return mesh::kNoHalfEdge;
  const Diameter diameter(*right, *left, errors_);
  const auto may_meet = [&](const Diameter::Vector& p, const Diameter::Vector& q) {
    const bool may_cross = Diameter::may_cross(p, q);
    const bool may_end_beyond = diameter.may_end_beyond(p, q);
    return may_cross & may_end_beyond;
  };
  diameter.compute_s(*right);
  diameter.compute_s(*left);
  const std::uint32_t most_edges = limit(&SearchLimits::edges);
  for (std::uint32_t edge = 0; edge < most_edges; ++edge) {
    diameter.compute_s(*apex);
    Sign apex_side = diameter.sure_side_of(*apex);
    if (apex_side == Sign::zero) {
      if (may_meet(*right, *apex) | may_meet(*apex, *left)) apex_side = side_of_diameter(corner, entry);
      if (apex_side == Sign::zero) return mesh::kNoHalfEdge;
    }
    const bool is_left = apex_side == Sign::positive;
    exit = is_left ? mesh::next(entry) : mesh::previous(entry);
    std::swap(apex, is_left ? left : right);
    if (!may_meet(*right, *left)) return mesh::kNoHalfEdge;
    if (mesh_.is_fixed(exit)) return exit;
    entry = mesh_.twin(exit);
    *apex = vector_to(mesh_.apex(entry));
  }
  return kTooFar;
}

/// Says exactly whether the apex of `entry` lies left or right of the diameter at the corner: positive if left,
/// negative if right, zero if it lies on the line of the diameter. In a rectangle, the apex often lies at the end of
/// the diameter.
Sign BridgeFinder::side_of_diameter(HalfEdge corner, HalfEdge entry) const {
  const Vertex x = mesh_.target(corner);
  const Vertex y = mesh_.apex(corner);
  const Vertex z = mesh_.apex(entry);
  const Point& w = position_of(mesh_.origin(corner));
  const auto is_right_angle = [&](Vertex v) {
    return exact::dot(position_of(v), w, position_of(v), position_of(z)) == Sign::zero;
  };
  if (is_explicit(x) && is_explicit(y) && is_explicit(z) && is_right_angle(x) && is_right_angle(y)) return Sign::zero;
  const auto exact = [&](Vertex v) { return geometry_.exact(number(v)); };
  return exact::side_of_diameter(w, exact(x), exact(y), exact(z));
}

bool BridgeFinder::is_bridge_to(HalfEdge corner, HalfEdge wall) {
  const Gap gap = gap_to_wall(corner, wall);
  if (!has_foot_on(gap, corner, wall)) return false;
  const Vertex w = mesh_.origin(corner);
  const Vertex x = mesh_.target(corner);
  const Vertex y = mesh_.apex(corner);
  const Candidate candidate = candidate_of(gap, w, mesh::kNoVertex);
  if (is_blocked_by(candidate, x) || is_blocked_by(candidate, y)) return false;
  begin_candidate();
  (void)scratch_.visit(mesh::face(corner));
  const NearVertex at_w = near_vertex(candidate, w);
  if (may_enter(candidate, at_w, near_vertex(candidate, x)) && !is_clear_beyond(candidate, mesh_.twin(corner)))
    return false;
  const HalfEdge other = mesh::previous(corner);
  if (may_enter(candidate, near_vertex(candidate, y), at_w) && !is_clear_beyond(candidate, mesh_.twin(other)))
    return false;
  return is_clear_beyond(candidate, mesh_.twin(mesh::next(corner)));
}

// A constructed vertex lies strictly inside both of its sides. If one of these sides ends at the start of the gap, the
// other end of this side gives the same sign. This end is explicit, so the sign needs no integers of arbitrary
// precision. In worlds of rectangles, this is frequent.
Sign BridgeFinder::side_of_foot(const Gap& gap, Vertex v) const {
  if (is_explicit(v)) return exact::dot(gap.from, position_of(v), gap.a, gap.b);
  const exact::ExactPosition point = geometry_.exact(number(v));
  for (const exact::PointPair* const line : {point.ab, point.cd}) {
    if (gap.from == line->a) return exact::dot(gap.from, line->b, gap.a, gap.b);
    if (gap.from == line->b) return exact::dot(gap.from, line->a, gap.a, gap.b);
  }
  return exact::dot(gap.from, point, gap.a, gap.b);
}

/// Returns whether the foot lies strictly inside the wall, and the gap leaves the face of `corner` through the edge
/// from x to y that is opposite to the corner's origin w. This is true exactly if the line of the gap separates the
/// wall's origin and x from the wall's target and y. The wall has w on its left.
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

}  // namespace waywright::clearance

#include "clearance/bridge_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "clearance/walls.hpp"

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

// The searches in the tree of walls.

namespace {

constexpr double kTreeUnit = 0x1p-46;  ///< much more than the relative errors of the formulas below

}  // namespace

void SearchRegion::begin(const Box& box) {
  corners_.assign({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}});
  half_planes_.clear();
  bounds_ = box;
}

// Clips at a line that lies farther out than all errors: those of the normal and the limit, and those of the new
// corners, which are much smaller than `slack`.
void SearchRegion::clip(const Point& normal, double limit, double error) {
  const double extent = std::max(-bounds_.min.x, bounds_.max.x) + std::max(-bounds_.min.y, bounds_.max.y);
  const double total_error = error + kTreeUnit * extent_of(normal);
  const double slack = 4.0 * total_error * (extent + extent_of(normal));
  const HalfPlane half_plane{normal, limit + slack, total_error};
  const Point farthest{normal.x > 0.0 ? bounds_.max.x : bounds_.min.x, normal.y > 0.0 ? bounds_.max.y : bounds_.min.y};
  if (half_plane.excess(farthest) <= 0.0) return;
  clipped_.clear();
  bool is_any_outside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Point& p = corners_[i];
    const Point& q = corners_[i + 1 < corners_.size() ? i + 1 : 0];
    const double at_p = half_plane.excess(p);
    const double at_q = half_plane.excess(q);
    if (at_p <= 0.0) clipped_.push_back(p);
    is_any_outside = is_any_outside || at_p > 0.0;
    if ((at_p <= 0.0) == (at_q <= 0.0)) continue;
    const double share = at_p / (at_p - at_q);
    clipped_.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
  }
  if (!is_any_outside) return;
  half_planes_.push_back(half_plane);
  corners_.swap(clipped_);
  bounds_ = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  const double rounding = kTreeUnit * extent;
  for (const Point& p : corners_) {
    bounds_.min = {std::min(bounds_.min.x, p.x - rounding), std::min(bounds_.min.y, p.y - rounding)};
    bounds_.max = {std::max(bounds_.max.x, p.x + rounding), std::max(bounds_.max.y, p.y + rounding)};
  }
}

bool SearchRegion::may_contain(const Point& z, double error) const {
  const double extent = extent_of(z);
  const double slack = kTreeUnit * extent + error;
  if (!Box{bounds_.min - Point{slack, slack}, bounds_.max + Point{slack, slack}}.contains(z)) return false;
  return std::none_of(half_planes_.begin(), half_planes_.end(), [&](const HalfPlane& half_plane) {
    const double of_normal = half_plane.error * (extent + 2.0 * error);
    return half_plane.excess(z) > of_normal + error * extent_of(half_plane.normal);
  });
}

/// Returns whether no wall, except those that `ignored` may contain, touches the closed disc.
bool BridgeFinder::is_clear_of_all_walls(const Candidate& candidate, const ChangedWalls* ignored) {
  if (!tree_->is_built()) tree_->build(triangulation_);
  const Disc& disc = candidate.disc;
  const Box bounds = disc.bounds(rounding_);
  const auto may_be_blocked = [&](HalfEdge wall) {
    const NearVertex p = near_vertex(candidate, mesh_.origin(wall));
    const NearVertex q = near_vertex(candidate, mesh_.target(wall));
    return may_enter(candidate, p, q) && is_blocked_by(candidate.gap, wall);
  };
  const auto is_ignored = [&](HalfEdge wall) {
    return ignored != nullptr && ignored->is_any([&](const Box& box) { return may_overlap(box, wall); });
  };
  return tree_->for_each_in(
      bounds, [&](const Box& box) { return may_touch(disc, box); },
      [&](HalfEdge wall) { return is_ignored(wall) || !may_be_blocked(wall); });
}

HalfEdge BridgeFinder::find_far_wall(HalfEdge corner) {
  find_far_ends(mesh_.origin(corner), corner, nullptr);
  for (const FarEnd& end : scratch_.far_ends) {
    if (end.vertex != mesh::kNoVertex) continue;
    const HalfEdge wall = wall_facing(end.wall, mesh_.origin(corner));
    if (is_far_wall(corner, wall)) return wall;
  }
  return mesh::kNoHalfEdge;
}

bool BridgeFinder::is_far_wall(HalfEdge corner, HalfEdge wall) {
  if (wall_facing(wall, mesh_.origin(corner)) != wall) return false;
  const Gap gap = gap_to_wall(corner, wall);
  return has_foot_on(gap, corner, wall) &&
         is_clear_of_all_walls(candidate_of(gap, mesh_.origin(corner), mesh::kNoVertex), nullptr);
}

/// The half-edge of the wall that has `w` on its left, if `w` does not lie on the line of the wall.
HalfEdge BridgeFinder::wall_facing(HalfEdge wall, Vertex w) const {
  const WallLine line = wall_line(triangulation_, wall);
  const Sign side = geometry_.orientation(exact::Geometry::view(line.from), exact::Geometry::view(line.to),
                                          geometry_.view(number(w)));
  return side == Sign::negative ? mesh_.twin(wall) : wall;
}

/// Collects in `far_ends` all positions at which a bridge from `w` may end: one that runs into the face of `corner` or,
/// if this is kNoHalfEdge, any. If `ignored` is not null, the walls that it may contain do not block a bridge.
///
/// All vectors start at w. A bridge to z exists only if no position p of a wall lies in the closed disc from w to z, so
/// z . p < p^2. Consider a wall that does not end at w. A bridge can end on it only at its nearest position to w, which
/// is a foot or an end of the wall. So the search visits walls in a region that becomes smaller and smaller. It notes
/// the nearest position p of each wall, and removes the positions z with z . p > p^2 from the region. If a wall ends at
/// w, a bridge has an angle of at least 90 degrees with it: z . p <= 0 for its other end p.
///
/// The order of the walls and the region only save time: exact predicates decide about each position.
void BridgeFinder::find_far_ends(Vertex w, HalfEdge corner, const ChangedWalls* ignored) {
  if (!tree_->is_built()) tree_->build(triangulation_);
  SearchRegion& region = scratch_.region;
  scratch_.far_ends.clear();
  const Point& from = position_of(w);
  const Box& domain = triangulation_.domain();
  region.begin({domain.min - from, domain.max - from});
  if (corner != mesh::kNoHalfEdge) {
    const Point x = position_of(mesh_.target(corner)) - from;
    const Point y = position_of(mesh_.apex(corner)) - from;
    exclude_side({x.y, -x.x});
    exclude_side({-y.y, y.x});
    exclude_beyond(x);
    exclude_beyond(y);
  }
  Box box;
  const auto take_bounds = [&] {
    const Box& bounds = region.bounds();
    const double slack = 4.0 * (rounding_ + kTreeUnit * (extent_of(from) + extent_of(domain.max - domain.min)));
    box = {bounds.min + from - Point{slack, slack}, bounds.max + from + Point{slack, slack}};
  };
  take_bounds();
  tree_->search(box, from, [&](HalfEdge wall) {
    const bool is_ignored =
        ignored != nullptr && ignored->is_any([&](const Box& changed) { return may_overlap(changed, wall); });
    offer_far_wall(w, wall, is_ignored);
    take_bounds();
  });
  std::erase_if(scratch_.far_ends, [&](const FarEnd& end) { return !region.may_contain(end.position, end.error); });
}

/// Excludes the positions z with z . p > p^2 from the region of the search.
void BridgeFinder::exclude_beyond(const Point& p, double error) {
  scratch_.region.clip(p, p.x * p.x + p.y * p.y, error + 4.0 * rounding_);
}

/// Excludes the positions z with z . p > 0 from the region of the search.
void BridgeFinder::exclude_side(const Point& p) { scratch_.region.clip(p, 0.0, 4.0 * rounding_); }

/// Notes the nearest position of the wall to `w` as a possible end of a bridge, and makes the region smaller.
void BridgeFinder::offer_far_wall(Vertex w, HalfEdge wall, bool is_ignored) {
  const Vertex u = mesh_.origin(wall);
  const Vertex v = mesh_.target(wall);
  const Point& from = position_of(w);
  const Point p = position_of(u) - from;
  const Point q = position_of(v) - from;
  if (u == w || v == w) {
    if (!is_ignored) exclude_side(u == w ? q : p);
    return;
  }
  const Point along = q - p;
  const double at_p = p.x * along.x + p.y * along.y;
  const double at_q = q.x * along.x + q.y * along.y;
  const double extent = extent_of(p) + extent_of(q);
  const double slack = (kTreeUnit * extent + 8.0 * rounding_) * (extent + 8.0 * rounding_);
  const auto offer = [&](Vertex end, const Point& position, double error, bool is_sure) {
    if (scratch_.region.may_contain(position, error)) scratch_.far_ends.push_back({wall, end, position, error});
    if (is_sure && !is_ignored) exclude_beyond(position, error);
  };
  if (at_p < slack && at_q > -slack) {
    const constraint::Side& side = triangulation_.any_side(wall);
    const Disc disc = Disc::of_gap(from, position_of(side.from), position_of(side.to));
    const Point foot{2.0 * disc.centre.x, 2.0 * disc.centre.y};
    offer(mesh::kNoVertex, foot, 4.0 * disc.error, at_p < -slack && at_q > slack);
  }
  if (at_p > -slack) offer(u, p, 0.0, true);
  if (at_q < slack) offer(v, q, 0.0, true);
}

/// Returns whether the line from `w` to the end would be a bridge without the walls that `changed` may contain, and one
/// of these walls may touch its disc.
bool BridgeFinder::is_far_bridge(Vertex w, const FarEnd& end, const ChangedWalls& changed) {
  const bool has_foot = end.vertex == mesh::kNoVertex;
  if (!has_foot && !is_explicit(end.vertex)) return false;
  const Point& to = position_of(has_foot ? w : end.vertex);
  const constraint::Side& side = triangulation_.any_side(end.wall);
  const Gap gap =
      has_foot ? Gap{position_of(w), position_of(side.from), position_of(side.to)} : Gap{position_of(w), to, to};
  const Candidate candidate = candidate_of(gap, w, end.vertex);
  return may_touch(candidate.disc, changed) && is_clear_of_all_walls(candidate, &changed);
}

}  // namespace waywright::clearance

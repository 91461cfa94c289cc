#include <algorithm>
#include <cmath>

#include "clearance/bridge_finder.hpp"
#include "clearance/wall_line.hpp"

// The searches of BridgeFinder in the tree of walls.

namespace waywright::clearance {

using exact::Gap;
using exact::Sign;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

constexpr double kUnit = 0x1p-46;  ///< much more than the relative errors of the formulas below

double extent_of(const Point& p) { return std::abs(p.x) + std::abs(p.y); }

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
  const double total_error = error + kUnit * extent_of(normal);
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
  const double rounding = kUnit * extent;
  for (const Point& p : corners_) {
    bounds_.min = {std::min(bounds_.min.x, p.x - rounding), std::min(bounds_.min.y, p.y - rounding)};
    bounds_.max = {std::max(bounds_.max.x, p.x + rounding), std::max(bounds_.max.y, p.y + rounding)};
  }
}

bool SearchRegion::may_contain(const Point& z, double error) const {
  const double extent = extent_of(z);
  const double slack = kUnit * extent + error;
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
    const double slack = 4.0 * (rounding_ + kUnit * (extent_of(from) + extent_of(domain.max - domain.min)));
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
  const double slack = (kUnit * extent + 8.0 * rounding_) * (extent + 8.0 * rounding_);
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

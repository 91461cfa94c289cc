#include "clearance/nearest_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/ieee.hpp"
#include "clearance/walls.hpp"
#include "constraint/distances.hpp"
#include "exact/doubles.hpp"
#include "exact/filter.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

using mesh::HalfEdge;
using mesh::Vertex;
using Interval = OffsetCurve::Interval;

namespace {

/// If an interval of a circle between two walls of its vertex is shorter than this, the search drops it: then it is the
/// single position where the offset lines of the two walls end.
constexpr double kShortestArc = 0x1p-40;

bool is_later(double p, double q) { return p > q; }

/// Returns the distance from (0, 0) to a segment.
double distance_to(const Point& a, const Point& b) {
  const Point along = b - a;
  const double size = squared_length(along);
  const double share = size > 0.0 ? std::clamp(-dot(a, along) / size, 0.0, 1.0) : 0.0;
  return length(a + along * share);
}

/// Returns the vector from the nearest position of a segment to `p`.
Point away_from(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double size = squared_length(along);
  const double share = size > 0.0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0.0;
  return (p - a) - along * share;
}

}  // namespace

const Point& NearestFit::position(Vertex v) const {
  return triangulation_->triangulation().geometry().rounded(number(v));
}
bool NearestFit::is_explicit(Vertex v) const {
  return triangulation_->triangulation().geometry().is_explicit(number(v));
}

std::optional<Point> NearestFit::find(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                                      NearWalls& near_walls, const Query& query, const Goal* goal) {
  triangulation_ = &triangulation;
  cover_finder_ = &cover_finder;
  near_walls_ = &near_walls;
  goal_ = goal;
  query_ = query;
  best_ = {};
  const Box& domain = triangulation.domain();
  if (query.radius > domain.width() || query.radius > domain.height()) return std::nullopt;
  if (goal != nullptr) reach_.begin(Cells(goal->walls, goal->bridges), goal->cell, query.radius);
  if (fits(query.point) && is_allowed(query.point)) return query.point;
  largest_ = exact::filter::largest_magnitude(domain);
  rounding_ = constraint::largest_rounding(triangulation);
  open_.clear();
  pieces_.clear();
  const mesh::TriangleMesh& mesh = triangulation.topology();
  entered_.grow_to(mesh.face_slots());
  seen_.grow_to(mesh.vertex_slots());
  clipped_.grow_to(mesh.face_slots());
  stamp_.next(1, entered_, seen_);
  enter(triangulation.triangulation().locate(query.point).h);
  while (!open_.empty()) {
    const Entry entry = pop();
    if (entry.bound > query.limit || (best_.is_found && entry.bound > best_.distance)) break;
    if (entry.kind == Kind::enter) {
      enter(entry.h);
    } else if (entry.kind == Kind::line) {
      clip_line(entry.piece);
    } else if (entry.kind == Kind::circle) {
      clip_circle(entry.h);
    } else {
      settle(Piece(pieces_[entry.piece]));
    }
  }
  if (!best_.is_found) return std::nullopt;
  return best_.at;
}

void NearestFit::push(double bound, Kind kind, HalfEdge h, std::uint32_t piece) {
  const double slack = 0x1p-46 * (std::abs(bound) + query_.radius);
  open_.push_back({bound - slack, kind, h, piece});
  std::push_heap(open_.begin(), open_.end(), [](const Entry& p, const Entry& q) { return is_later(p.bound, q.bound); });
}

NearestFit::Entry NearestFit::pop() {
  std::pop_heap(open_.begin(), open_.end(), [](const Entry& p, const Entry& q) { return is_later(p.bound, q.bound); });
  const Entry entry = open_.back();
  open_.pop_back();
  return entry;
}

void NearestFit::enter(HalfEdge h) {
  if (std::exchange(entered_[number(mesh::face(h))], stamp_.value()) == stamp_.value()) return;
  for (const HalfEdge edge : {h, mesh::next(h), mesh::previous(h)}) look(edge);
}

void NearestFit::look(HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Vertex v = mesh.origin(h);
  if (std::exchange(seen_[number(v)], stamp_.value()) != stamp_.value()) add_circle(h);
  if (mesh.is_fixed(h)) add_line(h);
  const HalfEdge beyond = mesh.twin(h);
  if (triangulation_->triangulation().is_ghost_face(beyond)) return;
  if (entered_[number(mesh::face(beyond))] == stamp_.value()) return;
  const double distance = distance_to(position(v) - query_.point, position(mesh.target(h)) - query_.point);
  push(std::max(0.0, distance - query_.radius), Kind::enter, beyond, 0);
}

void NearestFit::add_line(HalfEdge wall) {
  if (cover_finder_->is_covered(*triangulation_, wall)) return;
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Point& from = position(mesh.origin(wall));
  const Point& to = position(mesh.target(wall));
  if (from == to) return;
  const OffsetCurve curve = OffsetCurve::left_of(query_.point, from, to, query_.radius, rounding_);
  push_piece(Kind::line, {curve, curve.whole(), wall});
}

/// The walls at a crossing leave no angle above 180 degrees, so no disc touches a crossing.
void NearestFit::add_circle(HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Vertex v = mesh.origin(h);
  if (!is_explicit(v)) return;
  bool has_wall = false;
  mesh.for_each_outgoing(v, [&](HalfEdge out) { has_wall = has_wall || mesh.is_fixed(out); });
  if (has_wall) push(std::abs(length(position(v) - query_.point) - query_.radius), Kind::circle, h, 0);
}

void NearestFit::push_piece(Kind kind, const Piece& piece) {
  const double bound = length(piece.curve.at(piece.curve.nearest(piece.interval)));
  if (best_.is_found && bound * (1.0 - 0x1p-40) > best_.distance) return;
  pieces_.push_back(piece);
  push(bound, kind, piece.h, static_cast<std::uint32_t>(pieces_.size() - 1));
}

/// Clips the piece of the line that is nearest to the point. Pushes the other pieces to the open list: the search clips
/// them when no other entry can give a nearer position.
void NearestFit::clip_line(std::uint32_t piece) {
  const Piece line = pieces_[piece];
  const double nearest = line.curve.nearest(line.interval);
  const double reach = 2.0 * (query_.radius + length(line.curve.at(nearest))) + 0x1p-40 * largest_;
  Interval near_part = line.interval;
  if (nearest - reach > near_part.low) {
    push_piece(Kind::line, {line.curve, {near_part.low, nearest - reach}, line.h});
    near_part.low = nearest - reach;
  }
  if (nearest + reach < near_part.high) {
    push_piece(Kind::line, {line.curve, {nearest + reach, near_part.high}, line.h});
    near_part.high = nearest + reach;
  }
  clip_stamp_.next(1, clipped_);
  clipped_[number(mesh::face(line.h))] = clip_stamp_.value();
  to_cross_.clear();
  to_cross_.push_back(mesh::next(line.h));
  to_cross_.push_back(mesh::previous(line.h));
  intervals_.clear();
  intervals_.push_back(near_part);
  clip(line.curve, line.h);
  for (const Interval& interval : intervals_) push_piece(Kind::candidate, {line.curve, interval, line.h});
}

void NearestFit::clip_circle(HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Vertex v = mesh.origin(h);
  const OffsetCurve curve = OffsetCurve::around(query_.point, position(v), query_.radius, rounding_);
  intervals_.clear();
  intervals_.push_back(curve.whole());
  mesh.for_each_outgoing(v, [&](HalfEdge out) {
    if (!mesh.is_fixed(out)) return;
    const auto blocked = curve.blocked_by(position(v), position(mesh.target(out)), OffsetCurve::Bias::less);
    subtract(curve, blocked, mesh::kNoHalfEdge, intervals_);
  });
  std::erase_if(intervals_, [&](const Interval& interval) {
    return interval.high - interval.low < kShortestArc ||
           !is_outside(h, curve.normal(0.5 * (interval.low + interval.high)));
  });
  if (intervals_.empty()) return;
  clip_stamp_.next(1, clipped_);
  to_cross_.clear();
  mesh.for_each_outgoing(v, [&](HalfEdge out) {
    if (triangulation_->triangulation().is_ghost_face(out)) return;
    clipped_[number(mesh::face(out))] = clip_stamp_.value();
    to_cross_.push_back(mesh::next(out));
  });
  clip(curve, h);
  for (const Interval& interval : intervals_) push_piece(Kind::candidate, {curve, interval, h});
}

/// Returns whether no polygon covers the face around the origin of `h` in this direction. The direction differs from
/// the directions of all walls there by 90 degrees or more, up to rounding errors. Returns false if the direction leads
/// out of the domain.
bool NearestFit::is_outside(HalfEdge h, const Point& direction) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Point& centre = position(mesh.origin(h));
  HalfEdge found = mesh::kNoHalfEdge;
  mesh.for_each_outgoing(mesh.origin(h), [&](HalfEdge out) {
    if (triangulation_->triangulation().is_ghost_face(out)) return;
    const bool is_left = cross(position(mesh.target(out)) - centre, direction) >= 0.0;
    const bool is_right = cross(direction, position(mesh.apex(out)) - centre) >= 0.0;
    if (is_left && is_right) found = out;
  });
  return found != mesh::kNoHalfEdge && !cover_finder_->is_covered(*triangulation_, found);
}

/// Removes from `intervals_` the positions that are too near to a wall. Starts at the half-edges in `to_cross_`, and
/// enters each face that a disc at a position of the intervals meets. A wall hides the walls beyond it: a disc that is
/// too near to a hidden wall is also too near to a wall that the search finds.
void NearestFit::clip(const OffsetCurve& curve, HalfEdge own) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  for (std::size_t i = 0; i < to_cross_.size() && !intervals_.empty(); ++i) {
    const HalfEdge h = to_cross_[i];
    if (mesh.is_fixed(h)) {
      block(curve, h);
      divide_at_gaps(curve, own, h);
      continue;
    }
    const HalfEdge beyond = mesh.twin(h);
    std::uint32_t& mark = clipped_[number(mesh::face(beyond))];
    if (mark == clip_stamp_.value()) continue;
    const auto near = curve.blocked_by(position(mesh.origin(h)), position(mesh.target(h)), OffsetCurve::Bias::more);
    if (!meets(near, intervals_)) continue;
    mark = clip_stamp_.value();
    to_cross_.push_back(mesh::next(beyond));
    to_cross_.push_back(mesh::previous(beyond));
  }
}

void NearestFit::block(const OffsetCurve& curve, HalfEdge wall) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const auto blocked =
      curve.blocked_by(position(mesh.origin(wall)), position(mesh.target(wall)), OffsetCurve::Bias::less);
  subtract(curve, blocked, wall, intervals_);
}

/// If the gap between the curve's own wall and another wall is shorter than the diameter by less than a rounding error,
/// block() may have kept the positions where the disc would pass the gap. Exact predicates find these gaps, and cut the
/// interval there. So the disc can move from each position of an interval to all other positions of this interval.
void NearestFit::divide_at_gaps(const OffsetCurve& curve, HalfEdge own, HalfEdge wall) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const auto divide = [&](const exact::Gap& gap, const Point& other) {
    const double parameter = curve.parameter_of(other);
    if (!curve.is_nearly_diameter(other) || !contains(parameter, intervals_)) return;
    if (exact::compare_to_diameter(gap, query_.radius) < 0) cut(parameter, wall, intervals_);
  };
  for (const Vertex v : {mesh.origin(wall), mesh.target(wall)}) {
    if (!is_explicit(v) || !curve.is_nearly_diameter(position(v))) continue;
    if (curve.is_circle()) {
      divide({position(mesh.origin(own)), position(v), position(v)}, position(v));
    } else {
      const WallLine line = wall_line(*triangulation_, own);
      divide({position(v), line.from, line.to}, position(v));
    }
  }
  if (!curve.is_circle()) return;
  const Point& centre = position(mesh.origin(own));
  const Point& from = position(mesh.origin(wall));
  const Point foot = centre - away_from(centre, from, position(mesh.target(wall)));
  if (!curve.is_nearly_diameter(foot) || foot == from || foot == position(mesh.target(wall))) return;
  const WallLine line = wall_line(*triangulation_, wall);
  divide({centre, line.from, line.to}, foot);
}

/// Looks for a point near the position of the interval that is nearest to the query's point. Nearly always, one of the
/// first attempts succeeds. The other attempts are for positions where two offset curves meet at a very small angle,
/// and for intervals that exist only because of rounding errors.
void NearestFit::settle(const Piece& piece) {
  const double parameter = piece.curve.nearest(piece.interval);
  const Point from = piece.curve.at(sharpened(piece, parameter));
  const Point at = query_.point + from;
  const double largest = std::max({std::abs(at.x), std::abs(at.y), std::abs(from.x), std::abs(from.y), query_.radius});
  if (try_at(from)) return;
  const Point direction = inward(piece, parameter);
  step_ = 0x1p-53 * std::max(largest, kSmallestCoordinate);
  if (push_inwards(from, direction, step_, 0x1p10 * step_)) return;
  // Near the origin, a coordinate cannot change by less than the smallest coordinate.
  if (step_ < kSmallestCoordinate) {
    step_ = kSmallestCoordinate;
    if (push_inwards(from, direction, step_, 0x1p10 * step_)) return;
  }
  if (try_around(from)) return;
  follow(piece, parameter, piece.interval.low);
  follow(piece, parameter, piece.interval.high);
}

/// The wall that ends the interval at the parameter, or kNoHalfEdge.
HalfEdge NearestFit::blocker_at(const Piece& piece, double parameter) const {
  if (parameter == piece.interval.low) return piece.interval.low_blocker;
  return parameter == piece.interval.high ? piece.interval.high_blocker : mesh::kNoHalfEdge;
}

/// The intervals of clip() are a little longer than the exact ones. If the parameter is an end of such an interval,
/// returns the end of the exact interval, as precisely as doubles allow. If the two ends are too far from each other,
/// returns the parameter as it is. This happens if the curve of the piece and the border of the area that the blocker
/// blocks meet at a small angle.
double NearestFit::sharpened(const Piece& piece, double parameter) const {
  const HalfEdge blocker = blocker_at(piece, parameter);
  if (blocker == mesh::kNoHalfEdge) return parameter;
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const auto blocked =
      piece.curve.blocked_by(position(mesh.origin(blocker)), position(mesh.target(blocker)), OffsetCurve::Bias::none);
  const double sharp = parameter == piece.interval.low ? blocked.high : blocked.low;
  const double moved = length(piece.curve.at(sharp) - piece.curve.at(parameter));
  return blocked.is_blocked && moved < 0x1p-42 * (largest_ + query_.radius) ? sharp : parameter;
}

/// Returns the direction from a position of the interval to positions where the disc fits: away from the curve's wall,
/// and at the end of the interval away from the wall that blocks the curve beyond it, too.
Point NearestFit::inward(const Piece& piece, double parameter) const {
  const Point normal = piece.curve.normal(parameter);
  const HalfEdge blocker = blocker_at(piece, parameter);
  if (blocker == mesh::kNoHalfEdge) return normal;
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const Point other = unit(away_from(piece.curve.at(parameter), position(mesh.origin(blocker)) - query_.point,
                                     position(mesh.target(blocker)) - query_.point));
  const Point sum = normal + other;
  if (squared_length(sum) < 0x1p-60) return normal;
  return unit(sum);
}

/// Tries positions at the distances `least`, 2 `least`, 4 `least`, ... up to `most` in a direction. If the disc fits at
/// one of them, a bisection finds the nearest position between this position and the previous one.
bool NearestFit::push_inwards(const Point& from, const Point& direction, double least, double most) {
  double before = 0.0;
  for (double push = least; push <= most; push *= 2.0) {
    if (!try_at(from + direction * push)) {
      before = push;
      continue;
    }
    double after = push;
    while (after - before > least && after - before > 0x1p-50 * length(from)) {
      const double middle = 0.5 * (before + after);
      (try_at(from + direction * middle) ? after : before) = middle;
    }
    return true;
  }
  return false;
}

/// Tries the nine points around a position.
bool NearestFit::try_around(const Point& position) {
  const Point centre = query_.point + position;
  const auto around = [](double value) {
    const double middle = std::abs(value) < kSmallestCoordinate ? 0.0 : value;
    return std::array{exact::next_coordinate<double>(middle, -1.0), middle,
                      exact::next_coordinate<double>(middle, 1.0)};
  };
  if (!is_in_range(centre.x) || !is_in_range(centre.y)) return false;
  bool is_found = false;
  for (const double x : around(centre.x)) {
    for (const double y : around(centre.y)) is_found = try_point({x, y}) || is_found;
  }
  return is_found;
}

/// Follows the curve from a parameter to the end of its interval, in steps that double, until the disc fits. Then looks
/// for a nearer position between the last two steps.
void NearestFit::follow(const Piece& piece, double parameter, double end) {
  const double unit_length = piece.curve.is_circle() ? 1.0 / query_.radius : 1.0;
  const double least = 4.0 * step_ * unit_length;
  const double most = std::abs(end - parameter);
  if (!(most > 16.0 * least) || !std::isfinite(least)) return;
  const double sign = end > parameter ? 1.0 : -1.0;
  const auto attempt = [&](double distance) {
    const double there = distance >= most ? end : parameter + sign * distance;
    const Point from = piece.curve.at(there);
    return try_at(from) || push_inwards(from, piece.curve.normal(there), step_, 4.0 * step_);
  };
  double before = 0.0;
  for (double distance = least;; distance = std::min(2.0 * distance, most)) {
    if (attempt(distance)) {
      double after = distance;
      while (after - before > least && (after - before) > 0x1p-40 * after) {
        const double middle = 0.5 * (before + after);
        (attempt(middle) ? after : before) = middle;
      }
      return;
    }
    if (distance >= most) return;
    before = distance;
  }
}

bool NearestFit::try_at(const Point& position) {
  Point point = query_.point + position;
  if (std::abs(point.x) < kSmallestCoordinate) point.x = 0.0;
  if (std::abs(point.y) < kSmallestCoordinate) point.y = 0.0;
  return try_point(point);
}

/// Returns whether the disc fits at the point. Remembers the point if three conditions hold: the disc fits there, the
/// point is allowed (is_allowed()), and no better point is known.
bool NearestFit::try_point(const Point& point) {
  if (!fits(point)) return false;
  if (best_.is_found) {
    const auto order = exact::compare_distances(query_.point, point, point, best_.at, best_.at);
    if (order > 0 || (order == 0 && !comes_before(point, best_.at))) return true;
  }
  if (is_allowed(point)) best_ = {true, point, distance(query_.point, point)};
  return true;
}

bool NearestFit::fits(const Point& point) {
  if (!is_in_range(point) || !triangulation_->domain().contains(point)) return false;
  return near_walls_->has_no_nearer_wall(*triangulation_, point, query_.radius) &&
         !cover_finder_->is_strictly_inside(*triangulation_, triangulation_->triangulation().locate(point));
}

/// Returns whether a point where the disc fits is near enough and, if the query has a goal, connected with it.
bool NearestFit::is_allowed(const Point& point) {
  const bool is_limited = query_.limit < std::numeric_limits<double>::infinity();
  if (is_limited && exact::compare_distance(query_.point, point, point, query_.limit) > 0) return false;
  if (goal_ == nullptr) return true;
  const auto cell = near_walls_->find_cell(goal_->walls, goal_->bridges, point);
  return cell && reach_.is_reached(Cells(goal_->walls, goal_->bridges), *cell);
}

}  // namespace waywright::clearance

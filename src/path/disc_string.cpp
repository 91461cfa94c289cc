#include "path/disc_string.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace waywright::path {

using mesh::HalfEdge;

namespace {

/// If the code adds this number to an index, the index becomes smaller by 1, because unsigned numbers wrap around.
constexpr std::size_t kBackwards = static_cast<std::size_t>(-1);

/// In radii. The diameter of the disc is 2 radii. The rest of this number allows for rounding.
constexpr double kDiameterAndMargin = 2.125;

double coordinate_sum(const Point& v) { return std::abs(v.x) + std::abs(v.y); }

}  // namespace

bool DiscString::find(const DiscMap& map, const DiscEnds& ends, std::span<const HalfEdge> exits, HalfEdge goal_face) {
  map_ = &map;
  start_ = ends.start();
  goal_ = ends.goal();
  goal_face_ = goal_face;
  stops_.clear();
  is_funnel_open_ = true;
  if (exits.empty()) {
    stops_.push_back({{{start_, kNoTurn}, mesh::kNoVertex}, mesh::kNoHalfEdge, {}});
  } else {
    run_funnel(exits);
  }
  stops_.push_back({{{goal_, kNoTurn}, mesh::kNoVertex}, mesh::kNoHalfEdge, {}});
  return is_funnel_open_ && straighten();
}

DiscString::Stop DiscString::stop_at(HalfEdge corner, int turn) const {
  const mesh::Vertex v = map_->mesh().origin(corner);
  return {{{map_->position(v), turn}, v}, corner, {}};
}

DiscString::Bend DiscString::bend_at(HalfEdge corner) const {
  return {map_->position(map_->mesh().origin(corner)), corner};
}

// Seen from inside a face, the left end of an edge is its target.
void DiscString::run_funnel(std::span<const HalfEdge> exits) {
  left_ = apex_ = right_ = exits.size() + 1;
  if (row_.size() < 2 * exits.size() + 3) row_.resize(2 * exits.size() + 3);
  row_[apex_] = {start_, mesh::kNoHalfEdge};
  apex_turn_ = kNoTurn;
  row_[--left_] = bend_at(mesh::next(exits[0]));
  row_[++right_] = bend_at(exits[0]);
  for (std::size_t i = 1; i < exits.size() && is_funnel_open_; ++i) {
    const HalfEdge entry = map_->mesh().twin(exits[i - 1]);
    move(mesh::previous(entry), exits[i] == mesh::next(entry) ? kTurnLeft : kTurnRight);
  }
  end_at_goal();
}

/// Returns whether the string from the bend with the index `before` over `at` to `after` turns at `at` in the direction
/// `turn`. At `after`, the string turns in this direction, too. If there is no tangent, sets `is_funnel_open_` to
/// false.
bool DiscString::turns(std::size_t before, const Bend& at, const Bend& after, int turn) {
  const Point to = at.centre - row_[before].centre;
  const Point on = after.centre - at.centre;
  if (before != apex_ || apex_turn_ == turn) return turn * cross(to, on) > 0.0;
  // The last line computes the cross product of the direction of tangent() and `on`, times a positive number.
  const double across = (turn - apex_turn_) * map_->radius;
  const double square = squared_distance_minus(row_[before].centre, at.centre, across);
  if (!(square >= kLeastSquare * squared_length(to))) is_funnel_open_ = false;
  return turn * (std::sqrt(std::max(square, 0.0)) * cross(to, on) + across * dot(to, on)) > 0.0;
}

/// Returns whether the string from the apex to `end` has to turn around `other`, the next pivot on the opposite
/// string of the funnel. This is so if `end` lies beyond the tangent from the apex to `other`, and its own tangent is
/// longer. If there is no tangent, sets `is_funnel_open_` to false.
///
/// Let e and o be the vectors from the centre of the apex to the centres of `end` and `other`. The sine of the angle
/// between e and the tangent to `end` is at most 2 r / |e|. (It is 2 r / |e| if the path turns in opposite directions
/// at the two pivots.) The same is true of o and `other`. The sum of two sines is at least the sine of the sum. So if
/// the sine of the angle between e and o is larger than the sum of these two bounds, a turn from one tangent to the
/// other has the same direction as a turn from e to o. If e lies on the inner side of o by such an angle, `end` does
/// not lie beyond the tangent to `other`, and the function computes no tangent. (The sum of the magnitudes of the two
/// coordinates of a vector is at least the length of the vector.)
bool DiscString::is_across(const Pivot& end, const Pivot& other) {
  const Point to_end_centre = end.centre - row_[apex_].centre;
  const Point to_other_centre = other.centre - row_[apex_].centre;
  const double cross_of_centres = -other.turn * cross(to_other_centre, to_end_centre);
  if (cross_of_centres >
      kDiameterAndMargin * map_->radius * (coordinate_sum(to_end_centre) + coordinate_sum(to_other_centre))) {
    return false;
  }
  const auto to_end = tangent(apex(), end, map_->radius);
  const auto to_other = tangent(apex(), other, map_->radius);
  if (!to_end || !to_other) {
    is_funnel_open_ = false;
    return false;
  }
  const double across = other.turn * cross(to_other->direction, to_end->direction);
  return across > 0.0 && to_other->length < to_end->length;
}

/// Adds the apex of the funnel to the string.
void DiscString::add_apex() {
  const Bend& bend = row_[apex_];
  if (bend.corner == mesh::kNoHalfEdge) {
    stops_.push_back({{{start_, kNoTurn}, mesh::kNoVertex}, mesh::kNoHalfEdge, {}});
  } else {
    stops_.push_back(stop_at(bend.corner, apex_turn_));
  }
}

/// Adds the apex to the string, and makes a bend the new apex.
void DiscString::move_apex(std::size_t to, int turn) {
  add_apex();
  apex_ = to;
  apex_turn_ = turn;
}

/// Moves one end of the portal to the vertex of `corner`, as TautString does: the left end if `turn` is kTurnLeft, the
/// right end if it is kTurnRight.
void DiscString::move(HalfEdge corner, int turn) {
  const bool is_left = turn == kTurnLeft;
  const Bend bend = bend_at(corner);
  std::size_t& end = is_left ? left_ : right_;
  const std::size_t other = is_left ? right_ : left_;
  const std::size_t inwards = is_left ? 1 : kBackwards;  // the step in `row_` from `end` towards the apex
  while (end != apex_ && !turns(end + inwards, row_[end], bend, turn)) end += inwards;
  if (end == apex_) {
    while (apex_ != other && is_across({bend.centre, turn}, {row_[apex_ + inwards].centre, -turn})) {
      move_apex(apex_ + inwards, -turn);
    }
    end = apex_;
  }
  end -= inwards;
  row_[end] = bend;
}

void DiscString::end_at_goal() {
  const Pivot goal{goal_, kNoTurn};
  const std::size_t first = apex_;
  while (apex_ != left_ && is_across(goal, {row_[apex_ - 1].centre, kTurnLeft})) move_apex(apex_ - 1, kTurnLeft);
  if (apex_ == first) {
    while (apex_ != right_ && is_across(goal, {row_[apex_ + 1].centre, kTurnRight})) move_apex(apex_ + 1, kTurnRight);
  }
  add_apex();
}

/// Changes the string until the disc can move along it. Returns false if this does not succeed.
bool DiscString::straighten() {
  std::size_t steps = 8 * stops_.size() + 32;
  for (std::size_t i = 0; i + 1 < stops_.size(); --steps) {
    if (steps == 0) return false;
    const auto line = tangent(stops_[i].end.pivot, stops_[i + 1].end.pivot, map_->radius);
    if (!line) return false;
    stops_[i].line = *line;
    const int turn = stops_[i].end.pivot.turn;
    if (i > 0 && turn * cross(stops_[i - 1].line.direction, line->direction) < -kTurnsBack) {
      stops_.erase(stops_.begin() + static_cast<std::ptrdiff_t>(i));
      --i;
      continue;
    }
    Step step = test(i);
    if (step == Step::forward && i > 0) step = test_arc(i);
    if (step == Step::failed) return false;
    if (step == Step::forward) ++i;
  }
  return true;
}

/// Tests the line from a stop to the next one. If the line has obstacles, inserts one of them.
DiscString::Step DiscString::test(std::size_t i) {
  const Stop& from = stops_[i];
  const Stop& to = stops_[i + 1];
  HalfEdge face = goal_face_;
  if (to.end.vertex != mesh::kNoVertex) {
    const Point& centre = to.end.pivot.centre;
    const Point touching = touching_position(to.end.pivot, from.line.direction, map_->radius);
    const HalfEdge corner = corner_towards(*map_, to.corner, touching - centre, to.end.pivot.turn);
    if (corner == mesh::kNoHalfEdge) return Step::failed;
    stops_[i + 1].corner = corner;
    const DiscLine::FaceAt found = DiscLine::face_at(*map_, centre, touching, corner);
    face = found.h;
    if (found.is_behind_wall) return replace_hidden(i + 1, found.h);
  }
  if (line_.is_clear(*map_, from.end, to.end, from.line, face)) return Step::forward;
  return insert_obstacle(i);
}

/// Replaces a stop. The path cannot touch the circle of the old stop, because `wall` lies between the vertex and the
/// touching position. The new stop is one of the two ends of the wall. For a left turn, it is the end whose tangent
/// from the previous stop points farther to the right; for a right turn, farther to the left.
DiscString::Step DiscString::replace_hidden(std::size_t i, HalfEdge wall) {
  const Stop& before = stops_[i - 1];
  const int turn = stops_[i].end.pivot.turn;
  const mesh::Vertex hidden = stops_[i].end.vertex;
  std::optional<Stop> farthest;
  Point direction;
  for (const HalfEdge corner : {wall, map_->mesh().twin(wall)}) {
    const Stop stop = stop_at(corner, turn);
    if (stop.end.vertex == hidden || stop.end.vertex == before.end.vertex) continue;
    const auto line = tangent(before.end.pivot, stop.end.pivot, map_->radius);
    if (!line) continue;
    if (farthest && turn * cross(direction, line->direction) > 0.0) continue;
    farthest = stop;
    direction = line->direction;
  }
  if (!farthest) return Step::failed;
  stops_[i] = *farthest;
  return Step::again;
}

/// Inserts the obstacle of a line. If there are obstacles on the left and on the right, inserts the obstacle to which
/// the line is shorter.
DiscString::Step DiscString::insert_obstacle(std::size_t i) {
  const DiscLine::Obstacle* obstacle = nullptr;
  int turn = kNoTurn;
  for (const int next_turn : {kTurnLeft, kTurnRight}) {
    const DiscLine::Obstacle& next = next_turn == kTurnLeft ? line_.left() : line_.right();
    if (next.vertex == mesh::kNoVertex) continue;
    if (obstacle != nullptr && obstacle->line.length <= next.line.length) continue;
    obstacle = &next;
    turn = next_turn;
  }
  return obstacle == nullptr ? Step::failed : insert(i + 1, stop_at(obstacle->corner, turn));
}

/// Inserts a stop. Fails if the string already has a stop at this vertex, because then another stop there does not
/// help.
DiscString::Step DiscString::insert(std::size_t i, const Stop& stop) {
  const auto has_vertex = [&](const Stop& other) { return other.end.vertex == stop.end.vertex; };
  if (std::any_of(stops_.begin(), stops_.end(), has_vertex)) return Step::failed;
  stops_.insert(stops_.begin() + static_cast<std::ptrdiff_t>(i), stop);
  return Step::again;
}

/// Tests the arc at a stop. If a wall or a gap that is too narrow ends the turn, inserts a stop at the vertex at the
/// other end of this wall or gap.
DiscString::Step DiscString::test_arc(std::size_t i) {
  const Stop& stop = stops_[i];
  const Point& arrival = stops_[i - 1].line.direction;
  const Pivot& pivot = stop.end.pivot;
  const auto ignore = [](HalfEdge, HalfEdge, double) {};
  const TurnLimit limit = turn_around(*map_, pivot, arrival, stop.corner, ignore);
  if (!is_beyond(limit, pivot, arrival, stop.line.direction)) return Step::forward;
  if (limit.corner == mesh::kNoHalfEdge) return Step::failed;
  return insert(i + 1, stop_at(limit.corner, pivot.turn));
}

double DiscString::length() const {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
    const Stop& stop = stops_[i];
    if (i > 0) length += arc_length(stop.end.pivot, stops_[i - 1].line.direction, stop.line.direction, map_->radius);
    length += stop.line.length;
  }
  return length;
}

void DiscString::write_path(std::vector<DiscPiece>& pieces) {
  path_.clear();
  for (const Stop& stop : stops_) path_.push_back({stop.end.pivot, stop.line.direction});
  path_.pop_back();
  write_disc_pieces(*map_, path_, goal_, pieces);
}

}  // namespace waywright::path

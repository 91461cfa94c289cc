#include "waywright/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "waywright/assert.hpp"

#include "base/float_environment.hpp"
#include "base/ieee.hpp"
#include "exact/doubles.hpp"
#include "exact/position.hpp"
#include "exact/predicates.hpp"
#include "path/distance.hpp"
#include "path/pieces.hpp"

namespace waywright {

namespace {

using exact::Sign;

/// Returns the coordinate in the given precision that is nearest to `value`. A number beyond the largest coordinate
/// becomes the largest coordinate with the same sign. A number too near to 0, or NaN, becomes 0.
double fitted(double value, Precision precision) {
  if (precision == Precision::float32) value = static_cast<double>(static_cast<float>(value));
  if (is_in_range(value)) return value;
  return std::abs(value) > kLargestCoordinate ? std::copysign(kLargestCoordinate, value) : 0.0;
}

/// Returns the coordinate next to `value` in the given precision: above `value` if `direction` is positive, below
/// `value` if it is negative. Returns `value` itself if `direction` is 0.
double next_coordinate(double value, double direction, Precision precision) {
  if (direction == 0.0) return value;
  return precision == Precision::float32 ? exact::next_coordinate<float>(value, direction)
                                         : exact::next_coordinate<double>(value, direction);
}

Sign orientation(const Point& a, const Point& b, const Point& c) {
  return exact::orientation(exact::explicit_position(a), exact::explicit_position(b), exact::explicit_position(c));
}

/// A turn of the path: the index of its point, and its direction, which is zero if there is no turn.
struct Turn {
  std::size_t point = 0;
  Sign direction = Sign::zero;
};

/// turn_after() returns the first turn at or after the end of a segment, turn_before() the last turn at or before its
/// start. A point on the line of the segment is no turn.
Turn turn_after(const std::vector<Point>& points, std::size_t segment) {
  for (std::size_t i = segment + 2; i < points.size(); ++i) {
    const Sign direction = orientation(points[segment], points[segment + 1], points[i]);
    if (direction != Sign::zero) return {i - 1, direction};
  }
  return {};
}
Turn turn_before(const std::vector<Point>& points, std::size_t segment) {
  for (std::size_t i = segment; i-- > 0;) {
    const Sign direction = orientation(points[i], points[segment], points[segment + 1]);
    if (direction != Sign::zero) return {i + 1, direction};
  }
  return {};
}

/// A path turns around walls. So near a left turn, the walls that it touches lie to the left of the path, and near a
/// right turn to the right. Returns in which direction from the segment no wall is expected: positive means left,
/// negative means right, and zero means that nothing is known.
Sign free_direction(const std::vector<Point>& points, std::size_t segment, const Point& point) {
  const Turn before = turn_before(points, segment);
  const Turn after = turn_after(points, segment);
  const bool counts_after =
      before.direction == Sign::zero ||
      (after.direction != Sign::zero && distance(point, points[after.point]) < distance(point, points[before.point]));
  const Sign turn = counts_after ? after.direction : before.direction;
  if (turn == Sign::zero) return Sign::zero;
  return turn == Sign::positive ? Sign::negative : Sign::positive;
}

/// Returns the coordinate at the distance `step` from `value`, or at least the next one: above or below `value`, as for
/// next_coordinate().
double moved_coordinate(double value, double direction, double step, Precision precision) {
  if (direction == 0.0) return value;
  const double moved = fitted(value + std::copysign(step, direction), precision);
  return (moved - value) * direction > 0.0 ? moved : next_coordinate(value, direction, precision);
}

/// Returns a point near `point` that lies on the line from `a` to `b`, or to the left of it if `towards` is positive,
/// or to the right of it if `towards` is negative. Returns `point` if `towards` is zero. The first step is as long as
/// the rounding error of a point between `a` and `b`. Near 0 this error is far larger than the distance of neighbouring
/// doubles.
Point away_from_walls(const Point& a, const Point& b, const Point& point, Sign towards, Precision precision) {
  const auto is_allowed = [&](const Point& p) {
    const Sign own = orientation(a, b, p);
    return own == Sign::zero || own == towards;
  };
  if (towards == Sign::zero || is_allowed(point)) return point;
  const double sign = towards == Sign::positive ? 1.0 : -1.0;
  const Point direction{-sign * (b.y - a.y), sign * (b.x - a.x)};
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  for (double step = largest * 0x1p-52;; step *= 2.0) {
    const Point next{moved_coordinate(point.x, direction.x, step, precision),
                     moved_coordinate(point.y, direction.y, step, precision)};
    for (const Point& candidate : {Point{next.x, point.y}, Point{point.x, next.y}, next}) {
      if (is_allowed(candidate)) return candidate;
    }
  }
}

/// Where a position lies: `along` from the start of a segment or piece of a path.
struct Stop {
  std::size_t segment = 0;
  double before = 0.0;  ///< the length of the path up to the start of the segment
  double along = 0.0;
  double length = 0.0;  ///< of the segment
};

/// Returns where the position at distance `total` from the start lies. Starts to count at the segment of `from` if the
/// position does not lie before it.
Stop find_stop(const std::vector<Point>& points, const PathPosition& from, double total) {
  const bool goes_on = total >= from.before && from.segment + 1 < points.size();
  std::size_t segment = goes_on ? from.segment : 0;
  double before = goes_on ? from.before : 0.0;
  for (;; ++segment) {
    const double length = waywright::distance(points[segment], points[segment + 1]);
    if (total - before < length || segment + 2 == points.size()) {
      return {segment, before, std::min(total - before, length), length};
    }
    before += length;
  }
}

/// If rounding makes the distance of the position equal to the length of the path, returns the end of the path.
Stop find_stop(const std::vector<PathPiece>& pieces, const PathPosition& from, double total) {
  const bool goes_on = total >= from.before && from.segment < pieces.size();
  std::size_t segment = goes_on ? from.segment : 0;
  double before = goes_on ? from.before : 0.0;
  for (;; ++segment) {
    const double length = path::length_of(pieces[segment]);
    const double end = before + length;
    if (total < end || segment + 1 == pieces.size()) {
      const double along = std::min(total - before, length);
      return {segment, before, before + along < end ? along : length, length};
    }
    before = end;
  }
}

PathPosition position_on(const std::vector<Point>& points, const Stop& stop, Precision precision) {
  const auto [segment, before, along, length] = stop;
  const Point& a = points[segment];
  const Point& b = points[segment + 1];
  PathPosition position{{}, {}, segment, before, before + along};
  if (length > 0.0) position.heading = {(b.x - a.x) / length, (b.y - a.y) / length};
  const double share = length > 0.0 ? along / length : 0.0;
  const bool is_corner = along <= 0.0 || along >= length;
  const Point corner = along <= 0.0 ? a : b;
  const Point exact_position = is_corner ? corner : Point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  if (is_corner && precision == Precision::float64) {
    position.at = corner;
    return position;
  }
  const Point point{fitted(exact_position.x, precision), fitted(exact_position.y, precision)};
  position.at = away_from_walls(a, b, point, free_direction(points, segment, point), precision);
  return position;
}

PathPosition position_on(const std::vector<PathPiece>& pieces, const Stop& stop, Precision precision) {
  const Point at = path::position_at(pieces[stop.segment], stop.along);
  return {{fitted(at.x, precision), fitted(at.y, precision)},
          path::heading_at(pieces, stop.segment, stop.along),
          stop.segment,
          stop.before,
          stop.before + stop.along};
}

Stop nearest_stop(const std::vector<Point>& points, const Point& point) {
  Stop best;
  double best_distance = std::numeric_limits<double>::infinity();
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point direction{points[i + 1].x - points[i].x, points[i + 1].y - points[i].y};
    const double length = waywright::distance(points[i], points[i + 1]);
    const Point foot = path::foot(point, points[i], direction);
    const double ahead = (foot.x - points[i].x) * direction.x + (foot.y - points[i].y) * direction.y;
    const double along = ahead <= 0.0 ? 0.0 : std::min(waywright::distance(points[i], foot), length);
    const double share = length > 0.0 ? along / length : 0.0;
    const double distance =
        waywright::distance(point, {points[i].x + share * direction.x, points[i].y + share * direction.y});
    if (distance < best_distance) {
      best_distance = distance;
      best = {i, before, along, length};
    }
    before += length;
  }
  return best;
}

Stop nearest_stop(const std::vector<PathPiece>& pieces, const Point& point) {
  Stop best;
  double best_distance = std::numeric_limits<double>::infinity();
  double before = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const path::NearestOnPiece nearest = path::nearest_on(pieces[i], point);
    const double length = path::length_of(pieces[i]);
    if (nearest.distance < best_distance) {
      best_distance = nearest.distance;
      best = {i, before, nearest.along, length};
    }
    before += length;
  }
  return best;
}

/// The only position on a path of one point.
PathPosition only_position(const Point& point, Precision precision) {
  return {{fitted(point.x, precision), fitted(point.y, precision)}, {}, 0, 0.0, 0.0};
}

}  // namespace

std::string_view to_string(PathStatus status) {
  switch (status) {
    case PathStatus::found:
      return "found";
    case PathStatus::start_blocked:
      return "start-blocked";
    case PathStatus::goal_blocked:
      return "goal-blocked";
    case PathStatus::no_path:
      return "no-path";
  }
  return "unknown";
}

std::string_view to_string(PathAlgorithm algorithm) {
  switch (algorithm) {
    case PathAlgorithm::ta:
      return "ta";
    case PathAlgorithm::tra:
      return "tra";
    case PathAlgorithm::optimal:
      return "optimal";
  }
  return "unknown";
}

std::optional<PathAlgorithm> path_algorithm(std::string_view name) {
  for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal}) {
    if (to_string(algorithm) == name) return algorithm;
  }
  return std::nullopt;
}

PathPosition Path::at(double distance, Precision precision) const { return advance({}, distance, precision); }

PathPosition Path::advance(const PathPosition& from, double step, Precision precision) const {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(!points.empty() || !pieces.empty(), "Path::at and Path::advance: the path has no points");
  const double asked = from.distance + (std::isnan(step) ? 0.0 : step);
  const double total = asked > 0.0 ? asked : 0.0;  // NaN gives 0
  if (!pieces.empty()) return position_on(pieces, find_stop(pieces, from, total), precision);
  if (points.size() == 1) return only_position(points.front(), precision);
  return position_on(points, find_stop(points, from, total), precision);
}

PathPosition Path::nearest(const Point& point, Precision precision) const {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(!points.empty() || !pieces.empty(), "Path::nearest: the path has no points");
  if (!pieces.empty()) return position_on(pieces, nearest_stop(pieces, point), precision);
  if (points.size() == 1) return only_position(points.front(), precision);
  return position_on(points, nearest_stop(points, point), precision);
}

Result<void> Path::polyline(double tolerance, std::vector<Point>& line) const {
  const base::FloatEnvironment environment;
  if (!(tolerance >= agent.radius * path::kSmallestTolerance)) {
    return Error{
        ErrorCode::bad_distance, "the tolerance is negative, not a number, or below 2^-20 times the radius", {}, 0};
  }
  line.assign(points.begin(), points.end());
  path::append_polyline(pieces, tolerance, line);
  return {};
}

Result<std::vector<Point>> Path::polyline(double tolerance) const {
  std::vector<Point> line;
  if (auto done = polyline(tolerance, line); !done) return done.error();
  return line;
}

}  // namespace waywright

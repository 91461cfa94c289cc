#include "path/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ieee.hpp"
#include "path/distance.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

namespace {

bool is_arc(const PathPiece& piece) { return piece.kind == PathPiece::Kind::arc; }

/// Returns 1 if an arc turns left, and -1 if it turns right.
double turn_sign(const PathPiece& arc) { return arc.end_angle > arc.start_angle ? 1.0 : -1.0; }

double turn_of(const PathPiece& arc) { return std::abs(arc.end_angle - arc.start_angle); }

/// Returns the direction from the centre of an arc to the position at the distance `along` from the start of the arc.
/// Passes on the rounding error of the sum of the two angles (Knuth's TwoSum), because the sum can be three times as
/// large as the angle of a direction.
Point radial_at(const PathPiece& arc, double along) {
  const double turned = turn_sign(arc) * (along / arc.radius);
  const double angle = arc.start_angle + turned;
  const double added = angle - arc.start_angle;
  return unit_vector(angle, (arc.start_angle - (angle - added)) + (turned - added));
}

/// Returns the direction of the path on an arc.
Point heading_on(const PathPiece& arc, double along) { return turn_sign(arc) * left_of(radial_at(arc, along)); }

/// Returns the nearest position on a straight line.
NearestOnPiece nearest_on_line(const Point& a, const Point& b, const Point& point) {
  const Point direction = b - a;
  const double squared = squared_length(direction);
  const double share = squared > kNoLength ? std::clamp(dot(point - a, direction) / squared, 0.0, 1.0) : 0.0;
  return {share * std::sqrt(squared), distance(point, lerp(a, b, share))};
}

double distance_to(const Box& box, const Point& p) {
  const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
  const double y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
  return length({x, y});
}

/// Returns whether a box is at most `reach` away from the straight line from `a` to `b`.
bool is_near_line(const Point& a, const Point& b, const Box& box, double reach) {
  Box extent{a, a};
  extent.expand(b);
  const Box near = extent.expanded(reach);
  if (!near.overlaps(box)) return false;
  // Cuts off the piece of the box that is far from the line. So no coordinate of the rest is much larger than the
  // coordinates of the line.
  const Box cut{{std::max(box.min.x, near.min.x), std::max(box.min.y, near.min.y)},
                {std::min(box.max.x, near.max.x), std::min(box.max.y, near.max.y)}};
  if (distance_to(cut, a) <= reach || distance_to(cut, b) <= reach) return true;
  bool has_left = false;
  bool has_right = false;
  for (const Point& corner : {cut.min, Point{cut.max.x, cut.min.y}, cut.max, Point{cut.min.x, cut.max.y}}) {
    if (nearest_on_line(a, b, corner).distance <= reach) return true;
    (cross(b - a, corner - a) > 0.0 ? has_left : has_right) = true;
  }
  // No corner and no end is near. So the box is near only if the line crosses it.
  return has_left && has_right && extent.overlaps(cut);
}

/// Returns whether a box is at most `reach` away from an arc. Tests chords that are at most a 64th of the radius away
/// from the arc. So the result can also be true if the distance is up to a 32nd of the radius larger.
bool is_near_arc(const PathPiece& arc, const Box& box, double reach) {
  if (distance_to(box, arc.centre) > arc.radius + reach) return false;
  const double sagitta = arc.radius * 0x1p-6;
  const std::size_t count = chord_count(arc, sagitta);
  const double length = length_of(arc);
  Point from = arc.from;
  for (std::size_t i = 1; i <= count; ++i) {
    const Point to = position_at(arc, length * (static_cast<double>(i) / static_cast<double>(count)));
    if (is_near_line(from, to, box, reach + sagitta)) return true;
    from = to;
  }
  return false;
}

double largest_coordinate(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

double largest_coordinate(const PathPiece& piece) {
  double largest = 0.0;
  for (const Point& p : {piece.from, piece.to, piece.centre}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return largest;
}

}  // namespace

double length_of(const PathPiece& piece) {
  return is_arc(piece) ? turn_of(piece) * piece.radius : distance(piece.from, piece.to);
}

double length_of(std::span<const PathPiece> pieces) {
  double length = 0.0;
  for (const PathPiece& piece : pieces) length += length_of(piece);
  return length;
}

Point position_at(const PathPiece& piece, double along) {
  if (along <= 0.0) return piece.from;
  const double length = length_of(piece);
  if (along >= length) return piece.to;
  if (is_arc(piece)) return piece.centre + piece.radius * radial_at(piece, along);
  return lerp(piece.from, piece.to, along / length);
}

Point heading_at(std::span<const PathPiece> pieces, std::size_t i, double along) {
  const PathPiece& piece = pieces[i];
  if (is_arc(piece)) return heading_on(piece, along);
  if (i > 0 && is_arc(pieces[i - 1])) return heading_on(pieces[i - 1], length_of(pieces[i - 1]));
  if (i + 1 < pieces.size() && is_arc(pieces[i + 1])) return heading_on(pieces[i + 1], 0.0);
  const double length = length_of(piece);
  return length > 0.0 ? (piece.to - piece.from) / length : Point{};
}

NearestOnPiece nearest_on(const PathPiece& piece, const Point& point) {
  if (!is_arc(piece)) return nearest_on_line(piece.from, piece.to, point);
  const double length = length_of(piece);
  NearestOnPiece nearest{0.0, distance(point, piece.from)};
  const Point radial = point - piece.centre;
  const Point start = unit_vector(piece.start_angle);
  const double turned = turning_angle(start, radial, turn_sign(piece) > 0.0 ? 1 : -1);
  if (turned < turn_of(piece)) {
    const double between = std::abs(waywright::length(radial) - piece.radius);
    if (between < nearest.distance) nearest = {std::min(turned * piece.radius, length), between};
  } else if (const double to_end = distance(point, piece.to); to_end < nearest.distance) {
    nearest = {length, to_end};
  }
  return nearest;
}

// A chord over the angle 2 h is r (1 - cos h) = 2 r sin^2(h / 2) away from the arc.
std::size_t chord_count(const PathPiece& arc, double tolerance) {
  const double square = std::clamp(tolerance / (2.0 * arc.radius), kSmallestTolerance / 2.0, 0.25);
  const double chord_angle = 4.0 * angle_of({std::sqrt(1.0 - square), std::sqrt(square)});
  return static_cast<std::size_t>(std::max(std::ceil(turn_of(arc) / chord_angle), 1.0));
}

void append_polyline(std::span<const PathPiece> pieces, double tolerance, std::vector<Point>& points) {
  const auto append = [&points](const Point& p) {
    if (points.empty() || !(points.back() == p)) points.push_back(p);
  };
  for (const PathPiece& piece : pieces) {
    append(piece.from);
    const std::size_t count = is_arc(piece) ? chord_count(piece, tolerance) : 1;
    const double length = length_of(piece);
    for (std::size_t i = 1; i < count; ++i) {
      append(position_at(piece, length * (static_cast<double>(i) / static_cast<double>(count))));
    }
    append(piece.to);
  }
}

// The rounding errors of the positions, and of the distances to them, are below 2^-45 of the largest coordinate.
bool may_touch(std::span<const PathPiece> pieces, double radius, const Box& box) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const PathPiece& piece) {
    const double reach = radius + 0x1p-45 * (largest_coordinate(piece) + radius);
    return is_arc(piece) ? is_near_arc(piece, box, reach) : is_near_line(piece.from, piece.to, box, reach);
  });
}

bool may_touch(std::span<const Point> polyline, double radius, const Box& box) {
  if (polyline.empty()) return false;
  const auto is_near = [&](const Point& a, const Point& b) {
    const double largest = std::max(largest_coordinate(a), largest_coordinate(b));
    return is_near_line(a, b, box, radius + 0x1p-45 * (largest + radius));
  };
  if (is_near(polyline.front(), polyline.front())) return true;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    if (is_near(polyline[i - 1], polyline[i])) return true;
  }
  return false;
}

}  // namespace waywright::path

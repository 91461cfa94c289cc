#include "svg/path_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "svg/elements.hpp"

namespace waywright::svg {

namespace {

constexpr std::size_t kLong = 1000000;
constexpr double kStrokeRoom = 64.0;  // more than half the width of the widest stroke

}  // namespace

PathData::PathData(const SvgFrame& frame, double stroke_width) : frame_(frame), near_(frame.map()) {
  const double room = kStrokeRoom + stroke_width / 2.0;
  near_.min = {near_.min.x - room, near_.min.y - room};
  near_.max = {near_.max.x + room, near_.max.y + room};
}

void PathData::add_chain(PointSpan points) {
  is_continued_ = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    add_line(frame_.to_picture(points[i - 1]), frame_.to_picture(points[i]));
  }
}

void PathData::add_line(Point a, Point b) {
  const Point whole = b;
  if (!clip_segment(near_, a, b)) {
    is_continued_ = false;
    return;
  }
  if (!is_continued_) move_to(a);
  line_to(b);
  is_continued_ = b == whole;
}

void PathData::add_segment(const Point& a, const Point& b) {
  const std::array<Point, 2> ends{a, b};
  add_chain(ends);
}

void PathData::add_ring(PointSpan points) {
  ring_.clear();
  for (const Point& point : points) ring_.push_back(frame_.to_picture(point));
  clip_ring(near_, ring_, scratch_);
  if (ring_.empty()) return;
  move_to(ring_.front());
  for (std::size_t i = 1; i < ring_.size(); ++i) line_to(ring_[i]);
  text_ += 'Z';
}

void PathData::add_dot(const Point& position) {
  const Point pixels = frame_.to_picture(position);
  if (!contains(near_, pixels)) return;
  move_to(pixels);
  line_to(pixels);
}

std::string PathData::take_if_long() { return text_.size() < kLong ? std::string() : std::exchange(text_, {}); }

void PathData::move_to(const Point& pixels) {
  has_line_ = false;
  append('M', pixels);
}

/// Leaves out a point that rounds to the same two decimals as the point before, but never all points of a line.
void PathData::line_to(const Point& pixels) {
  const Point rounded{std::round(pixels.x * 100.0), std::round(pixels.y * 100.0)};
  if (rounded == last_) {
    if (!has_line_) text_ += "h0";
  } else {
    append('L', pixels);
  }
  has_line_ = true;
}

void PathData::append(char command, const Point& pixels) {
  last_ = {std::round(pixels.x * 100.0), std::round(pixels.y * 100.0)};
  text_ += command;
  append_pixels(text_, pixels.x);
  text_ += ' ';
  append_pixels(text_, pixels.y);
}

}  // namespace waywright::svg

// The arcs of a path element.

namespace waywright::svg {

namespace {

// The code draws an arc that is flatter than this as a line, because nobody sees the difference.
constexpr double kFlatPixels = 0.05;
constexpr double kFlatAngle = 1e-9;
// Rounding to hundredths of a pixel moves the middle of a longer arc visibly.
constexpr double kLongAngle = std::numbers::pi / 2.0;

/// The largest distance of the end of an arc from its circle, as a fraction of the radius.
constexpr double kInexact = 1e-3;

double length_of(const Point& vector) { return std::sqrt(vector.x * vector.x + vector.y * vector.y); }

/// Returns whether a point lies on a circle, apart from rounding errors.
bool is_on_circle(const Point& centre, double radius, const Point& point) {
  return std::fabs(length_of({point.x - centre.x, point.y - centre.y}) - radius) <= kInexact * radius;
}

}  // namespace

void PathData::add_pieces(std::span<const PathPiece> pieces) {
  is_continued_ = false;
  for (const PathPiece& piece : pieces) {
    const Point from = frame_.to_picture(piece.from);
    const Point to = frame_.to_picture(piece.to);
    const Point centre = frame_.to_picture(piece.centre);
    const double radius = piece.radius * frame_.scale();
    const bool is_arc =
        piece.kind == PathPiece::Kind::arc && is_on_circle(centre, radius, from) && is_on_circle(centre, radius, to);
    if (!is_arc) {
      add_line(from, to);
      continue;
    }
    const bool is_left_turn = piece.end_angle > piece.start_angle;
    add_arc({centre, radius, is_left_turn == frame_.y_down(), from, to,
             std::min(std::fabs(piece.end_angle - piece.start_angle), 2.0 * std::numbers::pi)});
  }
}

/// Returns the point in the middle of an arc.
Point PathData::middle_of(const Arc& arc) {
  const Point start{arc.from.x - arc.centre.x, arc.from.y - arc.centre.y};
  const Point end{arc.to.x - arc.centre.x, arc.to.y - arc.centre.y};
  Point towards{start.x + end.x, start.y + end.y};
  if (arc.angle > kLongAngle) {
    // The sum is inexact if the ends are nearly opposite, and has the wrong direction for more than half a circle.
    const double turn = arc.is_rising ? 1.0 : -1.0;
    towards = {turn * (end.y - start.y), turn * (start.x - end.x)};
  }
  const double length = length_of(towards);
  return {arc.centre.x + arc.radius * (towards.x / length), arc.centre.y + arc.radius * (towards.y / length)};
}

/// Divides the arc until each piece of it is flat, near the map or far from the map.
void PathData::add_arc(const Arc& arc) {
  const Point middle = middle_of(arc);
  if (!(arc.angle > kFlatAngle) || !is_finite(middle) || !is_finite(arc.from) || !is_finite(arc.to)) {
    add_line(arc.from, arc.to);
    return;
  }
  if (arc.angle <= kLongAngle) {
    const double height =
        length_of({(arc.from.x + arc.to.x) / 2.0 - middle.x, (arc.from.y + arc.to.y) / 2.0 - middle.y});
    if (height <= kFlatPixels) {
      add_line(arc.from, arc.to);
      return;
    }
    const Box box{{std::min(arc.from.x, arc.to.x) - height, std::min(arc.from.y, arc.to.y) - height},
                  {std::max(arc.from.x, arc.to.x) + height, std::max(arc.from.y, arc.to.y) + height}};
    if (!meets(near_, box)) {
      is_continued_ = false;
      return;
    }
    if (contains(near_, box)) {
      add_whole_arc(arc);
      return;
    }
  }
  add_arc({arc.centre, arc.radius, arc.is_rising, arc.from, middle, arc.angle / 2.0});
  add_arc({arc.centre, arc.radius, arc.is_rising, middle, arc.to, arc.angle / 2.0});
}

void PathData::add_whole_arc(const Arc& arc) {
  if (!is_continued_) move_to(arc.from);
  is_continued_ = true;
  text_ += 'A';
  append_pixels(text_, arc.radius);
  text_ += ' ';
  append_pixels(text_, arc.radius);
  text_ += arc.is_rising ? " 0 0 1 " : " 0 0 0 ";
  append_pixels(text_, arc.to.x);
  text_ += ' ';
  append_pixels(text_, arc.to.y);
  last_ = {std::round(arc.to.x * 100.0), std::round(arc.to.y * 100.0)};
  has_line_ = true;
}

namespace {

/// Narrows the range [from, to] of t to the values for which start + t * step lies between low and high. Returns
/// whether any are left.
bool narrow(double start, double step, double low, double high, double& from, double& to) {
  if (step == 0.0) return start >= low && start <= high;
  const double to_low = (low - start) / step;
  const double to_high = (high - start) / step;
  from = std::max(from, std::min(to_low, to_high));
  to = std::min(to, std::max(to_low, to_high));
  return from <= to;
}

/// The half-plane inside a side of the box: where sign * (x or y) <= limit.
struct HalfPlane {
  double Point::*axis;
  double sign;
  double limit;
};

double beyond(const HalfPlane& half_plane, const Point& point) {
  return half_plane.sign * point.*half_plane.axis - half_plane.limit;
}

/// Returns the point where the segment meets the border of the half-plane. Requires: one of `a` and `b` lies inside,
/// the other outside.
Point intersection(const HalfPlane& half_plane, const Point& a, const Point& b) {
  const double at_a = beyond(half_plane, a);
  const double part = at_a / (at_a - beyond(half_plane, b));
  Point position{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  position.*half_plane.axis = half_plane.sign * half_plane.limit;
  return position;
}

void clip_to(const HalfPlane& half_plane, const std::vector<Point>& ring, std::vector<Point>& clipped) {
  clipped.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& from = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Point& to = ring[i];
    const bool is_inside = beyond(half_plane, to) <= 0.0;
    if (is_inside != (beyond(half_plane, from) <= 0.0)) clipped.push_back(intersection(half_plane, from, to));
    if (is_inside) clipped.push_back(to);
  }
}

}  // namespace

bool clip_segment(const Box& box, Point& a, Point& b) {
  const Point step{b.x - a.x, b.y - a.y};
  if (!is_finite(a) || !is_finite(step)) return false;
  double from = 0.0;
  double to = 1.0;
  if (!narrow(a.x, step.x, box.min.x, box.max.x, from, to)) return false;
  if (!narrow(a.y, step.y, box.min.y, box.max.y, from, to)) return false;
  const Point start = a;
  if (from > 0.0) a = {start.x + from * step.x, start.y + from * step.y};
  if (to < 1.0) b = {start.x + to * step.x, start.y + to * step.y};
  return true;
}

void clip_ring(const Box& box, std::vector<Point>& ring, std::vector<Point>& scratch) {
  std::erase_if(ring, [](const Point& point) { return !is_finite(point); });
  for (const HalfPlane& half_plane : {HalfPlane{&Point::x, -1.0, -box.min.x}, HalfPlane{&Point::x, 1.0, box.max.x},
                                      HalfPlane{&Point::y, -1.0, -box.min.y}, HalfPlane{&Point::y, 1.0, box.max.y}}) {
    if (std::all_of(ring.begin(), ring.end(), [&](const Point& point) { return beyond(half_plane, point) <= 0.0; }))
      continue;
    clip_to(half_plane, ring, scratch);
    ring.swap(scratch);
  }
}

}  // namespace waywright::svg

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/svg_canvas.hpp"

// The arcs of a path element.

namespace waywright::io {

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

}  // namespace waywright::io

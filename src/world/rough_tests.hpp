#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright {

// Tests of segments in doubles.

/// Returns true only if the two segments surely cross, also if each coordinate of their ends is wrong by `slack`. Two
/// segments cross if one end of each segment lies left of the line through the other segment, and the other end lies
/// right of this line.
inline bool surely_cross(const Point& a, const Point& b, const Point& c, const Point& d, double slack) {
  const auto extent = [](const Point& p) { return std::abs(p.x) + std::abs(p.y); };
  const auto are_apart = [&](const Point& from, const Point& along, const Point& p, const Point& q) {
    const Point to_p = p - from;
    const Point to_q = q - from;
    const double error = 8.0 * slack * (extent(along) + extent(to_p) + extent(to_q) + slack);
    const double at_p = cross(along, to_p);
    const double at_q = cross(along, to_q);
    return std::min(at_p, at_q) < -error && std::max(at_p, at_q) > error;
  };
  return are_apart(a, b - a, c, d) && are_apart(c, d - c, a, b);
}

/// Returns whether a segment meets a box. Rounding errors may make the answer wrong.
inline bool probably_meets(const Point& a, const Point& b, const Box& box) {
  if (std::max(a.x, b.x) < box.min.x || std::min(a.x, b.x) > box.max.x) return false;
  if (std::max(a.y, b.y) < box.min.y || std::min(a.y, b.y) > box.max.y) return false;
  const Point along = b - a;
  const Point centre = 0.5 * (box.min + box.max);
  return 2.0 * std::abs(cross(along, centre - a)) <= std::abs(along.x) * box.height() + std::abs(along.y) * box.width();
}

}  // namespace waywright

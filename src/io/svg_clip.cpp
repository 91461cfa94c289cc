#include "io/svg_clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "io/svg_canvas.hpp"

namespace waywright::io {

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

}  // namespace waywright::io

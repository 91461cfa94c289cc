#include "waywright/item.hpp"

#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/assert.hpp"

#include "base/float_environment.hpp"

namespace waywright {

namespace {

struct Moments {
  double area = 0.0;
  double x = 0.0;
  double y = 0.0;
};

/// Returns the moments about `origin`. A near origin keeps the result accurate for small shapes far from (0, 0). The
/// area is positive if the ring is counter-clockwise.
Moments moments(PointSpan ring, const Point& origin) {
  Moments sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& next = ring[(i + 1) % ring.size()];
    const double px = ring[i].x - origin.x;
    const double py = ring[i].y - origin.y;
    const double qx = next.x - origin.x;
    const double qy = next.y - origin.y;
    const double cross = px * qy - qx * py;
    sum.area += cross / 2.0;
    sum.x += (px + qx) * cross / 6.0;
    sum.y += (py + qy) * cross / 6.0;
  }
  return sum;
}

/// The number of times that the ring goes around the point.
int winding_number(const Point& point, PointSpan ring) {
  int number = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& p = ring[i];
    const Point& q = ring[(i + 1) % ring.size()];
    if ((p.y > point.y) == (q.y > point.y)) continue;
    if (point.x < p.x + (q.x - p.x) * ((point.y - p.y) / (q.y - p.y))) number += q.y > p.y ? 1 : -1;
  }
  return number;
}

/// Returns the factor by which the ring's area counts in the area of its shape: 1, -1 for a hole, or 0 if it makes no
/// difference.
double share_of_ring(const Shape& shape, std::size_t ring, bool is_counter_clockwise) {
  int outside = 0;
  for (std::size_t i = 0; i < shape.rings.size(); ++i) {
    if (i != ring) outside += winding_number(shape.rings[ring].front(), shape.rings[i]);
  }
  const int inside = outside + (is_counter_clockwise ? 1 : -1);
  return static_cast<double>(is_filled(shape.fill, inside)) - static_cast<double>(is_filled(shape.fill, outside));
}

Point mean_of_points(const Shape& shape, const Point& origin) {
  double x = 0.0;
  double y = 0.0;
  double count = 0.0;
  for (const Point& point : shape.rings.points()) {
    x += point.x - origin.x;
    y += point.y - origin.y;
    count += 1.0;
  }
  return {origin.x + x / count, origin.y + y / count};
}

/// Returns the cosine and the sine of an angle within [0, pi / 4], by their series. The first terms left out are below
/// 2^-54. The functions of the standard library differ from machine to machine; sums, products and quotients do not.
Point direction(double angle) {
  const double square = angle * angle;
  double cosine = 1.0;
  double sine = 1.0;
  for (int i = 16; i >= 2; i -= 2) {
    cosine = 1.0 - cosine * square / (i * (i - 1));
    sine = 1.0 - sine * square / (i * (i + 1));
  }
  return {cosine, angle * sine};
}

/// Returns the direction after i / n of a full circle. Computes it for an angle of at most an eighth of a circle, and
/// then reflects it and rotates it by multiples of 90 degrees.
Point direction(std::size_t i, std::size_t n) {
  const std::size_t eighth = 8 * i / n;
  const std::size_t rest = 8 * i % n;
  const bool is_reflected = eighth % 2 == 1;
  const double share = static_cast<double>(is_reflected ? n - rest : rest) / static_cast<double>(n);
  Point result = direction(std::numbers::pi / 4 * share);
  if (is_reflected) result = {result.y, result.x};
  for (std::size_t quarter = 0; quarter < eighth / 2; ++quarter) result = {-result.y, result.x};
  return result;
}

}  // namespace

std::string_view to_string(ItemKind kind) {
  switch (kind) {
    case ItemKind::point:
      return "point";
    case ItemKind::segment:
      return "segment";
    case ItemKind::polyline:
      return "polyline";
    case ItemKind::polygon:
      return "polygon";
  }
  return "unknown";
}

std::string_view to_string(FillRule rule) {
  switch (rule) {
    case FillRule::even_odd:
      return "even-odd";
    case FillRule::nonzero:
      return "nonzero";
  }
  return "unknown";
}

Shape Shape::regular_polygon(const Point& centre, double radius, std::size_t corner_count) {
  const base::FloatEnvironment environment;
  if (corner_count < 3) return {ItemKind::polygon, {}};
  std::vector<Point> ring;
  ring.reserve(corner_count);
  for (std::size_t i = 0; i < corner_count; ++i) {
    const Point towards = direction(i, corner_count);
    ring.push_back({centre.x + radius * towards.x, centre.y + radius * towards.y});
  }
  return polygon(std::move(ring));
}

Shape translated(const Shape& shape, double dx, double dy) {
  const base::FloatEnvironment environment;
  Shape moved = shape;
  for (Point& point : moved.rings.points()) point = {point.x + dx, point.y + dy};
  return moved;
}

Point centroid(const Shape& shape) {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(!shape.rings.points().empty(), "centroid: the shape has no point");
  const Point origin = shape.rings.points().front();
  if (shape.kind != ItemKind::polygon) return mean_of_points(shape, origin);
  Moments sum;
  for (std::size_t i = 0; i < shape.rings.size(); ++i) {
    const Moments ring = moments(shape.rings[i], origin);
    const bool is_counter_clockwise = ring.area > 0.0;
    const double share = share_of_ring(shape, i, is_counter_clockwise) * (is_counter_clockwise ? 1.0 : -1.0);
    sum.area += share * ring.area;
    sum.x += share * ring.x;
    sum.y += share * ring.y;
  }
  if (!(sum.area > 0.0)) return mean_of_points(shape, origin);
  return {origin.x + sum.x / sum.area, origin.y + sum.y / sum.area};
}

}  // namespace waywright

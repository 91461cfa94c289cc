#include <cmath>
#include <cstddef>

#include "waywright/item.hpp"

#include "base/float_environment.hpp"

namespace waywright {

namespace {

struct Moments {
  double area = 0.0;
  double x = 0.0;
  double y = 0.0;
};

/// About `origin`, which keeps small things far from (0, 0) accurate. The area is positive whichever way the ring
/// turns.
Moments moments(const std::vector<Point>& ring, const Point& origin) {
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
  return sum.area < 0.0 ? Moments{-sum.area, -sum.x, -sum.y} : sum;
}

bool is_within(const Point& point, const std::vector<Point>& ring) {
  bool is_inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& p = ring[i];
    const Point& q = ring[(i + 1) % ring.size()];
    if ((p.y > point.y) == (q.y > point.y)) continue;
    if (point.x < p.x + (q.x - p.x) * ((point.y - p.y) / (q.y - p.y))) is_inside = !is_inside;
  }
  return is_inside;
}

bool is_hole(const std::vector<std::vector<Point>>& rings, std::size_t ring) {
  std::size_t around = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (i != ring && is_within(rings[ring].front(), rings[i])) ++around;
  }
  return around % 2 == 1;
}

Point mean_of_points(const Shape& shape, const Point& origin) {
  double x = 0.0;
  double y = 0.0;
  double count = 0.0;
  for (const std::vector<Point>& ring : shape.rings) {
    for (const Point& point : ring) {
      x += point.x - origin.x;
      y += point.y - origin.y;
      count += 1.0;
    }
  }
  return {origin.x + x / count, origin.y + y / count};
}

}  // namespace

Shape translated(const Shape& shape, double dx, double dy) {
  const base::FloatEnvironment environment;
  Shape moved = shape;
  for (std::vector<Point>& ring : moved.rings) {
    for (Point& point : ring) point = {point.x + dx, point.y + dy};
  }
  return moved;
}

Point centroid(const Shape& shape) {
  const base::FloatEnvironment environment;
  const Point origin = shape.rings.front().front();
  if (shape.kind != ItemKind::polygon) return mean_of_points(shape, origin);
  Moments sum;
  for (std::size_t i = 0; i < shape.rings.size(); ++i) {
    const Moments ring = moments(shape.rings[i], origin);
    const double sign = is_hole(shape.rings, i) ? -1.0 : 1.0;
    sum.area += sign * ring.area;
    sum.x += sign * ring.x;
    sum.y += sign * ring.y;
  }
  if (!(sum.area > 0.0)) return mean_of_points(shape, origin);
  return {origin.x + sum.x / sum.area, origin.y + sum.y / sum.area};
}

}  // namespace waywright

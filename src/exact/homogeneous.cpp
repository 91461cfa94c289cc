#include "exact/homogeneous.hpp"

namespace waywright::exact {

namespace {

struct IntegerPoint {
  Integer x, y;
};

IntegerPoint to_integers(const Point& point, int lattice_exponent) {
  return {to_integer(point.x, lattice_exponent), to_integer(point.y, lattice_exponent)};
}

IntegerPoint operator-(const IntegerPoint& p, const IntegerPoint& q) { return {p.x - q.x, p.y - q.y}; }

Integer cross(const IntegerPoint& u, const IntegerPoint& v) { return u.x * v.y - u.y * v.x; }

}  // namespace

// The point a + t (b - a) lies on the line through c and d if t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
Homogeneous to_homogeneous(const Crossing& crossing, int lattice_exponent) {
  const IntegerPoint a = to_integers(crossing.ab.a, lattice_exponent);
  const IntegerPoint c = to_integers(crossing.cd.a, lattice_exponent);
  const IntegerPoint ab = to_integers(crossing.ab.b, lattice_exponent) - a;
  const IntegerPoint cd = to_integers(crossing.cd.b, lattice_exponent) - c;
  Integer w = cross(ab, cd);
  Integer t = cross(c - a, cd);
  if (w < 0) {
    w = -w;
    t = -t;
  }
  return {a.x * w + t * ab.x, a.y * w + t * ab.y, w};
}

Homogeneous to_homogeneous(const ExactPosition& point, int lattice_exponent) {
  if (!point.is_explicit()) return to_homogeneous(point.crossing(), lattice_exponent);
  return {to_integer(point.x, lattice_exponent), to_integer(point.y, lattice_exponent), Integer{1}};
}

}  // namespace waywright::exact

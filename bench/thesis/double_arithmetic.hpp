#pragma once

#include <compare>

#include "waywright/point.hpp"

#include "exact/position.hpp"
#include "thesis/rival_geometry.hpp"

namespace waywright::bench {

/// The arithmetic "double" of Chen 2009: plain doubles, rounded crossings, and a determinant within 1e-14 of 0 counts
/// as 0.
struct DoubleArithmetic {
  struct Position {
    Point rounded;
  };
  using View = Point;

  [[nodiscard]] static Position at(const Point& point) { return {point}; }
  [[nodiscard]] static Position crossing(const Position& a, const Position& b, const Position& c, const Position& d) {
    const Point ab = difference(b.rounded, a.rounded);
    const Point cd = difference(d.rounded, c.rounded);
    const Point ac = difference(c.rounded, a.rounded);
    const double along = (ac.x * cd.y - ac.y * cd.x) / (ab.x * cd.y - ab.y * cd.x);
    return {{a.rounded.x + along * ab.x, a.rounded.y + along * ab.y}};
  }
  [[nodiscard]] static View view(const Position& position) { return position.rounded; }
  [[nodiscard]] static View view(const Point& point) { return point; }

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c) {
    return sign((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
  }
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d) {
    const Point ad = difference(a, d);
    const Point bd = difference(b, d);
    const Point cd = difference(c, d);
    const double a_lift = ad.x * ad.x + ad.y * ad.y;
    const double b_lift = bd.x * bd.x + bd.y * bd.y;
    const double c_lift = cd.x * cd.x + cd.y * cd.y;
    return sign(a_lift * (bd.x * cd.y - cd.x * bd.y) + b_lift * (cd.x * ad.y - ad.x * cd.y) +
                c_lift * (ad.x * bd.y - bd.x * ad.y));
  }
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q) {
    if (p.x != q.x) return p.x < q.x ? std::strong_ordering::less : std::strong_ordering::greater;
    if (p.y != q.y) return p.y < q.y ? std::strong_ordering::less : std::strong_ordering::greater;
    return std::strong_ordering::equal;
  }

 private:
  [[nodiscard]] static Point difference(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
  [[nodiscard]] static exact::Sign sign(double determinant) {
    constexpr double kTolerance = 1e-14;
    if (determinant > kTolerance) return exact::Sign::positive;
    return determinant < -kTolerance ? exact::Sign::negative : exact::Sign::zero;
  }
};

using DoubleGeometry = RivalGeometry<DoubleArithmetic>;

}  // namespace waywright::bench

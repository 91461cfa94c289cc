#pragma once

#include <compare>
#include <gmpxx.h>

#include "waywright/point.hpp"

#include "exact/position.hpp"
#include "thesis/rival_geometry.hpp"

namespace waywright::bench {

struct RationalPoint {
  mpq_class x;
  mpq_class y;
};

[[nodiscard]] exact::Sign orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c);
[[nodiscard]] exact::Sign in_circle(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                                    const RationalPoint& d);
[[nodiscard]] std::strong_ordering order(const RationalPoint& p, const RationalPoint& q);
[[nodiscard]] RationalPoint crossing(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                                     const RationalPoint& d);

/// The arithmetic "exact" of Chen 2009: GMP's rationals for everything.
struct RationalArithmetic {
  struct Position {
    RationalPoint exact;
    Point rounded;
  };
  using View = PositionView<Position>;

  [[nodiscard]] static Position at(const Point& point) { return {{mpq_class(point.x), mpq_class(point.y)}, point}; }
  [[nodiscard]] static Position crossing(const Position& a, const Position& b, const Position& c, const Position& d);
  [[nodiscard]] static View view(const Position& position) { return View(&position); }
  [[nodiscard]] static View view(const Point& point) { return View(at(point)); }

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c) {
    return bench::orientation(a->exact, b->exact, c->exact);
  }
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d) {
    return bench::in_circle(a->exact, b->exact, c->exact, d->exact);
  }
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q) {
    return bench::order(p->exact, q->exact);
  }
};

using RationalGeometry = RivalGeometry<RationalArithmetic>;

}  // namespace waywright::bench

#pragma once

#include <compare>
#include <cstddef>

#include "waywright/point.hpp"

#include "exact/sign.hpp"
#include "thesis/interval_filter.hpp"
#include "thesis/rational_arithmetic.hpp"
#include "thesis/rival_geometry.hpp"

namespace waywright::bench {

/// How often each kind of arithmetic was asked.
struct Evaluations {
  std::size_t interval = 0;
  std::size_t exact = 0;
};

/// Chen 2009, section 4.3.2, "interval + exact": intervals of doubles, kept with each vertex, answer where they can;
/// GMP's rationals answer the rest.
struct IntervalArithmetic {
  struct Place {
    BoundedPoint bounds;
    RationalPoint exact;
    Point rounded;
  };
  using View = PlaceView<Place>;

  /// Of the process, since its start or since they were last set to 0.
  static Evaluations evaluations;

  [[nodiscard]] static Place at(const Point& point);
  [[nodiscard]] static Place at(RationalPoint point);
  [[nodiscard]] static Place crossing(const Place& a, const Place& b, const Place& c, const Place& d);
  [[nodiscard]] static View view(const Place& place) { return View(&place); }
  [[nodiscard]] static View view(const Point& point) { return View(at(point)); }

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c);
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d);
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q);
};

using IntervalGeometry = RivalGeometry<IntervalArithmetic>;

}  // namespace waywright::bench

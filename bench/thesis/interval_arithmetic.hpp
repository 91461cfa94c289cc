#pragma once

#include <compare>
#include <cstddef>

#include "waywright/point.hpp"

#include "exact/position.hpp"
#include "thesis/interval_filter.hpp"
#include "thesis/rational_arithmetic.hpp"
#include "thesis/rival_geometry.hpp"

namespace waywright::bench {

/// How often each kind of arithmetic answered a question.
struct Evaluations {
  std::size_t interval = 0;
  std::size_t exact = 0;
};

/// The arithmetic "interval + exact" of Chen 2009, section 4.3.2: each vertex stores intervals of doubles, which answer
/// a question if they can; GMP's rationals answer the rest.
struct IntervalArithmetic {
  struct Position {
    BoundedPoint bounds;
    RationalPoint exact;
    Point rounded;
  };
  using View = PositionView<Position>;

  /// Counts for the process, since its start or since they were last set to 0.
  static Evaluations evaluations;

  [[nodiscard]] static Position at(const Point& point);
  [[nodiscard]] static Position at(RationalPoint point);
  [[nodiscard]] static Position crossing(const Position& a, const Position& b, const Position& c, const Position& d);
  [[nodiscard]] static View view(const Position& position) { return View(&position); }
  [[nodiscard]] static View view(const Point& point) { return View(at(point)); }

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c);
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d);
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q);
};

using IntervalGeometry = RivalGeometry<IntervalArithmetic>;

}  // namespace waywright::bench

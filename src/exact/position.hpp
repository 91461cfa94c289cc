#pragma once

#include <compare>

#include "waywright/point.hpp"
#include "waywright/predicate_counts.hpp"

#include "base/ieee.hpp"

// What the predicates take and return: positions and signs. And the counters of their stages.

namespace waywright::exact {

enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

[[nodiscard]] constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<signed char>(sign)); }

[[nodiscard]] constexpr std::strong_ordering order_of(Sign sign) {
  return static_cast<signed char>(sign) <=> static_cast<signed char>(0);
}

/// Two points. They define the line through them.
struct PointPair {
  Point a, b;

  friend constexpr bool operator==(const PointPair&, const PointPair&) = default;
};

/// The position at which the line through the points `ab` meets the line through the points `cd`. These four points are
/// always explicit, never constructed, so the degree of the predicates does not grow with the number of operations.
/// Requires: the lines are not parallel.
struct Crossing {
  PointPair ab, cd;

  Crossing() = default;
  Crossing(const PointPair& one, const PointPair& other) : ab(one), cd(other) {}
  Crossing(const Point& a, const Point& b, const Point& c, const Point& d) : ab{a, b}, cd{c, d} {}
};

/// A position in the form that the predicates take. An explicit position has no lines (null) and is (x, y). A
/// constructed position is the crossing of two lines, and x and y are its coordinates, each rounded to the nearest
/// double. The points of the two lines must exist as long as the ExactPosition.
///
/// The library stores a crossing whose coordinates are doubles in range as an explicit position. Hence an explicit and
/// a constructed position are never equal. Equal positions have equal (x, y).
struct ExactPosition {
  double x = 0.0;
  double y = 0.0;
  const PointPair* ab = nullptr;
  const PointPair* cd = nullptr;

  ExactPosition() = default;
  ExactPosition(double x_value, double y_value) : x(x_value), y(y_value) {}
  ExactPosition(double x_value, double y_value, const PointPair* one, const PointPair* other)
      : x(x_value), y(y_value), ab(one), cd(other) {}
  /// The crossing, or an explicit position if `crossing` is null.
  ExactPosition(double x_value, double y_value, const Crossing* crossing) : x(x_value), y(y_value) {
    if (crossing == nullptr) return;
    ab = &crossing->ab;
    cd = &crossing->cd;
  }

  [[nodiscard]] bool is_explicit() const { return ab == nullptr; }
  /// Requires: the point is constructed.
  [[nodiscard]] Crossing crossing() const { return {*ab, *cd}; }
};

[[nodiscard]] inline ExactPosition explicit_position(const Point& point) { return {point.x, point.y}; }

/// The counters of the calling thread. They always count, and no answer depends on them. Each thread has its own, so
/// concurrent queries do not write to memory that another thread reads.
inline constinit thread_local PredicateCounts counts{};

}  // namespace waywright::exact

#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "waywright/point.hpp"

#include "exact/position.hpp"

namespace waywright::exact {

// Predicates for discs that move along a segment. They run in two stages: doubles with a bound of their error, then
// integers. The integers lie on the stack, unless the radius is not a multiple of 2^-152. Requires, everywhere: the
// points are in range.

/// A disc whose centre moves straight from `from` to `to`.
struct Sweep {
  Point from;
  Point to;
  double radius = 0.0;  ///< finite and positive
};

/// How a moving disc first touches a side.
struct Touch {
  enum class Kind : std::uint8_t {
    start,   ///< it touches the side, or lies on it, at the start of its motion
    vertex,  ///< later, at the side's end `a`; then `b` equals `a`
    line,    ///< later, strictly inside the side; the centre comes from the left of the line from `a` to `b`
  };

  Kind kind = Kind::start;
  Point a;
  Point b;

  friend bool operator==(const Touch&, const Touch&) = default;
};

/// Returns how the disc first touches the side from `a` to `b`, or nothing if it does not touch it. A disc touches a
/// side if the distance of its centre from the side is at most the radius. Requires: `a` and `b` differ.
[[nodiscard]] std::optional<Touch> first_touch(const Sweep& sweep, const Point& a, const Point& b);

/// Compares the positions of the centre at two touches, in the order from `from` to `to`. Requires: first_touch() has
/// returned both for this sweep.
[[nodiscard]] std::strong_ordering compare_touches(const Sweep& sweep, const Touch& p, const Touch& q);

/// The position of the centre at a touch. Each coordinate differs from the exact one by at most a few times 2^-53 times
/// the larger magnitude of this coordinate at `from` and `to`. For output and for the order of a search only, never for
/// decisions.
[[nodiscard]] Point centre_at(const Sweep& sweep, const Touch& touch);

/// The answers of each stage alone, so that tests can compare them. The doubles may be unable to answer.
namespace stages {
struct TouchAnswer {
  bool is_sure = false;
  std::optional<Touch> touch;
};
[[nodiscard]] TouchAnswer first_touch_in_doubles(const Sweep& sweep, const Point& a, const Point& b);
[[nodiscard]] std::optional<Touch> first_touch_in_integers(const Sweep& sweep, const Point& a, const Point& b);
[[nodiscard]] std::optional<Sign> compare_touches_in_doubles(const Sweep& sweep, const Touch& p, const Touch& q);
[[nodiscard]] Sign compare_touches_in_integers(const Sweep& sweep, const Touch& p, const Touch& q);
}  // namespace stages

}  // namespace waywright::exact

#pragma once

#include <compare>
#include <optional>

#include "exact/counts.hpp"
#include "exact/exact_point.hpp"
#include "exact/filter.hpp"
#include "exact/lattice.hpp"
#include "exact/sign.hpp"

namespace waywright::exact {

// The three questions about existing points. Each is answered in stages, the cheapest first: a filter in doubles with a
// proven error bound; integers of fixed width, where all coordinates lie on one lattice; integers of any size. The
// stages are named so that tests can hold one against the other.
//
// Identities, for all points: orientation changes sign when two arguments are swapped; so does in_circle, and it keeps
// its sign when (a, b, c) turn round; compare(p, q) is the reverse of compare(q, p).

namespace integers {
/// The last stage: exact for every input in range.
[[nodiscard]] Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] Sign in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);
[[nodiscard]] std::strong_ordering compare(const ExactPoint& p, const ExactPoint& q);
}  // namespace integers

namespace detail {
/// The stages after the filter's coarse bound, one after the other.
[[nodiscard]] Sign finer_orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] Sign finer_in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);
[[nodiscard]] std::strong_ordering compare_beyond_doubles(const ExactPoint& p, const ExactPoint& q);
}  // namespace detail

/// Which side of the line from `a` to `b` the point `c` lies on: positive on the left (a, b, c counter-clockwise).
[[nodiscard]] inline Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  if (const Sign sign = filter::coarse::orientation(a, b, c); sign != Sign::zero) {
    ++counts.orientation.doubles;
    return sign;
  }
  return detail::finer_orientation(a, b, c);
}

/// Where `d` lies to the circle through `a`, `b`, `c`, these counter-clockwise: positive inside, zero on it. The sign
/// is reversed where a, b, c are clockwise.
[[nodiscard]] inline Sign in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                    const ExactPoint& d) {
  if (const Sign sign = filter::coarse::in_circle(a, b, c, d, filter::coarse::in_circle_place(d)); sign != Sign::zero) {
    ++counts.in_circle.doubles;
    return sign;
  }
  return detail::finer_in_circle(a, b, c, d);
}

/// Lexicographic order by (x, y).
///
/// Rounding to nearest is monotone: where two rounded coordinates differ, the true ones differ the same way. So
/// integers are only needed where rounded coordinates agree and one of them may have been rounded.
[[nodiscard]] inline std::strong_ordering compare(const ExactPoint& p, const ExactPoint& q) {
  if (p.x == q.x && !(p.is_explicit() && q.is_explicit())) return detail::compare_beyond_doubles(p, q);
  ++counts.order.doubles;
  return filter::order(p, q);
}

}  // namespace waywright::exact

#pragma once

#include <compare>
#include <optional>

#include "exact/filter.hpp"
#include "exact/position.hpp"

namespace waywright::exact {

// The three predicates. Each runs in stages, the cheapest first: a filter in doubles with a proven error bound;
// integers of fixed width, if all coordinates lie on one lattice; doubles once more, for in-circle only; integers of
// any size. Each stage has its own namespace, so that tests can compare the stages with each other.
//
// Identities, for all points: orientation and in_circle change their signs if two arguments are swapped; in_circle
// keeps its sign under a cyclic permutation of (a, b, c); compare(p, q) is the reverse of compare(q, p).

/// Stage 2 of the predicates: integers of a fixed width, on the stack, for coordinates that lie on one lattice. The
/// points are offsets from one of them, in units of that lattice (see Offsets). The widest numbers have this many bits:
///
///   points         offsets       orientation    in-circle    limbs of 64 bits
///   explicit       up to 2^30             62          124    1 and 2
///   explicit       up to 2^61            124          248    2 and 4
///   constructed    below 2^29            248          618    5 and 12
///   constructed    up to 2^61            504        1,258    8 and 20
///
/// For constructed positions whose coordinates differ by at most 2^b, the numbers of bits are 8 b + 8 and 20 b + 18.
/// This follows from the widths that LatticePoint states and from the determinants in predicates.cpp.
///
/// The functions return nothing if the points lie on no lattice in whose units their offsets are small enough. If no
/// lattice with one unit for both axes exists, orientation() and compare() use a unit for each axis: their answers do
/// not change if one axis is stretched.
namespace lattice {

[[nodiscard]] std::optional<Sign> orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);
[[nodiscard]] std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                            const ExactPosition& d);
/// Like in_circle, for explicit positions with whole coordinates close to `d`, where 64 bits are known to be enough for
/// all numbers. Most sets of four cocircular points are of this kind, and this function costs less than the fine bound
/// of the filter. Returns nothing for other points.
[[nodiscard]] std::optional<Sign> whole_in_circle(const ExactPosition& a, const ExactPosition& b,
                                                  const ExactPosition& c, const ExactPosition& d);
[[nodiscard]] std::optional<std::strong_ordering> compare(const ExactPosition& p, const ExactPosition& q);

}  // namespace lattice

namespace any_origin {
/// Doubles with a bound of the error of each term (Bounded), and with each of the points as the origin in turn. Returns
/// nothing if no bound decides. If two points are much closer to each other than to the other two points, then all
/// terms are small if one of the two is the origin, and so are the errors. The filter takes the last point, whichever
/// it is.
[[nodiscard]] std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                            const ExactPosition& d);
}  // namespace any_origin

namespace integers {
/// The last stage, which is exact for every input in range.
[[nodiscard]] Sign orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);
[[nodiscard]] Sign in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                             const ExactPosition& d);
[[nodiscard]] std::strong_ordering compare(const ExactPosition& p, const ExactPosition& q);
}  // namespace integers

namespace detail {
/// Run the stages after the coarse bound of the filter, one after the other.
[[nodiscard]] Sign finer_orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);
[[nodiscard]] Sign finer_in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                   const ExactPosition& d);
[[nodiscard]] std::strong_ordering compare_beyond_doubles(const ExactPosition& p, const ExactPosition& q);
}  // namespace detail

/// The orientation of three points: positive if `c` lies left of the line from `a` to `b` (a, b, c are
/// counter-clockwise), negative if it lies right of it, zero if it lies on it.
[[nodiscard]] inline Sign orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  if (const Sign sign = filter::coarse::orientation(a, b, c); sign != Sign::zero) {
    ++counts.orientation.doubles;
    return sign;
  }
  return detail::finer_orientation(a, b, c);
}

/// The position of `d` relative to the circle through `a`, `b` and `c`, if these are counter-clockwise: positive
/// inside, negative outside, zero on it. The sign is reversed if they are clockwise.
[[nodiscard]] inline Sign in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                    const ExactPosition& d) {
  if (const Sign sign = filter::coarse::in_circle(a, b, c, d, filter::coarse::in_circle_position_term(d));
      sign != Sign::zero) {
    ++counts.in_circle.doubles;
    return sign;
  }
  return detail::finer_in_circle(a, b, c, d);
}

/// Compares two points lexicographically by (x, y).
///
/// Rounding to nearest is monotone: if two rounded coordinates differ, the exact ones differ in the same direction.
/// Hence the function needs integers only if the rounded coordinates are equal and at least one of them may have been
/// rounded.
[[nodiscard]] inline std::strong_ordering compare(const ExactPosition& p, const ExactPosition& q) {
  if (p.x == q.x && !(p.is_explicit() && q.is_explicit())) return detail::compare_beyond_doubles(p, q);
  ++counts.order.doubles;
  return filter::order(p, q);
}

}  // namespace waywright::exact

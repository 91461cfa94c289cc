#pragma once

#include <compare>
#include <optional>

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"
#include "exact/small_integers.hpp"

namespace waywright::exact {

// The three questions about existing points. Each is answered in stages, the cheapest first: a filter in doubles with a
// proven error bound; integers of 64 and 128 bits, where they do; integers of any size. The stages are named so that
// tests can hold one against the other.
//
// Identities, for all points: orientation changes sign when two arguments are swapped; so does in_circle, and it keeps
// its sign when (a, b, c) turn round; compare(p, q) is the reverse of compare(q, p).

namespace filter {
/// Stage 1. Empty where the rounding error could hide the sign.
[[nodiscard]] std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                            const ExactPoint& d);
}  // namespace filter

namespace integers {
/// The last stage: exact for every input in range.
[[nodiscard]] Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] Sign in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);
[[nodiscard]] std::strong_ordering compare(const ExactPoint& p, const ExactPoint& q);
}  // namespace integers

/// Which side of the line from `a` to `b` the point `c` lies on: positive on the left (a, b, c counter-clockwise).
[[nodiscard]] inline Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  if (const auto sign = filter::orientation(a, b, c)) return *sign;
  if (const auto sign = small_integers::orientation(a, b, c)) return *sign;
  return integers::orientation(a, b, c);
}

/// Where `d` lies to the circle through `a`, `b`, `c`, these counter-clockwise: positive inside, zero on it. The sign
/// is reversed where a, b, c are clockwise.
[[nodiscard]] inline Sign in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                    const ExactPoint& d) {
  if (const auto sign = filter::in_circle(a, b, c, d)) return *sign;
  if (const auto sign = small_integers::in_circle(a, b, c, d)) return *sign;
  return integers::in_circle(a, b, c, d);
}

/// Lexicographic order by (x, y).
///
/// Rounding to nearest is monotone: where two rounded coordinates differ, the true ones differ the same way. So
/// integers are only needed where rounded coordinates agree and one of them may have been rounded.
[[nodiscard]] inline std::strong_ordering compare(const ExactPoint& p, const ExactPoint& q) {
  if (p.x < q.x) return std::strong_ordering::less;
  if (p.x > q.x) return std::strong_ordering::greater;
  if (!p.is_explicit() || !q.is_explicit()) return integers::compare(p, q);
  if (p.y < q.y) return std::strong_ordering::less;
  if (p.y > q.y) return std::strong_ordering::greater;
  return std::strong_ordering::equal;
}

}  // namespace waywright::exact

#include "exact/filter.hpp"

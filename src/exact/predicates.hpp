#pragma once

#include <compare>
#include <optional>

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"

namespace waywright::exact {

// The three questions about existing points. Each is answered by a filter in doubles with a proven error bound and,
// where the filter can't tell, by integers; both stages are named here so that tests can hold one against the other.
//
// Identities, for all points: orientation changes sign when two arguments are swapped; so does in_circle, and it keeps
// its sign when (a, b, c) turn round; compare(p, q) is the reverse of compare(q, p).

/// Which side of the line from `a` to `b` the point `c` lies on: positive on the left (a, b, c counter-clockwise).
[[nodiscard]] Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);

/// Where `d` lies to the circle through `a`, `b`, `c`, these counter-clockwise: positive inside, zero on it. The sign
/// is reversed where a, b, c are clockwise.
[[nodiscard]] Sign in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);

/// Lexicographic order by (x, y).
[[nodiscard]] std::strong_ordering compare(const ExactPoint& p, const ExactPoint& q);

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

}  // namespace waywright::exact

#pragma once

#include <compare>
#include <optional>

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"

/// Stage 2 of the predicates: integers of a fixed width, on the stack, where all coordinates lie on one lattice. With
/// the points' offsets from one of them in units of that lattice (see Offsets), the widest numbers are, in bits:
///
///   points         offsets       orientation    in-circle    limbs of 64 bits
///   explicit       up to 2^30             62          124    1 and 2
///   explicit       up to 2^61            124          248    2 and 4
///   constructed    below 2^29            248          618    5 and 12
///   constructed    up to 2^61            504        1,258    8 and 20
///
/// For constructed points those are 8 b + 8 and 20 b + 18, where coordinates differ by at most 2^b: LatticePoint says
/// how wide its numbers are, and the determinants are those of lattice.cpp.
///
/// Empty where the points have no such lattice.
namespace waywright::exact::lattice {

[[nodiscard]] std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                            const ExactPoint& d);
/// The same where all is known to fit 64 bits at once: of explicit points with whole coordinates not far from `d`. That
/// is where most circles with four points on them are met, and it costs less than the filter's fine bound.
[[nodiscard]] std::optional<Sign> whole_in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                                  const ExactPoint& d);
[[nodiscard]] std::optional<std::strong_ordering> compare(const ExactPoint& p, const ExactPoint& q);

}  // namespace waywright::exact::lattice

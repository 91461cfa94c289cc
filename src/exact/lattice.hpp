#pragma once

#include <compare>
#include <optional>

#include "exact/exact_position.hpp"
#include "exact/sign.hpp"

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
/// This follows from the widths that LatticePoint states and from the determinants in lattice.cpp.
///
/// The functions return nothing if the points lie on no lattice in whose units their offsets are small enough. If no
/// lattice with one unit for both axes exists, orientation() and compare() use a unit for each axis: their answers do
/// not change if one axis is stretched.
namespace waywright::exact::lattice {

[[nodiscard]] std::optional<Sign> orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);
[[nodiscard]] std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                            const ExactPosition& d);
/// Like in_circle, for explicit positions with whole coordinates close to `d`, where 64 bits are known to be enough for
/// all numbers. Most sets of four cocircular points are of this kind, and this function costs less than the fine bound
/// of the filter. Returns nothing for other points.
[[nodiscard]] std::optional<Sign> whole_in_circle(const ExactPosition& a, const ExactPosition& b,
                                                  const ExactPosition& c, const ExactPosition& d);
[[nodiscard]] std::optional<std::strong_ordering> compare(const ExactPosition& p, const ExactPosition& q);

}  // namespace waywright::exact::lattice

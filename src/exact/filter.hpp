#pragma once

#include <algorithm>
#include <cmath>

#include "exact/predicates.hpp"

// Stage 1 of the predicates: doubles with a proven error bound. Write u = 2^-53, fl() for a rounded result, and hats
// for what is computed.
//
// Explicit points. With exact inputs a difference is computed as d^ = d (1 + e), |e| <= u, and Shewchuk's analysis
// (*Adaptive precision floating-point arithmetic*, 1997, section 4) bounds the error of the determinants by
//   orientation: (3 + 16 u) u (|l^| + |r^|), where the determinant is l - r;
//   in-circle:   (10 + 96 u) u permanent^, the determinant's own expression with every term taken absolute.
// In range (exact_point.hpp) nothing overflows, and no non-zero product of up to four differences is below 2^-608.
//
// Constructed points. Their coordinates are rounded to nearest, so a true coordinate differs from the one at hand by at
// most u m, where m is the largest magnitude among the coordinates at hand. A true difference is then d^ (1 + e) + n
// with |n| <= 2 u m. Let S be the sum of all |d^|, and L the largest. On account of the n alone, the determinants move
// by no more than
//   orientation: 2 u m (1 + u) S + 2 (2 u m)^2, for each of its two products moves by |n1 d2| + |n2 d1| + |n1 n2|;
//   in-circle:   96 u m (L (1 + u) + 2 u m)^3, for each of its 12 monomials of degree 4 moves by at most
//                (L (1 + u) + 2 u m)^4 - (L (1 + u))^4 <= 4 (2 u m) (L (1 + u) + 2 u m)^3,
// to be added to the bounds above. A coordinate is at most as far from 0 as the last point's in its axis and the two's
// difference are together, so m is no larger than the sum of the last point's coordinates' magnitudes and S, or L. The
// constants in the code are a few per cent larger, which covers the rounding of the bounds themselves. A crossing can
// lie much nearer to 0 than any explicit coordinate, so that products may underflow; each such loss is below 2^-1022,
// and a sign is only trusted when the determinant exceeds 2^-1000.

namespace waywright::exact::filter {

inline constexpr double kHalfUlp = 0x1p-53;
inline constexpr double kOrientationBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;
inline constexpr double kInCircleBound = (10.0 + 96.0 * kHalfUlp) * kHalfUlp;
inline constexpr double kUnderflow = 0x1p-1000;

[[nodiscard]] inline std::optional<Sign> sign_beyond(double determinant, double error) {
  if (determinant > error) return Sign::positive;
  if (-determinant > error) return Sign::negative;
  return std::nullopt;
}

inline std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const double acx = a.x - c.x;
  const double acy = a.y - c.y;
  const double bcx = b.x - c.x;
  const double bcy = b.y - c.y;
  const double left = acx * bcy;
  const double right = acy * bcx;
  double error = kOrientationBound * (std::abs(left) + std::abs(right));
  if (!a.is_explicit() || !b.is_explicit() || !c.is_explicit()) {
    const double sum = std::abs(acx) + std::abs(acy) + std::abs(bcx) + std::abs(bcy);
    const double rounding = kHalfUlp * (std::abs(c.x) + std::abs(c.y) + sum);  // u m
    error += 2.1 * rounding * (sum + 5.0 * rounding) + kUnderflow;
  } else if (left == 0.0 && right == 0.0) {
    return Sign::zero;  // differences of doubles vanish only where they are 0, and nothing underflows
  }
  return sign_beyond(left - right, error);
}

inline std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                     const ExactPoint& d) {
  const double adx = a.x - d.x;
  const double ady = a.y - d.y;
  const double bdx = b.x - d.x;
  const double bdy = b.y - d.y;
  const double cdx = c.x - d.x;
  const double cdy = c.y - d.y;
  const double a_lift = adx * adx + ady * ady;
  const double b_lift = bdx * bdx + bdy * bdy;
  const double c_lift = cdx * cdx + cdy * cdy;
  const double determinant =
      a_lift * (bdx * cdy - cdx * bdy) + b_lift * (cdx * ady - adx * cdy) + c_lift * (adx * bdy - bdx * ady);
  const double permanent = a_lift * (std::abs(bdx * cdy) + std::abs(cdx * bdy)) +
                           b_lift * (std::abs(cdx * ady) + std::abs(adx * cdy)) +
                           c_lift * (std::abs(adx * bdy) + std::abs(bdx * ady));
  double error = kInCircleBound * permanent;
  if (!a.is_explicit() || !b.is_explicit() || !c.is_explicit() || !d.is_explicit()) {
    const double largest =
        std::max(std::max(std::max(std::abs(adx), std::abs(ady)), std::max(std::abs(bdx), std::abs(bdy))),
                 std::max(std::abs(cdx), std::abs(cdy)));
    const double rounding = kHalfUlp * (std::abs(d.x) + std::abs(d.y) + largest);  // u m
    const double reach = largest + 3.0 * rounding;
    error += 100.0 * rounding * reach * reach * reach + kUnderflow;
  }
  return sign_beyond(determinant, error);
}

}  // namespace waywright::exact::filter

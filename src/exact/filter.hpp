#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

#include "waywright/point.hpp"

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"

// Stage 1 of the predicates: doubles with a proven error bound. Write u = 2^-53, and hats for what is computed. There
// are three bounds: of orientations in a box, one for all; a coarse one that costs little, holds for points of any kind
// and decides nearly all that is left; and a fine one.
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
//
// That is the fine bound. The coarse one takes all points for constructed and puts squares for magnitudes. Let s = t^2
// be the sum of the squares of all d^, and q = |p|^2 that of the last point's coordinates; so m <= |p| + t, and
// |p| t <= 2^-11 q + 2^9 s, for (2^-5.5 |p| - 2^4.5 t)^2 >= 0.
//   Orientation: |l| + |r| <= s / 2 and S <= 2 t, so the error is at most u times
//     (3 / 2) s + 4 t (|p| + t) <= 2053.5 s + q / 512, and 8 u^2 m^2, which is nothing beside these.
//   In-circle: the vectors from d have lengths a, b, c, a^2 + b^2 + c^2 = s. By Cauchy-Schwarz the permanent is at
//     most a b c (a + b + c) <= a^2 b^2 + b^2 c^2 + c^2 a^2 <= s^2 / 3. The gradient by the first vector is at most
//     2 a b c + b c (b + c), the length of a 2 (b x c) and of b |c|^2 - c |b|^2; all three together are
//     (a + b) (b + c) (c + a) + 4 a b c <= (12 / 27) (a + b + c)^3 <= 2.3095 t^3. Each vector is off by 2 sqrt(2) u m
//     at most, so the error is at most u times
//     (10 / 3) s^2 + 6.533 t^3 (|p| + t) <= s (3355 s + q / 313),
//     if t is hardly shorter than on any vectors between the true and the computed ones. It is, where the determinant
//     exceeds the bound: being at most the permanent, it only can where s > q u / 313, so that u m < 2^-22 t.
// Again the constants are a few per cent larger.
//
// In a box of width w and height h whose corners' largest magnitude is M, so are rounded coordinates, for rounding is
// monotone. So |l| and |r| are at most w h, S is at most 2 (w + h), and m is at most M: which in the coarse bound of
// in-circle takes the place of |p| + t, so that M^2 may take that of q, also in what says that t is hardly shorter.

namespace waywright::exact::filter {

inline constexpr double kHalfUlp = 0x1p-53;
inline constexpr double kUnderflow = 0x1p-1000;

/// One branch that is nearly always taken, and none on the sign itself. Zero where the error could hide the sign.
[[nodiscard]] inline Sign sign_beyond(double determinant, double error) {
  if (std::abs(determinant) > error) [[likely]]
    return determinant > 0.0 ? Sign::positive : Sign::negative;
  return Sign::zero;
}

template <class Place>
[[nodiscard]] double orientation_determinant(const Place& a, const Place& b, const Place& c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// The in-circle determinant, and what it is made of: the points as seen from the last, and the squares of their
/// distances. In plain numbers, not points, which compilers would put together again and take apart.
struct CircleTerms {
  double adx, ady, bdx, bdy, cdx, cdy;
  double a_lift, b_lift, c_lift;
  double determinant;
};

template <class Place>
[[nodiscard]] CircleTerms circle_terms(const Place& a, const Place& b, const Place& c, const Place& d) {
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
  return {adx, ady, bdx, bdy, cdx, cdy, a_lift, b_lift, c_lift, determinant};
}

/// The largest magnitude of a coordinate in the box.
[[nodiscard]] inline double largest_magnitude(const Box& box) {
  return std::max(std::max(std::abs(box.min.x), std::abs(box.max.x)),
                  std::max(std::abs(box.min.y), std::abs(box.max.y)));
}

/// What the orientation's determinant of any points in the box is never off by.
[[nodiscard]] inline double largest_orientation_error(const Box& box) {
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  const double rounding = kHalfUlp * largest_magnitude(box);  // u M
  return 6.2 * kHalfUlp * width * height + 4.1 * rounding * (width + height) + 9.0 * rounding * rounding + kUnderflow;
}

/// That of the rounded coordinates.
template <class Place>
[[nodiscard]] std::strong_ordering order(const Place& p, const Place& q) {
  const bool by_x = p.x != q.x;
  const double one = by_x ? p.x : p.y;
  const double other = by_x ? q.x : q.y;
  return one < other   ? std::strong_ordering::less
         : one > other ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
}

/// Of points of any kind, of which only the rounded coordinates are looked at. Zero where the rounding error could hide
/// the sign, as it does whenever that is zero.
namespace coarse {

inline constexpr double kOrientationBySquares = 2100.0 * kHalfUlp;
inline constexpr double kOrientationByPlace = kHalfUlp / 500.0;
inline constexpr double kInCircleBySquares = 3450.0 * kHalfUlp;
inline constexpr double kInCircleByPlace = kHalfUlp / 300.0;

template <class Place>
[[nodiscard]] Sign orientation(const Place& a, const Place& b, const Place& c) {
  const double acx = a.x - c.x;
  const double acy = a.y - c.y;
  const double bcx = b.x - c.x;
  const double bcy = b.y - c.y;
  const double squares = (acx * acx + acy * acy) + (bcx * bcx + bcy * bcy);
  const double place = c.x * c.x + c.y * c.y;
  const double error = kOrientationBySquares * squares + (kOrientationByPlace * place + kUnderflow);
  return sign_beyond(acx * bcy - acy * bcx, error);
}

/// `place` is the last point's own in_circle_place(), or that of a box with all four.
template <class Place>
[[nodiscard]] Sign in_circle(const Place& a, const Place& b, const Place& c, const Place& d, double place) {
  const CircleTerms terms = circle_terms(a, b, c, d);
  const double squares = terms.a_lift + terms.b_lift + terms.c_lift;
  const double error = squares * (kInCircleBySquares * squares + place) + kUnderflow;
  return sign_beyond(terms.determinant, error);
}
template <class Place>
[[nodiscard]] double in_circle_place(const Place& last) {
  return kInCircleByPlace * (last.x * last.x + last.y * last.y);
}
[[nodiscard]] inline double in_circle_place(const Box& box) {
  const double largest = largest_magnitude(box);
  return kInCircleByPlace * (largest * largest);
}

}  // namespace coarse

/// Whether three explicit points lie on a line parallel to an axis, or the last at one of the others: where walls are
/// laid out on a grid, by far the most common tie. Then both products of the determinant have a factor 0.
template <class Place>
[[nodiscard]] bool is_flat(const Place& a, const Place& b, const Place& c) {
  if (a.x == c.x) return b.x == c.x || a.y == c.y;
  return b.y == c.y && (a.y == c.y || b.x == c.x);
}

/// Whether four explicit points are the corners of a rectangle with sides parallel to the axes. So they lie on a
/// circle, and nothing needs computing: where walls are laid out on a grid, that is by far the most common tie.
template <class Place>
[[nodiscard]] bool is_rectangle(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto faces = [&](const Place& p, const Place& q, const Place& r) {  // the side d - p, the side q - r
    return q.x == r.x && ((q.y == d.y && r.y == p.y) || (q.y == p.y && r.y == d.y));
  };
  if (d.x == a.x) return faces(a, b, c);
  return d.x == b.x ? faces(b, c, a) : d.x == c.x && faces(c, a, b);
}

/// Empty where the rounding error could hide the sign.
namespace fine {

inline constexpr double kOrientationBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;
inline constexpr double kInCircleBound = (10.0 + 96.0 * kHalfUlp) * kHalfUlp;

[[nodiscard]] inline std::optional<Sign> sign_beyond(double determinant, double error) {
  if (determinant > error) return Sign::positive;
  if (-determinant > error) return Sign::negative;
  return std::nullopt;
}

[[nodiscard]] inline std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
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
  } else if (is_flat(a, b, c)) {
    return Sign::zero;
  }
  return sign_beyond(left - right, error);
}

[[nodiscard]] inline std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                                   const ExactPoint& d) {
  const auto [adx, ady, bdx, bdy, cdx, cdy, a_lift, b_lift, c_lift, determinant] = circle_terms(a, b, c, d);
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

}  // namespace fine

}  // namespace waywright::exact::filter

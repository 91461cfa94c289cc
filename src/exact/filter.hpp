#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

#include "waywright/point.hpp"

#include "exact/position.hpp"

// Stage 1 of the predicates: doubles with a proven error bound. Notation: u = 2^-53, and d^ ("d hat") is the computed
// value of d. There are three bounds: one constant for all orientations in a box; a coarse bound, which is cheap, holds
// for points of any kind and decides nearly all predicates that the constant leaves open; and a fine bound.
//
// Explicit positions. The inputs are exact, and the computed value of a difference d is d^ = d (1 + e) with |e| <= u.
// Shewchuk's analysis (*Adaptive precision floating-point arithmetic*, 1997, section 4) bounds the error of the
// determinants by
//   orientation: (3 + 16 u) u (|l^| + |r^|), where the determinant is l - r;
//   in-circle:   (10 + 96 u) u permanent^, where the permanent is the expression of the determinant with the absolute
//                value of every term.
// For coordinates in range (kLargestCoordinate, kSmallestCoordinate) nothing overflows, and no non-zero product of up
// to four differences is below 2^-608.
//
// Constructed positions. Their stored coordinates are rounded to nearest. A true x coordinate differs from the stored
// one by at most u m_x, where m_x is the largest magnitude of the stored x coordinates. A true difference of x
// coordinates is then d^ (1 + e) + n with |n| <= 2 u m_x. The same holds for y, with m_y. The bounds treat x and y
// apart, because the points may be much closer to each other on one axis than on the other. Let S_x be the sum of all
// |d^| of the x coordinates, L_x the largest of them, R_x = L_x (1 + u) + 2 u m_x, and S_y, L_y and R_y the same for y.
// The terms n alone change the determinants by at most
//   orientation: 2 u m_x (1 + u) S_y + 2 u m_y (1 + u) S_x + 2 (2 u m_x) (2 u m_y), because each of its two products
//                changes by at most |n1 d2| + |n2 d1| + |n1 n2|;
//   in-circle:   12 u m_x R_y (3 R_x^2 + R_y^2) + 12 u m_y R_x (R_x^2 + 3 R_y^2). It has 12 monomials of degree 4. Six
//                consist of three differences of x coordinates and one of y coordinates. Each of these six changes by
//                at most R_x^3 R_y - (R_x - 2 u m_x)^3 (R_y - 2 u m_y) <= 3 (2 u m_x) R_x^2 R_y + (2 u m_y) R_x^3. In
//                the other six, x and y are exchanged.
// These errors are added to the bounds above. The magnitude of a coordinate is at most the magnitude of the last
// point's coordinate on the same axis plus the magnitude of their difference. Hence m_x is at most the magnitude of the
// last point's x coordinate plus S_x (for orientation) or L_x (for in-circle). The constants in the code are a few per
// cent larger, which covers the rounding errors of the bounds themselves. A crossing can lie much nearer to 0 than any
// explicit coordinate, so products may underflow. The underflow of a product loses less than 2^-1022, and the code
// trusts a sign only if the determinant exceeds 2^-1000. In-circle multiplies this loss by at most (R_x + R_y)^2. If
// R_x is the larger one and more than 2^9, then 36 u R_x^3 R_y exceeds the loss, because R_y is 0 or at least 2^-711
// (error_bounds.hpp). If R_y is 0, the loss is multiplied by 0, or all factors of the product that underflows are 0.
//
// The bounds above are the fine bound. The coarse bound treats all points as constructed and uses squares instead of
// magnitudes. Here m is the larger of m_x and m_y, and S is S_x + S_y. Let s = t^2 be the sum of the squares of all d^,
// and let q = |p|^2 be the sum of the squares of the last point's coordinates. Then m <= |p| + t, and |p| t <= 2^-11 q
// + 2^9 s, because (2^-5.5 |p| - 2^4.5 t)^2 >= 0.
//   Orientation: |l| + |r| <= s / 2 and S <= 2 t, so the error is at most u times
//     (3 / 2) s + 4 t (|p| + t) <= 2053.5 s + q / 512,
//   plus 8 u^2 m^2, which is negligible beside these terms.
//   In-circle: let a, b and c be the lengths of the vectors from d to the other points; a^2 + b^2 + c^2 = s. By
//     Cauchy-Schwarz the permanent is at most
//     a b c (a + b + c) <= a^2 b^2 + b^2 c^2 + c^2 a^2 <= s^2 / 3.
//     The gradient with respect to the first vector has the terms a 2 (b x c) and b |c|^2 - c |b|^2, so its length is
//     at most 2 a b c + b c (b + c). The sum of the three gradients' lengths is at most
//     (a + b) (b + c) (c + a) + 4 a b c <= (12 / 27) (a + b + c)^3 <= 2.3095 t^3.
//     Each vector is off by at most 2 sqrt(2) u m, so the error is at most u times
//     (10 / 3) s^2 + 6.533 t^3 (|p| + t) <= s (3355 s + q / 313),
//     if t is not much shorter than the same length of any vectors between the true and the computed ones. This
//     condition holds whenever the determinant exceeds the bound: the determinant is at most the permanent, so it can
//     exceed the bound only if s > q u / 313, and then u m < 2^-22 t.
// The constants in the code are a few per cent larger here, too.
//
// A box of width w and height h: let M be the largest magnitude of its corners' coordinates. Rounded coordinates also
// lie in the box, because rounding is monotone. Hence |l| and |r| are at most w h, S is at most 2 (w + h), and m is at
// most M. In the coarse bound of in-circle, M may replace |p| + t, and M^2 may replace q, also in the argument about
// the length of t.

namespace waywright::exact::filter {

inline constexpr double kHalfUlp = 0x1p-53;
inline constexpr double kUnderflow = 0x1p-1000;

/// The sign of the determinant, or zero if the determinant is not larger than the error bound. The function has one
/// branch, which is nearly always taken, and no branch on the sign itself.
[[nodiscard]] inline Sign sign_beyond(double determinant, double error) {
  if (std::abs(determinant) > error) [[likely]]
    return determinant > 0.0 ? Sign::positive : Sign::negative;
  return Sign::zero;
}

template <class Position>
[[nodiscard]] double orientation_determinant(const Position& a, const Position& b, const Position& c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// The in-circle determinant and its terms: the points relative to the last one, and the squares of their distances
/// from it. The members are numbers and not points, because compilers would move points into vector registers and back.
struct CircleTerms {
  double adx, ady, bdx, bdy, cdx, cdy;
  double a_lift, b_lift, c_lift;
  double determinant;
};

template <class Position>
[[nodiscard]] CircleTerms circle_terms(const Position& a, const Position& b, const Position& c, const Position& d) {
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

/// An upper bound of the error of the orientation determinant, for all points in the box.
[[nodiscard]] inline double largest_orientation_error(const Box& box) {
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  const double rounding = kHalfUlp * largest_magnitude(box);  // u M
  return 6.2 * kHalfUlp * width * height + 4.1 * rounding * (width + height) + 9.0 * rounding * rounding + kUnderflow;
}

/// Compares the rounded coordinates: first x, then y.
template <class Position>
[[nodiscard]] std::strong_ordering order(const Position& p, const Position& q) {
  const bool by_x = p.x != q.x;
  const double one = by_x ? p.x : p.y;
  const double other = by_x ? q.x : q.y;
  return one < other   ? std::strong_ordering::less
         : one > other ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
}

/// Predicates for points of any kind, which use only the rounded coordinates. They return zero if the rounding error
/// could change the sign. If the true sign is zero, they always return zero, but the converse is not true.
namespace coarse {

inline constexpr double kOrientationBySquares = 2100.0 * kHalfUlp;
inline constexpr double kOrientationByPosition = kHalfUlp / 500.0;
inline constexpr double kInCircleBySquares = 3450.0 * kHalfUlp;
inline constexpr double kInCircleByPosition = kHalfUlp / 300.0;

template <class Position>
[[nodiscard]] Sign orientation(const Position& a, const Position& b, const Position& c) {
  const double acx = a.x - c.x;
  const double acy = a.y - c.y;
  const double bcx = b.x - c.x;
  const double bcy = b.y - c.y;
  const double squares = (acx * acx + acy * acy) + (bcx * bcx + bcy * bcy);
  const double position = c.x * c.x + c.y * c.y;
  const double error = kOrientationBySquares * squares + (kOrientationByPosition * position + kUnderflow);
  return sign_beyond(acx * bcy - acy * bcx, error);
}

/// `position` is in_circle_position_term() of the last point, or of a box that contains all four points.
template <class Position>
[[nodiscard]] Sign in_circle(const Position& a, const Position& b, const Position& c, const Position& d,
                             double position) {
  const CircleTerms terms = circle_terms(a, b, c, d);
  const double squares = terms.a_lift + terms.b_lift + terms.c_lift;
  const double error = squares * (kInCircleBySquares * squares + position) + kUnderflow;
  return sign_beyond(terms.determinant, error);
}
template <class Position>
[[nodiscard]] double in_circle_position_term(const Position& last) {
  return kInCircleByPosition * (last.x * last.x + last.y * last.y);
}
[[nodiscard]] inline double in_circle_position_term(const Box& box) {
  const double largest = largest_magnitude(box);
  return kInCircleByPosition * (largest * largest);
}

}  // namespace coarse

/// Whether three explicit positions lie on a line parallel to an axis, or the last point equals one of the others. Then
/// both products of the determinant have a factor 0. If walls lie on a grid, this is by far the most common tie.
template <class Position>
[[nodiscard]] bool is_flat(const Position& a, const Position& b, const Position& c) {
  if (a.x == c.x) return b.x == c.x || a.y == c.y;
  return b.y == c.y && (a.y == c.y || b.x == c.x);
}

/// Whether four explicit positions are the corners of a rectangle with sides parallel to the axes. Such points lie on a
/// circle, so the answer is known without arithmetic. If walls lie on a grid, this is by far the most common tie.
template <class Position>
[[nodiscard]] bool is_rectangle(const Position& a, const Position& b, const Position& c, const Position& d) {
  const auto is_opposite = [&](const Position& p, const Position& q,
                               const Position& r) {  // whether d - p and q - r are opposite sides
    return q.x == r.x && ((q.y == d.y && r.y == p.y) || (q.y == p.y && r.y == d.y));
  };
  if (d.x == a.x) return is_opposite(a, b, c);
  return d.x == b.x ? is_opposite(b, c, a) : d.x == c.x && is_opposite(c, a, b);
}

/// Predicates with the fine bound. They return nothing if the rounding error could change the sign.
namespace fine {

inline constexpr double kOrientationBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;
inline constexpr double kInCircleBound = (10.0 + 96.0 * kHalfUlp) * kHalfUlp;

[[nodiscard]] inline std::optional<Sign> sign_beyond(double determinant, double error) {
  if (determinant > error) return Sign::positive;
  if (-determinant > error) return Sign::negative;
  return std::nullopt;
}

[[nodiscard]] inline std::optional<Sign> orientation(const ExactPosition& a, const ExactPosition& b,
                                                     const ExactPosition& c) {
  const double acx = a.x - c.x;
  const double acy = a.y - c.y;
  const double bcx = b.x - c.x;
  const double bcy = b.y - c.y;
  const double left = acx * bcy;
  const double right = acy * bcx;
  double error = kOrientationBound * (std::abs(left) + std::abs(right));
  if (!a.is_explicit() || !b.is_explicit() || !c.is_explicit()) {
    const double sum_x = std::abs(acx) + std::abs(bcx);
    const double sum_y = std::abs(acy) + std::abs(bcy);
    const double rounding_x = kHalfUlp * (std::abs(c.x) + sum_x);  // u m_x
    const double rounding_y = kHalfUlp * (std::abs(c.y) + sum_y);
    error += 2.1 * (rounding_x * (sum_y + 5.0 * rounding_y) + rounding_y * sum_x) + kUnderflow;
  } else if (is_flat(a, b, c)) {
    return Sign::zero;
  }
  return sign_beyond(left - right, error);
}

[[nodiscard]] inline std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b,
                                                   const ExactPosition& c, const ExactPosition& d) {
  const auto [adx, ady, bdx, bdy, cdx, cdy, a_lift, b_lift, c_lift, determinant] = circle_terms(a, b, c, d);
  const double permanent = a_lift * (std::abs(bdx * cdy) + std::abs(cdx * bdy)) +
                           b_lift * (std::abs(cdx * ady) + std::abs(adx * cdy)) +
                           c_lift * (std::abs(adx * bdy) + std::abs(bdx * ady));
  double error = kInCircleBound * permanent;
  if (!a.is_explicit() || !b.is_explicit() || !c.is_explicit() || !d.is_explicit()) {
    const double largest_x = std::max(std::max(std::abs(adx), std::abs(bdx)), std::abs(cdx));
    const double largest_y = std::max(std::max(std::abs(ady), std::abs(bdy)), std::abs(cdy));
    const double rounding_x = kHalfUlp * (std::abs(d.x) + largest_x);  // u m_x
    const double rounding_y = kHalfUlp * (std::abs(d.y) + largest_y);
    const double reach_x = largest_x + 3.0 * rounding_x;  // R_x
    const double reach_y = largest_y + 3.0 * rounding_y;
    const double square_x = reach_x * reach_x;
    const double square_y = reach_y * reach_y;
    error += 12.5 * (rounding_x * reach_y * (3.0 * square_x + square_y) +
                     rounding_y * reach_x * (square_x + 3.0 * square_y)) +
             kUnderflow;
  }
  return sign_beyond(determinant, error);
}

}  // namespace fine

}  // namespace waywright::exact::filter

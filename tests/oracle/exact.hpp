#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "oracle/interval.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// An integer of any size. The first 512 bits need no heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

/// The point (x / w, y / w) on a grid, w > 0, and two intervals that contain its coordinates in the units of the plane.
struct ExactPosition {
  Integer x;
  Integer y;
  Integer w = 1;
  Interval near_x;
  Interval near_y;

  /// Returns whether the intervals are exact, so that the point is a pair of doubles.
  [[nodiscard]] bool is_double() const { return near_x.lo == near_x.hi && near_y.lo == near_y.hi; }
};

/// The grid of all multiples of 2^exponent: the coarsest grid that contains every given point.
class Grid {
 public:
  Grid() = default;
  explicit Grid(const std::vector<OraclePoint>& points);

  /// Returns a point of doubles as an exact point. If it lies on the grid, w = 1.
  [[nodiscard]] ExactPosition point(OraclePoint p) const;
  /// Returns the crossing of the lines a b and c d. Requires: the lines cross, and all four points have w = 1.
  [[nodiscard]] ExactPosition crossing(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                       const ExactPosition& d) const;
  /// Returns the midpoint of two points.
  [[nodiscard]] static ExactPosition midpoint(const ExactPosition& a, const ExactPosition& b);
  /// Returns `XNUM XDEN YNUM YDEN`, in lowest terms, with positive denominators.
  [[nodiscard]] std::string text(const ExactPosition& p) const;
  /// Returns the correctly rounded point; ties go to even.
  [[nodiscard]] OraclePoint nearest(const ExactPosition& p) const;

 private:
  [[nodiscard]] std::string rational_text(const Integer& numerator, const Integer& denominator) const;
  [[nodiscard]] double nearest_double(const Integer& numerator, const Integer& denominator) const;

  int exponent_ = 0;
};

/// Returns -1, 0 or 1 if a comes before, equals or comes after b: by x alone, by y alone, or by x and then y.
[[nodiscard]] int compare_x(const ExactPosition& a, const ExactPosition& b);
[[nodiscard]] int compare_y(const ExactPosition& a, const ExactPosition& b);
[[nodiscard]] int compare_xy(const ExactPosition& a, const ExactPosition& b);

/// Returns 1, 0 or -1 if c lies left of, on, or right of the line from a to b.
[[nodiscard]] int orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);

/// Returns 1, 0 or -1 if d lies inside, on or outside the circle through a, b, c. Requires: a, b, c are
/// counter-clockwise.
[[nodiscard]] int in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                            const ExactPosition& d);

/// Returns whether p lies on the closed segment from a to b. The segment may be a single point.
[[nodiscard]] bool on_segment(const ExactPosition& a, const ExactPosition& b, const ExactPosition& p);

/// Returns whether two rays from `at` through u and v have the same direction. Requires: at, u and v are collinear, at
/// is not u or v.
[[nodiscard]] bool same_direction(const ExactPosition& at, const ExactPosition& u, const ExactPosition& v);

/// Returns whether the ray from `at` through t lies strictly inside the angle that runs counter-clockwise from the ray
/// through u to the ray through v. Requires: the rays through u and v have different directions.
[[nodiscard]] bool in_angle(const ExactPosition& at, const ExactPosition& u, const ExactPosition& t,
                            const ExactPosition& v);

/// Returns whether two segments cross at a point inside both. The order of their ends does not matter.
[[nodiscard]] bool cross_properly(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                  const ExactPosition& d);

}  // namespace waywright::oracle

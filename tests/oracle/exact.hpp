#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "oracle/interval.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// Of any size; the first 512 bits need no heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

/// The place (x / w, y / w) on a grid, w > 0, and two intervals that hold it in the plane's own units.
struct ExactPoint {
  Integer x;
  Integer y;
  Integer w = 1;
  Interval near_x;
  Interval near_y;

  /// Whether the intervals are the place itself, so that it is a pair of doubles.
  [[nodiscard]] bool is_double() const { return near_x.lo == near_x.hi && near_y.lo == near_y.hi; }
};

/// The grid of all multiples of 2^exponent: the coarsest one with every given point on it.
class Grid {
 public:
  Grid() = default;
  explicit Grid(const std::vector<OraclePoint>& points);

  /// A point of doubles, on the grid (then w = 1) or not.
  [[nodiscard]] ExactPoint point(OraclePoint p) const;
  /// Where the lines a b and c d cross. Requires: they do, and all four have w = 1.
  [[nodiscard]] ExactPoint crossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                    const ExactPoint& d) const;
  /// Half way between two points.
  [[nodiscard]] static ExactPoint midpoint(const ExactPoint& a, const ExactPoint& b);
  /// `XNUM XDEN YNUM YDEN`, reduced, denominators positive.
  [[nodiscard]] std::string text(const ExactPoint& p) const;
  /// Correctly rounded, ties to even.
  [[nodiscard]] OraclePoint nearest(const ExactPoint& p) const;

 private:
  [[nodiscard]] std::string rational_text(const Integer& numerator, const Integer& denominator) const;
  [[nodiscard]] double nearest_double(const Integer& numerator, const Integer& denominator) const;

  int exponent_ = 0;
};

/// -1, 0 or 1 as a comes before, equals or comes after b, by x alone, y alone, or x and then y.
[[nodiscard]] int compare_x(const ExactPoint& a, const ExactPoint& b);
[[nodiscard]] int compare_y(const ExactPoint& a, const ExactPoint& b);
[[nodiscard]] int compare_xy(const ExactPoint& a, const ExactPoint& b);

/// 1, 0 or -1 as c lies left of, on, or right of the line from a to b.
[[nodiscard]] int orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);

/// 1, 0 or -1 as d lies inside, on or outside the circle through a, b, c, which turn counter-clockwise.
[[nodiscard]] int in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);

/// Whether p lies on the closed segment from a to b, which may be a point.
[[nodiscard]] bool on_segment(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p);

/// Whether two rays from `at` through u and v go the same way. Requires: at, u and v are collinear, at is not u or v.
[[nodiscard]] bool same_way(const ExactPoint& at, const ExactPoint& u, const ExactPoint& v);

/// Whether the ray through t lies strictly inside the sector from the ray through u counter-clockwise to that through
/// v, all from `at`. Requires: u and v do not go the same way.
[[nodiscard]] bool in_sector(const ExactPoint& at, const ExactPoint& u, const ExactPoint& t, const ExactPoint& v);

/// Whether two segments cross in a point inside both. Their ends' order does not matter.
[[nodiscard]] bool cross_properly(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);

}  // namespace waywright::oracle

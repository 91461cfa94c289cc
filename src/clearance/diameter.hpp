#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/sign.hpp"

namespace waywright::clearance {

/// A diameter of the circle through three vertices w, x and y, counter-clockwise: from w to the opposite position D of
/// the circle. The class computes in doubles with error bounds. All vectors start at w, whose coordinates are exact.
///
/// For a vector v, let s(v) = x^2 (y . v) - y^2 (x . v) = n . v. The number s(v) is positive exactly if v lies left of
/// the ray from w through D: because D . x = x^2 and D . y = y^2, the product n . D is 0. It follows that
/// D = (n.y, -n.x) / cross(x, y).
class Diameter {
 public:
  /// The vector from w to another vertex.
  struct Vector {
    Point offset;
    double square;         ///< the square of the length
    double extent;         ///< bounds the magnitudes of the coordinates, and their errors: see Errors
    double error;          ///< the sum of this number for two vectors bounds the error of may_cross()
    double s = 0.0;        ///< s(v): compute_s() sets it
    double s_error = 0.0;  ///< a bound of the error of `s`
  };
  /// How exact the vectors are. Each coordinate may be wrong by 2 `rounding`, and by half an ulp. A product consists of
  /// at most four coordinates, and the functions below add or subtract at most four products. So if `rounding` is 0, a
  /// result is wrong by less than 2^-48 of the sum of the magnitudes of its products. Otherwise 2 `rounding` is at most
  /// 2^-19 of each extent, and the relative error covers four factors with such errors.
  struct Errors {
    explicit Errors(double rounding) : relative(rounding > 0.0 ? 0x1p-16 : 0x1p-48), least_extent(0x1p20 * rounding) {}

    double relative;
    double least_extent;
  };

  [[nodiscard]] static Vector vector(const Point& offset, const Errors& errors) {
    const double extent = std::abs(offset.x) + std::abs(offset.y) + errors.least_extent;
    return {offset, dot(offset, offset), extent, errors.relative * extent * extent};
  }

  /// If x or y is so near to w that the rounding may be large compared with the distance from w, the error has no
  /// bound.
  Diameter(const Vector& x, const Vector& y, const Errors& errors)
      : normal_(x.square * y.offset - y.square * x.offset), area_(cross(x.offset, y.offset)) {
    const bool is_bounded = std::min(x.extent, y.extent) >= 16.0 * errors.least_extent;
    area_error_ = errors.relative * x.extent * y.extent;
    normal_error_ = is_bounded ? area_error_ * (x.extent + y.extent) : HUGE_VAL;
  }

  /// Sets s(v) and its error.
  void compute_s(Vector& v) const {
    v.s = dot(normal_, v.offset);
    v.s_error = normal_error_ * v.extent;
  }
  /// Says whether a vertex lies left or right of the ray from w through D: positive if it surely lies left of the ray,
  /// negative if it surely lies right of the ray, zero if the doubles do not decide. Requires: the caller has called
  /// compute_s() for the vertex.
  [[nodiscard]] exact::Sign sure_side_of(const Vector& v) const {
    if (!(std::abs(v.s) > v.s_error)) return exact::Sign::zero;
    return v.s > 0.0 ? exact::Sign::positive : exact::Sign::negative;
  }
  /// Returns false only if D does not lie strictly beyond the line through two vertices, as seen from w. If D lies
  /// beyond this line, then cross(right, left) < cross(D, left - right). Requires: the caller has called compute_s()
  /// for both vertices.
  [[nodiscard]] bool may_end_beyond(const Vector& right, const Vector& left) const {
    const double difference = area_ * cross(right.offset, left.offset) - (left.s - right.s);
    return !(difference >= right.s_error + left.s_error + area_error_ * right.extent * left.extent);
  }
  /// Returns false only if the angle between w and `q` at `p`, or the angle between w and `p` at `q`, is at least 90
  /// degrees. The angle at p is less than 90 degrees if the product of the vectors from p to w and from p to q is
  /// positive: -p . (q - p) = p^2 - p . q.
  [[nodiscard]] static bool may_cross(const Vector& p, const Vector& q) {
    const double difference = dot(p.offset, q.offset) - std::min(p.square, q.square);
    return !(difference >= p.error + q.error);
  }

 private:
  [[nodiscard]] static double dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }
  [[nodiscard]] static double cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }

  Point normal_;         ///< n
  double area_;          ///< cross(x, y)
  double normal_error_;  ///< s(v) is wrong by at most this times the extent of v
  double area_error_;    ///< cross(x, y) cross(p, q) is wrong by at most this times the extents of p and q
};

}  // namespace waywright::clearance

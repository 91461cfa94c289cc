#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/position.hpp"

namespace waywright::clearance {

/// The sum of the magnitudes of the coordinates.
[[nodiscard]] inline double extent_of(const Point& p) { return std::abs(p.x) + std::abs(p.y); }

/// A disc in doubles, a little larger than the exact disc that it stands for. A search that visits the faces around a
/// bridge leaves out edges that this disc does not touch. The disc also rejects a gap if the exact disc surely contains
/// a vertex. It decides nothing else: exact predicates decide whether a gap is a bridge.
///
/// All positions are relative to `origin`, a vertex on the circle, so that a small disc far from (0, 0) keeps its
/// precision.
struct Disc {
  Point origin;
  Point centre;  ///< relative to `origin`
  double radius = 0.0;
  /// Each coordinate of `centre` is wrong by at most this number plus 2^-50 of the magnitudes of the coordinates.
  double error = 0.0;
  double excess =
      0.0;  ///< if `origin` lies inside the disc: at least the square of the radius; 0 if it lies on the circle

  /// Returns the disc whose diameter is the segment from `from` to the foot of the perpendicular on the line through
  /// `a` and `b`, or to `a` if the two are equal.
  [[nodiscard]] static Disc of_gap(const Point& from, const Point& a, const Point& b) {
    Point to{a.x - from.x, a.y - from.y};
    double error = 0.0;
    if (!(a == b)) {
      const Point along{b.x - a.x, b.y - a.y};
      const double squared_length = along.x * along.x + along.y * along.y;
      const double share = (along.x * to.y - along.y * to.x) / squared_length;
      error = kUnit * (std::abs(to.x) + std::abs(to.y));
      to = {-along.y * share, along.x * share};
    }
    return around(from, {0.5 * to.x, 0.5 * to.y}, error);
  }
  /// Returns the disc whose diameter is the segment from `a` to `b`. Each coordinate of the two points may be wrong by
  /// `rounding`.
  [[nodiscard]] static Disc of_edge(const Point& a, const Point& b, double rounding) {
    return around(a, {0.5 * (b.x - a.x), 0.5 * (b.y - a.y)}, 2.0 * rounding);
  }
  /// Returns the disc whose border contains the three vertices of a triangle. Each coordinate of a vertex may be wrong
  /// by `rounding`.
  [[nodiscard]] static Disc of_triangle(const Point& a, const Point& b, const Point& c, double rounding) {
    const Point p{b.x - a.x, b.y - a.y};
    const Point q{c.x - a.x, c.y - a.y};
    const double one = p.x * q.y;
    const double other = p.y * q.x;
    const double area = one - other;
    const double extent = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y);
    const double uncertain = kUnit * (std::abs(one) + std::abs(other)) + 4.0 * rounding * extent;
    if (!(std::abs(area) > 0x1p20 * uncertain)) return {a, {0.0, 0.0}, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    const double p_lift = p.x * p.x + p.y * p.y;
    const double q_lift = q.x * q.x + q.y * q.y;
    const double scale = 0.5 / area;
    const Point centre{(p_lift * q.y - q_lift * p.y) * scale, (p.x * q_lift - q.x * p_lift) * scale};
    const double terms =
        (p_lift * std::abs(q.y) + q_lift * std::abs(p.y) + std::abs(p.x) * q_lift + std::abs(q.x) * p_lift) *
        std::abs(scale);
    const double shift = 8.0 * rounding * extent * extent * std::abs(scale);
    return around(a, centre, terms * (kUnit + 2.0 * uncertain / std::abs(area)) + shift + rounding);
  }

  /// Returns false only if no point of the segment from `a` to `b` lies in the closed exact disc. Each coordinate of
  /// the two points may be wrong by `rounding`.
  [[nodiscard]] bool may_touch(const Point& a, const Point& b, double rounding) const {
    const Point from{a.x - origin.x - centre.x, a.y - origin.y - centre.y};
    const Point along{b.x - a.x, b.y - a.y};
    const double extent = std::abs(from.x) + std::abs(from.y) + std::abs(along.x) + std::abs(along.y);
    const double limit = (radius + (kUnit * extent + 4.0 * rounding)) * (1.0 + kUnit);
    const double squared_length = along.x * along.x + along.y * along.y;
    const double dot = -(from.x * along.x + from.y * along.y);
    if (dot > 0.0 && dot < squared_length) {
      const double cross = from.x * along.y - from.y * along.x;
      return !(cross * cross > limit * limit * squared_length);
    }
    const Point nearest = dot <= 0.0 ? from : from + along;
    return !(nearest.x * nearest.x + nearest.y * nearest.y > limit * limit);
  }
  /// Returns false only if no point of the box lies in the closed exact disc. Each coordinate of the box may be wrong
  /// by `rounding`, and so may `origin`.
  ///
  /// Let z be a position and c the centre, relative to `origin`. Because `origin` lies on the circle, z lies in the
  /// disc if z^2 - 2 c . z <= 0. A long flat triangle has a circle that is much larger than the distances that matter.
  /// Then this sum is far more exact than a comparison with the radius: an error e of the centre changes it by 2 e . z
  /// only.
  [[nodiscard]] bool may_touch(const Box& box, double rounding) const {
    const Point min{box.min.x - origin.x, box.min.y - origin.y};
    const Point max{box.max.x - origin.x, box.max.y - origin.y};
    const Point nearest{std::clamp(centre.x, min.x, max.x), std::clamp(centre.y, min.y, max.y)};
    const double power = nearest.x * (nearest.x - 2.0 * centre.x) + nearest.y * (nearest.y - 2.0 * centre.y);
    const double extent = std::max(-min.x, max.x) + std::max(-min.y, max.y);
    const double of_centre = std::abs(centre.x) + std::abs(centre.y);
    const double slack = 2.0 * extent * (error + 2.0 * rounding + kUnit * (of_centre + extent)) +
                         8.0 * rounding * (of_centre + error + rounding);
    return !(power > excess + slack);
  }
  /// A box that contains the exact disc, also if each coordinate of `origin` is wrong by `rounding`.
  [[nodiscard]] Box bounds(double rounding) const {
    const Point middle{origin.x + centre.x, origin.y + centre.y};
    const double extent = radius + error + 4.0 * rounding +
                          kUnit * (std::abs(origin.x) + std::abs(origin.y) + std::abs(centre.x) + std::abs(centre.y));
    return {{middle.x - extent, middle.y - extent}, {middle.x + extent, middle.y + extent}};
  }
  /// The disc with the same centre and a radius that is `factor` times as large, or a little larger. Requires: `factor`
  /// is at least 1.
  [[nodiscard]] Disc scaled(double factor) const {
    const double larger = radius * factor * (1.0 + kUnit);
    return {origin, centre, larger, error, (factor * factor - 1.0) * radius * radius * (1.0 + kUnit)};
  }
  /// Returns false only if the segment from `origin` to `p` contains no position strictly inside the exact disc: then
  /// the angle between the segment and the radius to `origin` is at least 90 degrees. Requires: the exact circle
  /// contains the exact position of `origin`. Each coordinate of the two points may be wrong by `rounding`.
  [[nodiscard]] bool may_enter(const Point& p, double rounding) const {
    const Point along{p.x - origin.x, p.y - origin.y};
    const double x = along.x * centre.x;
    const double y = along.y * centre.y;
    const double slack = kUnit * (std::abs(x) + std::abs(y)) + error * (std::abs(along.x) + std::abs(along.y)) +
                         4.0 * rounding * (std::abs(centre.x) + std::abs(centre.y) + error);
    return !(x + y + slack <= 0.0);
  }
  /// Returns true only if `p` lies in the closed exact disc. Requires: `origin` and `p` are exact.
  [[nodiscard]] bool surely_contains(const Point& p) const {
    const Point from{p.x - origin.x, p.y - origin.y};
    const double x = from.x * (from.x - 2.0 * centre.x);
    const double y = from.y * (from.y - 2.0 * centre.y);
    const double extent = std::abs(from.x) + std::abs(from.y);
    const double slack = kUnit * extent * (extent + std::abs(centre.x) + std::abs(centre.y)) + 4.0 * error * extent;
    return x + y + slack <= 0.0;
  }

  /// Returns true only if the exact value of (q - p) . (r - p) is not positive. Each coordinate of the points may be
  /// wrong by `rounding`.
  [[nodiscard]] static bool is_surely_not_acute(const Point& q, const Point& p, const Point& r, double rounding) {
    const Point to_q{q.x - p.x, q.y - p.y};
    const Point to_r{r.x - p.x, r.y - p.y};
    const double x = to_q.x * to_r.x;
    const double y = to_q.y * to_r.y;
    if (x + y > 0.0) return false;
    const double extent = std::abs(to_q.x) + std::abs(to_q.y) + std::abs(to_r.x) + std::abs(to_r.y);
    return x + y + kUnit * (std::abs(x) + std::abs(y)) + 4.0 * rounding * (extent + 4.0 * rounding) <= 0.0;
  }

 private:
  static constexpr double kUnit = 0x1p-48;  ///< 32 times the unit of rounding: more than the errors of these formulas

  /// `error` bounds the error of each coordinate of the centre. The circle contains the origin.
  [[nodiscard]] static Disc around(const Point& origin, const Point& centre, double error) {
    const double radius = std::sqrt(centre.x * centre.x + centre.y * centre.y) * (1.0 + kUnit) + 4.0 * error;
    return {origin, centre, radius, error, 0.0};
  }
};

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

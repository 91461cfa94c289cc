#pragma once

#include <vector>

#include "waywright/point.hpp"

#include "mesh/index.hpp"

namespace waywright::clearance {

/// The vector of length 1 in the direction of `v`.
inline Point unit(const Point& v) {
  const double size = length(v);
  return {v.x / size, v.y / size};
}

/// One of two curves: the straight line of the positions at the distance r from the line through a wall, on its left;
/// or the circle of radius r around a vertex. If a disc of radius r does not fit at a position, the nearest position at
/// which it fits lies on one of these curves.
///
/// A parameter says where a position lies on the curve. On a line, it is the distance from the foot of the
/// perpendicular from the query's point. On a circle it is an angle, from 0 to 4: each of its integers is a multiple of
/// 90 degrees, and it grows counter-clockwise. Between two integers it is not proportional to the angle.
///
/// All computations are in doubles, relative to the query's point, so they are precise far from (0, 0), too.
class OffsetCurve {
 public:
  /// An interval of parameters.
  struct Interval {
    double low;
    double high;
    mesh::HalfEdge low_blocker = mesh::kNoHalfEdge;   ///< the wall that blocks the curve below `low`, if there is one
    mesh::HalfEdge high_blocker = mesh::kNoHalfEdge;  ///< the wall that blocks the curve above `high`
  };
  using Intervals = std::vector<Interval>;

  /// The interval of the curve that a segment blocks: its positions are nearer to the segment than r.
  struct Blocked {
    bool is_blocked = false;
    double low = 0.0;
    double high = 0.0;  ///< on a circle, `high` is less than `low` if the interval contains the parameter 0
  };
  /// How rounding errors may change the result of blocked_by().
  enum class Bias : signed char {
    less,  ///< the result lies within the exact one
    none,  ///< the result is computed as precisely as possible
    more,  ///< the result contains the exact one
  };

  /// The line on the left of the wall from `a` to `b`. Each coordinate of the ends may be wrong by `rounding`.
  [[nodiscard]] static OffsetCurve left_of(const Point& point, const Point& a, const Point& b, double radius,
                                           double rounding);
  [[nodiscard]] static OffsetCurve around(const Point& point, const Point& vertex, double radius, double rounding);

  [[nodiscard]] bool is_circle() const { return is_circle_; }
  /// All parameters of the curve. A circle starts and ends at the parameter 0.
  [[nodiscard]] Interval whole() const { return whole_; }
  /// The position, relative to the query's point.
  [[nodiscard]] Point at(double parameter) const;
  /// The direction away from the wall or from the vertex.
  [[nodiscard]] Point normal(double parameter) const;
  /// The parameter of the position in the interval that is nearest to the query's point.
  [[nodiscard]] double nearest(const Interval& interval) const;
  /// The parameter of the position on the curve that is nearest to `position`: the foot of the perpendicular, or the
  /// direction from the centre. `position` is a position in the plane.
  [[nodiscard]] double parameter_of(const Point& position) const;

  /// The positions of the curve that are nearer than r to the segment from `a` to `b`. They form one interval, because
  /// the positions near a segment are a convex set of the width 2 r.
  [[nodiscard]] Blocked blocked_by(const Point& a, const Point& b, Bias bias) const;
  /// Returns whether rounding errors decide if a disc at the curve can pass between the curve's wall or vertex and
  /// `vertex`: the distance between the two is nearly 2 r.
  [[nodiscard]] bool is_nearly_diameter(const Point& vertex) const;

 private:
  [[nodiscard]] Blocked line_blocked_by(const Point& a, const Point& b, Bias bias) const;
  [[nodiscard]] Blocked circle_blocked_by(const Point& a, const Point& b, Bias bias) const;

  bool is_circle_ = false;
  Point point_;   ///< the point of the query
  Point centre_;  ///< of a circle: the vertex
  Point base_;    ///< of a line: the position with the parameter 0; of a circle: the centre; relative to `point_`
  Point along_;   ///< of a line: its direction
  Interval whole_;
  double height_ = 0.0;  ///< of a line: the distance of the query's point from the wall's line; negative on its right
  double radius_ = 0.0;
  double rounding_ = 0.0;
  double extent_ = 0.0;  ///< of a line: the distance to the far end of the wall
};

/// Removes the blocked positions from the intervals. `blocker` is the wall that blocks them.
void subtract(const OffsetCurve& curve, const OffsetCurve::Blocked& blocked, mesh::HalfEdge blocker,
              OffsetCurve::Intervals& intervals);
/// Divides the interval that contains the parameter, because no disc passes there.
void cut(double parameter, mesh::HalfEdge blocker, OffsetCurve::Intervals& intervals);
/// Returns whether one of the intervals contains a blocked position.
[[nodiscard]] bool meets(const OffsetCurve::Blocked& blocked, const OffsetCurve::Intervals& intervals);
/// Returns whether one of the intervals contains the parameter strictly between its ends.
[[nodiscard]] bool contains(double parameter, const OffsetCurve::Intervals& intervals);

}  // namespace waywright::clearance

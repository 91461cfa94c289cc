#include "clearance/offset_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ieee.hpp"
#include "clearance/disc.hpp"

namespace waywright::clearance {

using mesh::HalfEdge;
using Blocked = OffsetCurve::Blocked;
using Interval = OffsetCurve::Interval;

namespace {

/// More than the relative errors of the formulas in this file.
constexpr double kUnit = 0x1p-48;
/// A bound of the errors of a parameter of a circle.
constexpr double kAngle = 0x1p-46;

Point to_left(const Point& v) { return {-v.y, v.x}; }
/// Returns 1 if rounding errors must make intervals shorter, -1 if they must make them longer, otherwise 0.
double sign_of(OffsetCurve::Bias bias) {
  if (bias == OffsetCurve::Bias::none) return 0.0;
  return bias == OffsetCurve::Bias::less ? 1.0 : -1.0;
}

/// Returns a vector in the direction of the parameter of a circle.
Point direction_of(double parameter) {
  const double t = parameter;
  if (t <= 1.0) return {1.0 - t, t};
  if (t <= 2.0) return {1.0 - t, 2.0 - t};
  if (t <= 3.0) return {t - 3.0, 2.0 - t};
  return {t - 3.0, t - 4.0};
}

double parameter_of_direction(const Point& v) {
  const double size = extent_of(v);
  if (v.y >= 0.0) return v.x >= 0.0 ? v.y / size : 1.0 - v.x / size;
  return v.x < 0.0 ? 2.0 - v.y / size : 3.0 + v.x / size;
}

/// The blocked arc of a circle: how far it reaches counter-clockwise and clockwise from the direction `axis`, which
/// lies in the arc.
class Arc {
 public:
  explicit Arc(const Point& axis) : axis_(axis) {}

  /// Adds the end of an arc around `middle` whose half-angle has this cosine: the end that comes last counter-clockwise
  /// if `direction` is 1, or the end that comes last clockwise if `direction` is -1.
  void add(const Point& middle, double cosine, int direction) {
    const double sine = direction * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    add(Point{middle.x * cosine - middle.y * sine, middle.y * cosine + middle.x * sine}, direction);
  }
  void add(const Point& end, int direction) {
    const double parameter = parameter_of_direction({dot(axis_, end), cross(axis_, end)});
    // No end is more than 180 degrees away from the axis.
    if (direction > 0) {
      const double left = parameter > 3.0 ? parameter - 4.0 : parameter;
      if (left > left_) {
        left_ = left;
        left_end_ = end;
      }
    } else {
      const double right = parameter > 1.0 ? parameter - 4.0 : parameter;
      if (right < right_) {
        right_ = right;
        right_end_ = end;
      }
    }
  }

  [[nodiscard]] Blocked blocked(OffsetCurve::Bias bias) const {
    if (!(left_ > -4.0 && right_ < 4.0)) return {};
    const double low = parameter_of_direction(right_end_);
    const double high = parameter_of_direction(left_end_);
    if (bias == OffsetCurve::Bias::none) return {true, low, high};
    if (bias == OffsetCurve::Bias::more) {
      if (left_ - right_ > 4.0 - 4.0 * kAngle) return {true, 0.0, 4.0};
      return {true, low - kAngle, high + kAngle};
    }
    if (!(left_ - right_ > 4.0 * kAngle)) return {};
    return {true, low + kAngle, high - kAngle};
  }

 private:
  Point axis_;
  double left_ = -5.0;
  double right_ = 5.0;
  Point left_end_;
  Point right_end_;
};

}  // namespace

OffsetCurve OffsetCurve::left_of(const Point& point, const Point& a, const Point& b, double radius, double rounding) {
  OffsetCurve curve;
  const Point from = a - point;
  const Point to = b - point;
  curve.point_ = point;
  curve.radius_ = radius;
  curve.rounding_ = rounding;
  curve.along_ = unit(b - a);
  const Point normal = to_left(curve.along_);
  const Point& nearer = extent_of(from) < extent_of(to) ? from : to;
  curve.height_ = -dot(nearer, normal);
  curve.base_ = normal * (radius - curve.height_);
  curve.whole_ = {dot(from, curve.along_), dot(to, curve.along_)};
  curve.extent_ = std::max(extent_of(from), extent_of(to));
  return curve;
}

OffsetCurve OffsetCurve::around(const Point& point, const Point& vertex, double radius, double rounding) {
  OffsetCurve curve;
  curve.is_circle_ = true;
  curve.point_ = point;
  curve.centre_ = vertex;
  curve.base_ = vertex - point;
  curve.radius_ = radius;
  curve.rounding_ = rounding;
  curve.whole_ = {0.0, 4.0};
  return curve;
}

Point OffsetCurve::at(double parameter) const {
  return is_circle_ ? base_ + normal(parameter) * radius_ : base_ + along_ * parameter;
}

Point OffsetCurve::normal(double parameter) const {
  return is_circle_ ? unit(direction_of(parameter)) : to_left(along_);
}

double OffsetCurve::nearest(const Interval& interval) const {
  if (!is_circle_) return std::clamp(0.0, interval.low, interval.high);
  if (base_.x == 0.0 && base_.y == 0.0) return 0.5 * (interval.low + interval.high);
  const double best = parameter_of_direction(-base_);
  if (best >= interval.low && best <= interval.high) return best;
  const bool is_low = squared_length(at(interval.low)) <= squared_length(at(interval.high));
  return is_low ? interval.low : interval.high;
}

double OffsetCurve::parameter_of(const Point& position) const {
  return is_circle_ ? parameter_of_direction(position - centre_) : dot(position - point_, along_);
}

Blocked OffsetCurve::blocked_by(const Point& a, const Point& b, Bias bias) const {
  return is_circle_ ? circle_blocked_by(a, b, bias) : line_blocked_by(a, b, bias);
}

bool OffsetCurve::is_nearly_diameter(const Point& vertex) const {
  const Point to = is_circle_ ? vertex - centre_ : vertex - point_;
  const double distance = is_circle_ ? std::sqrt(squared_length(to)) : dot(to, to_left(along_)) + height_;
  const double error = 4.0 * (kUnit * (extent_of(to) + extent_ + radius_) + rounding_);
  return std::abs(distance - 2.0 * radius_) <= error;
}

// In the frame of the line, the wall lies at y = 0, and the curve at y = r. The ends of the interval are positions at
// the distance r from an end of the segment, or from the line through the segment.
Blocked OffsetCurve::line_blocked_by(const Point& a, const Point& b, Bias bias) const {
  const Point normal = to_left(along_);
  const auto local = [&](const Point& p) { return Point{dot(p, along_), dot(p, normal) + height_}; };
  const Point from_a = a - point_;
  const Point from_b = b - point_;
  const double extent = extent_of(from_a) + extent_of(from_b) + extent_ + radius_;
  const double slack = sign_of(bias) * (kUnit * extent + rounding_);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto add = [&](double from, double to, double shrink) {
    low = std::min(low, from + shrink);
    high = std::max(high, to - shrink);
  };
  const Point p = local(from_a);
  const Point q = local(from_b);
  for (const Point& end : {p, q}) {
    const double below = end.y - slack;
    const double above = 2.0 * radius_ - end.y - slack;
    if (!(below > 0.0 && above > 0.0)) continue;
    const double half = std::sqrt(below) * std::sqrt(above);
    add(end.x - half, end.x + half, slack);
  }
  const Point d = q - p;
  const double length = std::sqrt(squared_length(d));
  if (std::abs(d.y) > 0x1p-40 * length) {
    const double shrink = slack * (length / std::abs(d.y));
    for (const int sign : {1, -1}) {
      const double x = p.x + (d.x * (radius_ - p.y) - sign * radius_ * length) / d.y;
      const double share = ((x - p.x) * d.x + (radius_ - p.y) * d.y) / length;
      if (share >= -std::abs(shrink) && share <= length + std::abs(shrink)) add(x, x, shrink);
    }
  }
  if (!(low < high)) return {};
  return {true, low, high};
}

// Let w be the vector from the centre to an end of the segment. The positions nearer than r to this end lie in the
// directions that differ from w by an angle with a cosine above |w| / (2 r). The positions nearer than r to the line
// through the segment, at the distance d from the centre, lie in the directions that differ from the perpendicular by
// an angle with a cosine above d / r - 1.
Blocked OffsetCurve::circle_blocked_by(const Point& a, const Point& b, Bias bias) const {
  const Point p = a - centre_;
  const Point q = b - centre_;
  const double sign = sign_of(bias);
  const Point d = q - p;
  const double length = std::sqrt(squared_length(d));
  if (!(length > 0.0)) return {};
  const Point along{d.x / length, d.y / length};
  const double before = -dot(p, along);  // the foot of the perpendicular, from a
  const bool is_inside = before > 0.0 && before < length;
  const double offset = cross(along, p);
  const Point across = offset >= 0.0 ? to_left(along) : -to_left(along);
  const bool is_incident = squared_length(p) == 0.0 || squared_length(q) == 0.0;
  Point axis = is_inside ? across : before <= 0.0 ? p : q;
  if (is_incident) axis = squared_length(p) == 0.0 ? d : -d;
  Arc arc(unit(axis));
  const double error = sign * (kUnit * 2.0 + rounding_ / radius_);
  for (const Point& w : {p, q}) {
    const double size = std::sqrt(squared_length(w));
    const double cosine = size / (2.0 * radius_) + error;
    if (!(cosine < 1.0)) continue;
    const Point middle = size > 0.0 ? Point{w.x / size, w.y / size} : unit(axis);
    for (const int direction : {1, -1}) arc.add(middle, cosine, direction);
  }
  const double slack = kUnit * (extent_of(p) + extent_of(q)) / radius_;
  const double cosine = std::max(-1.0, std::abs(offset) / radius_ - 1.0 + error + sign * slack);
  if (cosine < 1.0 && !is_incident) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    for (const int direction : {1, -1}) {
      const Point end = across * cosine + to_left(across) * (direction * sine);
      const double foot = radius_ * dot(end, along) + before;
      const double margin = radius_ * (slack + std::abs(error));
      if (foot >= -margin && foot <= length + margin) arc.add(end, direction);
    }
  }
  return arc.blocked(bias);
}

namespace {

void subtract_one(double low, double high, HalfEdge blocker, OffsetCurve::Intervals& intervals) {
  const std::size_t count = intervals.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Interval interval = intervals[i];
    if (high <= interval.low || low >= interval.high) {
      intervals[kept++] = interval;
      continue;
    }
    const bool has_first = low > interval.low;
    const bool has_second = high < interval.high;
    const Interval first{interval.low, low, interval.low_blocker, blocker};
    const Interval second{high, interval.high, blocker, interval.high_blocker};
    if (has_first) intervals[kept++] = first;
    if (has_second && !has_first) intervals[kept++] = second;
    if (has_second && has_first) intervals.push_back(second);
  }
  intervals.erase(intervals.begin() + static_cast<std::ptrdiff_t>(kept),
                  intervals.begin() + static_cast<std::ptrdiff_t>(count));
}

bool meets_one(double low, double high, const OffsetCurve::Intervals& intervals) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& interval) { return low < interval.high && high > interval.low; });
}

}  // namespace

void subtract(const OffsetCurve& curve, const Blocked& blocked, HalfEdge blocker, OffsetCurve::Intervals& intervals) {
  if (!blocked.is_blocked) return;
  if (!curve.is_circle() || blocked.low <= blocked.high) {
    return subtract_one(blocked.low, blocked.high, blocker, intervals);
  }
  subtract_one(blocked.low, 5.0, blocker, intervals);
  subtract_one(-1.0, blocked.high, blocker, intervals);
}

void cut(double parameter, HalfEdge blocker, OffsetCurve::Intervals& intervals) {
  const std::size_t count = intervals.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Interval interval = intervals[i];
    if (!(parameter > interval.low && parameter < interval.high)) continue;
    intervals[i] = {interval.low, parameter, interval.low_blocker, blocker};
    intervals.push_back({parameter, interval.high, blocker, interval.high_blocker});
  }
}

bool meets(const Blocked& blocked, const OffsetCurve::Intervals& intervals) {
  if (!blocked.is_blocked) return false;
  if (blocked.low <= blocked.high) return meets_one(blocked.low, blocked.high, intervals);
  return meets_one(blocked.low, 5.0, intervals) || meets_one(-1.0, blocked.high, intervals);
}

bool contains(double parameter, const OffsetCurve::Intervals& intervals) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& interval) { return parameter > interval.low && parameter < interval.high; });
}

}  // namespace waywright::clearance

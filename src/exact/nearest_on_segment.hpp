#pragma once

#include <compare>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/homogeneous.hpp"
#include "exact/position.hpp"

namespace waywright::exact {

/// The position on a closed segment that is nearest to a point, and its distance from that point, both exact. The class
/// uses integers of any size and is slow. So use it only in rare cases, for example if a polygon covers the end of a
/// path only because of rounding.
class NearestOnSegment {
 public:
  /// The segment from `a` to `b` lies on the line through the explicit positions `c` and `d`, and runs in the direction
  /// from `c` to `d` or in the opposite one. Requires: `c` and `d` differ.
  NearestOnSegment(const Point& from, const ExactPosition& a, const ExactPosition& b, const Point& c, const Point& d);

  /// The position, each coordinate rounded to the nearest double.
  [[nodiscard]] Point rounded() const;
  /// Compares the distances. If these are equal, compares the positions in (x, y) order.
  [[nodiscard]] static std::strong_ordering compare(const NearestOnSegment& p, const NearestOnSegment& q);
  /// Whether the position is at most `distance` away. Requires: `distance` is positive, finite and not subnormal.
  [[nodiscard]] bool is_within(double distance) const;

 private:
  void set_to_foot(const Homogeneous& p, const Homogeneous& line, const Integer& dx, const Integer& dy);
  void set_to_end(const ExactPosition& end, const Homogeneous& from);

  int exponent_;  ///< the unit of all lengths below is 2^exponent_
  Homogeneous position_;
  // The squared distance is numerator_ / denominator_, in units of 4^exponent_.
  Integer numerator_;
  Integer denominator_;
};

}  // namespace waywright::exact

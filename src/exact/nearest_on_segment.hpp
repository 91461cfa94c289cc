#pragma once

#include <compare>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/exact_point.hpp"
#include "exact/homogeneous.hpp"
#include "exact/integer.hpp"

namespace waywright::exact {

/// The place of a closed segment that is nearest to a point, and its distance, both exactly. Integers of any size: for
/// few questions, such as those about ends of paths that polygons cover by no more than rounding.
class NearestOnSegment {
 public:
  /// The segment from `a` to `b` lies on the line through the explicit points `c` and `d`, and runs in the direction
  /// from `c` to `d` or in the opposite one. Requires: `c` and `d` differ.
  NearestOnSegment(const Point& from, const ExactPoint& a, const ExactPoint& b, const Point& c, const Point& d);

  /// The place, each coordinate rounded to the nearest double.
  [[nodiscard]] Point rounded() const;
  /// Orders by distance, and places of equal distance by (x, y).
  [[nodiscard]] static std::strong_ordering compare(const NearestOnSegment& p, const NearestOnSegment& q);
  /// Requires: `distance` is positive, finite and not subnormal.
  [[nodiscard]] bool is_within(double distance) const;

 private:
  void set_to_foot(const Homogeneous& p, const Homogeneous& line, const Integer& dx, const Integer& dy);
  void set_to_end(const ExactPoint& end, const Homogeneous& from);

  int exponent_;  ///< of the lattice that the integers count on
  Homogeneous place_;
  // The squared distance, in units of 4^exponent_.
  Integer numerator_;
  Integer denominator_;
};

}  // namespace waywright::exact

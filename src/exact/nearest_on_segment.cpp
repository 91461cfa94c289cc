#include "exact/nearest_on_segment.hpp"

#include <algorithm>
#include <utility>

namespace waywright::exact {

namespace {

std::strong_ordering compare_integers(const Integer& p, const Integer& q) {
  const int sign = p.compare(q);
  return sign <=> 0;
}

/// Compares p 2^p_exponent with q 2^q_exponent.
std::strong_ordering compare_scaled(Integer p, int p_exponent, Integer q, int q_exponent) {
  if (p_exponent >= q_exponent) {
    p <<= static_cast<unsigned>(p_exponent - q_exponent);
  } else {
    q <<= static_cast<unsigned>(q_exponent - p_exponent);
  }
  return compare_integers(p, q);
}

}  // namespace

// The points of the line are C + t D with D = d - c. The foot of the perpendicular from P has t = (P - C) . D / D . D.
// It lies on the segment unless (P - a) . D and (P - b) . D are both positive or both negative.
NearestOnSegment::NearestOnSegment(const Point& from, const ExactPosition& a, const ExactPosition& b, const Point& c,
                                   const Point& d) {
  LatticeExponent lattice;
  for (const Point& point : {from, c, d}) lattice.include(point);
  lattice.include(a);
  lattice.include(b);
  exponent_ = lattice.value();
  const Homogeneous p = to_homogeneous(explicit_position(from), exponent_);
  const Homogeneous line = to_homogeneous(explicit_position(c), exponent_);
  const Homogeneous line_end = to_homogeneous(explicit_position(d), exponent_);
  const Integer dx = line_end.x - line.x;
  const Integer dy = line_end.y - line.y;
  const auto beyond = [&](const ExactPosition& end) {
    const Homogeneous q = to_homogeneous(end, exponent_);
    return Integer((p.x * q.w - q.x) * dx + (p.y * q.w - q.y) * dy);
  };
  const Integer beyond_a = beyond(a);
  const Integer beyond_b = beyond(b);
  // If the segment runs in the direction of D, the value of `beyond` decreases from a to b.
  const bool is_beyond_both = beyond_a.sign() * beyond_b.sign() > 0;
  if (is_beyond_both) {
    const Homogeneous qa = to_homogeneous(a, exponent_);
    const Homogeneous qb = to_homogeneous(b, exponent_);
    // If the foot does not lie between the ends, the nearer end has the smaller |beyond|. Each value is in units of its
    // own w.
    const bool a_is_nearer = abs(beyond_a) * qb.w < abs(beyond_b) * qa.w;
    set_to_end(a_is_nearer ? a : b, p);
  } else if (beyond_a == 0) {
    set_to_end(a, p);
  } else if (beyond_b == 0) {
    set_to_end(b, p);
  } else {
    set_to_foot(p, line, dx, dy);
  }
}

/// Sets the position to the foot of the perpendicular on the line through `line` in the direction (dx, dy).
void NearestOnSegment::set_to_foot(const Homogeneous& p, const Homogeneous& line, const Integer& dx,
                                   const Integer& dy) {
  const Integer squared_length = dx * dx + dy * dy;
  const Integer t = (p.x - line.x) * dx + (p.y - line.y) * dy;
  const Integer across = (p.x - line.x) * dy - (p.y - line.y) * dx;
  position_ = {line.x * squared_length + dx * t, line.y * squared_length + dy * t, squared_length};
  numerator_ = across * across;
  denominator_ = squared_length;
}

void NearestOnSegment::set_to_end(const ExactPosition& end, const Homogeneous& from) {
  position_ = to_homogeneous(end, exponent_);
  const Integer dx = from.x * position_.w - position_.x;
  const Integer dy = from.y * position_.w - position_.y;
  numerator_ = dx * dx + dy * dy;
  denominator_ = position_.w * position_.w;
}

Point NearestOnSegment::rounded() const { return round_to_nearest(position_, exponent_); }

std::strong_ordering NearestOnSegment::compare(const NearestOnSegment& p, const NearestOnSegment& q) {
  const auto by_distance =
      compare_scaled(p.numerator_ * q.denominator_, 2 * p.exponent_, q.numerator_ * p.denominator_, 2 * q.exponent_);
  if (by_distance != 0) return by_distance;
  const auto by_x =
      compare_scaled(p.position_.x * q.position_.w, p.exponent_, q.position_.x * p.position_.w, q.exponent_);
  if (by_x != 0) return by_x;
  return compare_scaled(p.position_.y * q.position_.w, p.exponent_, q.position_.y * p.position_.w, q.exponent_);
}

bool NearestOnSegment::is_within(double distance) const {
  const Dyadic limit = to_dyadic(distance);
  const Integer squared = Integer{limit.mantissa} * Integer{limit.mantissa};
  return compare_scaled(numerator_, 2 * exponent_, squared * denominator_, 2 * limit.exponent) <= 0;
}

}  // namespace waywright::exact

#include "exact/filter.hpp"

#include <algorithm>
#include <array>

// The part of the bounds that only constructed points need; filter.hpp derives it.

namespace waywright::exact::filter {

namespace {

/// The largest magnitude of the points' coordinates, and of their differences from the last point's.
struct Extent {
  double coordinate = 0.0;
  double difference = 0.0;
};

template <std::size_t kCount>
Extent extent_of(const std::array<const ExactPoint*, kCount>& points) {
  const ExactPoint& last = *points.back();
  Extent extent;
  for (const ExactPoint* const p : points) {
    extent.coordinate = std::max({extent.coordinate, std::abs(p->x), std::abs(p->y)});
    extent.difference = std::max({extent.difference, std::abs(p->x - last.x), std::abs(p->y - last.y)});
  }
  return extent;
}

}  // namespace

double orientation_rounding(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const Extent extent = extent_of<3>({&a, &b, &c});
  const double m = extent.coordinate;
  return 9.0 * kHalfUlp * m * (extent.difference + 3.0 * kHalfUlp * m) + kUnderflow;
}

double in_circle_rounding(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  const Extent extent = extent_of<4>({&a, &b, &c, &d});
  const double m = extent.coordinate;
  const double reach = extent.difference + 3.0 * kHalfUlp * m;
  return 100.0 * kHalfUlp * m * reach * reach * reach + kUnderflow;
}

}  // namespace waywright::exact::filter

#pragma once

#include <optional>

#include "exact/sign.hpp"

namespace waywright::bench {

/// Bounds of a coordinate, both included.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

struct BoundedPoint {
  Bounds x;
  Bounds y;
};

// The questions in interval arithmetic (Boost's). Empty where the interval holds zero and more.
[[nodiscard]] std::optional<exact::Sign> orientation(const BoundedPoint& a, const BoundedPoint& b,
                                                     const BoundedPoint& c);
[[nodiscard]] std::optional<exact::Sign> in_circle(const BoundedPoint& a, const BoundedPoint& b, const BoundedPoint& c,
                                                   const BoundedPoint& d);

}  // namespace waywright::bench

#pragma once

#include <optional>

#include "exact/position.hpp"

namespace waywright::bench {

/// The bounds of a coordinate, both included.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

struct BoundedPoint {
  Bounds x;
  Bounds y;
};

// The predicates in Boost's interval arithmetic. They return nothing if the interval contains zero and other numbers.
[[nodiscard]] std::optional<exact::Sign> orientation(const BoundedPoint& a, const BoundedPoint& b,
                                                     const BoundedPoint& c);
[[nodiscard]] std::optional<exact::Sign> in_circle(const BoundedPoint& a, const BoundedPoint& b, const BoundedPoint& c,
                                                   const BoundedPoint& d);

}  // namespace waywright::bench

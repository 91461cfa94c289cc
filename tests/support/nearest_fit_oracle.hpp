#pragma once

#include <functional>
#include <optional>

#include "waywright/point.hpp"

#include "support/disc_oracle.hpp"

namespace waywright::test::disc {

/// Returns a point near to `point` where the disc of radius r > 0 is free and `counts` is true: brute force over the
/// offset lines of all walls, the circles around all ends of walls, and the crossings of all pairs of these, in long
/// double. The function rounds each position to several doubles and asks fits() about each of them, in rationals. No
/// position is nearer than the result, except for positions that the rounding has missed. Returns nothing if the
/// function finds no point.
[[nodiscard]] std::optional<Point> nearest_fit(const Walls& walls, Point point, double r,
                                               const std::function<bool(Point)>& counts);

}  // namespace waywright::test::disc

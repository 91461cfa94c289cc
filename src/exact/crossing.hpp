#pragma once

#include <optional>
#include <string>

#include "waywright/point.hpp"

#include "exact/position.hpp"

namespace waywright::exact {

/// The coordinates of a crossing, each rounded to the nearest double (ties to even).
struct RoundedCrossing {
  Point nearest;
  bool is_exact = false;  ///< whether `nearest` equals the crossing and is in range
};

// The stages of round_to_nearest(), in the order in which it tries them: the cheapest first. The predicates have the
// same order.
namespace by_construction {
/// For two lines that are parallel to the axes: their crossing has one coordinate of each line. Empty for other lines.
[[nodiscard]] inline std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing) {
  const auto& [a, b] = crossing.ab;
  const auto& [c, d] = crossing.cd;
  if (a.x == b.x && c.y == d.y) return RoundedCrossing{{a.x, c.y}, true};
  if (a.y == b.y && c.x == d.x) return RoundedCrossing{{c.x, a.y}, true};
  return std::nullopt;
}
}  // namespace by_construction
namespace doubles {
/// For whole numbers that are so small that only the quotient is rounded. Empty for other numbers.
[[nodiscard]] std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing);
}  // namespace doubles
namespace lattice {
/// In integers of fixed width. Empty if no lattice that contains the points is coarse enough.
[[nodiscard]] std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing);
}  // namespace lattice
namespace integers {
[[nodiscard]] RoundedCrossing round_to_nearest(const Crossing& crossing);
}  // namespace integers

namespace detail {
/// Runs the stages after the first, one after the other.
[[nodiscard]] RoundedCrossing round_other_to_nearest(const Crossing& crossing);
}  // namespace detail

/// Returns the rounded crossing. Requires: the two lines are not parallel, and the four points are in range.
[[nodiscard]] inline RoundedCrossing round_to_nearest(const Crossing& crossing) {
  if (const auto rounded = by_construction::round_to_nearest(crossing)) {
    ++counts.crossing.doubles;
    return *rounded;
  }
  return detail::round_other_to_nearest(crossing);
}

/// Returns "XNUM XDEN YNUM YDEN": the point as reduced fractions with positive denominators.
[[nodiscard]] std::string to_fractions(const ExactPosition& point);

}  // namespace waywright::exact

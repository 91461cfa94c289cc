#pragma once

#include <optional>
#include <string>

#include "waywright/point.hpp"

#include "exact/counts.hpp"
#include "exact/exact_point.hpp"

namespace waywright::exact {

/// A crossing's coordinates, each rounded to the nearest double (ties to even).
struct RoundedCrossing {
  Point nearest;
  bool is_exact = false;  ///< `nearest` is the crossing itself, and in range
};

// The stages of round_to_nearest, the cheapest first, as those of the predicates.
namespace by_construction {
/// Of two lines parallel to the axes, which cross in a pair of their coordinates. Empty where they aren't.
[[nodiscard]] inline std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing) {
  const auto& [a, b, c, d] = crossing;
  if (a.x == b.x && c.y == d.y) return RoundedCrossing{{a.x, c.y}, true};
  if (a.y == b.y && c.x == d.x) return RoundedCrossing{{c.x, a.y}, true};
  return std::nullopt;
}
}  // namespace by_construction
namespace doubles {
/// Of whole numbers so small that nothing but the quotient is rounded. Empty where the points aren't such.
[[nodiscard]] std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing);
}  // namespace doubles
namespace lattice {
/// In integers of fixed width. Empty where the points lie on no lattice that is coarse enough.
[[nodiscard]] std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing);
}  // namespace lattice
namespace integers {
[[nodiscard]] RoundedCrossing round_to_nearest(const Crossing& crossing);
}  // namespace integers

namespace detail {
/// The stages after the first, one after the other.
[[nodiscard]] RoundedCrossing round_other_to_nearest(const Crossing& crossing);
}  // namespace detail

/// Requires: the crossing's two lines are not parallel, its points in range.
[[nodiscard]] inline RoundedCrossing round_to_nearest(const Crossing& crossing) {
  if (const auto rounded = by_construction::round_to_nearest(crossing)) {
    ++counts.crossing.doubles;
    return *rounded;
  }
  return detail::round_other_to_nearest(crossing);
}

/// "XNUM XDEN YNUM YDEN": the point as reduced fractions, denominators positive.
[[nodiscard]] std::string to_fractions(const ExactPoint& point);

}  // namespace waywright::exact

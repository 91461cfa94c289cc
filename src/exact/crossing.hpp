#pragma once

#include <optional>
#include <string>

#include "waywright/point.hpp"

#include "exact/exact_point.hpp"

namespace waywright::exact {

/// A crossing's coordinates, each rounded to the nearest double (ties to even).
struct RoundedCrossing {
  Point nearest;
  bool is_exact = false;  ///< `nearest` is the crossing itself, and in range
};

/// Requires: the crossing's two lines are not parallel, its points in range.
[[nodiscard]] RoundedCrossing round_to_nearest(const Crossing& crossing);

// Its stages, the cheapest first, as those of the predicates.
namespace by_construction {
/// Of two lines parallel to the axes, which cross in a pair of their coordinates. Empty where they aren't.
[[nodiscard]] std::optional<RoundedCrossing> round_to_nearest(const Crossing& crossing);
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

/// "XNUM XDEN YNUM YDEN": the point as reduced fractions, denominators positive.
[[nodiscard]] std::string to_fractions(const ExactPoint& point);

}  // namespace waywright::exact

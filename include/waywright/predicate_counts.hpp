#pragma once

#include <cstdint>

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup build
/// @{

/// The number of calls of one predicate, counted by the stage of the exact arithmetic that decided the call.
struct StageCounts {
  /// Doubles with a proven error bound. For crossings: doubles, if no step before the final division rounds.
  std::uint64_t doubles = 0;
  std::uint64_t lattice = 0;   ///< integers of a fixed width: coordinates as multiples of one power of two, a lattice
  std::uint64_t integers = 0;  ///< integers of any size

  friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

/// The number of calls of three predicates, and the number of computed crossings. The library does not count the
/// predicates about gaps and distances of discs.
///
/// @code{.cpp}
/// const PredicateCounts counts = predicate_counts();
/// std::printf("%ju in-circle tests needed integers of any size\n", std::uintmax_t{counts.in_circle.integers});
/// @endcode
struct PredicateCounts {
  StageCounts orientation;  ///< whether a point lies left of, on or right of a line
  StageCounts in_circle;    ///< whether a point lies inside a circle
  StageCounts order;        ///< which of two points comes first in (x, y) order
  StageCounts crossing;     ///< where two lines cross

  friend bool operator==(const PredicateCounts&, const PredicateCounts&) = default;
};

/// Returns the counts of the calling thread since its start, for all worlds together.
/// Cost: O(1).
/// Threads: each thread has its own counts, so this function shares no data.
[[nodiscard]] WAYWRIGHT_API PredicateCounts predicate_counts();

/// @}

}  // namespace waywright

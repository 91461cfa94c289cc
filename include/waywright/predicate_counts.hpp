#pragma once

#include <cstdint>

#include "waywright/export.hpp"

namespace waywright {

/// How many calls of one question about points each stage of the arithmetic decided.
struct StageCounts {
  std::uint64_t doubles = 0;   ///< doubles with a proven error bound, or exact but for one division (crossings)
  std::uint64_t lattice = 0;   ///< integers of a fixed width, on the stack
  std::uint64_t integers = 0;  ///< integers of any size

  friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

/// The same for each question.
struct PredicateCounts {
  StageCounts orientation;  ///< on which side of a line
  StageCounts in_circle;    ///< inside which circle
  StageCounts order;        ///< which comes first
  StageCounts crossing;     ///< where two lines cross

  friend bool operator==(const PredicateCounts&, const PredicateCounts&) = default;
};

/// What the calling thread has asked since it began, of all worlds together. Threads: each counts for itself, so asking
/// shares nothing.
[[nodiscard]] WAYWRIGHT_API PredicateCounts predicate_counts();

}  // namespace waywright

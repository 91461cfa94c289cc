#pragma once

#include "waywright/predicate_counts.hpp"

namespace waywright::exact {

/// The counters of the calling thread. They always count, and no answer depends on them. Each thread has its own, so
/// concurrent queries do not write to memory that another thread reads.
inline constinit thread_local PredicateCounts counts{};

}  // namespace waywright::exact

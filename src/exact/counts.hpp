#pragma once

#include "waywright/predicate_counts.hpp"

namespace waywright::exact {

/// Always on. By thread, so that queries that run at once write nothing that another reads; no answer depends on it.
inline constinit thread_local PredicateCounts counts{};

}  // namespace waywright::exact

#include "exact/counts.hpp"

namespace waywright {

PredicateCounts predicate_counts() { return exact::counts; }

}  // namespace waywright

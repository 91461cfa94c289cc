#include "constraint_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"

namespace waywright::bench {

void register_maps() { register_real_scenes<Waywright>("waywright"); }

}  // namespace waywright::bench

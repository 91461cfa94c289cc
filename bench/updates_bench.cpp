#include <string>

#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"
#include "workloads.hpp"

namespace waywright::bench {

void register_updates() {
  register_updates<Waywright>("point_removal/" + std::to_string(kRemovalCount), "waywright",
                              [] { return point_removal(kRemovalCount); });
  register_moving_square<Waywright>("waywright");
  register_moving_square<WaywrightReplace>("waywright_replace");
  register_rts<Waywright>("waywright");
}

}  // namespace waywright::bench

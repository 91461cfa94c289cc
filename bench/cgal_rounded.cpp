#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "cgal_polylines.hpp"
#include "constraint_benchmarks.hpp"
#include "registers.hpp"

namespace waywright::bench {

/// Exact predicates, crossing points rounded to doubles.
void register_cgal_rounded() {
  using Rounded = CgalPolylines<CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Exact_predicates_tag>;
  register_segments<Rounded>("cgal_rounded");
  register_moving_square<Rounded>("cgal_rounded");
  register_rts<Rounded>("cgal_rounded");
  register_real_scenes<Rounded>("cgal_rounded");
}

}  // namespace waywright::bench

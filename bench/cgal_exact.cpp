#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "cgal_polylines.hpp"
#include "constraint_benchmarks.hpp"
#include "registers.hpp"

namespace waywright::bench {

/// Exact predicates and exact crossing points.
void register_cgal_exact() {
  using Exact = CgalPolylines<CGAL::Exact_predicates_exact_constructions_kernel, CGAL::Exact_intersections_tag>;
  register_segments<Exact>("cgal_exact");
  register_moving_square<Exact>("cgal_exact");
  register_rts<Exact>("cgal_exact");
  register_real_scenes<Exact>("cgal_exact");
}

}  // namespace waywright::bench

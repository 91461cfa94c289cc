#include "thesis/interval_arithmetic.hpp"

#define WAYWRIGHT_GEOMETRY bench::IntervalGeometry
#define delaunay delaunay_over_interval
#define constraint constraint_over_interval

#include "thesis/triangulated_over.hpp"
#include "thesis/triangulation_sources.hpp"

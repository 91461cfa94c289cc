#include "thesis/double_arithmetic.hpp"

#define WAYWRIGHT_GEOMETRY bench::DoubleGeometry
#define delaunay delaunay_over_double
#define constraint constraint_over_double

#include "thesis/triangulated_over.hpp"
#include "thesis/triangulation_sources.hpp"

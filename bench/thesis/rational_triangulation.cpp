#include "thesis/rational_arithmetic.hpp"

#define WAYWRIGHT_GEOMETRY bench::RationalGeometry
#define delaunay delaunay_over_rational
#define constraint constraint_over_rational

#include "thesis/triangulated_over.hpp"
#include "thesis/triangulation_sources.hpp"

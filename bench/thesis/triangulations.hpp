#pragma once

#include "constraint/constrained_triangulation.hpp"
#include "thesis/double_arithmetic.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/rational_arithmetic.hpp"

static_assert(waywright::exact::AnyGeometry<waywright::bench::DoubleGeometry>);
static_assert(waywright::exact::AnyGeometry<waywright::bench::IntervalGeometry>);
static_assert(waywright::exact::AnyGeometry<waywright::bench::RationalGeometry>);

// The template instances for the rival geometries, as constraint/exact_triangulation.hpp declares them for the
// library's.

extern template class waywright::delaunay::Triangulation<waywright::bench::DoubleGeometry>;
extern template class waywright::delaunay::Triangulation<waywright::bench::IntervalGeometry>;
extern template class waywright::delaunay::Triangulation<waywright::bench::RationalGeometry>;
extern template class waywright::constraint::ConstrainedTriangulation<waywright::bench::DoubleGeometry>;
extern template class waywright::constraint::ConstrainedTriangulation<waywright::bench::IntervalGeometry>;
extern template class waywright::constraint::ConstrainedTriangulation<waywright::bench::RationalGeometry>;

#include "constraint/constrained_triangulation.inl"
#include "thesis/triangulations.hpp"

template class waywright::delaunay::Triangulation<waywright::bench::IntervalGeometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::bench::IntervalGeometry>;

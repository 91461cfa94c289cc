#include "constraint/constrained_triangulation.inl"
#include "thesis/triangulations.hpp"

template class waywright::delaunay::Triangulation<waywright::bench::DoubleGeometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::bench::DoubleGeometry>;

#include "thesis/triangulations.hpp"

#include "constraint/constrained_triangulation.inl"

template class waywright::delaunay::Triangulation<waywright::bench::DoubleGeometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::bench::DoubleGeometry>;

#include "constraint/exact_triangulation.hpp"

#include "constraint/constrained_triangulation.inl"

template class waywright::delaunay::Triangulation<waywright::exact::Geometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::exact::Geometry>;

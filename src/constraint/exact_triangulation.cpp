#include "constraint/exact_triangulation.hpp"

template class waywright::delaunay::Triangulation<waywright::exact::Geometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::exact::Geometry>;

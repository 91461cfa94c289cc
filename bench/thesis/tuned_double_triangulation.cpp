#include "thesis/triangulations.hpp"

template class waywright::delaunay::Triangulation<waywright::bench::TunedDoubleGeometry>;
template class waywright::constraint::ConstrainedTriangulation<waywright::bench::TunedDoubleGeometry>;

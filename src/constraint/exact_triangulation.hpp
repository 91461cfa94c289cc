#pragma once

#include "constraint/constrained_triangulation.hpp"
#include "exact/geometry.hpp"

namespace waywright::constraint {

/// The triangulation of a World.
using ExactTriangulation = ConstrainedTriangulation<exact::Geometry>;

extern template class ConstrainedTriangulation<exact::Geometry>;

}  // namespace waywright::constraint

extern template class waywright::delaunay::Triangulation<waywright::exact::Geometry>;

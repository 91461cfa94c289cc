#pragma once

#include "exact/geometry.hpp"

#if !defined(WAYWRIGHT_GEOMETRY)
#define WAYWRIGHT_GEOMETRY exact::Geometry
#endif

namespace waywright::delaunay {

/// The class that does all arithmetic of the triangulations. The library uses exact::Geometry. To compare another
/// arithmetic with it, bench/thesis compiles the triangulations again and defines the macro. A geometry has the
/// functions of the concept exact::AnyGeometry, and the functions set_positions(), prefetch(), count_memory() and
/// shrink_to_fit() of exact::Geometry.
using Geometry = WAYWRIGHT_GEOMETRY;

static_assert(exact::AnyGeometry<Geometry>);

}  // namespace waywright::delaunay

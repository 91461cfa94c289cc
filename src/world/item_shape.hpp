#pragma once

#include "waywright/id.hpp"
#include "waywright/item.hpp"

#include "constraint/constrained_triangulation.hpp"

namespace waywright {

/// Fills `shape` with the shape of a live item. Reuses the memory of `shape`.
void fill_shape(const constraint::ConstrainedTriangulation& triangulation, ItemId id, Shape& shape);

}  // namespace waywright

#pragma once

#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"
#include "waywright/ray.hpp"

#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// The items that cover a point, or have a side or corner there; ascending. `cover` is asked for the polygons.
[[nodiscard]] std::vector<ItemId> items_at(const ExactTriangulation& triangulation, Cover& cover, const Point& point);

/// The items whose sides the segment meets, in the order in which it does, and where, as nearest doubles. One that it
/// runs along is told of where that begins. Items met in one place come by ascending id.
[[nodiscard]] std::vector<std::pair<ItemId, Point>> items_crossed(const ExactTriangulation& triangulation,
                                                                  const Point& from, const Point& to);

/// The first wall that the segment touches on its way.
void first_wall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit);

/// The items that have a point in common with the closed box; ascending. `cover` is asked for the polygons. Requires:
/// the box meets the domain.
[[nodiscard]] std::vector<ItemId> items_in(const ExactTriangulation& triangulation, Cover& cover, const Box& box);

}  // namespace waywright::constraint

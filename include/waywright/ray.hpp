#pragma once

#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The answer of World::ray: the first wall that a segment touches. If you reuse one object for many queries, it keeps
/// its memory.
///
/// @code{.cpp}
/// const RayHit hit = world.ray({10, 50}, {90, 50}).value();
/// if (hit.hit) std::printf("a wall at (%g, %g)\n", hit.at.x, hit.at.y);
/// const ItemId wall = hit.items.front();  // == 1
/// @endcode
struct RayHit {
  bool hit = false;           ///< whether the segment touches a wall
  Point at;                   ///< the first position where the segment touches a wall, rounded to the nearest doubles
  std::vector<ItemId> items;  ///< the items with a side at this position, ascending; the null id is the domain's border

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// @}

}  // namespace waywright

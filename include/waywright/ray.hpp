#pragma once

#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// The first wall on a segment's way: the answer to World::ray. Reuse one object for many queries: its memory is kept.
struct RayHit {
  bool hit = false;
  Point at;                   ///< the first place where the segment touches a wall, as nearest doubles
  std::vector<ItemId> items;  ///< those with a side there, ascending; the null id is the domain's; empty without a hit

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

}  // namespace waywright

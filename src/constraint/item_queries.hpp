#pragma once

#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"
#include "waywright/ray.hpp"

#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/slot_sets.hpp"

namespace waywright::constraint {

/// What the queries work in. An object to keep: its memory serves query after query.
struct ItemQueryScratch {
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> along;
  std::vector<ItemId> ids;
  std::vector<mesh::HalfEdge> faces;
  SlotSet reached;
};

/// The items that cover a point, or have a side or corner there; ascending. `cover` is asked for the polygons.
void items_at(const ExactTriangulation& triangulation, Cover& cover, const Point& point, ItemQueryScratch& scratch,
              std::vector<ItemId>& result);

/// The items whose sides the segment meets, in the order in which it does, and where, as nearest doubles. One that it
/// runs along is told of where that begins. Items met in one place come by ascending id.
void items_crossed(const ExactTriangulation& triangulation, const Point& from, const Point& to,
                   ItemQueryScratch& scratch, std::vector<CrossedItem>& result);

/// The first wall that the segment touches on its way.
void first_wall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit);

/// The items that have a point in common with the closed box; ascending. `cover` is asked for the polygons. Requires:
/// the box meets the domain.
void items_in(const ExactTriangulation& triangulation, Cover& cover, const Box& box, ItemQueryScratch& scratch,
              std::vector<ItemId>& result);

}  // namespace waywright::constraint

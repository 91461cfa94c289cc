#pragma once

#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"
#include "waywright/ray.hpp"

#include "constraint/cover_finder.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/slot_sets.hpp"

namespace waywright::constraint {

/// The scratch of the queries. Use one object for many queries, because it keeps its memory.
struct ItemQueryScratch {
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> along;
  std::vector<ItemId> ids;
  std::vector<mesh::HalfEdge> faces;
  SlotSet reached;
};

/// Finds the items that cover a point or have a side or corner there, in ascending order of ids. `cover_finder`
/// finds the polygons.
void items_at(const ExactTriangulation& triangulation, CoverFinder& cover_finder, const Point& point,
              ItemQueryScratch& scratch, std::vector<ItemId>& result);

/// Finds the items whose sides the segment meets, in order from `from` to `to`, each with the position where the
/// segment meets it, rounded to doubles. If the segment runs along a side, the position is the point where the overlap
/// starts. Items at the same position are in ascending order of ids.
void items_crossed(const ExactTriangulation& triangulation, const Point& from, const Point& to,
                   ItemQueryScratch& scratch, std::vector<CrossedItem>& result);

/// Finds the first constrained edge that the segment touches, in the direction from `from` to `to`.
void first_wall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit);

/// Finds the items that have a point in common with the closed box, in ascending order of ids. `cover_finder`
/// finds the polygons. Requires: the box meets the domain.
void items_in(const ExactTriangulation& triangulation, CoverFinder& cover_finder, const Box& box,
              ItemQueryScratch& scratch, std::vector<ItemId>& result);

}  // namespace waywright::constraint

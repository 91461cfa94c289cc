#pragma once

#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/location.hpp"
#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "constraint/slot_sets.hpp"
#include "exact/sweep.hpp"
#include "memory/scratch.hpp"

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
void items_at(const ConstrainedTriangulation& triangulation, CoverFinder& cover_finder, const Point& point,
              ItemQueryScratch& scratch, std::vector<ItemId>& result);

/// Finds the items whose sides the segment meets, in order from `from` to `to`, each with the position where the
/// segment meets it, rounded to doubles. If the segment runs along a side, the position is the point where the overlap
/// starts. Items at the same position are in ascending order of ids.
void items_crossed(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to,
                   ItemQueryScratch& scratch, std::vector<CrossedItem>& result);

/// Finds the first constrained edge that the segment touches, in the direction from `from` to `to`.
void first_wall(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit);

/// Finds the items that have a point in common with the closed box, in ascending order of ids. `cover_finder`
/// finds the polygons. Requires: the box meets the domain.
void items_in(const ConstrainedTriangulation& triangulation, CoverFinder& cover_finder, const Box& box,
              ItemQueryScratch& scratch, std::vector<ItemId>& result);

/// Finds the first wall that a moving disc touches. Use one object for many queries, because it keeps its memory.
class SweptDisc {
 public:
  /// Requires: both ends of the sweep lie in the domain, and its radius is finite and positive. Cost: n log n in the
  /// number n of faces that a disc 1.07 times as large meets before the disc touches a wall.
  void find_first_wall(const ConstrainedTriangulation& triangulation, const exact::Sweep& sweep, RayHit& hit);

 private:
  /// An edge that the disc may meet, as a half-edge of the face from which the search saw it.
  struct Edge {
    double earliest;  ///< the centre has moved at least this far when the disc meets the edge
    mesh::HalfEdge h;
  };
  /// A side that the disc touches first, among the sides that the search has seen; and how it touches this side.
  struct TouchedSide {
    exact::Touch touch;
    std::uint32_t item;
  };

  void find_first_sides(const ConstrainedTriangulation& triangulation, const exact::Sweep& sweep);
  bool add_sides(const ConstrainedTriangulation& triangulation, const exact::Sweep& sweep, mesh::HalfEdge h);
  [[nodiscard]] Point contact(const exact::Sweep& sweep, const Point& centre) const;

  std::vector<Edge> edges_;  ///< a heap: the earliest edge is at the front
  std::vector<TouchedSide> first_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by face: the number of the last query that visited it
  memory::Stamp stamp_;
};

}  // namespace waywright::constraint

#pragma once

#include <cstdint>
#include <vector>

#include "waywright/ray.hpp"

#include "constraint/exact_triangulation.hpp"
#include "exact/sweep.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::constraint {

/// Finds the first wall that a moving disc touches. Use one object for many queries, because it keeps its memory.
class SweptDisc {
 public:
  /// Requires: both ends of the sweep lie in the domain, and its radius is finite and positive. Cost: n log n in the
  /// number n of faces that a disc 1.07 times as large meets before the disc touches a wall.
  void find_first_wall(const ExactTriangulation& triangulation, const exact::Sweep& sweep, RayHit& hit);

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

  void find_first_sides(const ExactTriangulation& triangulation, const exact::Sweep& sweep);
  bool add_sides(const ExactTriangulation& triangulation, const exact::Sweep& sweep, mesh::HalfEdge h);
  [[nodiscard]] Point contact(const exact::Sweep& sweep, const Point& centre) const;

  std::vector<Edge> edges_;  ///< a heap: the earliest edge is at the front
  std::vector<TouchedSide> first_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by face: the number of the last query that visited it
  memory::Stamp stamp_;
};

}  // namespace waywright::constraint

#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "clearance/cells.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// Finds the walls near a position. Use one object for many queries, because it keeps its memory.
class NearWalls {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Returns whether no wall is nearer to `point` than `radius`. Requires: the point lies in the domain, and the radius
  /// is finite and positive. Cost: the number of faces within the radius.
  [[nodiscard]] bool has_no_nearer_wall(const Triangulation& triangulation, const Point& point, double radius);
  /// Appends to `items` the items, by slot, that have a side nearer to `point` than `radius`. An item may be listed
  /// several times. The domain has the slot 0.
  void find_items(const Triangulation& triangulation, const Point& point, double radius,
                  std::vector<std::uint32_t>& items);

  /// Returns an edge of the cell that contains the point, or nothing if the point lies on a wall. A point on a bridge
  /// belongs to two cells; the result is one of them. Requires: the point lies in the domain, and each vertex of the
  /// mesh is the end of a wall.
  [[nodiscard]] std::optional<CellEdge> find_cell(const Triangulation& triangulation, const Bridges& bridges,
                                                  const Point& point);

 private:
  /// A wall that may be the nearest one, as a half-edge of the face from which the search saw it.
  struct Candidate {
    mesh::HalfEdge wall;
    double least;  ///< the wall is not nearer than this
  };

  template <class Enters, class Visit>
  void flood(const Triangulation& triangulation, const Point& point, Enters&& enters, Visit&& visit);
  void find_candidates(const Triangulation& triangulation, const Point& point);
  [[nodiscard]] std::optional<CellEdge> find_cell_at(const Triangulation& triangulation, const Bridges& bridges,
                                                     const Point& point, mesh::HalfEdge wall) const;
  [[nodiscard]] static CellEdge cell_at_vertex(const Triangulation& triangulation, const Bridges& bridges,
                                               const Point& point, mesh::Vertex v);
  [[nodiscard]] static CellEdge cell_at_wall(const Triangulation& triangulation, const Bridges& bridges,
                                             const Point& point, mesh::HalfEdge wall);

  std::vector<mesh::HalfEdge> to_enter_;
  std::vector<Candidate> candidates_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by face: the number of the last query that visited it
  memory::Stamp stamp_;
};

}  // namespace waywright::clearance

#pragma once

#include <vector>

#include "clearance/cells.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::path {

/// The input of a search for the path of a disc: the walls of a world, their bridges, and the radius of the disc.
struct DiscMap {
  const constraint::ExactTriangulation& walls;
  clearance::Cells cells;
  double radius;
  Point origin;  ///< all positions of a search are relative to this point, so that they are precise far from (0, 0)
};

/// The border of one cell, with positions in doubles. The first edge is the argument of load().
class CellView {
 public:
  struct Edge {
    clearance::CellEdge edge;
    Point from;                ///< where it starts
    mesh::Vertex vertex;       ///< the vertex there, or kNoVertex at a foot
    bool is_passable = false;  ///< whether it is a gate through which the disc fits: decided exactly
  };

  /// Reads the border of the cell of `first`. Reuses the memory of the previous cell.
  void load(const DiscMap& map, const clearance::CellEdge& first);

  [[nodiscard]] std::size_t size() const { return edges_.size(); }
  [[nodiscard]] const Edge& operator[](std::size_t i) const { return edges_[i]; }
  [[nodiscard]] const Point& from(std::size_t i) const { return edges_[i].from; }
  [[nodiscard]] const Point& to(std::size_t i) const { return edges_[i + 1 == edges_.size() ? 0 : i + 1].from; }

 private:
  std::vector<Edge> edges_;
};

}  // namespace waywright::path

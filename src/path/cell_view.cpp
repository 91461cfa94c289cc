#include "path/cell_view.hpp"

#include "exact/gap.hpp"

namespace waywright::path {

using clearance::CellEdge;

void CellView::load(const DiscMap& map, const CellEdge& first) {
  const exact::Geometry& geometry = map.walls.triangulation().geometry();
  edges_.clear();
  CellEdge edge = first;
  do {
    const mesh::Vertex v = map.cells.origin(edge);
    const Point from = v != mesh::kNoVertex ? geometry.rounded(number(v)) : map.cells.position_of_foot(edge.foot);
    const bool is_passable = edge.is_gate() && exact::compare_to_diameter(map.cells.gap(edge), map.radius) >= 0;
    edges_.push_back({edge, from - map.origin, v, is_passable});
    edge = map.cells.next(edge);
  } while (edge != first);
}

}  // namespace waywright::path

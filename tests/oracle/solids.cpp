#include "oracle/solids.hpp"

namespace waywright::oracle {

std::vector<Solid> solids_of(const OracleScene& scene, const Grid& grid) {
  std::vector<Solid> solids;
  for (const OracleItem& item : scene.items) {
    if (item.kind != OracleKind::polygon) continue;
    Solid& solid = solids.emplace_back();
    solid.id = item.id;
    solid.is_nonzero = item.is_nonzero;
    for (const auto& ring : item.rings) {
      auto& exact_ring = solid.rings.emplace_back();
      for (const OraclePoint& p : ring) exact_ring.push_back(grid.point(p));
    }
  }
  return solids;
}

namespace {

// Above its inside, a counter-clockwise ring runs towards smaller x; to the right of its inside, it runs towards larger
// y. No ray next to a side that is parallel to the ray crosses that side, so for such a side any result is correct.
int turn_of(const ExactPosition& p, const ExactPosition& q, bool across_x) {
  const int direction = across_x ? compare_y(q, p) : compare_x(p, q);
  return direction > 0 ? 1 : direction < 0 ? -1 : 0;
}

}  // namespace

// Computes the winding number along a ray from the position upwards (or to the right). A side counts if one of its ends
// lies beyond the ray's line and the other does not. An end on the line does not lie beyond it, so a ray through a
// corner counts correctly. A side through the position itself does not cross the ray that starts just after the
// position; it crosses the ray that starts just before.
RingRelation relation_to_rings(const Solid& solid, const ExactPosition& position, bool across_x) {
  RingRelation relation;
  int winding_ahead = 0;
  int winding_here = 0;
  for (const auto& ring : solid.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ExactPosition& p = ring[i];
      const ExactPosition& q = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (on_segment(p, q, position)) {
        relation.on_boundary = true;
        winding_here += turn_of(p, q, across_x);
        continue;
      }
      const bool p_beyond = across_x ? compare_y(p, position) > 0 : compare_x(p, position) > 0;
      const bool q_beyond = across_x ? compare_y(q, position) > 0 : compare_x(q, position) > 0;
      if (p_beyond == q_beyond) continue;
      const int turn = q_beyond ? orientation(p, q, position) : orientation(q, p, position);
      if (across_x ? turn > 0 : turn < 0) winding_ahead += turn_of(p, q, across_x);
    }
  }
  const auto is_inside = [&](int winding) { return solid.is_nonzero ? winding != 0 : winding % 2 != 0; };
  relation.inside_after = is_inside(winding_ahead);
  relation.inside_before = is_inside(winding_ahead + winding_here);
  return relation;
}

}  // namespace waywright::oracle

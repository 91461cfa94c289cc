#include "oracle/cover.hpp"

namespace waywright::oracle {

std::vector<Solid> solids_of(const OracleScene& scene, const Grid& grid) {
  std::vector<Solid> solids;
  for (const OracleItem& item : scene.items) {
    if (item.kind != OracleKind::polygon) continue;
    Solid& solid = solids.emplace_back();
    solid.id = item.id;
    for (const auto& ring : item.rings) {
      auto& exact_ring = solid.rings.emplace_back();
      for (const OraclePoint& p : ring) exact_ring.push_back(grid.point(p));
    }
  }
  return solids;
}

// Parity along a ray from the place up (or right). A side counts if its ends part at the ray's line; an end on the line
// belongs to the lesser side, so a ray through a corner counts right. Sides through the place itself lie behind the
// ray's start as seen from one side, and are crossed as seen from the other.
Cover cover_of(const Solid& solid, const ExactPoint& place, bool across_x) {
  Cover cover;
  bool odd_ahead = false;
  bool odd_here = false;
  for (const auto& ring : solid.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ExactPoint& p = ring[i];
      const ExactPoint& q = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (on_segment(p, q, place)) {
        cover.on_boundary = true;
        if (compare_xy(p, q) != 0) odd_here = !odd_here;
        continue;
      }
      const bool p_beyond = across_x ? compare_y(p, place) > 0 : compare_x(p, place) > 0;
      const bool q_beyond = across_x ? compare_y(q, place) > 0 : compare_x(q, place) > 0;
      if (p_beyond == q_beyond) continue;
      const int turn = q_beyond ? orientation(p, q, place) : orientation(q, p, place);
      if (across_x ? turn > 0 : turn < 0) odd_ahead = !odd_ahead;
    }
  }
  cover.inside_after = odd_ahead;
  cover.inside_before = odd_ahead != odd_here;
  return cover;
}

}  // namespace waywright::oracle

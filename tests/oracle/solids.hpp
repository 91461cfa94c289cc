#pragma once

#include <cstdint>
#include <vector>

#include "oracle/exact.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// The exact rings of a polygon.
struct Solid {
  std::uint64_t id = 0;
  std::vector<std::vector<ExactPosition>> rings;
  bool is_nonzero = false;  ///< whether the fill rule is nonzero, not even-odd
};

/// Returns the polygons of a scene.
[[nodiscard]] std::vector<Solid> solids_of(const OracleScene& scene, const Grid& grid);

/// The relation of a position to the rings of a polygon.
struct RingRelation {
  bool on_boundary = false;    ///< on a side or corner
  bool inside_after = false;   ///< inside just after the position: towards larger y, or towards larger x if `across_x`
  bool inside_before = false;  ///< inside just before the position
};

/// Returns the relation of `position` to the polygon. `inside_after` and `inside_before` are correct if the position is
/// not a corner and all sides through it lie on one line. If the position is not on the boundary, both are equal. With
/// `across_x`, they describe the left and the right instead of below and above.
[[nodiscard]] RingRelation relation_to_rings(const Solid& solid, const ExactPosition& position, bool across_x = false);

}  // namespace waywright::oracle

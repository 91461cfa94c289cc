#pragma once

#include <cstdint>
#include <vector>

#include "oracle/exact.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// A polygon's rings, exact.
struct Solid {
  std::uint64_t id = 0;
  std::vector<std::vector<ExactPoint>> rings;
  bool is_nonzero = false;  ///< by the fill rule nonzero, not even-odd
};

/// The polygons of a scene.
[[nodiscard]] std::vector<Solid> solids_of(const OracleScene& scene, const Grid& grid);

/// How a place lies to the rings of a polygon.
struct Cover {
  bool on_boundary = false;   ///< on a side or corner
  bool inside_after = false;  ///< by the fill rule, just beside the place: towards larger y, or larger x where so asked
  bool inside_before = false;  ///< the same on the other side
};

/// Away from corners, and with all sides through the place on one line, the answers for the two sides of that line are
/// right; off the boundary they agree. `across_x` asks for the sides to the left and right instead of those below and
/// above.
[[nodiscard]] Cover cover_of(const Solid& solid, const ExactPoint& place, bool across_x = false);

}  // namespace waywright::oracle

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// A copy of a world's mesh, in the canonical order of the dump: vertices by (x, y), triangles counter-clockwise from
/// their smallest index and sorted, edges smaller index first and sorted, ids ascending.
struct MeshSnapshot {
  /// An edge that items have a side on.
  struct ConstrainedEdge {
    std::array<std::uint32_t, 2> vertices{};  ///< by position in `vertices`, the smaller first
    std::uint32_t first_id = 0;               ///< where its ids start in `ids`
    std::uint32_t id_count = 0;
  };

  std::vector<Point> vertices;                          ///< nearest doubles
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< by position in `vertices`
  std::vector<ConstrainedEdge> constraints;
  std::vector<ItemId> ids;  ///< the ids of all constrained edges, one edge after the other; 0 is the domain
};

}  // namespace waywright

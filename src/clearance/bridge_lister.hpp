#pragma once

#include <cstdint>
#include <vector>

#include "waywright/bridges.hpp"

#include "clearance/bridges.hpp"
#include "clearance/cells.hpp"
#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::clearance {

/// Lists bridges for a program. The list depends only on the positions of the walls. Use one object for many queries,
/// because it keeps its memory.
class BridgeLister {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Lists the bridges that have a position in common with the closed box, without those in the interior of polygons.
  /// Requires: `bridges` belongs to the triangulation. Cost: linear in the mesh, and n log n in the list.
  void list(const Triangulation& triangulation, const Bridges& bridges, const Box& box, BridgeList& result);

 private:
  enum class Side : std::uint8_t { unknown, open, covered };

  /// A bridge of the list.
  struct Listed {
    CellEdge gate;
    exact::Gap gap;
    Point to;
  };

  void mark_faces(const Triangulation& triangulation);
  void mark_around(const Triangulation& triangulation, mesh::Face first);
  [[nodiscard]] static Bridge append_items(const Triangulation& triangulation, const Bridges& bridges,
                                           const Listed& listed, std::vector<ItemId>& ids);

  constraint::Cover cover_;
  std::vector<Side> sides_;  ///< by face
  std::vector<mesh::Face> faces_;
  std::vector<Listed> listed_;
};

}  // namespace waywright::clearance

#pragma once

#include <cstdint>
#include <vector>

#include "clearance/bridges.hpp"
#include "clearance/near_walls.hpp"
#include "clearance/widest.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::clearance {

/// The radius of the largest disc that can move from one position to another, and the gap that stops every larger disc.
struct WidestGap {
  bool is_connected = false;  ///< whether a disc of some radius above 0 can move from one to the other
  bool is_limited = false;    ///< whether a gap limits the disc; if not, all of the following is empty
  double radius = 0.0;        ///< half the length of the gap, rounded down
  Point from;                 ///< the vertex at which the gap starts
  Point to;                   ///< where the gap ends: a vertex, or the rounded foot on a wall
  /// The items with a side at `from`, and at `to`, by slot. An item may be listed several times. The domain has the
  /// slot 0.
  std::vector<std::uint32_t> from_items;
  std::vector<std::uint32_t> to_items;

  /// Makes the gap of two positions that are not connected. Keeps the memory of the lists.
  void clear() {
    is_connected = is_limited = false;
    radius = 0.0;
    from = to = {};
    from_items.clear();
    to_items.clear();
  }
};

/// Finds the widest gap between two positions. The answer depends only on the positions of the walls. Use one object
/// for many queries, because it keeps its memory.
class WidestGapFinder {
 public:
  /// Requires: `bridges` belongs to the triangulation, and both points lie in its domain. A position on a wall is
  /// connected with no other.
  void find(const constraint::ExactTriangulation& triangulation, const Bridges& bridges, NearWalls& near_walls,
            const Point& start, const Point& goal, WidestGap& result);

 private:
  WidestSearch search_;
};

/// Writes the answer of a search as a gap.
void write_gap(const constraint::ExactTriangulation& triangulation, const Bridges& bridges, const Narrowest& narrowest,
               WidestGap& result);

}  // namespace waywright::clearance

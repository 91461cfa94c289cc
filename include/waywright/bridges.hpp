#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// A bridge: the straight connection between two walls at the gap between them. The closed disc whose diameter
/// is the bridge touches walls only at the two ends of the bridge. A disc that passes between the two walls
/// crosses the bridge, so the bridges decide which discs can move from one position to another. World::bridges returns
/// bridges in a BridgeList.
///
/// A bridge starts at a corner of an item, or of the domain. It ends at another corner, or at a *foot*: a position
/// strictly inside a wall, where the bridge meets the wall at a right angle.
struct Bridge {
  /// The corner at which the bridge starts. If the bridge ends at a corner, too, `from` is the first of the two in
  /// (x, y) order.
  Point from;
  Point to;  ///< where the bridge ends: a corner, or the foot, rounded
  /// The largest radius of a disc that passes: half the length of the bridge, rounded down. A disc with the next larger
  /// double as its radius does not pass.
  double radius = 0.0;
  bool has_foot = false;         ///< whether the bridge ends at a foot
  std::uint32_t first_id = 0;    ///< the index of the bridge's first id in BridgeList::ids
  std::uint32_t from_count = 0;  ///< the number of items with a side at `from`
  std::uint32_t to_count = 0;    ///< the number of items with a side at `to`

  friend bool operator==(const Bridge&, const Bridge&) = default;
};

/// The answer of World::bridges: the bridges in a box. If you reuse one object for many queries, it keeps its memory.
///
/// The bridges are sorted by `from`, then by `to`, both in (x, y) order. The list depends only on the domain and the
/// live items. It does not contain the bridges in the interior of polygons, because no disc can move there.
///
/// @code{.cpp}
/// World door = World::create({{0, 0}, {20, 10}}, {.keep_bridges = true}).value();
/// door.insert_segment({10, 0}, {10, 4}, 1).value();
/// door.insert_segment({10, 7}, {10, 10}, 2).value();
/// const BridgeList narrow = door.bridges({{9, 5}, {11, 6}}).value();
/// const Bridge bridge = narrow.bridges.front();               // == Bridge{{10, 4}, {10, 7}, 1.5, false, 0, 1, 1}
/// const ItemId lower = narrow.from_items(bridge).front();     // == 1
/// const ItemId upper = narrow.to_items(bridge).front();       // == 2
/// @endcode
///
/// Source: the bridges are the Gabriel edges (Gabriel and Sokal 1969) of the walls.
struct BridgeList {
  std::vector<Bridge> bridges;
  /// The items at the ends of all bridges, bridge after bridge: first the items with a side at Bridge::from, then the
  /// items with a side at Bridge::to, each ascending. The null id stands for the domain's border.
  std::vector<ItemId> ids;

  /// Returns the items with a side at Bridge::from. Requires: the bridge is in this list.
  [[nodiscard]] std::span<const ItemId> from_items(const Bridge& bridge) const {
    return std::span(ids).subspan(bridge.first_id, bridge.from_count);
  }
  /// Returns the items with a side at Bridge::to. Requires: the bridge is in this list.
  [[nodiscard]] std::span<const ItemId> to_items(const Bridge& bridge) const {
    return std::span(ids).subspan(bridge.first_id + bridge.from_count, bridge.to_count);
  }

  friend bool operator==(const BridgeList&, const BridgeList&) = default;
};

/// @}

}  // namespace waywright

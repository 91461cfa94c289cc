#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "waywright/agent.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The answer of World::fit_disc: whether a disc fits at a position. If you reuse one object for many queries, it keeps
/// its memory.
///
/// @code{.cpp}
/// const DiscFit fit = world.fit_disc({30, 50}, {.radius = 12}).value();  // the house begins at x = 40
/// const bool has_room = fit.fits;          // == false
/// const ItemId first = fit.items.front();  // == 1
/// @endcode
struct DiscFit {
  bool fits = false;  ///< whether no item and no border of the domain stops the disc
  /// The items that stop the disc, ascending: the items with a side that is nearer to the centre than the radius, and
  /// the polygons whose interior contains the centre. The null id is the domain's border.
  std::vector<ItemId> items;

  friend bool operator==(const DiscFit&, const DiscFit&) = default;
};

/// A query for World::nearest_fit: among all positions where a disc fits, which one is the nearest to a point?
///
/// @code{.cpp}
/// const NearestFit nearest = world.nearest_fit({.point = {45, 50}, .agent = {.radius = 5}, .limit = 20}).value();
/// const Point at = nearest.at;  // == Point{35, 50}
/// @endcode
struct NearestFitQuery {
  Point point;
  /// The disc. With the radius 0, the answer is the position that a path query would take instead of a blocked end: the
  /// nearest position in or on the border of a triangle that no polygon covers.
  Agent agent{};
  /// The goal: the point to which the disc must be able to move from the answer. If it is not set, every position at
  /// which the disc fits can be the answer. If the disc does not fit at the goal, there is no answer.
  std::optional<Point> goal{};
  /// The largest distance of the answer from `point`, 0 or more.
  double limit = std::numeric_limits<double>::infinity();
};

/// The answer of World::nearest_fit.
///
/// @code{.cpp}
/// const NearestFit nearest = world.nearest_fit({.point = {45, 50}, .agent = {.radius = 5}}).value();
/// if (nearest.is_found) std::printf("%s, %g away\n", to_string(nearest.at).c_str(), nearest.distance);
/// @endcode
///
/// If the disc fits at the point of the query and, if the query has a goal, can move from there to the goal, this point
/// is the answer. There is one exception: if the radius is 0 and polygons cover all triangles around the point, it is
/// not the answer (see NearestFitQuery::agent), even if the point lies on the boundaries of these polygons.
///
/// The coordinates of the answer are doubles, so the answer can lie a little farther away than the nearest position at
/// which the disc fits. The distance exceeds the smallest possible one by at most the larger of two numbers: 1e-9 times
/// the distance, and the rounding error of the coordinates. There is one exception: near a position where the disc
/// touches both walls of a narrow angle, there may be few points with double coordinates at which it fits. There the
/// answer can lie up to about a millionth of the radius farther away than the nearest of these points. If the disc fits
/// only at a single position, or only along a line between two walls, there is an answer only if doubles can express a
/// position there. Of several equally near points that the search finds, the first in (x, y) order is the answer.
/// (If the point of the query lies at a vertex, all positions of an arc around this vertex are equally near. The search
/// finds one of them, and rounding errors decide which one it is.)
struct NearestFit {
  /// Whether there is an answer: a point within the limit where the disc fits and, if the query has a goal, from which
  /// the disc can move to the goal. If the member is false, all other members are zero.
  bool is_found = false;
  Point at;               ///< a point where the disc fits, as World::fit_disc decides exactly
  double distance = 0.0;  ///< the distance from the query's point to `at`

  friend bool operator==(const NearestFit&, const NearestFit&) = default;
};

/// The answer of World::widest_path: the radius of the largest disc that can move from a start to a goal, and the gap
/// that stops every larger disc. If you reuse one object for many queries, it keeps its memory.
///
/// @code{.cpp}
/// World rooms = World::create({{0, 0}, {20, 10}}, {.keep_bridges = true}).value();
/// rooms.insert_segment({10, 0}, {10, 4}, 1).value();
/// rooms.insert_segment({10, 7}, {10, 10}, 2).value();
/// const WidestPath widest = rooms.widest_path({5, 5}, {15, 5}).value();
/// const double radius = widest.radius;           // == 1.5
/// const Point from = widest.from;                // == Point{10, 4}
/// const ItemId above = widest.to_items.front();  // == 2
/// @endcode
///
/// Source: Pollack, *The maximum capacity through a network*, 1960. The bridges are Gabriel edges (Gabriel and Sokal
/// 1969).
struct WidestPath {
  /// Whether a disc of some radius above 0 can move from the start to the goal. This is impossible, for example, if the
  /// start or the goal lies on a wall or in the interior of a polygon. If the member is false, all other members are
  /// zero or empty.
  bool is_connected = false;
  /// Whether a gap between the ends limits the disc. If not, each disc that fits at both ends can move from one to the
  /// other.
  bool is_limited = false;
  /// The largest radius of a disc that passes all gaps of the widest path: half the length of its narrowest gap,
  /// rounded down. A disc with this radius or a smaller one can move from start to goal if it fits at both. A disc with
  /// the next larger double as its radius cannot. The radius is infinity if the ends are connected and no gap limits
  /// the disc.
  double radius = 0.0;
  Point from;                      ///< the corner of an item, or of the domain, at which the gap starts
  Point to;                        ///< where the gap ends, rounded: another corner, or a position inside a wall
  std::vector<ItemId> from_items;  ///< the items with a side at `from`, ascending; the null id is the domain's border
  std::vector<ItemId> to_items;    ///< the items with a side at `to`, ascending; the null id is the domain's border

  friend bool operator==(const WidestPath&, const WidestPath&) = default;
};

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

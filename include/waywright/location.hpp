#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The kind of a location in the mesh.
enum class LocationKind : std::uint8_t { vertex, edge, face };

/// Returns the name of the kind in the output of world scripts: `vertex`, `edge`, `face`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(LocationKind kind);

/// The answer of World::locate: the vertex, edge or face of the mesh at a point, and the polygons there.
///
/// @code{.cpp}
/// const Location location = world.locate({50, 50}).value();
/// const bool is_in_house = !location.polygons.empty() && location.polygons.front() == 1;  // == true
/// for (std::size_t i = 0; i < location.vertex_count; ++i) std::puts(to_string(location.vertices[i]).c_str());
/// const std::vector<ItemId> clicked = world.items_at({50, 50}).value();
/// const ItemId house_there = clicked.front();                                   // == 1
/// const std::size_t count = world.items_in({start, goal}).value().size();       // == 1
/// @endcode
struct Location {
  LocationKind kind = LocationKind::face;
  /// The vertices of the location, each coordinate rounded to the nearest double: 1 vertex, the 2 ends of an edge, or
  /// the 3 vertices of a face, counter-clockwise. The first vertex of an edge or a face in this array is the vertex
  /// that comes first in (x, y) order.
  std::array<Point, 3> vertices{};
  std::size_t vertex_count = 0;  ///< the number of vertices in `vertices`
  /// The polygons that contain the point in their interior or on their boundary, ascending.
  std::vector<ItemId> polygons;
};

/// The answer of World::ray: the first wall that a segment or a moving disc touches. If you reuse one object for many
/// queries, it keeps its memory.
///
/// @code{.cpp}
/// const RayHit hit = world.ray({10, 50}, {90, 50}).value();
/// if (hit.hit) std::printf("a wall at (%g, %g)\n", hit.at.x, hit.at.y);
/// const ItemId wall = hit.items.front();                       // == 1
/// const bool sees_goal = !world.ray(start, goal).value().hit;  // == false
/// const RayHit disc_hit = world.ray({10, 50}, {90, 50}, {.radius = 5}).value();
/// const Point centre = disc_hit.at;         // == Point{35, 50}
/// const Point contact = disc_hit.contact;   // == Point{40, 50}
/// @endcode
///
/// A disc touches a wall if the wall is not farther from its centre than the radius. So if a disc touches a wall before
/// it moves, the hit is at the start, whatever the direction of the motion. Items of the kind point are not walls. To
/// slide a disc along a wall, continue at right angles to the direction from `contact` to `at`. If `hit` is false,
/// `items` is empty, and the points have no meaning.
struct RayHit {
  bool hit = false;  ///< whether the segment or the disc touches a wall
  /// The first position where the segment touches a wall, rounded to the nearest doubles. For a disc: the position of
  /// its centre when it first touches a wall. Let m be the larger magnitude of the x coordinate at the two ends of the
  /// motion. The x of the centre's position then differs from the exact x by at most a few times 2^-53 * m. The same is
  /// true for y.
  Point at;
  /// The items that the segment or the disc touches at the hit, ascending. Each has a side through `at` or, for a disc,
  /// a side whose distance from `at` is at most the radius. The null id is the border of the domain.
  std::vector<ItemId> items;
  /// The touched position: of all positions on the touched walls, the one nearest to `at`, up to rounding errors. If
  /// several positions are equally near, it is the first of them in (x, y) order. For a segment, it equals `at`.
  Point contact;

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// @}

}  // namespace waywright

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

/// @}

}  // namespace waywright

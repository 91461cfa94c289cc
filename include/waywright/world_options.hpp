#pragma once

#include <cstddef>
#include <limits>

namespace waywright {

/// @addtogroup world
/// @{

/// The value of WorldOptions::new_vertex_limit that means "no limit".
inline constexpr std::size_t kNoVertexLimit = std::numeric_limits<std::size_t>::max();

/// The options of World::create.
///
/// @code{.cpp}
/// World mesh_only = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = false}).value();
/// @endcode
struct WorldOptions {
  /// Whether the world maintains the path abstraction: data that says which triangles are connected, which polygons
  /// cover them, and which triangles lie in dead ends. Without the abstraction, an operation costs less, and a world
  /// takes 10 bytes less for each vertex (up to 18 bytes less if walls change everywhere). But then many path queries
  /// enter far more triangles, and the world does not support PathAlgorithm::tra.
  bool keep_abstraction = true;
  /// Whether the world maintains the bridges of its walls: the shortest connections between two walls at each gap. They
  /// say how wide the gaps are, for discs of any radius. World::widest_path and path queries with a radius above 0 need
  /// them. An operation then takes two to four times as long, because it also updates the bridges near its changes. A
  /// world takes about 60 bytes more for each vertex. If an item is a point or has a ring with only one corner, the
  /// world keeps a second mesh, of the walls alone, and each operation changes both meshes.
  bool keep_bridges = false;
  /// The largest number of vertices that one operation may make: World::set_new_vertex_limit.
  std::size_t new_vertex_limit = kNoVertexLimit;
};

/// @}

}  // namespace waywright

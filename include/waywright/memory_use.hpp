#pragma once

#include <cstddef>

namespace waywright {

/// @addtogroup world
/// @{

/// The memory of a world in bytes, by purpose. World::memory returns it.
///
/// @code{.cpp}
/// const MemoryUse use = world.memory();
/// std::printf("%zu bytes, of which %zu are spare\n", use.total(), use.spare);
/// world.shrink_to_fit();
/// const bool is_smaller = world.memory().total() <= use.total();  // == true
/// @endcode
///
/// The numbers do not include the overhead of the allocator. They do not include the context of the world, either: the
/// world makes this context at the first query that needs one and gets none, and keeps it. Like every QueryContext, it
/// takes 4 to 16 bytes per triangle for each path algorithm that has used it. Path queries with a radius above 0 add up
/// to 100 bytes per triangle, all algorithms together. Nor do the numbers include the snapshots that readers hold
/// (WorldSnapshot).
///
/// World::shrink_to_fit() does not free the slots of removed items, which later items will use. So if you have removed
/// most items and want a smaller world, make a new world and insert the World::items() of the old world.
struct MemoryUse {
  std::size_t vertices = 0;     ///< for each vertex: its point, a half-edge from it, the items with a corner there
  std::size_t crossings = 0;    ///< for constructed vertices: the lines that cross there
  std::size_t faces = 0;        ///< for each face: its vertices and neighbours
  std::size_t walls = 0;        ///< for each constrained edge: the list of the sides that lie on it
  std::size_t items = 0;        ///< ids, kinds and sides of the items
  std::size_t sectors = 0;      ///< for point location: the vertices from which walks start
  std::size_t abstraction = 0;  ///< the path abstraction: see WorldOptions::keep_abstraction
  std::size_t bridges = 0;      ///< the bridges: see WorldOptions::keep_bridges
  std::size_t history = 0;      ///< the ticks for World::rewind and World::publish
  /// Unused capacity of arrays; the undo logs, records of changes and scratch that operations keep; and replicas of the
  /// world for later snapshots.
  std::size_t spare = 0;

  /// Returns the sum of all members.
  [[nodiscard]] std::size_t total() const {
    return vertices + crossings + faces + walls + items + sectors + abstraction + bridges + history + spare;
  }
  friend bool operator==(const MemoryUse&, const MemoryUse&) = default;
};

/// @}

}  // namespace waywright

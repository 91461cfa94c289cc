#pragma once

#include "waywright/world.hpp"

#include "world/world_impl.hpp"

namespace waywright {

/// Gives tests access to the data of a world.
struct WorldInternals {
  /// Sets the largest number of vertices of a world. A world with 350 million vertices is too large for a test.
  static void set_most_vertices(World& world, std::size_t count) { world.impl_->limits.of_triangulation = count; }
};

}  // namespace waywright

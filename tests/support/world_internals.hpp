#pragma once

#include <cstddef>
#include <memory>

#include "waywright/world.hpp"

#include "world/snapshot_pool.hpp"
#include "world/world_impl.hpp"

namespace waywright {

/// Gives tests access to the data of a world.
struct WorldInternals {
  /// Sets the largest number of vertices of a world. A world with 350 million vertices is too large for a test.
  static void set_most_vertices(World& world, std::size_t count) { world.impl_->limits.of_triangulation = count; }
  /// Lets all new replicas of the world share pages, if the system can do this.
  static void share_pages(World& world) {
    std::unique_ptr<SnapshotPool>& snapshots = world.impl_->snapshots;
    if (!snapshots) snapshots = std::make_unique<SnapshotPool>(world.version());
    snapshots->share_always();
  }
  /// Returns how many replicas that share pages the world has made.
  static std::size_t sharing_replicas(const World& world) {
    return world.impl_->snapshots ? world.impl_->snapshots->sharing_count() : 0;
  }
};

}  // namespace waywright

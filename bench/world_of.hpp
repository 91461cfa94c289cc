#pragma once

#include <array>
#include <cstddef>

#include "waywright/world.hpp"

#include "workloads.hpp"

namespace waywright::bench {

/// The counts of squares in the worlds of the path benchmarks.
inline constexpr std::array<std::size_t, 3> kPathSquares = {100, 500, 2000};

/// Returns the world after all insertions of a workload without removals.
[[nodiscard]] inline World world_of(const Workload& workload, const WorldOptions& options = {}) {
  World world = World::create(workload.domain, options).value();
  for (const Item& item : workload.before) static_cast<void>(world.insert(item.shape, item.id).value());
  for (const Update& update : workload.updates) {
    static_cast<void>(world.insert(update.inserted.shape, update.inserted.id).value());
  }
  return world;
}

}  // namespace waywright::bench

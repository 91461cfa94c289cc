#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"
#include "mesh/index.hpp"
#include "nav/abstraction.hpp"

namespace waywright {

/// Prefetches the memory that a replica needs when it repeats changes of its world. In a large world, a change at a
/// random place spends most of its time waiting for memory, one address after the other. This class knows all items
/// before the first change. So it looks at all of them in turn, one step each, and the processor fetches the memory for
/// the next steps at the same time. It changes nothing, and answers do not depend on it.
class ReplicaPrefetch {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// The largest number of items for one call of run(): the cache has room for the surroundings of this many items.
  static constexpr std::size_t kItems = 16;

  /// Prefetches what the replica needs to remove its items with these ids, and to insert the items with these ids of
  /// the world. `abstraction` is the abstraction of the replica, or null.
  void run(const Triangulation& replica, const Triangulation& world, const nav::Abstraction* abstraction,
           std::span<const ItemId> ids);

  void count_memory(MemoryUse& use) const { memory::count_spare(use, corners_, new_corners_, starts_, spokes_); }

 private:
  void find_corners(const Triangulation& replica, const Triangulation& world, std::span<const ItemId> ids);
  void advance_spokes(const Triangulation& replica, const nav::Abstraction* abstraction);

  /// The spoke at which the prefetch around a corner has arrived.
  struct Spoke {
    mesh::HalfEdge h;
    mesh::HalfEdge first;  ///< the spoke at which it started
    mesh::Face before;     ///< the face of the spoke before `h`
  };

  std::vector<mesh::Vertex> corners_;      ///< the corners of the old shapes, as vertices of the replica
  std::vector<mesh::Vertex> new_corners_;  ///< the corners of the new shapes, as vertices of the world
  std::vector<mesh::Vertex> starts_;       ///< the vertices of the replica at which the walks to the new corners start
  std::vector<Spoke> spokes_;              ///< a spoke for each vertex of `corners_`
};

}  // namespace waywright

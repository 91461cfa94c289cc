#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "waywright/world.hpp"

#include "support/live_items.hpp"

namespace waywright::test {

/// Makes the changes of a step one after the other. A replacement is a removal and an insertion. Returns how many
/// vertices the insertions have made. Requires: the world accepts each change.
[[nodiscard]] inline std::size_t count_new_vertices(World& world, const Step& step) {
  std::size_t count = 0;
  for (const Change& change : step.changes) {
    if (change.kind != Change::Kind::insert) world.remove(change.id).value();
    const std::size_t before = world.vertex_count();
    if (change.kind != Change::Kind::remove) world.insert(change.shape, change.id).value();
    if (change.kind != Change::Kind::remove) count += world.vertex_count() - before;
  }
  return count;
}

/// What a refused operation must not change.
struct WorldState {
  explicit WorldState(const World& world)
      : items(world.items_hash()), dump(world.dump()), version(world.version()), limit(world.new_vertex_limit()) {}

  friend bool operator==(const WorldState&, const WorldState&) = default;

  ItemsHash items;
  std::string dump;
  std::uint64_t version;
  std::size_t limit;
};

}  // namespace waywright::test

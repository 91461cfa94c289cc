#pragma once

#include <cstddef>

namespace waywright {

/// Where a world's memory is, in bytes.
struct MemoryUse {
  std::size_t vertices = 0;     ///< where each is, a half-edge from it, the items with a corner there
  std::size_t crossings = 0;    ///< the walls whose crossing a constructed vertex is
  std::size_t faces = 0;        ///< their corners and neighbours
  std::size_t walls = 0;        ///< which sides lie on a constrained edge
  std::size_t items = 0;        ///< their ids, kinds and sides
  std::size_t sectors = 0;      ///< where walks start
  std::size_t abstraction = 0;  ///< what searches for paths live on: see WorldOptions
  std::size_t spare = 0;        ///< room to grow, and what operations keep from one to the next: logs and scratch

  [[nodiscard]] std::size_t total() const {
    return vertices + crossings + faces + walls + items + sectors + abstraction + spare;
  }
  friend bool operator==(const MemoryUse&, const MemoryUse&) = default;
};

}  // namespace waywright

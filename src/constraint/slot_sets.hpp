#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// Sets of items, as lists of their slots. However many polygons lie on one another, making a set of them costs no more
// than sorting them.

namespace waywright::constraint {

/// Sorts the slots and leaves one of each.
inline void keep_one_of_each(std::vector<std::uint32_t>& slots) {
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
}

/// Sorts the slots and leaves one of each that is there an odd number of times.
inline void keep_odd(std::vector<std::uint32_t>& slots) {
  std::sort(slots.begin(), slots.end());
  std::size_t kept = 0;
  for (const std::uint32_t slot : slots) {
    if (kept > 0 && slots[kept - 1] == slot) {
      --kept;
    } else {
      slots[kept++] = slot;
    }
  }
  slots.resize(kept);
}

}  // namespace waywright::constraint

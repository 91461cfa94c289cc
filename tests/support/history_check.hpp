#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "support/random_scenes.hpp"

namespace waywright::test {

/// How many steps of each kind a check has made.
struct HistoryCounts {
  std::size_t steps = 0;
  std::size_t operations = 0;
  std::size_t refusals = 0;  ///< operations that the world must refuse, and has refused
  std::size_t marks = 0;
  std::size_t rewinds = 0;
  std::size_t attempts = 0;
  std::size_t snapshots = 0;
  std::size_t snapshots_of_ticks = 0;
  std::size_t comparisons = 0;  ///< comparisons of a snapshot with the state that it was made from, some time later
  std::size_t sharing_replicas = 0;  ///< replicas that share pages
  std::size_t clones = 0;
  std::size_t saves = 0;

  HistoryCounts& operator+=(const HistoryCounts& other);
};

struct HistoryReport {
  std::string fault;  ///< the first fault, or empty
  HistoryCounts counts;
};

/// Makes `count` random steps with one world: operations, marks, rewinds, attempts, snapshots of the present and of
/// ticks, clones and saves. Readers hold some snapshots for many steps. Compares the world after each step with a
/// model, which keeps all items of each tick: the items, their hash as docs/hashes.md defines it, the next id, and the
/// dump of a new world with these items. Compares each snapshot with the model of its moment or tick, when it is made
/// and before it is released.
[[nodiscard]] HistoryReport check_history(Flavour flavour, std::uint64_t seed, std::size_t count);

}  // namespace waywright::test

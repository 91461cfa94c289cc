#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "support/random_scenes.hpp"

namespace waywright::test {

struct RollbackReport {
  std::string fault;  ///< the first fault, or empty
  std::size_t rollbacks = 0;
  std::size_t changes = 0;  ///< that were made and then taken back
};

/// Plays a game with rollback `count` times: a world makes about 10 predicted changes in each of 8 ticks, goes back to
/// the first of these ticks, and makes other changes. A second world makes only these other changes. Compares the
/// hashes of both worlds at every tick, and their meshes after each rollback.
[[nodiscard]] RollbackReport check_rollbacks(Flavour flavour, std::uint64_t seed, std::size_t count);

}  // namespace waywright::test

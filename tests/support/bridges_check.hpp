#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "support/random_changes.hpp"

namespace waywright::test {

struct BridgesReport {
  std::optional<std::string> fault;  ///< the first fault
  std::size_t changes = 0;
  std::size_t undone = 0;  ///< steps that were made, undone and made again
};

/// Makes the changes of the script, without the steps that a world refuses, in a triangulation with bridges. Checks
/// after every step that the bridges equal the bridges of a rebuild. Undoes some of the steps, checks the bridges, and
/// makes these steps again. The seed determines which steps.
[[nodiscard]] BridgesReport check_bridges(const ChangeScript& script, std::uint64_t seed);

/// Shrinks a script that fails check_bridges. Returns a message with the fault and the script.
[[nodiscard]] std::string report_bridges_failure(const ChangeScript& script, std::uint64_t seed);

}  // namespace waywright::test

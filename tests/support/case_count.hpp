#pragma once

#include <cstdint>
#include <cstdlib>

namespace waywright::test {

/// Returns how many random cases of each kind a property test runs: the environment variable WAYWRIGHT_SCRIPTS, or 100.
[[nodiscard]] inline std::uint64_t case_count() {
  const char* const asked = std::getenv("WAYWRIGHT_SCRIPTS");
  const int count = asked == nullptr ? 0 : std::atoi(asked);
  return count > 0 ? static_cast<std::uint64_t>(count) : 100;
}

}  // namespace waywright::test

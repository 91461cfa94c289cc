#pragma once

#include <cstdint>
#include <cstdlib>

namespace waywright::test {

/// Returns whether only the fast forms of the tests run: `./dev test` sets WAYWRIGHT_QUICK. `./dev check` runs the
/// whole form of each test that calls a function of this file.
[[nodiscard]] inline bool is_quick() { return std::getenv("WAYWRIGHT_QUICK") != nullptr; }

/// Returns how many random cases of each kind a property test runs: the environment variable WAYWRIGHT_SCRIPTS, or 100.
[[nodiscard]] inline std::uint64_t case_count() {
  const char* const asked = std::getenv("WAYWRIGHT_SCRIPTS");
  const int count = asked == nullptr ? 0 : std::atoi(asked);
  return count > 0 ? static_cast<std::uint64_t>(count) : 100;
}

/// Returns how many of its `count` cases a long test runs: all, or in the fast form every `nth`.
template <class Count>
[[nodiscard]] Count case_count(Count count, Count nth = 8) {
  return is_quick() ? (count + nth - 1) / nth : count;
}

}  // namespace waywright::test

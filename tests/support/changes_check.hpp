#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "support/random_changes.hpp"

namespace waywright::test {

/// How often a world is compared, in 1000 steps. It is always compared at the end.
struct Comparisons {
  std::size_t with_rebuild = 30;
  std::size_t with_oracle = 5;
};

/// The counts of a check. They count steps, unless a comment says that they are single changes.
struct ChangeCounts {
  std::size_t steps = 0;
  std::size_t refusals = 0;
  std::size_t batches = 0;
  std::size_t insertions = 0;    ///< changes, in batches or not
  std::size_t removals = 0;      ///< changes
  std::size_t replacements = 0;  ///< changes
  std::size_t validations = 0;
  std::size_t rebuilds = 0;
  std::size_t oracles = 0;

  ChangeCounts& operator+=(const ChangeCounts& other);
};

struct ChangesReport {
  std::optional<std::string> fault;  ///< the first fault
  ChangeCounts counts;
};

/// Runs the script on a world. Checks after every step: the result is the expected one, the items are the expected
/// ones, validate() finds nothing, and a refused step has changed nothing. Checks from time to time and at the end: the
/// dump, both hashes and the snapshot equal those of a new world that gets the live items in another order, and the
/// dump is the one that the oracle expects. The seed determines everything that is random.
/// If it is a multiple of 16, the world keeps its bridges.
[[nodiscard]] ChangesReport check_changes(const ChangeScript& script, std::uint64_t seed,
                                          const Comparisons& comparisons = {});

/// Returns the script without all steps, changes and points that are not needed for it to fail.
[[nodiscard]] ChangeScript shrink(ChangeScript script, const std::function<bool(const ChangeScript&)>& fails);

/// Shrinks a script that fails check_changes and writes it as a world script into the folder for temporary files.
/// Returns a message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const ChangeScript& script, const std::string& name, std::uint64_t seed);

}  // namespace waywright::test

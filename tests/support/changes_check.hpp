#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "support/random_changes.hpp"

namespace waywright::test {

/// How often a world is compared, in steps of 1000 that it makes; it always is at the end.
struct Comparisons {
  std::size_t with_rebuild = 30;
  std::size_t with_oracle = 5;
};

/// What was done and checked, each count in steps, or in single changes where it says so.
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
  std::optional<std::string> fault;  ///< the first
  ChangeCounts counts;
};

/// Makes a world live through the script. After every step: the answer is the expected one, the items are the expected
/// ones, validate() finds nothing, and a refused step has changed nothing. Now and then and at the end: the dump, both
/// hashes and the snapshot are those of a fresh world that gets the live items in another order; the dump is the one
/// that the oracle expects. All that is random follows from the seed.
[[nodiscard]] ChangesReport check_changes(const ChangeScript& script, std::uint64_t seed,
                                          const Comparisons& comparisons = {});

/// The script less all steps, changes and points that it can do without and still fail.
[[nodiscard]] ChangeScript shrink(ChangeScript script, const std::function<bool(const ChangeScript&)>& fails);

/// Shrinks a script that fails check_changes and writes it as a world script into the folder for temporary files.
/// Returns a message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const ChangeScript& script, const std::string& name, std::uint64_t seed);

}  // namespace waywright::test

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/script.hpp"

#include "support/live_items.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {

/// A world's whole life.
struct ChangeScript {
  Box domain;
  std::vector<Step> steps;
};

/// Steps that are the same everywhere for the same arguments. The world fills up to `live_count` items, lives on and
/// empties, again and again. Its items are those of random_scene, and such with a corner dragged to another's; what
/// goes likes to be what touches the last thing changed, and to come back; ids are reused. A few steps must be refused.
[[nodiscard]] ChangeScript random_changes(Flavour flavour, std::uint64_t seed, std::size_t step_count,
                                          std::size_t live_count);

/// The insertions, replacements and removals of a world script; queries are passed over.
[[nodiscard]] ChangeScript changes_of(const Script& script);

/// A world script of the same changes: a batch is its changes one by one.
/// What a world refuses is a comment.
[[nodiscard]] std::string to_script(const ChangeScript& changes);

}  // namespace waywright::test

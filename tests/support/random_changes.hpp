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

/// All changes of a world from start to end.
struct ChangeScript {
  Box domain;
  std::vector<Step> steps;
};

/// Returns random steps that are the same on every platform for the same arguments. The world fills up to `live_count`
/// items, changes for a time and empties, again and again. Its items are those of random_scene, and copies of these
/// with a corner moved to a corner of another item. The steps often remove items that touch the last changed shape,
/// often insert removed shapes again, and reuse ids. A world must refuse a few of the steps.
[[nodiscard]] ChangeScript random_changes(Flavour flavour, std::uint64_t seed, std::size_t step_count,
                                          std::size_t live_count);

/// Returns the insertions, replacements and removals of a world script, without its queries.
[[nodiscard]] ChangeScript changes_of(const Script& script);

/// Returns a world script with the same changes. A batch becomes its single changes. A change that a world refuses
/// becomes a comment.
[[nodiscard]] std::string to_script(const ChangeScript& changes);

}  // namespace waywright::test

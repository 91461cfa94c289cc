#pragma once

#include <limits>

#include "waywright/world.hpp"

namespace waywright::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Box kTen{{0, 0}, {10, 10}};

/// Returns an empty world with bridges. Its domain is 100 wide and high.
inline World world_of_hundred() { return World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value(); }

}  // namespace waywright::test

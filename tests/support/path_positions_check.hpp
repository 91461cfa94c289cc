#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "waywright/path.hpp"

#include "support/random_path_cases.hpp"

namespace waywright::test {

/// The result of checking positions on paths.
struct PathPositionsReport {
  std::optional<std::string> fault;  ///< the first fault
  std::size_t paths = 0;             ///< from which positions were taken
  std::size_t positions = 0;
  std::size_t moved = 0;  ///< positions from which the library moved the start
  double worst = 0.0;     ///< the largest excess of a path's length, divided by the domain's size
};

/// Finds a path for each query of the case by each algorithm, takes `positions_per_path` positions from each path, and
/// searches for a path from each position to the goal. It must exist, and must not be longer than the rest of the first
/// path, except for rounding and for what `ta` and `tra` allow. Path::at gives some of the positions, for doubles and
/// for floats; a program computes the others itself, in double and in float arithmetic. A program may round a position
/// to a position beyond a wall without thickness, where the path is different. So the length of paths from a program's
/// positions is checked only with `has_solids_only`, that is if all walls are sides of polygons.
[[nodiscard]] PathPositionsReport check_path_positions(const PathCase& path_case, std::size_t positions_per_path,
                                                       bool has_solids_only);

}  // namespace waywright::test

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "waywright/path.hpp"

#include "support/random_path_cases.hpp"

namespace waywright::test {

/// What checking the places of paths found.
struct PlacesReport {
  std::optional<std::string> fault;  ///< the first
  std::size_t paths = 0;             ///< that places were taken from
  std::size_t places = 0;
  std::size_t moved = 0;  ///< places from which the library moved the start
  double worst = 0.0;     ///< the largest excess of a path's length, as a share of the domain's size
};

/// Finds a path for each query of the case by each algorithm, takes `places_per_path` places from each, and asks for
/// the way from there to the goal. It must be found, and be no longer than what was left of the path, but for rounding
/// and for what `ta` and `tra` allow for. The places are those that Path::at gives, for doubles and floats, and those
/// that a program computes by itself, in double and in float arithmetic. A place that a program rounds onto the other
/// side of a wall without thickness has a way of its own; so the length of the way from such places is checked only if
/// `has_solids_only`: if all walls are sides of polygons.
[[nodiscard]] PlacesReport check_places(const PathCase& path_case, std::size_t places_per_path, bool has_solids_only);

}  // namespace waywright::test

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "waywright/point.hpp"

namespace waywright::command {

/// A line of a scenario.
struct ScenarioQuery {
  std::uint32_t line = 0;  ///< of the file, from 1
  Point start;
  Point goal;
  double length = 0.0;     ///< as given; negative where there is said to be no path
  double precision = 0.0;  ///< of the given length: half a unit of its last digit
};

/// Reads a scenario of Moving AI, version 1: a header, then `bucket map width height start-x start-y goal-x goal-y
/// length` a line, parted by tabs or blanks. Coordinates may be any numbers. Throws Failure.
[[nodiscard]] std::vector<ScenarioQuery> load_scenario(const std::string& name);

}  // namespace waywright::command

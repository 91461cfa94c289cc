#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// One line of a scenario: a query on a map, and the length that its author found.
struct ScenarioQuery {
  std::uint32_t line = 0;    ///< of the text, from 1
  std::string map;           ///< the map's file name as the line gives it, often with folders
  std::uint64_t width = 0;   ///< of that map, in cells
  std::uint64_t height = 0;  ///< of that map, in cells
  Point start;
  Point goal;
  double length = 0.0;     ///< as given; negative where the author found no path
  double precision = 0.0;  ///< half a unit of the last digit of `length`
};

/// Reads a scenario of Moving AI, version 1, from text: a header `version 1`, then `bucket map width height start-x
/// start-y goal-x goal-y length` a line, separated by tabs or blanks. Coordinates may be any finite numbers. `name` is
/// what messages call the text; they start `NAME:LINE: `. Errors: malformed. Cost: linear.
[[nodiscard]] WAYWRIGHT_API Result<std::vector<ScenarioQuery>> parse_movingai_scenario(std::string_view text,
                                                                                       std::string_view name);

}  // namespace waywright

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup scenes
/// @{

/// One line of a scenario: a path query on a map, and the length of the path that the author of the scenario has found.
struct ScenarioQuery {
  std::uint32_t line = 0;    ///< the line in the text, from 1
  std::string map;           ///< the file name of the map as the line gives it, often with folders
  std::uint64_t width = 0;   ///< the width of the map in tiles
  std::uint64_t height = 0;  ///< the height of the map in tiles
  Point start;
  Point goal;
  double length = 0.0;     ///< the length as the line gives it; negative if the author found no path
  double precision = 0.0;  ///< half a unit of the last digit of `length`
};

/// Reads a scenario of Moving AI, version 1, from text. The text is a header `version 1`, then lines of the form
/// `bucket map width height start-x start-y goal-x goal-y length`, separated by tabs or blanks. The reader
/// ignores the bucket, a number that puts queries of similar lengths into one group. Coordinates may be any finite
/// numbers. Error messages start with `NAME:LINE: `, where NAME is `name`.
///
/// @code{.cpp}
/// const std::string text = "version 1\n0 arena.map 49 49 1 11 1 12 1\n";
/// for (const ScenarioQuery& query : parse_movingai_scenario(text, "arena.map.scen").value()) {
///   std::printf("line %u expects a path of length %g\n", query.line, query.length);
/// }
/// @endcode
/// Errors: malformed.
/// Cost: linear in the length of the text.
[[nodiscard]] WAYWRIGHT_API Result<std::vector<ScenarioQuery>> parse_movingai_scenario(std::string_view text,
                                                                                       std::string_view name);

/// @}

}  // namespace waywright

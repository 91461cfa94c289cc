#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "waywright/point.hpp"

namespace waywright::formats {

/// Checks a ring of GeoJSON or WKT: at least four positions, of which the last one equals the first one. Removes the
/// last position. Throws a Refusal at `offset`. `name` names the ring in its message: `ring 2`.
void open_ring(std::vector<Point>& ring, const std::string& name, std::size_t offset);

/// Throws a Refusal unless a chain has at least two positions. `name` names it in the message: `a LineString`.
void check_line(const std::vector<Point>& line, const std::string& name, std::size_t offset);

/// The end of a message about a position with more than two numbers.
inline constexpr const char* kFlattenHint =
    "; a map has only x and y: remove the heights, for example with 'ogr2ogr -dim XY' or PostGIS' ST_Force2D";

}  // namespace waywright::formats

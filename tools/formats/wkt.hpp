#pragma once

#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

/// Reads geometries in well-known text (OGC 06-103r4): `POINT`, `LINESTRING`, `POLYGON`, their `MULTI` forms and
/// `GEOMETRYCOLLECTION`, each in two dimensions. Blanks, line ends or `;` separate the geometries. A geometry may have
/// the prefix `SRID=N;` of PostGIS, with the same number for all geometries. Each member of a geometry becomes an item;
/// ids count from 1. An `EMPTY` geometry gives no item. Error messages start with `NAME:LINE: `. Errors: malformed,
/// coordinate_range. Cost: linear in the length of the text.
[[nodiscard]] Result<Scene> parse_wkt(std::string_view text, std::string_view name, const ReadProgress& progress = {});

}  // namespace waywright::formats

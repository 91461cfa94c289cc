#pragma once

#include <optional>
#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

/// A format of maps that the command reads and the library does not.
enum class MapFormat : unsigned char { geojson, wkt, polyanya_mesh, wavefront_obj };

/// Returns the format for the ending of a file name: `.geojson`, `.json`, `.wkt`, `.mesh` or `.obj`.
[[nodiscard]] std::optional<MapFormat> map_format(std::string_view file_name);

/// Reads a map from text. Error messages start with `NAME:LINE: `.
/// Errors: malformed, coordinate_range.
[[nodiscard]] Result<Scene> parse_map(MapFormat format, std::string_view text, std::string_view name,
                                      const ReadProgress& progress = {});

}  // namespace waywright::formats

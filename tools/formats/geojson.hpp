#pragma once

#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

/// The name of the members and properties that GeoJSON knows nothing of: the domain of a file, and what a feature is.
inline constexpr std::string_view kOwnMember = "waywright";

/// Reads a GeoJSON text (RFC 7946): a FeatureCollection, a feature or a geometry. docs/formats.md says which items the
/// geometries become. Error messages start with `NAME:LINE: `.
/// Errors: malformed, coordinate_range.
/// Cost: linear in the length of the text. Keeps no tree of the text in memory.
[[nodiscard]] Result<Scene> parse_geojson(std::string_view text, std::string_view name,
                                          const ReadProgress& progress = {});

}  // namespace waywright::formats

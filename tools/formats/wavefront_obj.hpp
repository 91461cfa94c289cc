#pragma once

#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

/// Reads a flat Wavefront OBJ file: all its vertices have the same z, or no z. Each point of a line `p` becomes a
/// point, a line `l` a segment or a polyline, and a face `f` a polygon of one ring. Ids count from 1 in the order of
/// the file. The reader checks and ignores normals, texture coordinates, groups and materials. It refuses curves and
/// surfaces. Error messages start with `NAME:LINE: `. Errors: malformed, coordinate_range. Cost: linear in the length
/// of the text.
[[nodiscard]] Result<Scene> parse_wavefront_obj(std::string_view text, std::string_view name,
                                                const ReadProgress& progress = {});

}  // namespace waywright::formats

#pragma once

#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

/// Reads a mesh of Polyanya, version 2: convex polygons that together are the free space. The scene has one polygon, of
/// id 1, with the fill rule even-odd: it covers the domain without the free space. Its rings are the border of the
/// domain and the border of the free space, which consists of the edges without a neighbour. The domain is the box
/// around all vertices, enlarged like the domain of a `.poly` file. The reader checks that the polygons name each other
/// as neighbours. Error messages start with `NAME:LINE: `. Errors: malformed, coordinate_range. Cost: n log n, with the
/// n edges of all polygons.
[[nodiscard]] Result<Scene> parse_polyanya_mesh(std::string_view text, std::string_view name,
                                                const ReadProgress& progress = {});

}  // namespace waywright::formats

#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "waywright/scene.hpp"

/// Readers of the input formats of other triangulators; only tests use them. They throw std::runtime_error for text
/// that does not follow its format. Items are numbered from 1. The domain is the bounding box, enlarged in each of the
/// four directions by an eighth of its larger extent, by 1 at least, and to whole numbers.
namespace waywright::test {

/// Reads a file of artem-ogre/CDT: `V E`, then V points, then E pairs of indices from 0. Points on no edge become
/// points; edges become segments.
[[nodiscard]] Scene read_cdt(std::string_view text);

/// Reads JSON. The structure of the text selects the format:
/// - `[[x,y],...]`, of delaunator: points;
/// - `[ring,...]`, of earcut: one polygon of all rings that have two points or more, and the other rings' points;
/// - `{"points":...,"edges":...}`, of constrainautor: points on no edge, then the edges as segments;
/// - a GeoJSON FeatureCollection of (Multi)Polygons: polygons.
/// Returns null if the text has none of these formats.
[[nodiscard]] std::optional<Scene> read_json(std::string_view text);

/// Reads files of poly2tri: pairs of numbers, whatever other characters are between them. A blank line ends a ring of
/// `holes`. Returns one polygon of the outer ring and the holes, and the Steiner points.
[[nodiscard]] Scene read_poly2tri(std::string_view outer, std::string_view holes, std::string_view steiner);

/// Reads SUMO's `.poly.xml`: each `<poly shape="x,y x,y ...">` becomes a polygon, in hundredths of the file's unit,
/// rounded to integers.
[[nodiscard]] Scene read_sumo(std::string_view text);

/// Reads a file of one of these formats or of the library's own, chosen by its name and its contents; for a `.dat`,
/// also the files of holes and Steiner points beside it. Returns null if the file is not a scene, or belongs to another
/// file.
[[nodiscard]] std::optional<Scene> read_any_scene(const std::filesystem::path& name);

}  // namespace waywright::test

#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "waywright/scene.hpp"

/// Readers of the formats that other triangulators keep their inputs in, for tests alone. What does not follow its
/// format throws std::runtime_error. Items are numbered from 1; the domain is the bounding box grown on each side by an
/// eighth of its larger extent, 1 at least, to whole numbers.
namespace waywright::test {

/// artem-ogre/CDT: `V E`, V points, E pairs of positions from 0. Points on no edge, then the edges as segments.
[[nodiscard]] Scene read_cdt(std::string_view text);

/// JSON, told apart by its shape:
/// - `[[x,y],...]`, of delaunator: points;
/// - `[ring,...]`, of earcut: one polygon of all rings that have two points or more, and the other rings' points;
/// - `{"points":...,"edges":...}`, of constrainautor: points on no edge, then the edges as segments;
/// - a GeoJSON FeatureCollection of (Multi)Polygons: polygons.
/// Null where it is none of these.
[[nodiscard]] std::optional<Scene> read_json(std::string_view text);

/// poly2tri: pairs of numbers, whatever stands between them; a blank line ends a ring of holes. One polygon of the
/// outer ring and the holes, and the Steiner points.
[[nodiscard]] Scene read_poly2tri(std::string_view outer, std::string_view holes, std::string_view steiner);

/// SUMO's `.poly.xml`: each `<poly shape="x,y x,y ...">` as a polygon, in hundredths of the file's unit, rounded to
/// integers.
[[nodiscard]] Scene read_sumo(std::string_view text);

/// Reads a file of one of these formats, or of the library's own, by its name and shape; a `.dat` with the holes and
/// Steiner points beside it. Null where the file is no scene, or goes with another.
[[nodiscard]] std::optional<Scene> read_any_scene(const std::filesystem::path& path);

}  // namespace waywright::test

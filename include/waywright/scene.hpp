#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup scenes
/// @{

/// A domain and its items, as a file gives them, before any triangulation.
///
/// @code{.cpp}
/// const Result<Scene> scene = read_scene("level.map");
/// if (!scene) {
///   std::puts(scene.error().message().c_str());
///   return;
/// }
/// World level = World::create(scene->domain).value();
/// level.insert_all(scene->items).value();
/// @endcode
struct Scene {
  Box domain;
  std::vector<Item> items;
  bool y_down = false;  ///< whether the y axis of the file points down; see SvgOptions::y_down

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// A file format of scenes.
enum class SceneFormat : unsigned char {
  script,         ///< `.wws`, the world script: the items that are left after all changes; queries are ignored
  movingai,       ///< `.map` of Moving AI: blocked tiles become polygons
  triangle_poly,  ///< `.poly` of Triangle: segments, and points for the vertices that are no end of a segment
  triangle_node,  ///< `.node` of Triangle: points
  saved_world,    ///< `.wwb`, a saved world: its domain and its items; see save_world
};

/// @name Reading and writing scenes
/// Use read_scene for a file, and the other functions if you have the text already. In all of them `name` is the name
/// of the text in error messages, which start with `NAME:LINE: `.
///
/// @code{.cpp}
/// const std::string text = "type octile\nheight 2\nwidth 3\nmap\n..@\n..@\n";
/// const Scene scene = parse_movingai_map(text, "small.map").value();
/// const std::size_t count = scene.items.size();  // == 1
/// std::puts(to_script(scene).c_str());
/// @endcode
/// @{

/// Returns the format for the ending of a file name.
/// Errors: not_supported.
/// Cost: O(1).
[[nodiscard]] WAYWRIGHT_API Result<SceneFormat> scene_format(std::string_view file_name);

/// Reads a map of Moving AI from text. Tile (x, y) is the square [x, x+1] x [y, y+1], and y points down. The tiles `.`,
/// `G` and `S` are free, the tiles `@`, `O`, `T` and `W` are blocked. Blocked tiles that touch along a line form a
/// group. Each group becomes one polygon with an outer ring and its holes. The rings have points only where they turn.
/// Each ring is simple, even if tiles of one group touch only diagonally; at these points, two rings touch. Ids count
/// from 1 in the order of the first tile of each group, row by row. The domain is [0, width] x [0, height].
/// Errors: malformed.
/// Cost: linear in the length of the text.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_movingai_map(std::string_view text, std::string_view name);

/// Reads a `.poly` file of Triangle from text. The vertices that are no end of a segment become items of the kind
/// point, then the segments of the file become items of the kind segment. The ids of these items count from 1 in this
/// order. If the vertex list of the file is empty, the vertices come from `node_text`, the text of the `.node` file of
/// the same name. In each list of the file (vertices, segments, holes, regions), the numbers of the entries must count
/// up by 1 from 0 or 1. The function reads and checks attributes, boundary markers, holes and regions, and then ignores
/// them. The domain is the bounding box of the vertices, enlarged in each of the four directions by an eighth of its
/// larger extent, but at least by 1. Each bound is then rounded outwards to a multiple of a power of two, so that it
/// has few digits.
/// Errors: malformed, coordinate_range.
/// Cost: linear in the length of the text.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_triangle_poly(std::string_view text, std::string_view name,
                                                              std::string_view node_text = {},
                                                              std::string_view node_name = {});

/// Reads a `.node` file of Triangle from text. Its vertices become points. Ids, domain, errors and cost are as for
/// parse_triangle_poly.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_triangle_node(std::string_view text, std::string_view name);

/// Returns whether the bytes of a file start like a saved world (SceneFormat::saved_world).
/// Cost: O(1).
[[nodiscard]] WAYWRIGHT_API bool is_saved_world(std::string_view bytes);

/// Reads the domain and the items of a saved world from its bytes. Error messages start with `NAME: `. To read the
/// options and the next id, too, use load_world().
/// Errors: malformed, not_supported.
/// Cost: the cost of load_world().
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_saved_world(std::string_view bytes, std::string_view name);

/// Reads a scene from a file. A file that starts like a saved world counts as a saved world, whatever its name.
/// Otherwise the ending of the file name says the format. If a `.poly` file has no vertices, the function also reads
/// the `.node` file of the same name in the same folder. Error messages start with the file name.
/// Errors: unreadable, not_supported, malformed, coordinate_range.
/// Cost: linear in the length of the file; for a saved world, the cost of load_world().
[[nodiscard]] WAYWRIGHT_API Result<Scene> read_scene(const std::string& file_name);

/// Returns the scene as a world script: a header, the domain, and an insertion for each item in the order of the items.
/// A script has no line for Scene::y_down.
/// Cost: linear in the points of the items.
[[nodiscard]] WAYWRIGHT_API std::string to_script(const Scene& scene);

/// @}

/// @}

}  // namespace waywright

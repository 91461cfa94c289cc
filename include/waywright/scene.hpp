#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// A domain and its items, as read from a file, before any triangulation.
struct Scene {
  Box domain;
  std::vector<Item> items;
  bool y_down = false;  ///< the file's y axis points down (pictures show it that way)

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// The formats a scene is read from.
enum class SceneFormat : unsigned char {
  script,         ///< `.wws`, the world script: what its changes leave; queries are passed over
  movingai,       ///< `.map`: blocked cells become polygons, cell (x, y) the square [x, x+1] x [y, y+1], y downwards
  triangle_poly,  ///< `.poly` of Triangle: segments, and the vertices on none of them as points
  triangle_node,  ///< `.node` of Triangle: points
};

/// The format that a file name's ending stands for. Errors: not_supported.
[[nodiscard]] WAYWRIGHT_API Result<SceneFormat> scene_format(std::string_view file_name);

/// Reads a map from text; `name` is what messages call the text, they start `NAME:LINE: `. The cells `.`, `G` and `S`
/// are free, `@`, `O`, `T` and `W` blocked. Each group of blocked cells, connected through their sides, becomes one
/// polygon: its outer ring and its holes, of true corners alone; where cells of one group touch diagonally the rings
/// turn so that each of them is simple. Ids count from 1 in the order of the groups' first cells, row by row. The
/// domain is [0, width] x [0, height]. Errors: malformed. Cost: linear.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_movingai_map(std::string_view text, std::string_view name);

/// Reads a `.poly` of Triangle from text: its vertices on no segment become points, then its segments segments, ids
/// from 1 in this order. A file whose vertex list is empty takes its vertices from `node_text`, the `.node` file of the
/// same name. Ids in the file count from 0 or 1, each one more than the last. Attributes, boundary markers, holes and
/// regions are read and checked, and passed over. The domain is the vertices' bounding box, grown on each side by an
/// eighth of its larger extent, 1 at least, and on to the next simple number. Errors: malformed, coordinate_range.
/// Cost: linear.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_triangle_poly(std::string_view text, std::string_view name,
                                                              std::string_view node_text = {},
                                                              std::string_view node_name = {});

/// Reads a `.node` of Triangle from text: points, else as parse_triangle_poly.
[[nodiscard]] WAYWRIGHT_API Result<Scene> parse_triangle_node(std::string_view text, std::string_view name);

/// Reads a scene from a file, its format told by its ending. Errors: unreadable, not_supported, malformed,
/// coordinate_range; messages start with the file's name.
[[nodiscard]] WAYWRIGHT_API Result<Scene> read_scene(const std::string& file_name);

/// The scene as a world script: a header, the domain and an insertion for each item, in their order. `y_down` has no
/// place in a script.
[[nodiscard]] WAYWRIGHT_API std::string to_script(const Scene& scene);

}  // namespace waywright

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// A domain and its items, as read from a file, before any triangulation.
struct Scene {
  Box domain;
  std::vector<Item> items;
  bool y_down = false;  ///< the file's y axis points down (pictures show it that way)
};

/// The formats a scene is read from.
enum class SceneFormat : unsigned char {
  script,         ///< `.wws`, the world script: what its insertions and removals leave; queries are passed over
  movingai,       ///< `.map`: blocked cells become polygons, cell (x, y) the square [x, x+1] x [y, y+1], y downwards
  triangle_poly,  ///< `.poly` of Triangle: segments, and the vertices on none of them as points
  triangle_node,  ///< `.node` of Triangle: points
};

/// The format that a file name's ending stands for. Errors: not_supported.
[[nodiscard]] Result<SceneFormat> scene_format(std::string_view file_name);

/// Reads a scene from text. `name` is what messages call the text; they start `NAME:LINE: `. Errors: malformed.
[[nodiscard]] Result<Scene> parse_movingai_map(std::string_view text, std::string_view name);
/// A `.poly` file whose vertex list is empty takes its vertices from `node_text`, the `.node` file of the same name.
[[nodiscard]] Result<Scene> parse_triangle_poly(std::string_view text, std::string_view name,
                                                std::string_view node_text = {}, std::string_view node_name = {});
[[nodiscard]] Result<Scene> parse_triangle_node(std::string_view text, std::string_view name);

/// Reads a scene from a file, its format told by its ending. Errors: unreadable, not_supported, malformed.
[[nodiscard]] Result<Scene> read_scene(const std::string& file_name);

/// The scene as a world script: a header, the domain and an insertion for each item.
[[nodiscard]] std::string to_script(const Scene& scene);

}  // namespace waywright

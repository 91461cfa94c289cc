#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/item.hpp"
#include "waywright/path.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// @addtogroup scenes
/// @{

/// The kind of one line of a world script. docs/formats.md describes each kind.
enum class ScriptLineKind : std::uint8_t {
  insert,
  remove,
  replace,
  locate,
  ray,
  disc,
  nearest,
  path,
  check,
  hash,
  clear,  ///< a query: World::is_clear
  tick,
  mark,
  rewind
};

/// One line of a world script. The parser does not check whether numbers are in range or points lie in the domain. A
/// world checks this.
struct ScriptLine {
  ScriptLineKind kind = ScriptLineKind::check;
  std::uint32_t line = 0;                  ///< the line in the text, from 1
  Item item;                               ///< insert and replace: the item; remove: its id; clear: its points
  Point from;                              ///< for locate, ray, disc, nearest and path
  Point to;                                ///< for ray and path; for nearest, the goal if there is one
  Agent agent;                             ///< for ray, disc, nearest and path: the radius of the line
  bool has_radius = false;                 ///< for ray: whether the line gives a radius
  std::optional<PathAlgorithm> algorithm;  ///< for path, if the line names one
  std::optional<double> end_tolerance;     ///< for path, if the line gives one
  bool has_goal = false;                   ///< for nearest: whether the line gives a goal
  std::uint64_t tick = 0;                  ///< for tick: its number; for mark and rewind: the tick of World::mark()
  std::optional<ItemsHash> items_hash;     ///< for tick, if the line gives one
};

/// Returns the first word of the line: `point`, `segment`, ..., `remove`, `replace`, `locate`, ...
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(const ScriptLine& line);

/// A whole world script. parse_script() reads and checks all lines before your program carries out the first one.
///
/// @code{.cpp}
/// const std::string text = "waywright 1\ndomain 0 0 10 10\nsegment 1 4 0 4 7\npath 1 1 7 1 0\n";
/// const Script script = parse_script(text, "example.wws").value();
/// for (const ScriptLine& line : script.lines) {
///   if (line.kind == ScriptLineKind::path) std::printf("line %u asks for a path\n", line.line);
/// }
/// const std::size_t count = scene_of(script).items.size();  // == 1
/// @endcode
struct Script {
  Box domain;                     ///< min is below max, and a world accepts the coordinates
  std::uint32_t domain_line = 0;  ///< the line of the domain in the text, from 1
  std::vector<ScriptLine> lines;
};

/// Reads a world script. docs/formats.md describes the format. Error messages start with `NAME:LINE: `, where NAME is
/// `name`. The text is UTF-8; the function skips a byte order mark at its start.
/// Errors: malformed.
/// Cost: linear in the length of the text.
[[nodiscard]] WAYWRIGHT_API Result<Script> parse_script(std::string_view text, std::string_view name);

/// Returns the items that are left after all insertions, replacements, removals and rewinds of a script, in the order
/// of the insertions. The function ignores each operation that a world would refuse: an insertion with an id that is in
/// use, a replacement or removal with an id that is not in use, and an operation with a coordinate that is out of range
/// or outside the domain.
/// Cost: O(n log n) for n lines, and linear in the points of the items.
[[nodiscard]] WAYWRIGHT_API Scene scene_of(const Script& script);

/// @}

}  // namespace waywright

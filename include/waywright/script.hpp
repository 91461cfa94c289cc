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

namespace waywright {

/// What a line of a world script asks for.
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
  clear
};

/// One line of a world script. Numbers are as read: whether they lie in range, or in the domain, is for the world to
/// say.
struct ScriptLine {
  ScriptLineKind kind = ScriptLineKind::check;
  std::uint32_t line = 0;                  ///< from 1
  Item item;                               ///< of an insertion or replacement; of a removal its id, of clear its points
  Point from;                              ///< of locate, ray, disc, nearest and path
  Point to;                                ///< of ray and path
  double radius = 0.0;                     ///< of disc, nearest and path
  std::optional<PathAlgorithm> algorithm;  ///< of path, where the line names one
  std::optional<double> end_tolerance;     ///< of path, where the line gives one
};

/// The word that the script's line begins with: `point`, `segment`, ..., `remove`, `replace`, `locate`, ...
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(const ScriptLine& operation);

/// A whole world script, read before any of it runs.
struct Script {
  Box domain;  ///< min < max holds, and a world can hold its corners
  std::uint32_t domain_line = 0;
  std::vector<ScriptLine> lines;
};

/// Reads a world script, as docs/formats.md describes it. `name` is what messages call the text; they start `NAME:LINE:
/// `. The text is UTF-8; a byte order mark at its start is skipped. Errors: malformed.
[[nodiscard]] WAYWRIGHT_API Result<Script> parse_script(std::string_view text, std::string_view name);

/// The scene that a script's insertions, replacements and removals leave, in the order of the insertions. What a world
/// would refuse is passed over: an insertion whose id is in use, a replacement whose id is not, and a coordinate that
/// is out of range or outside the domain.
[[nodiscard]] WAYWRIGHT_API Scene scene_of(const Script& script);

}  // namespace waywright

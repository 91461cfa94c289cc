#pragma once

#include <optional>
#include <string_view>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"
#include "text/file_types.hpp"

namespace waywright::formats {

/// Returns whether a file of this type contains a map that the command reads and the library does not.
[[nodiscard]] bool reads_map(std::optional<text::FileType> type);

/// Reads a map from text. Error messages start with `NAME:LINE: `. Requires: reads_map(type).
/// Errors: malformed, coordinate_range.
[[nodiscard]] Result<Scene> parse_map(text::FileType type, std::string_view text, std::string_view name,
                                      const ReadProgress& progress = {});

}  // namespace waywright::formats

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

// What a file is: the only table of the endings of file names, and the only place that looks at first bytes. The
// library and the command use it.

namespace waywright::text {

enum class FileType : unsigned char {
  script,
  saved_world,
  movingai_map,
  triangle_poly,
  triangle_node,
  geojson,
  wkt,
  polyanya_mesh,
  wavefront_obj,
  picture,
};

struct FileEnding {
  std::string_view ending;
  FileType type;
};

inline constexpr std::array kFileEndings{
    FileEnding{".wws", FileType::script},         FileEnding{".wwb", FileType::saved_world},
    FileEnding{".map", FileType::movingai_map},   FileEnding{".poly", FileType::triangle_poly},
    FileEnding{".node", FileType::triangle_node}, FileEnding{".geojson", FileType::geojson},
    FileEnding{".json", FileType::geojson},       FileEnding{".wkt", FileType::wkt},
    FileEnding{".mesh", FileType::polyanya_mesh}, FileEnding{".obj", FileType::wavefront_obj},
    FileEnding{".svg", FileType::picture},
};

/// The first bytes of a saved world.
inline constexpr std::string_view kSavedWorldMagic = "WWORLD";

/// Returns the type for the ending of a file name, or null if no type has this ending.
constexpr std::optional<FileType> type_of_name(std::string_view file_name) {
  for (const FileEnding& row : kFileEndings) {
    if (file_name.ends_with(row.ending)) return row.type;
  }
  return std::nullopt;
}

/// Returns the type of a text that has no name: a saved world, GeoJSON or a world script. Only GeoJSON starts with a
/// brace.
constexpr FileType type_of_bytes(std::string_view bytes) {
  if (bytes.starts_with(kSavedWorldMagic)) return FileType::saved_world;
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  const std::size_t start = bytes.find_first_not_of(" \t\r\n", bytes.starts_with(kByteOrderMark) ? 3 : 0);
  return start != std::string_view::npos && bytes[start] == '{' ? FileType::geojson : FileType::script;
}

}  // namespace waywright::text

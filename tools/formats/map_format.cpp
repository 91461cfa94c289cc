#include "formats/map_format.hpp"

#include <utility>

#include "formats/geojson.hpp"
#include "formats/polyanya_mesh.hpp"
#include "formats/wavefront_obj.hpp"
#include "formats/wkt.hpp"

namespace waywright::formats {

std::optional<MapFormat> map_format(std::string_view file_name) {
  static constexpr std::pair<std::string_view, MapFormat> kEndings[] = {{".geojson", MapFormat::geojson},
                                                                        {".json", MapFormat::geojson},
                                                                        {".wkt", MapFormat::wkt},
                                                                        {".mesh", MapFormat::polyanya_mesh},
                                                                        {".obj", MapFormat::wavefront_obj}};
  for (const auto& [ending, format] : kEndings) {
    if (file_name.ends_with(ending)) return format;
  }
  return std::nullopt;
}

Result<Scene> parse_map(MapFormat format, std::string_view text, std::string_view name, const ReadProgress& progress) {
  switch (format) {
    case MapFormat::geojson:
      return parse_geojson(text, name, progress);
    case MapFormat::wkt:
      return parse_wkt(text, name, progress);
    case MapFormat::polyanya_mesh:
      return parse_polyanya_mesh(text, name, progress);
    case MapFormat::wavefront_obj:
      break;
  }
  return parse_wavefront_obj(text, name, progress);
}

}  // namespace waywright::formats

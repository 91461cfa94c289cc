#include "formats/map_format.hpp"

#include "formats/geojson.hpp"
#include "formats/polyanya_mesh.hpp"
#include "formats/wavefront_obj.hpp"
#include "formats/wkt.hpp"

namespace waywright::formats {

bool reads_map(std::optional<text::FileType> type) {
  return type == text::FileType::geojson || type == text::FileType::wkt || type == text::FileType::polyanya_mesh ||
         type == text::FileType::wavefront_obj;
}

Result<Scene> parse_map(text::FileType type, std::string_view text, std::string_view name,
                        const ReadProgress& progress) {
  switch (type) {
    case text::FileType::geojson:
      return parse_geojson(text, name, progress);
    case text::FileType::wkt:
      return parse_wkt(text, name, progress);
    case text::FileType::polyanya_mesh:
      return parse_polyanya_mesh(text, name, progress);
    default:
      return parse_wavefront_obj(text, name, progress);
  }
}

}  // namespace waywright::formats

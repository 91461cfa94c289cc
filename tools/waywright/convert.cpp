#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "waywright/save.hpp"
#include "waywright/scene.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "file_names.hpp"
#include "formats/write_geojson.hpp"
#include "input.hpp"
#include "output.hpp"
#include "picture.hpp"
#include "text/file_types.hpp"

namespace waywright::command {

namespace {

std::string picture_of(const Scene& scene, const ConvertOptions& options) {
  const SvgOptions picture = svg_options(options.picture, scene.domain, title_of(options.in), scene.y_down);
  return draw(build_world(scene, options.in, 0.0), {}, picture);
}

/// Returns the format of OUT: `wws`, `wwb`, `svg`, `geojson` or `geojson-mesh`. Throws Failure if neither the options
/// nor the file name tells.
std::string_view format_of(const ConvertOptions& options) {
  const std::string_view name = options.out;
  if (!options.format.empty()) return options.format;
  if (name == "-") return "wws";
  const auto type = text::type_of_name(name);
  if (type == text::FileType::script) return "wws";
  if (type == text::FileType::saved_world) return "wwb";
  if (type == text::FileType::picture) return "svg";
  if (type == text::FileType::geojson) return "geojson";
  throw Failure(fmt::format(
      "waywright: convert writes world scripts (.wws), saved worlds (.wwb), pictures (.svg) and GeoJSON (.geojson, "
      ".json), and '{}' has none of these endings; --format says which",
      name));
}

std::string saved_world_of(const ConvertOptions& options) {
  std::ostringstream bytes;
  const Result<void> saved = save_world(load_world(options.in), bytes);
  if (!saved.ok()) throw Failure(fmt::format("{}: {}", options.out, saved.error().message()));
  return std::move(bytes).str();
}

std::string geojson_mesh_of(const Scene& scene, const ConvertOptions& options) {
  formats::GeoJsonWriter writer(scene.domain, scene.y_down);
  writer.add_mesh(build_world(scene, options.in, 0.0).snapshot());
  return writer.take();
}

/// Returns what OUT becomes, for a message.
std::string_view noun_of(std::string_view format) {
  if (format == "wwb") return "a saved world";
  return format == "wws" ? "a world script" : "GeoJSON";
}

std::string contents_of(const ConvertOptions& options, std::string_view format) {
  if (format == "wwb") return saved_world_of(options);
  const Scene scene = load_scene(options.in);
  if (format == "geojson") return formats::to_geojson(scene);
  if (format == "geojson-mesh") return geojson_mesh_of(scene, options);
  return format == "svg" ? picture_of(scene, options) : to_script(scene);
}

}  // namespace

ExitStatus convert(const ConvertOptions& options) {
  const std::string_view format = format_of(options);
  if (format != "svg" && !options.picture.crop.empty()) {
    throw Failure(fmt::format("waywright: convert: --crop is for pictures, and OUT becomes {}", noun_of(format)));
  }
  refuse_shared_files(files_of_map(options.in), {{"OUT", options.out}});
  OutputFile out(options.out);
  out.write(contents_of(options, format));
  out.commit();
  return kDone;
}

}  // namespace waywright::command

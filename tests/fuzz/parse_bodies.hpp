#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/save.hpp"
#include "waywright/scenario.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"

#include "formats/map_format.hpp"
#include "formats/write_geojson.hpp"
#include "support/saved_world_oracle.hpp"

/// The checks that hold for every text. The fuzz targets use them, and so do the tests that replay their corpora. Each
/// function returns what is wrong, or an empty text if nothing is.
namespace waywright::test {

inline constexpr std::string_view kFuzzName = "fuzz";

/// Checks that an error names the text and a line that exists in the text.
inline std::string fault_of_error(const Error& error, std::string_view text) {
  if (error.code != ErrorCode::malformed && error.code != ErrorCode::coordinate_range)
    return "an error of another code";
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  if (error.index < 1 || error.index > lines) return "an error on a line that is not there";
  const std::string start = std::string(kFuzzName) + ":" + std::to_string(error.index) + ": ";
  return error.message().rfind(start, 0) == 0 ? "" : "an error without name and line: " + error.message();
}

/// Checks that a scene written as a script reads back as the same scene.
inline std::string fault_of_scene(Scene scene) {
  scene.y_down = false;
  const Result<Script> script = parse_script(to_script(scene), kFuzzName);
  if (!script.ok()) return "the scene's script is refused: " + script.error().message();
  return scene_of(*script) == scene ? "" : "the scene's script reads back as another scene";
}

inline std::string fault_of_script(std::string_view text) {
  const Result<Script> script = parse_script(text, kFuzzName);
  if (!script.ok()) return fault_of_error(script.error(), text);
  for (const ScriptLine& operation : script->lines) {
    if (to_string(operation).empty()) return "an operation without a word";
  }
  return fault_of_scene(scene_of(*script));
}

/// Returns twice the area that the rings enclose, without the holes.
inline double doubled_area(const std::vector<std::vector<Point>>& rings) {
  double doubled = 0.0;
  for (const std::vector<Point>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      doubled += a.x * b.y - b.x * a.y;
    }
  }
  return doubled;
}

/// Checks that the polygons of a map have the area of its blocked tiles. In an accepted map the letters of blocked
/// tiles occur only in tiles.
inline std::string fault_of_map(std::string_view text) {
  const Result<Scene> scene = parse_movingai_map(text, kFuzzName);
  if (!scene.ok()) return fault_of_error(scene.error(), text);
  const auto blocked = std::count_if(text.begin(), text.end(),
                                     [](char c) { return std::string_view("@OTW").find(c) != std::string_view::npos; });
  double doubled = 0.0;
  for (const Item& item : scene->items) doubled += doubled_area(item.shape.rings);
  if (doubled != 2.0 * static_cast<double>(blocked)) return "the polygons' area is not that of the blocked tiles";
  return fault_of_scene(*scene);
}

/// Reads the text as a `.poly` file. If the text has a line `%`, the text after that line is the `.node` file that
/// belongs to it. Reads the whole text as a `.node` file too.
inline std::string fault_of_poly(std::string_view text) {
  constexpr std::string_view kSeparator = "\n%\n";
  const std::size_t separator = text.find(kSeparator);
  const std::string_view poly = text.substr(0, separator);
  const std::string_view node =
      separator == std::string_view::npos ? std::string_view{} : text.substr(separator + kSeparator.size());
  for (const Result<Scene>& scene :
       {parse_triangle_poly(poly, kFuzzName, node, kFuzzName), parse_triangle_node(text, kFuzzName)}) {
    const std::string fault = scene.ok() ? fault_of_scene(*scene) : fault_of_error(scene.error(), text);
    if (!fault.empty()) return fault;
  }
  return {};
}

/// Checks that a scene written as GeoJSON reads back as the same scene, and is written again as the same text.
inline std::string fault_of_geojson_copy(const Scene& scene) {
  const std::string text = formats::to_geojson(scene);
  const Result<Scene> copy = formats::parse_map(text::FileType::geojson, text, kFuzzName);
  if (!copy.ok()) return "the scene's GeoJSON is refused: " + copy.error().message();
  if (formats::to_geojson(*copy) != text) return "the scene's GeoJSON reads back as another scene";
  const bool has_short_ring = std::any_of(scene.items.begin(), scene.items.end(), [](const Item& item) {
    return std::any_of(item.shape.rings.begin(), item.shape.rings.end(),
                       [&](PointSpan ring) { return ring.size() < (item.shape.kind == ItemKind::polygon ? 3U : 1U); });
  });
  return has_short_ring || *copy == scene ? "" : "the scene's GeoJSON reads back as a similar scene";
}

/// Reads the text in a format of the command.
inline std::string fault_of_foreign_map(text::FileType format, std::string_view text) {
  const Result<Scene> scene = formats::parse_map(format, text, kFuzzName);
  if (!scene.ok()) return fault_of_error(scene.error(), text);
  // GeoJSON may give a domain that is too small for its items. A script would leave these items out.
  const bool has_own_domain = format == text::FileType::geojson;
  if (const std::string fault = has_own_domain ? "" : fault_of_scene(*scene); !fault.empty()) return fault;
  return fault_of_geojson_copy(*scene);
}

inline std::string fault_of_geojson(std::string_view text) {
  return fault_of_foreign_map(text::FileType::geojson, text);
}
inline std::string fault_of_wkt(std::string_view text) { return fault_of_foreign_map(text::FileType::wkt, text); }
inline std::string fault_of_mesh(std::string_view text) {
  return fault_of_foreign_map(text::FileType::polyanya_mesh, text);
}
inline std::string fault_of_obj(std::string_view text) {
  return fault_of_foreign_map(text::FileType::wavefront_obj, text);
}

/// Checks that the queries of a scenario have ascending line numbers that exist in the text, and that all their numbers
/// are finite.
inline std::string fault_of_scenario(std::string_view text) {
  const Result<std::vector<ScenarioQuery>> queries = parse_movingai_scenario(text, kFuzzName);
  if (!queries.ok()) return fault_of_error(queries.error(), text);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  std::size_t last = 1;
  for (const ScenarioQuery& query : *queries) {
    if (query.line <= last || query.line > lines) return "a query on a line that is not its own";
    last = query.line;
    for (const double number : {query.start.x, query.start.y, query.goal.x, query.goal.y, query.length}) {
      if (!std::isfinite(number)) return "a number that is not finite";
    }
    if (!(query.precision >= 0.0)) return "a precision below 0";
    if (text.find(query.map) == std::string_view::npos) return "a map that the text does not name";
  }
  return queries->empty() ? "no query" : "";
}

/// Reads the bytes as a saved world, as they are and with the right checksum in their last four bytes.
inline std::string fault_of_saved_world(std::string_view bytes) {
  std::string with_checksum(bytes);
  if (bytes.size() >= 4) with_checksum = saved_world::sealed(with_checksum.substr(0, bytes.size() - 4));
  for (const std::string& tried : {std::string(bytes), with_checksum}) {
    std::istringstream in(tried);
    const Result<World> world = load_world(in);
    if (!world.ok()) {
      if (world.error().index > tried.size()) return "an error at a byte that is not there";
      if (world.error().code == ErrorCode::unreadable) return "an error of another code";
      continue;
    }
    std::stringstream again;
    if (!save_world(*world, again).ok()) return "a loaded world cannot be saved";
    const Result<World> second = load_world(again);
    if (!second.ok()) return "a saved world is refused: " + second.error().message();
    if (second->items_hash() != world->items_hash()) return "a saved world is another world";
    if (const Validation validation = world->validate(); !validation.ok) return validation.fault;
  }
  return {};
}

/// Ends the process with a message if there is a fault, so that the fuzzer reports it.
inline void stop_at(const std::string& fault) {
  if (fault.empty()) return;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

}  // namespace waywright::test

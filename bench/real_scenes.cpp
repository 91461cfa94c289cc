#include "real_scenes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "waywright/scene.hpp"

namespace waywright::bench {
namespace {

Workload workload_of(Scene scene) {
  Workload workload{scene.domain, {}, {}};
  workload.updates.reserve(scene.items.size());
  for (Item& item : scene.items) workload.updates.push_back({{}, std::move(item)});
  return workload;
}

/// Returns the points of `x,y x,y ...`, which are in hundredths, as whole numbers.
std::vector<Point> parse_footprint(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    double value = 0.0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error == std::errc()) numbers.push_back(std::nearbyint(value * 100.0));
    at = rest == at ? at + 1 : rest;
  }
  std::vector<Point> ring;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) ring.push_back({numbers[i], numbers[i + 1]});
  // The file repeats the first point at the end.
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

std::optional<Scene> parse_footprints(std::string_view text) {
  constexpr std::string_view kShape = "shape=\"";
  Scene scene;
  std::vector<Point> all;
  for (std::size_t at = text.find(kShape); at != std::string_view::npos; at = text.find(kShape, at)) {
    at += kShape.size();
    const std::size_t end = text.find('"', at);
    if (end == std::string_view::npos) return std::nullopt;
    std::vector<Point> ring = parse_footprint(text.substr(at, end - at));
    if (ring.empty()) continue;
    all.insert(all.end(), ring.begin(), ring.end());
    const ItemId id{scene.items.size() + 1};
    scene.items.push_back({id, {ItemKind::polygon, {std::move(ring)}}});
  }
  if (all.empty()) return std::nullopt;
  const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
  const auto by_y = [](const Point& a, const Point& b) { return a.y < b.y; };
  const auto [left, right] = std::minmax_element(all.begin(), all.end(), by_x);
  const auto [low, high] = std::minmax_element(all.begin(), all.end(), by_y);
  scene.domain = {{left->x - 1000.0, low->y - 1000.0}, {right->x + 1000.0, high->y + 1000.0}};
  return scene;
}

}  // namespace

std::string data_folder() {
  const char* const given = std::getenv("WAYWRIGHT_DATA");
  return given != nullptr ? given : WAYWRIGHT_SOURCE_DIR "/../shared/data";
}

const std::vector<std::string>& real_scene_files() {
  static const std::vector<std::string> files = {
      "grid/dao/arena.map",           "grid/dao/brc202d.map",
      "grid/sc1/Aurora.map",          "grid/bgmaps/AR0500SR.map",
      "grid/cities/Berlin_1_256.map", "grid/mazes/maze512-2-5.map",
      "grid/rooms/8room_000.map",     "grid/random/random512-20-0.map",
      "poly/triangle/greenland.node", "poly/city/luxembourg_lust.poly.xml",
  };
  return files;
}

std::optional<Workload> read_real_scene(const std::string& file) {
  const std::string file_name = data_folder() + '/' + file;
  if (!file.ends_with(".poly.xml")) {
    Result<Scene> scene = read_scene(file_name);
    if (!scene.ok()) return std::nullopt;
    return workload_of(*std::move(scene));
  }
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::optional<Scene> scene = parse_footprints(text);
  if (!scene) return std::nullopt;
  return workload_of(*std::move(scene));
}

std::optional<std::vector<KnownPath>> read_known_paths(const std::string& file) {
  std::ifstream stream(data_folder() + '/' + file);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  std::vector<KnownPath> paths;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string bucket, map, width, height;
    KnownPath path;
    fields >> bucket >> map >> width >> height >> path.start.x >> path.start.y >> path.goal.x >> path.goal.y >>
        path.length;
    if (fields) paths.push_back(path);
  }
  return paths;
}

}  // namespace waywright::bench

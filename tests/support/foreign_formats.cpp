#include "support/foreign_formats.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace waywright::test {
namespace {

using Json = nlohmann::json;
using Ring = std::vector<Point>;
using Edges = std::vector<std::array<std::size_t, 2>>;

class SceneBuilder {
 public:
  void add(ItemKind kind, std::vector<Ring> rings) {
    scene_.items.push_back({ItemId{scene_.items.size() + 1}, Shape{kind, std::move(rings)}});
  }

  /// Adds the points that are on no edge, then the edges as segments.
  void add_graph(const Ring& points, const Edges& edges) {
    std::vector<bool> on_edge(points.size());
    for (const auto [a, b] : edges) {
      if (a >= points.size() || b >= points.size()) throw std::runtime_error("an edge to a point that is not there");
      on_edge[a] = on_edge[b] = true;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!on_edge[i]) add(ItemKind::point, {{points[i]}});
    }
    for (const auto [a, b] : edges) add(ItemKind::segment, {{points[a], points[b]}});
  }

  Scene finish() {
    Ring all;
    for (const Item& item : scene_.items) {
      for (const PointSpan& ring : item.shape.rings) all.insert(all.end(), ring.begin(), ring.end());
    }
    if (all.empty()) all.push_back({0.0, 0.0});
    const auto [left, right] = std::minmax_element(all.begin(), all.end(), [](Point a, Point b) { return a.x < b.x; });
    const auto [low, high] = std::minmax_element(all.begin(), all.end(), [](Point a, Point b) { return a.y < b.y; });
    const double margin = std::max(1.0, std::max(right->x - left->x, high->y - low->y) / 8.0);
    scene_.domain.min = {std::floor(left->x - margin), std::floor(low->y - margin)};
    scene_.domain.max = {std::ceil(right->x + margin), std::ceil(high->y + margin)};
    return std::move(scene_);
  }

 private:
  Scene scene_;
};

/// Returns all numbers of a text, whatever other characters are between them. A sign belongs to a number that follows
/// it directly.
std::vector<double> numbers_in(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_of(kDigits); at != std::string_view::npos;) {
    std::size_t start = at;
    if (start > 0 && text[start - 1] == '.') --start;
    if (start > 0 && text[start - 1] == '-') --start;
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data() + start, text.data() + text.size(), value);
    if (status != std::errc{}) throw std::runtime_error("a number that no double is near to");
    numbers.push_back(value);
    at = text.find_first_of(kDigits, static_cast<std::size_t>(end - text.data()));
  }
  return numbers;
}

Ring ring_of(const std::vector<double>& numbers) {
  if (numbers.size() % 2 != 0) throw std::runtime_error("an x without its y");
  Ring ring;
  for (std::size_t i = 0; i < numbers.size(); i += 2) ring.push_back({numbers[i], numbers[i + 1]});
  return ring;
}

/// Returns the rings of a text in which blank lines separate rings.
std::vector<Ring> rings_in(std::string_view text) {
  std::vector<Ring> rings;
  std::string block;
  const auto end_block = [&] {
    Ring ring = ring_of(numbers_in(block));
    if (!ring.empty()) rings.push_back(std::move(ring));
    block.clear();
  };
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) end_block();
    (block += line) += '\n';
  }
  end_block();
  return rings;
}

Point json_point(const Json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

Ring json_ring(const Json& points) {
  Ring ring;
  for (const Json& point : points) ring.push_back(json_point(point));
  return ring;
}

std::vector<Ring> json_rings(const Json& list) {
  std::vector<Ring> rings;
  for (const Json& points : list) rings.push_back(json_ring(points));
  return rings;
}

Scene earcut_scene(const Json& rings) {
  SceneBuilder builder;
  std::vector<Ring> polygon;
  Ring points;
  for (Ring& ring : json_rings(rings)) {
    if (ring.size() == 1) {
      points.push_back(ring.front());
    } else if (!ring.empty()) {
      polygon.push_back(std::move(ring));
    }
  }
  if (!polygon.empty()) builder.add(ItemKind::polygon, std::move(polygon));
  builder.add_graph(points, {});
  return builder.finish();
}

Scene constrainautor_scene(const Json& graph) {
  Edges edges;
  for (const Json& edge : graph.at("edges")) {
    edges.push_back({edge.at(0).get<std::size_t>(), edge.at(1).get<std::size_t>()});
  }
  SceneBuilder builder;
  builder.add_graph(json_ring(graph.at("points")), edges);
  return builder.finish();
}

Scene geojson_scene(const Json& collection) {
  SceneBuilder builder;
  for (const Json& feature : collection.at("features")) {
    const Json& geometry = feature.at("geometry");
    const Json& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
      builder.add(ItemKind::polygon, json_rings(coordinates));
    } else if (geometry.at("type") == "MultiPolygon") {
      for (const Json& polygon : coordinates) builder.add(ItemKind::polygon, json_rings(polygon));
    }
  }
  return builder.finish();
}

/// Returns how deep arrays are nested, looking only at first elements.
int depth_of(const Json& json) {
  int depth = 0;
  for (const Json* at = &json; at->is_array(); at = &at->front()) {
    ++depth;
    if (at->empty()) break;
  }
  return depth;
}

std::string read_file(const std::filesystem::path& name) {
  std::ifstream file(name, std::ios::binary);
  if (!file) throw std::runtime_error(name.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Returns the text of the first file that exists: the stem of `name` with one of the endings.
std::string partner_of(const std::filesystem::path& name, const std::vector<std::string>& endings) {
  for (const std::string& ending : endings) {
    const std::filesystem::path partner = name.parent_path() / (name.stem().string() + ending);
    if (std::filesystem::exists(partner)) return read_file(partner);
  }
  return {};
}

}  // namespace

Scene read_cdt(std::string_view text) {
  const std::vector<double> numbers = numbers_in(text);
  if (numbers.size() < 2) throw std::runtime_error("no counts of points and edges");
  const auto vertices = static_cast<std::size_t>(numbers[0]);
  const auto edge_count = static_cast<std::size_t>(numbers[1]);
  if (numbers.size() != 2 + 2 * vertices + 2 * edge_count) throw std::runtime_error("a wrong count of numbers");
  const auto edges_start = numbers.begin() + 2 + static_cast<std::ptrdiff_t>(2 * vertices);
  Edges edges;
  for (auto at = edges_start; at != numbers.end(); at += 2) {
    edges.push_back({static_cast<std::size_t>(at[0]), static_cast<std::size_t>(at[1])});
  }
  SceneBuilder builder;
  builder.add_graph(ring_of({numbers.begin() + 2, edges_start}), edges);
  return builder.finish();
}

std::optional<Scene> read_json(std::string_view text) {
  const Json json = Json::parse(text);
  if (json.is_object() && json.contains("points")) return constrainautor_scene(json);
  if (json.is_object() && json.contains("features")) return geojson_scene(json);
  if (depth_of(json) == 3) return earcut_scene(json);
  if (depth_of(json) != 2) return std::nullopt;
  SceneBuilder builder;
  builder.add_graph(json_ring(json), {});
  return builder.finish();
}

Scene read_poly2tri(std::string_view outer, std::string_view holes, std::string_view steiner) {
  std::vector<Ring> rings{ring_of(numbers_in(outer))};
  for (Ring& hole : rings_in(holes)) rings.push_back(std::move(hole));
  SceneBuilder builder;
  builder.add(ItemKind::polygon, std::move(rings));
  builder.add_graph(ring_of(numbers_in(steiner)), {});
  return builder.finish();
}

Scene read_sumo(std::string_view text) {
  constexpr std::string_view kTag = "<poly ";
  constexpr std::string_view kShape = " shape=\"";
  SceneBuilder builder;
  for (std::size_t at = text.find(kTag); at != std::string_view::npos; at = text.find(kTag, at + kTag.size())) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    const std::size_t shape = tag.find(kShape);
    if (shape == std::string_view::npos) throw std::runtime_error("a poly without shape");
    const std::string_view rest = tag.substr(shape + kShape.size());
    std::vector<double> numbers = numbers_in(rest.substr(0, rest.find('"')));
    for (double& number : numbers) number = std::round(number * 100.0);
    builder.add(ItemKind::polygon, {ring_of(numbers)});
  }
  return builder.finish();
}

std::optional<Scene> read_any_scene(const std::filesystem::path& name) {
  const std::string ending = name.extension().string();
  const std::string stem = name.stem().string();
  if (ending == ".poly" || ending == ".node") return read_scene(name.string()).value();
  if (ending == ".xml") return read_sumo(read_file(name));
  if (ending == ".json" || ending == ".geojson") return read_json(read_file(name));
  if (ending == ".txt" && name.parent_path().filename() == "cdt") return read_cdt(read_file(name));
  if (ending != ".dat" || stem.ends_with("_hole") || stem.ends_with("_holes") || stem.ends_with("_steiner")) {
    return std::nullopt;
  }
  return read_poly2tri(read_file(name), partner_of(name, {"_hole.dat", "_holes.dat"}),
                       partner_of(name, {"_steiner.dat"}));
}

}  // namespace waywright::test

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "formats/geojson.hpp"
#include "formats/write_geojson.hpp"
#include "support/case_count.hpp"
#include "support/data_folder.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;

/// The hash of the items and the hash of the mesh.
using Hashes = std::pair<ItemsHash, MeshHash>;

Hashes hashes_of(const Scene& scene) {
  World world = World::create(scene.domain).value();
  for (const Item& item : scene.items) static_cast<void>(world.insert(item.shape, item.id));
  return {world.items_hash(), world.mesh_hash()};
}

/// Expects that a scene is the same world after it has been written as GeoJSON and read.
void expect_round_trip(const Scene& scene) {
  const std::string text = formats::to_geojson(scene);
  const Result<Scene> copy = formats::parse_geojson(text, "copy");
  ASSERT_TRUE(copy.ok()) << copy.error().message();
  EXPECT_EQ(copy->domain, scene.domain);
  EXPECT_EQ(copy->y_down, scene.y_down);
  EXPECT_EQ(copy->items.size(), scene.items.size());
  EXPECT_EQ(hashes_of(*copy), hashes_of(scene));
  EXPECT_EQ(formats::to_geojson(*copy), text);
}

std::vector<fs::path> files_in(const fs::path& folder, std::string_view ending) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  return files;
}

TEST(GeoJsonRoundTrip, EveryScriptOfTheTestsAndEveryBundledMapKeepsItsHashes) {
  const fs::path root(WAYWRIGHT_SOURCE_DIR);
  std::vector<fs::path> files = files_in(root / "tests/scripts", ".wws");
  const std::vector<fs::path> maps = files_in(root / "examples/maps", ".wws");
  ASSERT_GE(files.size(), 30U);
  ASSERT_GE(maps.size(), 2U);
  files.insert(files.end(), maps.begin(), maps.end());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    expect_round_trip(read_scene(file.string()).value());
  }
}

TEST(GeoJsonRoundTrip, RandomScenesKeepTheirHashes) {
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 1; seed <= case_count() / 5 + 1; ++seed) {
      SCOPED_TRACE(std::string(to_string(flavour)) + ", seed " + std::to_string(seed));
      expect_round_trip(random_scene(flavour, seed, 20));
    }
  }
}

TEST(GeoJsonRoundTrip, ShortRingsAndLinesKeepTheirHashes) {
  const Scene scene{.domain = {{0, 0}, {9, 9}},
                    .items = {{1, Shape::polyline(std::vector<Point>{{1, 1}})},
                              {2, Shape::segment({2, 2}, {2, 2})},
                              {3, Shape::polygon({{3, 3}})},
                              {4, Shape::polygon({{4, 4}, {5, 5}})},
                              {5, Shape::polyline(std::vector<Point>{{6, 6}, {7, 7}})},
                              {ItemId::kLargest, Shape::point({-0.0, 8})}},
                    .y_down = true};
  expect_round_trip(scene);
  const nlohmann::json json = nlohmann::json::parse(formats::to_geojson(scene));
  EXPECT_EQ(json["features"][0]["geometry"]["coordinates"], nlohmann::json::parse("[[1,1],[1,1]]"));
  EXPECT_EQ(json["features"][2]["geometry"]["coordinates"], nlohmann::json::parse("[[[3,3],[3,3],[3,3],[3,3]]]"));
  EXPECT_EQ(json["features"][3]["geometry"]["coordinates"], nlohmann::json::parse("[[[4,4],[5,5],[5,5],[4,4]]]"));
}

Point point_of(const nlohmann::json& position) {
  EXPECT_EQ(position.size(), 2U);
  return {position.at(0).get<double>(), position.at(1).get<double>()};
}

/// Reads the coordinates of a feature with another parser: nlohmann's tree, and the C library's numbers.
std::vector<std::vector<Point>> rings_of(const nlohmann::json& feature) {
  const nlohmann::json& coordinates = feature.at("geometry").at("coordinates");
  const std::string type = feature.at("geometry").at("type");
  if (type == "Point") return {{point_of(coordinates)}};
  std::vector<std::vector<Point>> rings;
  for (const nlohmann::json& ring : type == "Polygon" ? coordinates : nlohmann::json::array({coordinates})) {
    std::vector<Point>& points = rings.emplace_back();
    for (const nlohmann::json& position : ring) points.push_back(point_of(position));
    if (type != "Polygon") continue;
    EXPECT_GE(points.size(), 4U);
    EXPECT_EQ(points.front(), points.back());
    points.pop_back();
  }
  return rings;
}

TEST(WriteGeoJson, AnotherParserReadsTheSameCoordinates) {
  for (const Flavour flavour : kFlavours) {
    const Scene scene = random_scene(flavour, 11, 60);
    const nlohmann::json json = nlohmann::json::parse(formats::to_geojson(scene));
    EXPECT_EQ(json["type"], "FeatureCollection");
    ASSERT_EQ(json["features"].size(), scene.items.size());
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
      const nlohmann::json& feature = json["features"][i];
      EXPECT_EQ(feature["type"], "Feature");
      EXPECT_EQ(feature["id"].get<std::uint64_t>(), scene.items[i].id.value);
      std::vector<std::vector<Point>> expected = scene.items[i].shape.rings;
      const std::size_t least = scene.items[i].shape.kind == ItemKind::polygon    ? 3
                                : scene.items[i].shape.kind == ItemKind::polyline ? 2
                                                                                  : 1;
      for (std::vector<Point>& ring : expected) {
        while (ring.size() < least) ring.push_back(ring.back());
      }
      EXPECT_EQ(rings_of(feature), expected) << i;
    }
  }
}

TEST(WriteGeoJson, TheTextOfASmallSceneIsThis) {
  const Scene scene{
      .domain = {{-1, 0}, {10, 10.5}},
      .items = {{3, Shape::point({0.1, 1e-7})}, {4, Shape::polygon({{1, 1}, {2, 1}, {2, 2}}, FillRule::nonzero)}}};
  EXPECT_EQ(formats::to_geojson(scene),
            R"({"type":"FeatureCollection","waywright":{"domain":[-1,0,10,10.5]},"features":[
{"type":"Feature","id":3,"properties":{"waywright":"point"},"geometry":{"type":"Point","coordinates":[0.1,1e-07]}},
{"type":"Feature","id":4,"properties":{"waywright":"polygon nonzero"},"geometry":{"type":"Polygon","coordinates":[[[1,1],[2,1],[2,2],[1,1]]]}}
]}
)");
}

TEST(WriteGeoJson, TheMeshIsItsTrianglesAndItsConstrainedEdges) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_segment({2, 5}, {8, 5}, 1).value();
  world.insert_segment({4, 5}, {8, 5}, 2).value();
  formats::GeoJsonWriter writer(world.domain(), false);
  writer.add_mesh(world.snapshot());
  const std::string text = writer.take();
  const nlohmann::json json = nlohmann::json::parse(text);
  double doubled_area = 0.0;
  std::size_t triangles = 0;
  std::vector<nlohmann::json> edges;
  for (const nlohmann::json& feature : json["features"]) {
    if (feature["properties"]["waywright"] == "edge") {
      edges.push_back(feature);
      continue;
    }
    ++triangles;
    const std::vector<Point> ring = rings_of(feature).at(0);
    ASSERT_EQ(ring.size(), 3U);
    const double area =
        (ring[1].x - ring[0].x) * (ring[2].y - ring[0].y) - (ring[2].x - ring[0].x) * (ring[1].y - ring[0].y);
    EXPECT_GT(area, 0.0);
    doubled_area += area;
  }
  // By Euler's formula: 7 vertices, of which 4 lie on the hull.
  EXPECT_EQ(triangles, 8U);
  EXPECT_EQ(doubled_area, 200.0);
  ASSERT_EQ(edges.size(), 6U);
  std::size_t of_both = 0;
  for (const nlohmann::json& edge : edges)
    of_both += edge["properties"]["items"] == nlohmann::json::array({1, 2}) ? 1U : 0U;
  EXPECT_EQ(of_both, 1U);
  // The features of a mesh are no items.
  EXPECT_EQ(formats::parse_geojson(text, "mesh").value(), (Scene{.domain = world.domain(), .items = {}}));
}

}  // namespace
}  // namespace waywright::test

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

/// A wall from (4, 0) to (4, 7) in each format. Each file also has a point at (0, 0) and one at (8, 8).
struct WallFile {
  std::string name;
  std::string text;
};

std::vector<WallFile> wall_files() {
  return {{"wall.geojson",
           R"({"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[4,0],[4,7]]},
              {"type":"MultiPoint","coordinates":[[0,0],[8,8]]}]})"},
          {"wall.json", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":
              {"type":"LineString","coordinates":[[4,0],[4,7]]}},{"type":"Feature","properties":{},"geometry":
              {"type":"MultiPoint","coordinates":[[0,0],[8,8]]}}]})"},
          {"wall.wkt", "LINESTRING(4 0, 4 7)\nMULTIPOINT(0 0, 8 8)\n"},
          {"wall.obj", "v 4 0\nv 4 7\nv 0 0\nv 8 8\nl 1 2\np 3 4\n"},
          {"wall.wws", "waywright 1\ndomain -1 -1 9 9\nsegment 1 4 0 4 7\npoint 2 0 0\npoint 3 8 8\n"}};
}

TEST(Formats, EachFormatGivesTheSameDump) {
  const TemporaryFolder folder;
  std::vector<std::string> dumps;
  for (const auto& [name, text] : wall_files()) {
    const std::string file = folder.file(name, text);
    ASSERT_EQ(run_command({"convert", file, folder.file(name + ".wws")}).status, 0) << name;
    const CommandResult from_script = run_command({"run", folder.file(name + ".wws"), "--dump", "-", "--check"});
    const CommandResult from_map = run_command({"run", file, "--dump", "-", "--check"});
    EXPECT_EQ(from_map.status, 0) << from_map.err;
    EXPECT_EQ(from_map.out, from_script.out) << name;
    dumps.push_back(from_map.out);
  }
  for (const std::string& dump : dumps) EXPECT_EQ(dump, dumps.back());
  EXPECT_NE(dumps.back().find("vertices 8\n"), std::string::npos);
}

/// The only path from (1, 1) to (7, 1) passes the end of the wall at (4, 0) or at (4, 7). The nearer end is (4, 0).
TEST(Formats, PathReadsEachFormat) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : wall_files()) {
    const CommandResult result = run_command(
        {"path", folder.file(name, text), "--from", "1", "1", "--to", "7", "1", "--svg", folder.file("a.svg")});
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json answer = json_lines(result.out).at(0);
    EXPECT_EQ(answer["pieces"], nlohmann::json::parse(R"([{"line":[1,1,4,0]},{"line":[4,0,7,1]}])")) << name;
    EXPECT_NE(read_file(folder.file("a.svg")).find("<svg"), std::string::npos);
  }
}

TEST(Formats, PathReadsAPolyanyaMesh) {
  const TemporaryFolder folder;
  // The square [0, 4] x [0, 2], and the square [2, 4] x [2, 4] on it.
  const std::string right = folder.file("r.mesh",
                                        "mesh\n2\n7 2\n0 0 2 0 -1\n4 0 2 0 -1\n4 2 3 0 -1 1\n2 2 3 0 1 -1\n4 4 2 1 -1\n"
                                        "2 4 2 1 -1\n0 2 2 0 -1\n5 0 1 2 3 6 -1 -1 -1 1 -1\n4 3 2 4 5 -1 0 -1 -1\n");
  const CommandResult result = run_command({"path", right, "--from", "0.5", "1", "--to", "2.5", "4"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0)["pieces"],
            nlohmann::json::parse(R"([{"line":[0.5,1,2,2]},{"line":[2,2,2.5,4]}])"));
  const CommandResult blocked = run_command({"path", right, "--from", "1", "3", "--to", "3", "3"});
  EXPECT_EQ(json_lines(blocked.out).at(0)["reason"], "start-blocked");
}

TEST(Formats, ConvertWritesGeoJsonThatReadsBackAsTheSameWorld) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.map", "type octile\nheight 3\nwidth 4\nmap\n@@@.\n@.@.\n@@@@\n");
  ASSERT_EQ(run_command({"convert", map, folder.file("a.geojson")}).status, 0);
  ASSERT_EQ(run_command({"convert", folder.file("a.geojson"), folder.file("b.json")}).status, 0);
  EXPECT_EQ(read_file(folder.file("a.geojson")), read_file(folder.file("b.json")));
  const nlohmann::json json = nlohmann::json::parse(read_file(folder.file("a.geojson")));
  EXPECT_EQ(json["waywright"]["domain"], nlohmann::json::parse("[0,0,4,3]"));
  EXPECT_EQ(json["waywright"]["y_down"], true);
  ASSERT_EQ(run_command({"convert", map, folder.file("a.wws")}).status, 0);
  const std::string hash = "\nhash\n";
  std::ofstream(folder.file("a.wws"), std::ios::app) << hash;
  ASSERT_EQ(run_command({"convert", folder.file("b.json"), folder.file("b.wws")}).status, 0);
  std::ofstream(folder.file("b.wws"), std::ios::app) << hash;
  const CommandResult of_map = run_command({"run", folder.file("a.wws")});
  EXPECT_NE(of_map.out.find("\"mesh\""), std::string::npos);
  EXPECT_EQ(run_command({"run", folder.file("b.wws")}).out, of_map.out);
}

TEST(Formats, GeoJsonIsReadFromStandardInputAndWrittenToStandardOutput) {
  const std::string text = wall_files()[0].text;
  const CommandResult converted = run_command({"convert", "-", "-", "--format", "geojson"}, "\n " + text);
  ASSERT_EQ(converted.status, 0) << converted.err;
  EXPECT_EQ(nlohmann::json::parse(converted.out)["features"].size(), 3U);
  const CommandResult again = run_command({"convert", "-", "-", "--format", "geojson"}, converted.out);
  EXPECT_EQ(again.out, converted.out);
  const CommandResult run = run_command({"run", "-", "--dump", "-"}, converted.out);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("vertices 8\n"), std::string::npos);
  const CommandResult broken = run_command({"convert", "-", "-"}, "\xef\xbb\xbf{\n5}");
  EXPECT_EQ(broken.status, 2);
  EXPECT_EQ(broken.err.find("-:2: the JSON text cannot be read"), 0U) << broken.err;
}

TEST(Formats, ConvertWritesTheMesh) {
  const TemporaryFolder folder;
  const std::string wall = folder.file("wall.wkt", wall_files()[2].text);
  const CommandResult result = run_command({"convert", wall, "-", "--format", "geojson-mesh"});
  ASSERT_EQ(result.status, 0) << result.err;
  // By Euler's formula: 8 vertices, of which 4 lie on the hull. The wall and the border are the constrained edges.
  EXPECT_EQ(nlohmann::json::parse(result.out)["features"].size(), 10U + 5U);
}

TEST(Formats, PathWritesGeoJson) {
  const TemporaryFolder folder;
  const std::string wall = folder.file("wall.wkt", wall_files()[2].text);
  const std::vector<std::string> ask{"path", wall, "--from", "1", "1", "--to", "7", "1", "--geojson", "-"};
  const CommandResult point = run_command(ask);
  ASSERT_EQ(point.status, 0) << point.err;
  const nlohmann::json feature = nlohmann::json::parse(point.out)["features"].at(0);
  EXPECT_EQ(feature["geometry"], nlohmann::json::parse(R"({"type":"LineString","coordinates":[[1,1],[4,0],[7,1]]})"));
  EXPECT_EQ(feature["properties"]["length"].get<double>(), 2.0 * std::sqrt(10.0));
  EXPECT_EQ(json_lines(point.err).at(0)["found"], true);

  std::vector<std::string> ask_for_disc = ask;
  ask_for_disc.insert(ask_for_disc.end(), {"--radius", "0.5"});
  const nlohmann::json disc = nlohmann::json::parse(run_command(ask_for_disc).out)["features"].at(0);
  const nlohmann::json& line = disc["geometry"]["coordinates"];
  EXPECT_GT(line.size(), 4U);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double distance = std::hypot(line[i][0].get<double>() - 4.0, line[i][1].get<double>());
    EXPECT_GT(distance, 0.5 - 1e-9);
  }

  std::vector<std::string> ask_for_giant = ask;
  ask_for_giant.insert(ask_for_giant.end(), {"--radius", "1.5"});
  const nlohmann::json none = nlohmann::json::parse(run_command(ask_for_giant).out)["features"].at(0);
  EXPECT_EQ(none["properties"]["found"], false);
  EXPECT_EQ(none["geometry"], nlohmann::json::parse(R"({"type":"MultiPoint","coordinates":[[1,1],[7,1]]})"));
}

TEST(Formats, RunWritesItemsAndPathsAndReadsBackOnlyItems) {
  const TemporaryFolder folder;
  const std::string script = folder.file(
      "a.wws",
      "waywright 1\ndomain 0 0 10 10\npath 1 1 2 2 0\npolygon 7 nonzero 4 3 3 6 3 6 6 3 6\nsegment 9 0 8 10 8\n"
      "path 1 1 7 1 0\npath 1 1 1 9 0\n");
  ASSERT_EQ(run_command({"run", script, "--geojson", folder.file("a.geojson")}).status, 0);
  const nlohmann::json json = nlohmann::json::parse(read_file(folder.file("a.geojson")));
  std::vector<std::string> kinds;
  for (const nlohmann::json& feature : json["features"]) kinds.push_back(feature["properties"]["waywright"]);
  EXPECT_EQ(kinds, (std::vector<std::string>{"polygon nonzero", "segment", "path", "path"}));
  EXPECT_EQ(json["features"][2]["geometry"]["coordinates"], nlohmann::json::parse("[[1,1],[7,1]]"));
  EXPECT_EQ(json["features"][3]["properties"]["reason"], "no-path");
  const CommandResult back = run_command({"convert", folder.file("a.geojson"), "-"});
  EXPECT_EQ(back.out, "waywright 1\ndomain 0 0 10 10\npolygon 7 nonzero 4 3 3 6 3 6 6 3 6\nsegment 9 0 8 10 8\n");
}

TEST(Formats, SavedWorldsAndPicturesComeFromEachFormat) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : wall_files()) {
    const std::string file = folder.file(name, text);
    ASSERT_EQ(run_command({"convert", file, folder.file("a.wwb")}).status, 0) << name;
    ASSERT_EQ(run_command({"convert", file, folder.file("a.svg")}).status, 0) << name;
    const CommandResult run = run_command({"run", folder.file("a.wwb"), "--dump", "-"});
    EXPECT_EQ(run.out, run_command({"run", file, "--dump", "-"}).out) << name;
  }
}

TEST(Formats, AnUnknownEndingIsRefusedWithAllKnownOnes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.shp", "x");
  const CommandResult result = run_command({"convert", file, folder.file("a.wws")});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, file +
                            ": expected a file name that ends in .wws, .wwb, .map, .poly or .node, or in .geojson, " +
                            ".json, .wkt, .mesh or .obj\n");
}

TEST(Formats, NoOutputOverwritesAnInput) {
  const TemporaryFolder folder;
  const std::string wall = folder.file("wall.geojson", wall_files()[0].text);
  const CommandResult path = run_command({"path", wall, "--from", "1", "1", "--to", "7", "1", "--geojson", wall});
  EXPECT_EQ(path.status, 2);
  EXPECT_NE(path.err.find("--geojson would write to"), std::string::npos) << path.err;
  EXPECT_EQ(run_command({"run", wall, "--geojson", wall}).status, 2);
  EXPECT_EQ(run_command({"convert", wall, wall}).status, 2);
  EXPECT_EQ(read_file(wall), wall_files()[0].text);
}

/// Reads GeoJSON with Shapely and Python's json, and prints the type, the coordinates as exact hexadecimal numbers and
/// the area of each feature.
constexpr const char* kShapely = R"(
import json, sys
from shapely.geometry import shape
for feature in json.load(open(sys.argv[1]))["features"]:
    geometry = shape(feature["geometry"])
    parts = [geometry.exterior] + list(geometry.interiors) if geometry.geom_type == "Polygon" else [geometry]
    points = [" ".join(x.hex() for x in point) for part in parts for point in part.coords]
    print(geometry.geom_type, geometry.area, geometry.is_valid, *points, sep=",")
)";

/// Returns the name of a Python that has Shapely, or nothing. Debian's package is for the Python in /usr/bin.
std::string python_with_shapely() {
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (run_program(python, {"-c", "import shapely"}).status == 0) return python;
  }
  return {};
}

TEST(Formats, ShapelyReadsTheSameCoordinates) {
  const std::string python = python_with_shapely();
  if (python.empty()) GTEST_SKIP() << "Python has no module shapely (Debian: python3-shapely)";
  const TemporaryFolder folder;
  const std::string script = folder.file("a.wws",
                                         "waywright 1\ndomain -1e9 -1e9 1e9 1e9\npoint 1 0.1 -1e-7\nsegment 2 1 2 3 4\n"
                                         "polyline 3 3 0.3 0.7 123456789.01234568 5e-20 4 4\n"
                                         "polygon 4 4 0 0 8 0 8 8 0 8 / 4 2 2 2 4 4 4 4 2\n");
  ASSERT_EQ(run_command({"convert", script, folder.file("a.geojson")}).status, 0);
  const CommandResult shapely = run_program(python, {"-c", kShapely, folder.file("a.geojson")});
  ASSERT_EQ(shapely.status, 0) << shapely.err;
  // The compiler rounds these numbers.
  const std::vector<std::vector<std::vector<double>>> lines{
      {{0.1, -1e-7}},
      {{1, 2}, {3, 4}},
      {{0.3, 0.7}, {123456789.01234568, 5e-20}, {4, 4}},
      {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}};
  const std::vector<std::string> heads{"Point,0.0,True", "LineString,0.0,True", "LineString,0.0,True",
                                       "Polygon,60.0,True"};
  std::istringstream out(shapely.out);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line;
    ASSERT_TRUE(std::getline(out, line));
    ASSERT_EQ(line.substr(0, heads[i].size()), heads[i]);
    std::istringstream points(line.substr(heads[i].size()));
    for (const std::vector<double>& point : lines[i]) {
      for (const double value : point) {
        points.ignore(1);  // a comma or a blank
        std::string word;
        while (points.peek() != ',' && points.peek() != ' ' && points.good()) word += static_cast<char>(points.get());
        EXPECT_EQ(std::strtod(word.c_str(), nullptr), value) << line;
      }
    }
    EXPECT_EQ(points.peek(), std::istringstream::traits_type::eof()) << line;
  }
}

}  // namespace
}  // namespace waywright::test

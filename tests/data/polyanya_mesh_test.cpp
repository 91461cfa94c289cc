#include "formats/polyanya_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "support/data_folder.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;

fs::path mesh_folder() { return data_folder() / "mesh" / "polyanya_v2"; }

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

World world_of(const Scene& scene) {
  World world = World::create(scene.domain).value();
  world.insert_all(scene.items).value();
  return world;
}

/// Twice the area that all rings enclose, each with the sign of its direction.
double doubled_area(const Rings& rings) {
  double doubled = 0.0;
  for (const PointSpan ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[(i + 1) % ring.size()];
      doubled += a.x * b.y - b.x * a.y;
    }
  }
  return doubled;
}

/// Twice the area of all polygons of a mesh. Reads the file without the reader that the test is about.
double doubled_area_of_polygons(const fs::path& file) {
  std::ifstream in(file);
  std::string word;
  std::size_t version = 0, vertex_count = 0, polygon_count = 0;
  in >> word >> version >> vertex_count >> polygon_count;
  const auto skip = [&](std::size_t count) {
    for (int ignored = 0; count > 0; --count) in >> ignored;
  };
  std::vector<Point> vertices(vertex_count);
  for (Point& vertex : vertices) {
    std::size_t count = 0;
    in >> vertex.x >> vertex.y >> count;
    skip(count);
  }
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon_count; ++i) {
    std::size_t count = 0;
    in >> count;
    std::vector<Point> ring;
    for (std::size_t corner = 0; corner < count; ++corner) {
      std::size_t vertex = 0;
      in >> vertex;
      ring.push_back(vertices.at(vertex));
    }
    skip(count);
    doubled += doubled_area(Rings(std::move(ring)));
  }
  EXPECT_FALSE(in.fail()) << file;
  return doubled;
}

TEST(PolyanyaMeshes, TheBorderEnclosesTheAreaOfAllPolygons) {
  if (!fs::exists(mesh_folder())) GTEST_SKIP() << "no folder " << mesh_folder() << "; set WAYWRIGHT_DATA";
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(mesh_folder())) {
    if (entry.path().extension() != ".mesh") continue;
    SCOPED_TRACE(entry.path().string());
    const Result<Scene> scene = formats::parse_polyanya_mesh(text_of(entry.path()), "mesh");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    const Rings& rings = scene->items.at(0).shape.rings;
    Rings border;
    for (std::size_t i = 1; i < rings.size(); ++i) border.push_back(rings[i]);
    const double area = doubled_area_of_polygons(entry.path());
    EXPECT_NEAR(doubled_area(border), area, 1e-12 * area);
    EXPECT_GT(area, 0.0);
    ++count;
  }
  EXPECT_GE(count, 5U);
}

/// Expects the lengths that a scenario gives for paths through a mesh.
void expect_lengths(const fs::path& mesh, const fs::path& scenario, std::size_t step) {
  if (!fs::exists(mesh) || !fs::exists(scenario)) GTEST_SKIP() << "no " << mesh << " or no " << scenario;
  const World world = world_of(formats::parse_polyanya_mesh(text_of(mesh), "mesh").value());
  std::ifstream in(scenario);
  std::size_t number = 0;
  std::size_t asked = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string bucket, map, width, height;
    Point start, goal;
    double length = 0.0;
    if (!(fields >> bucket >> map >> width >> height >> start.x >> start.y >> goal.x >> goal.y >> length)) continue;
    if (number++ % step != 0) continue;
    const Path path = world.find_path({.start = start, .goal = goal}).value();
    ASSERT_EQ(path.status, PathStatus::found) << line;
    EXPECT_NEAR(path.length, length, 1e-6 * std::max(1.0, length)) << line;
    ++asked;
  }
  EXPECT_GT(asked, 10U);
}

TEST(PolyanyaMeshes, PathsThroughArenaHaveTheKnownLengths) {
  expect_lengths(mesh_folder() / "arena.mesh", data_folder() / "grid/anyangle/arena.anyangle.scen", 1);
}

TEST(PolyanyaMeshes, PathsThroughMergedArenaHaveTheKnownLengths) {
  expect_lengths(mesh_folder() / "arena-merged.mesh", data_folder() / "grid/anyangle/arena.anyangle.scen", 1);
}

TEST(PolyanyaMeshes, PathsThroughAuroraHaveTheKnownLengths) {
  expect_lengths(mesh_folder() / "aurora.mesh", data_folder() / "grid/anyangle/Aurora.anyangle.scen", 20);
}

}  // namespace
}  // namespace waywright::test

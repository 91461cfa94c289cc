#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "support/data_folder.hpp"

namespace waywright::test {
namespace {

struct Query {
  Point start;
  Point goal;
  double shortest = 0.0;
};

/// The lines of a scenario file: bucket, map, width, height, start, goal, length.
std::vector<Query> read_scenario(const std::filesystem::path& file) {
  std::vector<Query> queries;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string bucket, map, width, height;
    Query query;
    fields >> bucket >> map >> width >> height >> query.start.x >> query.start.y >> query.goal.x >> query.goal.y >>
        query.shortest;
    if (fields) queries.push_back(query);
  }
  return queries;
}

struct MapCase {
  const char* name;
  const char* map;
  std::size_t query_count;
};

class MapPaths : public testing::TestWithParam<MapCase> {};

INSTANTIATE_TEST_SUITE_P(Maps, MapPaths,
                         testing::Values(MapCase{"arena", "dao/arena.map", 160},
                                         MapCase{"brc202d", "dao/brc202d.map", 2519},
                                         MapCase{"AR0500SR", "bgmaps/AR0500SR.map", 200},
                                         MapCase{"AcrosstheCape", "sc1/AcrosstheCape.map", 201}),
                         [](const auto& map) { return std::string(map.param.name); });

// The lengths given are the shortest there are, each computed by two independent solvers.
TEST_P(MapPaths, AreFoundNeverShorterThanTheShortestAndHardlyLonger) {
  const std::filesystem::path folder = data_folder() / "grid";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  const Scene scene = read_scene((folder / GetParam().map).string()).value();
  World world = World::create(scene.domain).value();
  for (const Item& item : scene.items) ASSERT_TRUE(world.insert(item.shape, item.id).ok());
  ASSERT_TRUE(world.validate().ok);

  const std::vector<Query> queries =
      read_scenario(folder / "anyangle" / (std::string(GetParam().name) + ".anyangle.scen"));
  ASSERT_EQ(queries.size(), GetParam().query_count);
  QueryContext context;
  Path path;
  double ratios = 0.0;
  for (const Query& query : queries) {
    world.find_path({query.start, query.goal}, context, path).value();
    ASSERT_EQ(path.status, PathStatus::found);
    ASSERT_GE(path.length, query.shortest * (1 - 1e-9));
    ratios += query.shortest > 0.0 ? path.length / query.shortest : 1.0;
  }
  EXPECT_LE(ratios / static_cast<double>(queries.size()), 1.02);
}

}  // namespace
}  // namespace waywright::test

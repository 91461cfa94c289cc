#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "support/data_folder.hpp"

namespace waywright::test {
namespace {

/// The precision of the lengths in the file, which have nine decimals or more.
constexpr double kPrecision = 0.5e-9;

struct Query {
  Point start;
  Point goal;
  double shortest = 0.0;
};

/// Reads the lines of a scenario file: bucket, map, width, height, start, goal, length.
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

struct PathMapCase {
  const char* name;
  const char* map;
  std::size_t query_count;
};

void PrintTo(const PathMapCase& map, std::ostream* out) { *out << map.name; }

/// The world of a map, its tiles and its queries.
struct Loaded {
  World world;
  std::vector<std::string> tiles;
  std::vector<Query> queries;
};

Loaded load(const std::filesystem::path& folder, const PathMapCase& map) {
  const Scene scene = read_scene((folder / map.map).string()).value();
  Loaded loaded{World::create(scene.domain).value(), {}, {}};
  for (const Item& item : scene.items) loaded.world.insert(item.shape, item.id).value();
  std::ifstream in(folder / map.map);
  std::string line;
  while (std::getline(in, line) && line != "map") {
  }
  while (std::getline(in, line)) loaded.tiles.push_back(line);
  loaded.queries =
      read_scenario(folder / "anyangle" / (std::filesystem::path(map.map).stem().string() + ".anyangle.scen"));
  return loaded;
}

/// Returns whether exactly two blocked and two free tiles meet diagonally at the lattice point `p`. The scenario takes
/// such an end to be in its own tile, at the lower right. A world takes it to be in both free tiles.
bool is_ambiguous(const std::vector<std::string>& tiles, Point p) {
  const auto is_free = [&](double x, double y) {
    if (x < 0 || y < 0 || y >= static_cast<double>(tiles.size())) return false;
    const std::string& row = tiles[static_cast<std::size_t>(y)];
    if (x >= static_cast<double>(row.size())) return false;
    const char tile = row[static_cast<std::size_t>(x)];
    return tile == '.' || tile == 'G' || tile == 'S';
  };
  const bool here = is_free(p.x, p.y);
  return here == is_free(p.x - 1, p.y - 1) && here != is_free(p.x - 1, p.y) && here != is_free(p.x, p.y - 1);
}

class MapPaths : public testing::TestWithParam<PathMapCase> {};

INSTANTIATE_TEST_SUITE_P(Maps, MapPaths,
                         testing::Values(PathMapCase{"arena", "dao/arena.map", 160},
                                         PathMapCase{"brc202d", "dao/brc202d.map", 2519},
                                         PathMapCase{"AR0500SR", "bgmaps/AR0500SR.map", 200},
                                         PathMapCase{"AcrosstheCape", "sc1/AcrosstheCape.map", 201},
                                         PathMapCase{"Aurora", "sc1/Aurora.map", 2990},
                                         PathMapCase{"maze512", "mazes/maze512-2-5.map", 200},
                                         PathMapCase{"random512", "random/random512-20-0.map", 200}),
                         [](const auto& map) { return std::string(map.param.name); });

// Two independent solvers computed each length in the file, and it is the length of a shortest path.
TEST_P(MapPaths, AreAsLongAsThoseOfOtherSolvers) {
  const std::filesystem::path folder = data_folder() / "grid";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  const Loaded map = load(folder, GetParam());
  ASSERT_TRUE(map.world.validate().ok);
  ASSERT_EQ(map.queries.size(), GetParam().query_count);
  QueryContext context;
  Path path;
  double ratios = 0.0;
  std::size_t ambiguous = 0;
  for (std::size_t i = 0; i < map.queries.size(); ++i) {
    const Query& query = map.queries[i];
    const double slack = 1e-9 * query.shortest + kPrecision;
    PathQuery asked{query.start, query.goal};
    asked.algorithm = PathAlgorithm::optimal;
    map.world.find_path(asked, context, path).value();
    ASSERT_EQ(path.status, PathStatus::found) << "query " << i;
    double shortest = query.shortest;
    if (is_ambiguous(map.tiles, query.start) || is_ambiguous(map.tiles, query.goal)) {
      ++ambiguous;
      std::cout << "query " << i << " has an ambiguous end: " << path.length << ", given " << query.shortest << '\n';
      EXPECT_LE(path.length, query.shortest + slack) << "query " << i;
      shortest = path.length;
    } else {
      EXPECT_NEAR(path.length, query.shortest, slack) << "query " << i;
    }
    asked.algorithm = PathAlgorithm::ta;
    map.world.find_path(asked, context, path).value();
    ASSERT_EQ(path.status, PathStatus::found) << "query " << i;
    ASSERT_GE(path.length, shortest - slack) << "query " << i;
    ratios += shortest > 0.0 ? path.length / shortest : 1.0;
  }
  EXPECT_LE(ratios / static_cast<double>(map.queries.size()), 1.02);
  std::cout << ambiguous << " queries with ambiguous ends; ta: " << ratios / static_cast<double>(map.queries.size())
            << " times the shortest\n";
}

// `ta` enters each edge once, so it may run out of passages before it proves that its path is the shortest. The path's
// lower bound tells whether it has proven it; a proven path must be a shortest path.
TEST_P(MapPaths, ByTaAreTheShortestWhereProven) {
  const std::filesystem::path folder = data_folder() / "grid";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  const Loaded map = load(folder, GetParam());
  QueryContext context;
  Path path;
  std::size_t proven = 0;
  std::size_t shortest = 0;
  for (std::size_t i = 0; i < map.queries.size(); ++i) {
    const Query& query = map.queries[i];
    if (is_ambiguous(map.tiles, query.start) || is_ambiguous(map.tiles, query.goal)) continue;
    PathQuery asked{query.start, query.goal};
    asked.algorithm = PathAlgorithm::ta;
    asked.budget.expansions = PathBudget::kNoLimit;
    map.world.find_path(asked, context, path).value();
    ASSERT_EQ(path.status, PathStatus::found) << "query " << i;
    const double slack = 1e-9 * query.shortest + kPrecision;
    EXPECT_GE(path.length, query.shortest - slack) << "query " << i;
    EXPECT_LE(path.lower_bound, query.shortest + slack) << "query " << i;
    shortest += path.length <= query.shortest + slack ? 1U : 0U;
    if (path.lower_bound < path.length) continue;
    ++proven;
    EXPECT_NEAR(path.length, query.shortest, slack) << "query " << i;
  }
  EXPECT_GT(proven, 0U);
  std::cout << "ta, as far as it goes: " << shortest << " of " << map.queries.size() << " are the shortest, " << proven
            << " proven\n";
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scenario.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/data_folder.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_paths.hpp"

namespace waywright::test {
namespace {

struct MapCase {
  const char* name;
  const char* map;
  std::size_t query_count;
};

void PrintTo(const MapCase& map, std::ostream* out) { *out << map.name; }

class MapDiscPaths : public testing::TestWithParam<MapCase> {};

INSTANTIATE_TEST_SUITE_P(Maps, MapDiscPaths,
                         testing::Values(MapCase{"arena", "dao/arena.map", 160},
                                         MapCase{"brc202d", "dao/brc202d.map", 2519},
                                         MapCase{"AR0500SR", "bgmaps/AR0500SR.map", 200},
                                         MapCase{"Aurora", "sc1/Aurora.map", 2990}),
                         [](const auto& map) { return std::string(map.param.name); });

/// All sides of the items of a scene, and the four sides of its domain.
disc::Walls walls_of(const Scene& scene) {
  disc::Walls walls;
  const auto add_ring = [&](std::span<const Point> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) walls.segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const Item& item : scene.items) {
    for (const auto& ring : item.shape.rings) add_ring(ring);
  }
  const Box& box = scene.domain;
  add_ring(std::vector<Point>{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}});
  return walls;
}

std::vector<ScenarioQuery> read_queries(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return parse_movingai_scenario(text.str(), file.string()).value();
}

/// Returns the walls that may be nearer to a piece than 1.01 radii: those whose box is not farther from its box.
disc::Walls walls_near(const disc::Walls& walls, const std::vector<disc::Piece>& pieces, double radius) {
  std::vector<Box> boxes;
  for (const disc::Piece& piece : pieces) {
    const double reach = 1.01 * radius + (piece.is_arc ? piece.radius : 0.0);
    const Point a = piece.is_arc ? piece.centre : piece.from;
    const Point b = piece.is_arc ? piece.centre : piece.to;
    boxes.push_back({{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
                     {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}});
  }
  disc::Walls result;
  for (const auto& [p, q] : walls.segments) {
    const bool is_near = std::any_of(boxes.begin(), boxes.end(), [p = p, q = q](const Box& box) {
      return std::max(p.x, q.x) >= box.min.x && std::min(p.x, q.x) <= box.max.x && std::max(p.y, q.y) >= box.min.y &&
             std::min(p.y, q.y) <= box.max.y;
    });
    if (is_near) result.segments.emplace_back(p, q);
  }
  return result;
}

/// The results of one radius.
struct Count {
  std::size_t found = 0;
  std::size_t no_path = 0;
  std::size_t blocked = 0;
  double worst_ratio = 1.0;  ///< of the length by `tra` to the shortest length
};

class Checker {
 public:
  Checker(const std::filesystem::path& folder, const MapCase& map)
      : scene_(read_scene((folder / map.map).string()).value()),
        walls_(walls_of(scene_)),
        world_(World::create(scene_.domain, {.keep_bridges = true}).value()) {
    world_.insert_all(scene_.items).value();
  }

  /// Asks one query with `optimal` and `tra`, and checks both paths against all walls.
  void check(const ScenarioQuery& query, double radius, Count& count) {
    const Path& shortest = find(query, radius, PathAlgorithm::optimal);
    if (shortest.status != PathStatus::found) {
      ++(shortest.status == PathStatus::no_path ? count.no_path : count.blocked);
      EXPECT_EQ(find(query, radius, PathAlgorithm::tra).status, shortest.status);
      return;
    }
    ++count.found;
    const double length = shortest.length;
    const Path& quick = find(query, radius, PathAlgorithm::tra);
    ASSERT_EQ(quick.status, PathStatus::found);
    EXPECT_GE(quick.length, length * (1.0 - 1e-9));
    if (length > 0.0) count.worst_ratio = std::max(count.worst_ratio, quick.length / length);
  }

 private:
  const Path& find(const ScenarioQuery& query, double radius, PathAlgorithm algorithm) {
    PathQuery asked{.start = query.start, .goal = query.goal, .agent = {.radius = radius}, .end_tolerance = 0.0};
    asked.algorithm = algorithm;
    world_.find_path(asked, context_, path_).value();
    if (path_.status == PathStatus::found) {
      const std::vector<disc::Piece> pieces = disc::pieces_of(path_);
      const auto report = disc::check_path(walls_near(walls_, pieces, radius), query.start, query.goal, radius, pieces);
      EXPECT_EQ(report.fault, "");
      EXPECT_NEAR(report.length, path_.length, 1e-9 * std::max(1.0, path_.length));
    }
    return path_;
  }

  Scene scene_;
  disc::Walls walls_;
  World world_;
  QueryContext context_;
  Path path_;
};

// WAYWRIGHT_SCRIPTS is the number of queries of each map; the queries are in the middle of their tiles.
TEST_P(MapDiscPaths, KeepTheRadiusFromAllWalls) {
  const std::filesystem::path folder = data_folder() / "grid";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  const std::string name = std::filesystem::path(GetParam().map).stem().string();
  const std::vector<ScenarioQuery> queries = read_queries(folder / "anyangle" / (name + ".anyangle.scen"));
  ASSERT_EQ(queries.size(), GetParam().query_count);
  Checker checker(folder, GetParam());
  const std::size_t step = std::max<std::size_t>(1, queries.size() / case_count());
  for (const double radius : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    Count count;
    for (std::size_t i = 0; i < queries.size(); i += step) {
      SCOPED_TRACE("query " + std::to_string(i) + ", radius " + std::to_string(radius));
      ScenarioQuery query = queries[i];
      query.start = {query.start.x + 0.5, query.start.y + 0.5};
      query.goal = {query.goal.x + 0.5, query.goal.y + 0.5};
      checker.check(query, radius, count);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(count.found + count.blocked, 0U);
    std::cout << name << ", radius " << radius << ": " << count.found << " paths, " << count.no_path
              << " queries without a path, " << count.blocked << " with a blocked end; tra at most "
              << count.worst_ratio << " times the shortest\n";
  }
}

}  // namespace
}  // namespace waywright::test

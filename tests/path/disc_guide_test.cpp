#include "path/disc_guide.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/shortest_paths.hpp"
#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"
#include "support/oracle_adapter.hpp"
#include "support/wall_mesh.hpp"

namespace waywright::test {
namespace {

using disc::NamedScene;

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// Returns the scene as an input of the oracle for shortest paths. It also contains a wall for each bridge between two
/// ends of walls that is too narrow for the disc.
oracle::OracleScene scene_with_closed_bridges(const NamedScene& scene, const disc::Connectivity& connectivity,
                                              double radius) {
  oracle::OracleScene result{{oracle::to_oracle(scene.domain.min), oracle::to_oracle(scene.domain.max)}, {}};
  const auto add = [&](const Point& a, const Point& b) {
    if (a == b) return;
    result.items.push_back(
        {result.items.size() + 1, oracle::OracleKind::segment, {{oracle::to_oracle(a), oracle::to_oracle(b)}}, false});
  };
  for (const auto& [a, b] : scene.walls.segments) add(a, b);
  const disc::Rational square = disc::Rational(4) * disc::Rational(radius) * disc::Rational(radius);
  const auto to_point = [](const disc::RationalPoint& p) {
    return Point{p.x.convert_to<double>(), p.y.convert_to<double>()};
  };
  for (const disc::Bridge& bridge : connectivity.bridges()) {
    if (!bridge.is_foot && bridge.squared_length < square) add(to_point(bridge.from), to_point(bridge.to));
  }
  return result;
}

/// An end of a wall, and a position at which the disc touches it, except for rounding.
struct Touch {
  Point vertex;
  Point position;
};

/// Returns some random positions to which the disc can move from the start, and at which it touches an end of a wall.
std::vector<Touch> touches_of(const NamedScene& scene, const disc::Connectivity& connectivity, const Point& start,
                              double radius, Random& random) {
  constexpr std::size_t kTouches = 6;
  std::vector<Touch> touches;
  for (std::size_t i = 0; i < 8 * kTouches && touches.size() < kTouches; ++i) {
    const auto& wall = scene.walls.segments[random.below(scene.walls.segments.size())];
    if (wall.first == wall.second) continue;
    const Point vertex = random.below(2) == 0 ? wall.first : wall.second;
    const double angle = static_cast<double>(random.below(6283)) / 1000.0;
    const double reach = radius * (1.0 + 0x1p-20);
    const Point position{vertex.x + reach * std::cos(angle), vertex.y + reach * std::sin(angle)};
    if (!scene.domain.contains(position) || !connectivity.fits(position, radius)) continue;
    if (connectivity.connected(start, position, radius)) touches.push_back({vertex, position});
  }
  return touches;
}

/// Returns the vertex of the mesh at a point.
mesh::Vertex vertex_at(const WallMesh& map, const Point& at) {
  std::uint32_t i = 0;
  while (!(map.position(mesh::Vertex{i}) == at)) ++i;
  return mesh::Vertex{i};
}

/// Compares the distances of a guide with shortest paths of points among the walls and the closed bridges.
void check_distances(const NamedScene& scene, const disc::Connectivity& connectivity, const WallMesh& map,
                     const Point& start, const Point& goal, double radius, Random& random) {
  if (!connectivity.fits(start, radius) || !connectivity.fits(goal, radius)) return;
  const path::DiscMap disc_map(map.walls(), map.bridges(), radius, start);
  path::DiscEnds ends;
  ends.begin(disc_map, start, goal);
  if (ends.have_common_face()) return;
  const std::vector<Touch> touches = touches_of(scene, connectivity, start, radius, random);
  std::vector<oracle::OraclePoint> points{oracle::to_oracle(start), oracle::to_oracle(goal)};
  for (const Touch& touch : touches) {
    points.push_back(oracle::to_oracle(touch.vertex));
    points.push_back(oracle::to_oracle(touch.position));
  }
  oracle::ShortestPaths oracle(scene_with_closed_bridges(scene, connectivity, radius), points);
  const auto to_goal = [&](const Point& p) { return oracle.between(oracle::to_oracle(p), oracle::to_oracle(goal)); };

  path::DiscGuide guide;
  std::size_t expansions = 0;
  guide.begin(disc_map, ends, start, goal);
  ASSERT_TRUE(guide.step(kNoLimit, expansions));
  const oracle::ShortestPath whole = to_goal(start);
  ASSERT_EQ(guide.is_found(), whole.status == oracle::OracleStatus::found);
  if (!guide.is_found()) return;
  ASSERT_NEAR(guide.length(), whole.length, 1e-12 * whole.length);
  const double length = 1.25 * whole.length;
  guide.continue_to(length);
  ASSERT_TRUE(guide.step(kNoLimit, expansions));

  for (const Touch& touch : touches) {
    SCOPED_TRACE(to_string(touch.position) + " at " + to_string(touch.vertex));
    const mesh::Vertex v = vertex_at(map, touch.vertex);
    const oracle::ShortestPath rest = to_goal(touch.position);
    ASSERT_EQ(rest.status, oracle::OracleStatus::found);
    const double most = distance(touch.vertex, touch.position) + rest.length;
    const bool is_useful = guide.distances().is_useful(v, touch.vertex);
    if (most + distance(touch.vertex, start) < length + 2.0 * radius) {
      ASSERT_TRUE(is_useful);
      ASSERT_LE(guide.distances().least_length(v, touch.vertex), most + 1e-12 * length);
    }
    if (is_useful) {
      ASSERT_GE(guide.distances().least_length(v, touch.vertex), to_goal(touch.vertex).length - 1e-12 * length);
    }
  }
}

class GuideDistances : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(GuideDistances, AreTheShortestPathsOfPoints) {
  Random random(5);
  for (std::uint64_t i = 0; i < (case_count() + 19) / 20; ++i) {
    const NamedScene scene = disc::random_scene(random, GetParam());
    const disc::Connectivity connectivity(walls_of(scene));
    const WallMesh map(scene);
    for (const auto& [start, goal] : scene.queries) {
      for (const double radius : scene.radii) {
        SCOPED_TRACE("scene " + std::to_string(i) + ", " + to_string(start) + " to " + to_string(goal) + ", radius " +
                     std::to_string(radius));
        check_distances(scene, connectivity, map, start, goal, radius, random);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(DiscGuide, GuideDistances, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

}  // namespace
}  // namespace waywright::test

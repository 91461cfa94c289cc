#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/path_scene_check.hpp"
#include "support/random_path_cases.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

constexpr std::uint64_t kScenes = 60;
constexpr std::size_t kSymmetryQueries = 8;

/// A movement, reflection or scaling of the plane that doubles compute exactly.
using Movement = Point (*)(const Point&);

Point stay(const Point& p) { return p; }
Point mirror(const Point& p) { return {-p.x, p.y}; }
Point turn_by_90(const Point& p) { return {-p.y, p.x}; }
Point turn_by_180(const Point& p) { return {-p.x, -p.y}; }
Point turn_by_270(const Point& p) { return {p.y, -p.x}; }
constexpr double kScale = 0x1p-3;
Point shrink(const Point& p) { return {kScale * p.x, kScale * p.y}; }

Box moved(const Box& box, Movement move) {
  const Point a = move(box.min);
  const Point b = move(box.max);
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

World moved_world(const Scene& scene, Movement move) {
  World world = World::create(moved(scene.domain, move)).value();
  for (Item item : scene.items) {
    for (Point& point : item.shape.rings.points()) point = move(point);
    world.insert(item.shape, item.id).value();
  }
  return world;
}

Path find(const World& world, const Ends& ends, PathAlgorithm algorithm, Movement move) {
  PathQuery query{move(ends.start), move(ends.goal), {}, algorithm};
  query.end_tolerance = 0.0;  // a moved end is a rounded point, which may not be symmetric
  return world.find_path(query).value();
}

/// Returns by how much equal lengths may differ in doubles: by the rounding of sums and of the corners' coordinates.
double tolerance(const Path& path) {
  double largest = 0.0;
  for (const Point& p : path.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return 1e-9 * path.length + 0x1p-50 * largest;
}

/// Returns the status of the path with its ends exchanged.
PathStatus seen_from_goal(PathStatus status) {
  if (status == PathStatus::start_blocked) return PathStatus::goal_blocked;
  if (status == PathStatus::goal_blocked) return PathStatus::start_blocked;
  return status;
}

/// Checks that a path exists in the moved scene exactly when one exists in the scene. The shortest path must be as
/// long, but not with the same bits: of two equally long paths another may be found, and a sum may be rounded
/// differently. For the other algorithms only existence is promised: the axes decide which diagonal a tie has, and the
/// diagonals decide which channel is found first. Returns the number of paths found.
std::size_t expect_alike(const PathCase& path_case) {
  const World world = moved_world(path_case.scene, stay);
  std::size_t found = 0;
  for (const Movement move : {mirror, turn_by_90, turn_by_180, turn_by_270}) {
    const World other_world = moved_world(path_case.scene, move);
    EXPECT_EQ(other_world.vertex_count(), world.vertex_count());
    for (const Ends& ends : path_case.queries) {
      const Path path = find(world, ends, PathAlgorithm::optimal, stay);
      for (const PathAlgorithm algorithm : kPathAlgorithms) {
        EXPECT_EQ(find(other_world, ends, algorithm, move).status, path.status);
      }
      EXPECT_NEAR(find(other_world, ends, PathAlgorithm::optimal, move).length, path.length, tolerance(path));
      if (path.points.size() > 2) ++found;
    }
  }
  return found;
}

void expect_same_length_in_reverse(const PathCase& path_case) {
  const World world = moved_world(path_case.scene, stay);
  for (const Ends& ends : path_case.queries) {
    const Path path = find(world, ends, PathAlgorithm::optimal, stay);
    for (const PathAlgorithm algorithm : kPathAlgorithms) {
      const Path back = find(world, {ends.goal, ends.start}, algorithm, stay);
      // If both ends are blocked, the status names the start.
      if (path.status != PathStatus::start_blocked || back.status != PathStatus::start_blocked) {
        EXPECT_EQ(back.status, seen_from_goal(path.status));
      }
      if (algorithm == PathAlgorithm::optimal) {
        EXPECT_NEAR(back.length, path.length, tolerance(path));
      }
    }
  }
}

/// A scaling of all coordinates by a power of two does not change how numbers are rounded. So all algorithms must give
/// the same results, bit for bit.
void expect_scaled(const PathCase& path_case) {
  const World world = moved_world(path_case.scene, stay);
  const World small_world = moved_world(path_case.scene, shrink);
  for (const Ends& ends : path_case.queries) {
    for (const PathAlgorithm algorithm : kPathAlgorithms) {
      const Path path = find(world, ends, algorithm, stay);
      const Path small = find(small_world, ends, algorithm, shrink);
      std::vector<Point> points = path.points;
      std::transform(points.begin(), points.end(), points.begin(), shrink);
      EXPECT_EQ(small.status, path.status);
      EXPECT_EQ(small.points, points);
      EXPECT_EQ(small.length, kScale * path.length);
      EXPECT_EQ(small.lower_bound, kScale * path.lower_bound);
      EXPECT_EQ(small.expansions, path.expansions);
    }
  }
}

class PathSymmetryAmongObstacles : public ::testing::TestWithParam<Obstacles> {};

TEST_P(PathSymmetryAmongObstacles, HoldsForTurnsMirrorsScalesAndReversal) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const PathCase path_case = random_path_case(GetParam(), seed, kSymmetryQueries);
    found += expect_alike(path_case);
    expect_same_length_in_reverse(path_case);
    expect_scaled(path_case);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(found, kScenes);  // with turns
}

INSTANTIATE_TEST_SUITE_P(Obstacles, PathSymmetryAmongObstacles, ::testing::ValuesIn(kObstacles),
                         [](const auto& obstacles) { return std::string(to_string(obstacles.param)); });

class PathSymmetryInRandomScenes : public ::testing::TestWithParam<Flavour> {};

TEST_P(PathSymmetryInRandomScenes, HoldsForTurnsMirrorsScalesAndReversal) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const PathCase path_case = random_path_case(GetParam(), seed, seed % 41, kSymmetryQueries);
    expect_alike(path_case);
    expect_same_length_in_reverse(path_case);
    if (GetParam() != Flavour::mixed) expect_scaled(path_case);  // its smallest coordinates cannot shrink
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Flavours, PathSymmetryInRandomScenes, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test

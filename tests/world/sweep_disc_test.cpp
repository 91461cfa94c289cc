#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_scenes.hpp"
#include "support/disc_sweep_oracle.hpp"
#include "support/random.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

using Ids = std::vector<ItemId>;

World numbered_world_of(const disc::NamedScene& scene) {
  World world = World::create(scene.domain).value();
  for (std::size_t i = 0; i < scene.walls.segments.size(); ++i) {
    const auto& [a, b] = scene.walls.segments[i];
    world.insert_segment(a, b, static_cast<std::int64_t>(i + 1)).value();
  }
  return world;
}

double distance_to(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Compares the library with the oracle.
class SweepChecker {
 public:
  explicit SweepChecker(const disc::NamedScene& scene)
      : world_(numbered_world_of(scene)), walls_(walls_of(scene)), item_count_(scene.walls.segments.size()) {
    rounding_ = 0x1p-46 * disc::largest_coordinate(scene.domain);
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::size_t hits() const { return hits_; }

  void check(const disc::Motion& motion) {
    SCOPED_TRACE(testing::Message() << std::hexfloat << "from (" << motion.from.x << ", " << motion.from.y << ") to ("
                                    << motion.to.x << ", " << motion.to.y << "), radius " << motion.radius);
    const disc::FirstTouch expected = disc::first_touch(walls_, motion);
    world_.ray(motion.from, motion.to, {.radius = motion.radius}, context_, hit_).value();
    ASSERT_EQ(hit_.items, ids_of(expected.walls));
    ASSERT_EQ(hit_.hit, !expected.walls.empty());
    if (!hit_.hit) {
      ASSERT_EQ(hit_, RayHit{});
      return;
    }
    ++hits_;
    ASSERT_LE(distance_to(hit_.at, expected.centre), rounding_);
    // The contact is one of the nearest positions on the walls that the disc touches.
    double least = kInfinity;
    double error = kInfinity;
    for (const Point& contact : expected.contacts) {
      least = std::min(least, distance_to(contact, expected.centre));
      error = std::min(error, distance_to(contact, hit_.contact));
    }
    ASSERT_LE(error, rounding_);
    ASSERT_LE(distance_to(hit_.contact, expected.centre), least + rounding_);
  }

 private:
  /// The ids of the items of walls. The last four walls are the border of the domain.
  [[nodiscard]] Ids ids_of(const std::vector<std::size_t>& walls) const {
    Ids ids;
    for (const std::size_t wall : walls) ids.push_back(wall < item_count_ ? static_cast<std::int64_t>(wall + 1) : 0);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

  World world_;
  disc::Walls walls_;
  std::size_t item_count_;
  double rounding_ = 0.0;
  QueryContext context_;
  RayHit hit_;
  std::size_t hits_ = 0;
};

/// Returns motions that are hard to decide: between corners and positions at exactly the radius from corners.
std::vector<disc::Motion> hard_motions(const disc::NamedScene& scene, Random& random) {
  std::vector<Point> points;
  for (const auto& [a, b] : scene.walls.segments) {
    points.push_back(a);
    points.push_back(b);
  }
  const auto inside = [&](Point p) {
    return Point{std::clamp(p.x, scene.domain.min.x, scene.domain.max.x),
                 std::clamp(p.y, scene.domain.min.y, scene.domain.max.y)};
  };
  const double width = scene.domain.max.x - scene.domain.min.x;
  std::vector<disc::Motion> motions;
  for (int i = 0; i < 5; ++i) {
    const double radius = scene.radii[random.below(4)];
    const Point corner = points[random.below(points.size())];
    const Point other = points[random.below(points.size())];
    const Point end = inside(corner + Point{radius, 0});
    const Point beside = inside(other + Point{0, -radius});
    const double reach = width * 0x1p-3 * static_cast<double>(random.between(-8, 8));
    motions.push_back({inside(end + Point{0, reach}), end, radius});
    motions.push_back({inside(end + Point{0, reach}), inside(end - Point{0, reach}), radius});
    motions.push_back({inside(beside + Point{reach, 0}), inside(beside - Point{reach, 0}), radius});
    motions.push_back({end, beside, radius});
    motions.push_back({corner, other, radius});
    motions.push_back({inside(corner + Point{reach, reach}), corner, radius});
    motions.push_back({beside, beside, radius});
  }
  return motions;
}

std::size_t check_scene(const disc::NamedScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
  SweepChecker checker(scene);
  Random random(seed);
  for (const auto& [start, goal] : scene.queries) {
    for (const double radius : scene.radii) {
      checker.check({start, goal, radius});
      checker.check({goal, start, radius});
      if (testing::Test::HasFatalFailure()) return 0;
    }
  }
  for (const disc::Motion& motion : hard_motions(scene, random)) {
    checker.check(motion);
    if (testing::Test::HasFatalFailure()) return 0;
  }
  return checker.hits();
}

TEST(SweepDisc, AgreesWithTheOracleInRandomScenes) {
  std::size_t hits = 0;
  for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
    Random random(seed);
    const disc::SceneKind kind = disc::kSceneKinds[seed % disc::kSceneKinds.size()];
    hits += check_scene(disc::random_scene(random, kind), seed);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(hits, 10 * case_count());
}

TEST(SweepDisc, AgreesWithTheOracleInTraps) {
  for (std::uint64_t seed = 0; seed < (case_count() + 99) / 100; ++seed) {
    for (const disc::NamedScene& scene : disc::checked_trap_scenes(seed)) {
      check_scene(scene, seed);
      if (HasFatalFailure()) return;
    }
  }
}

World walls_with_gap() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert_segment({50, 0}, {50, 60}, 1).value();
  world.insert_segment({50, 70}, {50, 100}, 2).value();
  return world;
}

RayHit sweep(const World& world, Point from, Point to, double radius) {
  return world.ray(from, to, {.radius = radius}).value();
}

TEST(SweepDisc, StopsAtTheFirstWall) {
  const World world = walls_with_gap();
  EXPECT_EQ(sweep(world, {20, 30}, {80, 30}, 5), (RayHit{true, {45, 30}, Ids{1}, {50, 30}}));
  EXPECT_EQ(sweep(world, {80, 30}, {20, 30}, 5), (RayHit{true, {55, 30}, Ids{1}, {50, 30}}));
  EXPECT_EQ(sweep(world, {20, 63}, {80, 63}, 5), (RayHit{true, {46, 63}, Ids{1}, {50, 60}})) << "its end";
  EXPECT_EQ(sweep(world, {20, 30}, {30, 30}, 5), RayHit{});
  EXPECT_EQ(sweep(world, {20, 50}, {20, 5}, 5), (RayHit{true, {20, 5}, Ids{0}, {20, 0}})) << "just at its end";
  EXPECT_EQ(sweep(world, {20, 50}, {20, std::nextafter(5, 6)}, 5), RayHit{});
}

TEST(SweepDisc, TouchesAllWallsOfATie) {
  const World world = walls_with_gap();
  EXPECT_EQ(sweep(world, {20, 65}, {80, 65}, 5), (RayHit{true, {50, 65}, Ids{1, 2}, {50, 60}}));
  EXPECT_EQ(sweep(world, {20, 65}, {80, 65}, std::nextafter(5, 0)), RayHit{}) << "the gap is wide enough";
  EXPECT_EQ(sweep(world, {20, 65}, {80, 65}, 13), (RayHit{true, {38, 65}, Ids{1, 2}, {50, 60}}));
  EXPECT_EQ(sweep(world, {60, 60}, {95, 95}, 5), (RayHit{true, {95, 95}, Ids{0}, {95, 100}})) << "two sides";
}

TEST(SweepDisc, TouchesAWallThatItPassesAtItsRadius) {
  const World world = walls_with_gap();
  EXPECT_EQ(sweep(world, {55, 30}, {55, 90}, 5), (RayHit{true, {55, 30}, Ids{1}, {50, 30}}));
  EXPECT_EQ(sweep(world, {45, 64}, {55, 64}, 4), (RayHit{true, {50, 64}, Ids{1}, {50, 60}}));
  EXPECT_EQ(sweep(world, {45, 64}, {55, 64}, std::nextafter(4, 0)), RayHit{});
}

TEST(SweepDisc, ThatTouchesAtTheStartNamesAllWallsThere) {
  const World world = walls_with_gap();
  EXPECT_EQ(sweep(world, {46, 65}, {20, 65}, 8), (RayHit{true, {46, 65}, Ids{1, 2}, {50, 60}}));
  EXPECT_EQ(sweep(world, {48, 30}, {20, 30}, 3), (RayHit{true, {48, 30}, Ids{1}, {50, 30}}));
  EXPECT_EQ(sweep(world, {50, 30}, {50, 30}, 1), (RayHit{true, {50, 30}, Ids{1}, {50, 30}})) << "on the wall";
  EXPECT_EQ(sweep(world, {30, 30}, {30, 30}, 1), RayHit{});
  EXPECT_EQ(sweep(world, {30, 30}, {30, 30}, 1e300).items, (Ids{0, 1, 2}));
}

TEST(SweepDisc, OfRadiusZeroIsARay) {
  const World world = walls_with_gap();
  EXPECT_EQ(sweep(world, {20, 30}, {80, 31}, 0), world.ray({20, 30}, {80, 31}).value());
  EXPECT_EQ(sweep(world, {20, 65}, {80, 65}, -0.0), world.ray({20, 65}, {80, 65}).value());
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    Random random(seed);
    const disc::NamedScene scene = disc::random_scene(random, disc::SceneKind::mixture);
    const World random_world = numbered_world_of(scene);
    for (const auto& [start, goal] : scene.queries) {
      EXPECT_EQ(sweep(random_world, start, goal, 0), random_world.ray(start, goal).value());
    }
  }
}

// The order of the touches depends on the angles of the walls, however small the disc is.
TEST(SweepDisc, OfATinyRadiusDecidesExactly) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert_segment({50, 50}, {60, 90}, 1).value();
  world.insert_segment({50, 50}, {60, 20}, 2).value();
  for (const double radius : {1e-30, 1e-100, 1e-300, std::numeric_limits<double>::denorm_min()}) {
    SCOPED_TRACE(radius);
    const RayHit hit = sweep(world, {20, 50}, {80, 50}, radius);
    EXPECT_EQ(hit.items, (Ids{1, 2})) << "both at the corner";
    EXPECT_EQ(hit.at, (Point{50, 50}));
    EXPECT_EQ(hit.contact, (Point{50, 50}));
    EXPECT_EQ(sweep(world, {40, 10}, {60, 90}, radius).items, (Ids{2}));
    EXPECT_EQ(sweep(world, {70, 50}, {50, 50}, radius).items, (Ids{2})) << "it leans more";
  }
}

TEST(SweepDisc, IgnoresPoints) {
  World world = walls_with_gap();
  for (int i = 1; i < 30; ++i) world.insert_point({20.0 + i, 30}).value();
  world.insert_segment({30, 33}, {30, 33}).value();
  EXPECT_EQ(sweep(world, {20, 30}, {80, 30}, 5), (RayHit{true, {45, 30}, Ids{1}, {50, 30}}));
}

TEST(SweepDisc, DoesNotDependOnTheOrderOfInsertions) {
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    Random random(seed);
    const disc::NamedScene scene = disc::random_scene(random, disc::SceneKind::lattice);
    const World world = numbered_world_of(scene);
    World reversed = World::create(scene.domain).value();
    for (std::size_t i = scene.walls.segments.size(); i-- > 0;) {
      const auto& [a, b] = scene.walls.segments[i];
      reversed.insert_segment(b, a, static_cast<std::int64_t>(i + 1)).value();
    }
    for (const disc::Motion& motion : hard_motions(scene, random)) {
      ASSERT_EQ(sweep(world, motion.from, motion.to, motion.radius),
                sweep(reversed, motion.from, motion.to, motion.radius));
    }
  }
}

TEST(SweepDisc, RefusesWhatItCannotUse) {
  const World world = walls_with_gap();
  EXPECT_EQ(world.ray({-1, 5}, {5, 5}, {.radius = 1}).error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(world.ray({1, 5}, {500, 5}, {.radius = 1}).error().index, 1U);
  EXPECT_EQ(world.ray({1, 5}, {5, 5}, {.radius = -1}).error().code, ErrorCode::bad_radius);
  EXPECT_EQ(world.ray({1, 5}, {5, 5}, {.radius = kInfinity}).error().code, ErrorCode::bad_radius);
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"
#include "support/nearest_fit_oracle.hpp"
#include "support/random.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

using disc::NamedScene;

World world_to_fit_in(const NamedScene& scene, bool has_loose_corners) {
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  for (const auto& [a, b] : scene.walls.segments) {
    if (!(a == b)) world.insert_segment(a, b).value();
  }
  if (has_loose_corners) {
    world.insert_point(scene.domain.centre()).value();
    world.insert_point(lerp(scene.walls.segments[0].first, scene.walls.segments[0].second, 0.5)).value();
  }
  return world;
}

/// The distances of neighbouring doubles near the corners of the domain.
double rounding_in(const NamedScene& scene) { return 0x1p-52 * disc::largest_coordinate(scene.domain); }

class NearestChecker {
 public:
  NearestChecker(const NamedScene& scene, std::uint64_t seed)
      : scene_(scene), walls_(walls_of(scene)), oracle_(walls_), world_(world_to_fit_in(scene, seed % 2 == 1)) {}

  void check(const Point& point, double radius) {
    SCOPED_TRACE("nearest " + to_string(point) + ", radius " + std::to_string(radius));
    const NearestFit fit = world_.nearest_fit({.point = point, .agent = {.radius = radius}}).value();
    compare(fit, point, radius,
            disc::nearest_fit(walls_, point, radius, [&](Point p) { return scene_.domain.contains(p); }));
  }
  void check(const Point& point, double radius, const Point& goal) {
    SCOPED_TRACE("nearest " + to_string(point) + ", radius " + std::to_string(radius) + ", goal " + to_string(goal));
    const NearestFit fit = world_.nearest_fit({.point = point, .agent = {.radius = radius}, .goal = goal}).value();
    if (fit.is_found) {
      ASSERT_TRUE(oracle_.connected(fit.at, goal, radius)) << to_string(fit.at);
    }
    if (!disc::fits(walls_, goal, radius)) {
      ASSERT_FALSE(fit.is_found);
      return;
    }
    compare(fit, point, radius, disc::nearest_fit(walls_, point, radius, [&](Point p) {
              return scene_.domain.contains(p) && oracle_.connected(p, goal, radius);
            }));
  }

 private:
  void compare(const NearestFit& fit, const Point& point, double radius, const std::optional<Point>& expected) const {
    ASSERT_EQ(fit.is_found, expected.has_value()) << (expected ? to_string(*expected) : to_string(fit.at));
    if (!fit.is_found) {
      ASSERT_EQ(fit, NearestFit{});
      return;
    }
    ASSERT_TRUE(disc::fits(walls_, fit.at, radius)) << to_string(fit.at);
    ASSERT_TRUE(world_.fit_disc(fit.at, {.radius = radius}).value().fits);
    ASSERT_EQ(fit.distance, distance(point, fit.at));
    const double least = distance(point, *expected);
    const double slack = is_narrow(*expected, radius) ? 0x1p-22 * radius : 0.0;
    ASSERT_LE(fit.distance, least * (1 + 1e-9) + 8 * rounding_in(scene_) + slack)
        << to_string(fit.at) << " instead of " << to_string(*expected);
  }

  /// Returns whether the disc, about 64 rounding errors away from a point, fits in one of eight directions at most.
  /// This is so at the end of the narrow area between two touching circles: among the positions where the disc fits
  /// there, doubles lie by chance. The library need not find the nearest of these points.
  [[nodiscard]] bool is_narrow(const Point& p, double radius) const {
    const double step = 0x1p-46 * std::max({std::abs(p.x), std::abs(p.y), radius});
    int count = 0;
    for (const double x : {-step, 0.0, step}) {
      for (const double y : {-step, 0.0, step}) {
        const bool is_elsewhere = x != 0.0 || y != 0.0;
        if (is_elsewhere && disc::fits(walls_, p + Point{x, y}, radius)) ++count;
      }
    }
    return count <= 1;
  }

  const NamedScene& scene_;
  disc::Walls walls_;
  disc::Connectivity oracle_;
  World world_;
};

void check_nearest(const NamedScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(scene.name);
  NearestChecker checker(scene, seed);
  Random random(seed);
  const auto share = [&] { return static_cast<double>(random.below(1025)) / 1024.0; };
  for (std::size_t i = 0; i < scene.queries.size(); ++i) {
    const auto& [start, goal] = scene.queries[i];
    const auto& [a, b] = scene.walls.segments[random.below(scene.walls.segments.size())];
    const Box& domain = scene.domain;
    const Point anywhere{domain.min.x + share() * domain.width(), domain.min.y + share() * domain.height()};
    const double radius = scene.radii[random.below(4)];
    const std::array<Point, 4> points{start, a, lerp(a, b, share()), anywhere};
    const Point& point = points.at((i + seed) % 4);
    if (!is_in_range(point) || !domain.contains(point)) continue;
    for (const double r : scene.radii) checker.check(point, r);
    checker.check(point, radius, goal);
    if (testing::Test::HasFatalFailure()) return;
  }
}

class RandomNearestFits : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(RandomNearestFits, AgreeWithTheOracle) {
  Random random(5);
  for (std::uint64_t i = 0; i < (case_count() + 9) / 10; ++i) {
    check_nearest(disc::random_scene(random, GetParam()), i);
    if (HasFatalFailure()) FAIL() << "scene " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(NearestFit, RandomNearestFits, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

TEST(NearestFit, AgreesWithTheOracleInTrapScenes) {
  for (std::uint64_t seed = 0; seed < (case_count() + 99) / 100; ++seed) {
    const std::vector<NamedScene> scenes = disc::checked_trap_scenes(seed);
    for (std::size_t i = seed % 8; i < scenes.size(); i += 8) {
      check_nearest(scenes[i], seed);
      if (HasFatalFailure()) FAIL() << "seed " << seed << ", scene " << i;
    }
  }
}

// Between two touching circles, the disc fits at a row of points with x = 0.8, or at a few short rows.
TEST(NearestFit, LiesBetweenTouchingCircles) {
  check_nearest(disc::trap_scenes(3).at(131), 3);
  check_nearest(disc::trap_scenes(24).at(88), 24);
}

/// Solid squares that overlap and touch. Discs must not get inside, although there is room.
TEST(NearestFit, LiesOutsidePolygons) {
  Random random(7);
  for (std::uint64_t i = 0; i < (case_count() + 3) / 4; ++i) {
    const Box domain{{0, 0}, {24, 24}};
    World world = World::create(domain, {.keep_abstraction = i % 2 == 0}).value();
    disc::Walls walls{{{{0, 0}, {24, 0}}, {{24, 0}, {24, 24}}, {{24, 24}, {0, 24}}, {{0, 24}, {0, 0}}}};
    std::vector<Box> boxes;
    for (int count = 0; count < 8; ++count) {
      const Point min{static_cast<double>(random.below(18)), static_cast<double>(random.below(18))};
      const Point max = min + Point{static_cast<double>(1 + random.below(6)), static_cast<double>(1 + random.below(6))};
      boxes.push_back({min, max});
      world.insert(Shape::rectangle(boxes.back())).value();
      const std::array<Point, 5> corners{min, {max.x, min.y}, max, {min.x, max.y}, min};
      for (std::size_t side = 0; side < 4; ++side) walls.segments.emplace_back(corners[side], corners[side + 1]);
    }
    const auto is_outside = [&](const Point& p) {
      return domain.contains(p) && std::none_of(boxes.begin(), boxes.end(), [&](const Box& box) {
               return p.x > box.min.x && p.x < box.max.x && p.y > box.min.y && p.y < box.max.y;
             });
    };
    for (int query = 0; query < 8; ++query) {
      const Point point{static_cast<double>(random.below(193)) / 8, static_cast<double>(random.below(193)) / 8};
      for (const double radius : {0.25, 0.5, 1.0, 1.375}) {
        SCOPED_TRACE("scene " + std::to_string(i) + ", " + to_string(point) + ", radius " + std::to_string(radius));
        const NearestFit fit = world.nearest_fit({.point = point, .agent = {.radius = radius}}).value();
        const auto expected = disc::nearest_fit(walls, point, radius, is_outside);
        ASSERT_EQ(fit.is_found, expected.has_value());
        if (!fit.is_found) continue;
        ASSERT_TRUE(disc::fits(walls, fit.at, radius) && is_outside(fit.at)) << to_string(fit.at);
        ASSERT_LE(fit.distance, distance(point, *expected) * (1 + 1e-9) + 0x1p-44) << to_string(*expected);
      }
    }
  }
}

World two_rooms() {
  World world = World::create({{0, 0}, {20, 10}}, {.keep_bridges = true}).value();
  world.insert_segment({10, 0}, {10, 4}, 1).value();
  world.insert_segment({10, 6}, {10, 10}, 2).value();
  world.insert(Shape::rectangle({{2, 2}, {4, 4}}), 3).value();
  return world;
}

TEST(NearestFit, IsThePointItselfIfTheDiscFitsThere) {
  const World world = two_rooms();
  EXPECT_EQ(world.nearest_fit({.point = {6, 5}, .agent = {.radius = 2}}).value(), (NearestFit{true, {6, 5}, 0}));
  EXPECT_EQ(world.nearest_fit({.point = {10, 5}, .agent = {.radius = 1}}).value(), (NearestFit{true, {10, 5}, 0}))
      << "in a gap";
}

TEST(NearestFit, KeepsTheRadiusFromWalls) {
  const World world = two_rooms();
  EXPECT_EQ(world.nearest_fit({.point = {9.5, 2}, .agent = {.radius = 1}}).value(), (NearestFit{true, {9, 2}, 0.5}));
  EXPECT_EQ(world.nearest_fit({.point = {20, 10}, .agent = {.radius = 1}}).value().at, (Point{19, 9}));
  EXPECT_EQ(world.nearest_fit({.point = {3.75, 3}, .agent = {.radius = 0.5}}).value(),
            (NearestFit{true, {4.5, 3}, 0.75}));
  EXPECT_EQ(world.nearest_fit({.point = {10, 2}, .agent = {.radius = 1}}).value().at, (Point{9, 2}))
      << "the first of two";
  EXPECT_FALSE(world.nearest_fit({.point = {10, 2}, .agent = {.radius = 5.5}}).value().is_found);
  EXPECT_FALSE(world.nearest_fit({.point = {10, 2}, .agent = {.radius = 1e300}}).value().is_found);
}

TEST(NearestFit, StopsAtTheLimit) {
  const World world = two_rooms();
  EXPECT_TRUE(world.nearest_fit({.point = {9.5, 2}, .agent = {.radius = 1}, .limit = 0.5}).value().is_found);
  EXPECT_FALSE(world.nearest_fit({.point = {9.5, 2}, .agent = {.radius = 1}, .limit = 0.499}).value().is_found);
  EXPECT_TRUE(world.nearest_fit({.point = {9, 2}, .agent = {.radius = 1}, .limit = 0}).value().is_found);
}

TEST(NearestFit, IsConnectedWithTheGoal) {
  const World world = two_rooms();
  const auto at = [&](const Point& point, double radius, const Point& goal) {
    return world.nearest_fit({.point = point, .agent = {.radius = radius}, .goal = goal}).value();
  };
  EXPECT_EQ(at({9.5, 2}, 1, {15, 5}).at, (Point{9, 2})) << "the disc just passes the gap";
  EXPECT_EQ(at({9.5, 2}, 1.25, {15, 5}).at, (Point{11.25, 2}));
  EXPECT_EQ(at({5, 7}, std::nextafter(1.0, 2.0), {15, 5}).at.x > 10, true) << "the gap is too narrow by one ulp";
  EXPECT_EQ(at({5, 7}, 1.25, {15, 9}), NearestFit{}) << "the disc does not fit at the goal";
  EXPECT_EQ(at({5, 7}, 1.25, {6, 6}).at, (Point{5, 7}));
}

// The gap below the wall is shorter than the diameter by two ulps. So the line above the floor consists of two pieces,
// one on the left and one on the right of the gap, although doubles cannot tell where one ends and the other begins.
TEST(NearestFit, LiesBeyondAGapThatIsTooNarrowByRoundingOnly) {
  World world = World::create({{0, 0}, {20, 10}}, {.keep_bridges = true}).value();
  world.insert_segment({10, 2}, {10, 10}, 1).value();
  const double radius = std::nextafter(1.0, 2.0);
  const NearestFit fit =
      world.nearest_fit({.point = {5, 0}, .agent = {.radius = radius}, .goal = Point{15, 5}}).value();
  ASSERT_TRUE(fit.is_found);
  EXPECT_GT(fit.at.x, 10);
  EXPECT_NEAR(fit.distance, std::sqrt(26.0), 1e-6);
}

TEST(NearestFit, OfRadiusZeroIsWhereAPathCanStart) {
  World world = two_rooms();
  const auto at = [&](const Point& point) { return world.nearest_fit({.point = point}).value(); };
  EXPECT_EQ(at({3, 2.5}), (NearestFit{true, {3, 2}, 0.5}));
  EXPECT_EQ(at({10, 2}), (NearestFit{true, {10, 2}, 0})) << "on a wall";
  EXPECT_FALSE(world.nearest_fit({.point = {3, 2.5}, .limit = 0.25}).value().is_found);
  EXPECT_FALSE(world.nearest_fit({.point = {3, 2.5}, .limit = 0}).value().is_found);
  world.insert(Shape::rectangle({{12, 1}, {18, 9}}), 4).value();
  world.insert_segment({10, 4}, {10, 6}, 5).value();
  const NearestFit left = world.nearest_fit({.point = {13, 5}, .goal = Point{6, 6}}).value();
  EXPECT_EQ(left.at, (Point{10, 5})) << "the rectangle lies beyond the wall";
  EXPECT_FALSE(world.nearest_fit({.point = {13, 5}, .goal = Point{3, 3}}).value().is_found);
  EXPECT_EQ(world.nearest_fit({.point = {6, 5}, .goal = Point{6, 6}}).value().at, (Point{6, 5}));
}

TEST(NearestFit, NeedsBridgesOnlyForAGoal) {
  const World world = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = false}).value();
  EXPECT_EQ(world.nearest_fit({.point = {0, 5}, .agent = {.radius = 1}}).value().at, (Point{1, 5}));
  EXPECT_EQ(world.nearest_fit({.point = {0, 5}}).value().at, (Point{0, 5}));
  const auto code = [&](double radius) {
    return world.nearest_fit({.point = {0, 5}, .agent = {.radius = radius}, .goal = Point{1, 1}}).error().code;
  };
  EXPECT_EQ(code(1), ErrorCode::no_bridges);
  EXPECT_EQ(code(0), ErrorCode::not_supported);
}

TEST(NearestFit, RefusesWrongArguments) {
  const World world = two_rooms();
  const auto error = [&](const NearestFitQuery& query) { return world.nearest_fit(query).error(); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error({.point = {21, 1}, .agent = {.radius = 1}}).code, ErrorCode::out_of_domain);
  EXPECT_EQ(error({.point = {kInfinity, 1}, .agent = {.radius = 1}}).code, ErrorCode::coordinate_range);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = -1}}).code, ErrorCode::bad_radius);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = kInfinity}}).code, ErrorCode::bad_radius);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = 1}, .limit = -1}).code, ErrorCode::bad_distance);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = 1}, .limit = nan}).code, ErrorCode::bad_distance);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = 1}, .goal = Point{1, 11}}).code, ErrorCode::out_of_domain);
  EXPECT_EQ(error({.point = {1, 1}, .agent = {.radius = 1}, .goal = Point{1, 11}}).index, 1U);
}

// Extreme radii and coordinates.
TEST(NearestFit, WorksWithRadiiOfAnySize) {
  const World world = two_rooms();
  for (const double radius : {5e-324, 1e-300, 1e-100, 1e-30, 1e-17, 1e-9}) {
    const NearestFit fit = world.nearest_fit({.point = {10, 2}, .agent = {.radius = radius}}).value();
    ASSERT_TRUE(fit.is_found) << radius;
    EXPECT_TRUE(world.fit_disc(fit.at, {.radius = radius}).value().fits);
    EXPECT_LE(fit.distance, radius + 0x1p-49) << radius;
  }
  World large = World::create({{-0x1p100, -0x1p100}, {0x1p100, 0x1p100}}, {.keep_bridges = true}).value();
  large.insert_segment({-0x1p99, 0}, {0x1p99, 0x1p-100}).value();
  const NearestFit fit =
      large.nearest_fit({.point = {0, 0}, .agent = {.radius = 0x1p90}, .goal = Point{0, 0x1p98}}).value();
  ASSERT_TRUE(fit.is_found);
  EXPECT_NEAR(std::abs(fit.at.y) / 0x1p90, 1, 1e-12);
}

// Near (0, 0), doubles are much closer to each other than the smallest coordinate that a world accepts. The search must
// not halve its steps down to 0.
TEST(NearestFit, IsAsPreciseInASmallWorld) {
  const auto distance_at_scale = [](double scale) {
    World world = World::create({{0, 0}, {16 * scale, 16 * scale}}).value();
    world.insert_segment({3 * scale, 3 * scale}, {8 * scale, 8 * scale}).value();
    world.insert_segment({8 * scale, 8 * scale}, {13 * scale, 2 * scale}).value();
    const NearestFit fit =
        world.nearest_fit({.point = {8.25 * scale, 9 * scale}, .agent = {.radius = 1.5 * scale}}).value();
    return fit.distance / scale;
  };
  const double expected = 1.5 - std::hypot(0.25, 1);
  for (const double scale : {1.0, 0x1p-60, 0x1p-70, 0x1p-80, 0x1p-95}) {
    EXPECT_NEAR(distance_at_scale(scale), expected, 1e-12) << scale;
  }
}

TEST(NearestFit, EndsNearTheOriginForTheSmallestRadius) {
  const World world = World::create({{0, 0}, {0x1p-35, 0x1p-35}}, {.keep_bridges = true}).value();
  const NearestFit fit = world.nearest_fit({.point = {0, 0}, .agent = {.radius = 5e-324}}).value();
  ASSERT_TRUE(fit.is_found);
  EXPECT_TRUE(world.fit_disc(fit.at, {.radius = 5e-324}).value().fits);
  EXPECT_LE(fit.distance, 0x1p-96);
}

}  // namespace
}  // namespace waywright::test

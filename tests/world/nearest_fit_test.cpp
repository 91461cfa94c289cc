#include <algorithm>
#include <array>
#include <cmath>
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

namespace waywright::test {
namespace {

using disc::NamedScene;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

World world_of(const NamedScene& scene, bool has_loose_corners) {
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
double rounding_in(const NamedScene& scene) {
  const Box& domain = scene.domain;
  return 0x1p-52 * std::max({std::abs(domain.min.x), std::abs(domain.min.y), std::abs(domain.max.x),
                             std::abs(domain.max.y)});
}

class Checker {
 public:
  Checker(const NamedScene& scene, std::uint64_t seed)
      : scene_(scene), walls_(walls_of(scene)), oracle_(walls_), world_(world_of(scene, seed % 2 == 1)) {}

  void check(const Point& point, double radius) {
    SCOPED_TRACE("nearest " + to_string(point) + ", radius " + std::to_string(radius));
    const NearestFit fit = world_.nearest_fit({.point = point, .radius = radius}).value();
    compare(fit, point, radius, disc::nearest_fit(walls_, point, radius, [&](Point p) { return scene_.domain.contains(p); }));
  }
  void check(const Point& point, double radius, const Point& goal) {
    SCOPED_TRACE("nearest " + to_string(point) + ", radius " + std::to_string(radius) + ", goal " + to_string(goal));
    const NearestFit fit = world_.nearest_fit({.point = point, .radius = radius, .goal = goal}).value();
    if (fit.is_found) {
      ASSERT_TRUE(oracle_.connected(fit.at, goal, radius)) << to_string(fit.at);
    }
    if (!disc::is_free(walls_, goal, radius)) {
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
    ASSERT_TRUE(disc::is_free(walls_, fit.at, radius)) << to_string(fit.at);
    ASSERT_TRUE(world_.fit_disc(fit.at, radius).value().fits);
    ASSERT_EQ(fit.distance, distance(point, fit.at));
    const double least = distance(point, *expected);
    const double slack = is_alone(*expected, radius) ? 0x1p-22 * radius : 0.0;
    ASSERT_LE(fit.distance, least * (1 + 1e-9) + 8 * rounding_in(scene_) + slack)
        << to_string(fit.at) << " instead of " << to_string(*expected);
  }

  /// Returns whether the disc fits at none of the four points next to a point. Between two touching circles, a few
  /// points of doubles lie among the free positions by chance. The library need not find the nearest of these.
  [[nodiscard]] bool is_alone(const Point& p, double radius) const {
    const auto next = [](double value, double towards) { return std::nextafter(value, towards); };
    const std::array<Point, 4> around{{{next(p.x, kInfinity), p.y},
                                       {next(p.x, -kInfinity), p.y},
                                       {p.x, next(p.y, kInfinity)},
                                       {p.x, next(p.y, -kInfinity)}}};
    return std::none_of(around.begin(), around.end(), [&](const Point& q) { return disc::is_free(walls_, q, radius); });
  }

  const NamedScene& scene_;
  disc::Walls walls_;
  disc::Connectivity oracle_;
  World world_;
};

void check_scene(const NamedScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(scene.name);
  Checker checker(scene, seed);
  Random random(seed);
  const auto share = [&] { return static_cast<double>(random.below(1025)) / 1024.0; };
  for (std::size_t i = 0; i < scene.queries.size(); ++i) {
    const auto& [start, goal] = scene.queries[i];
    const auto& [a, b] = scene.walls.segments[random.below(scene.walls.segments.size())];
    const Box& domain = scene.domain;
    const Point anywhere{domain.min.x + share() * domain.width(), domain.min.y + share() * domain.height()};
    const double radius = scene.radii[random.below(4)];
    for (const Point& point : {start, a, lerp(a, b, share()), anywhere}) {
      if (!is_in_range(point) || !domain.contains(point)) continue;
      for (const double r : scene.radii) checker.check(point, r);
      checker.check(point, radius, goal);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

class RandomNearestFits : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(RandomNearestFits, AgreeWithTheOracle) {
  Random random(5);
  for (std::uint64_t i = 0; i < (case_count() + 9) / 10; ++i) {
    check_scene(disc::random_scene(random, GetParam()), i);
    if (HasFatalFailure()) FAIL() << "scene " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(NearestFit, RandomNearestFits, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

TEST(NearestFit, AgreesWithTheOracleInTrapScenes) {
  for (std::uint64_t seed = 0; seed < (case_count() + 99) / 100; ++seed) {
    const std::vector<NamedScene> scenes = disc::trap_scenes(seed);
    for (std::size_t i = seed % 4; i < scenes.size(); i += 4) {
      check_scene(scenes[i], seed);
      if (HasFatalFailure()) FAIL() << "seed " << seed << ", scene " << i;
    }
  }
}

}  // namespace
}  // namespace waywright::test

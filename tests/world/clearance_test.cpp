#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

using disc::NamedScene;
using disc::Rational;
using Ids = std::vector<ItemId>;

constexpr WorldOptions kWithBridges = {.keep_bridges = true};

std::string fault_of(const World& world) { return world.validate().fault; }

/// Returns whether each ring of the shape has a side.
bool has_walls(const Shape& shape) {
  if (shape.kind == ItemKind::point) return false;
  return std::all_of(shape.rings.begin(), shape.rings.end(), [](const auto& ring) {
    return std::any_of(ring.begin(), ring.end(), [&](const Point& p) { return !(p == ring.front()); });
  });
}

class RandomChanges : public testing::TestWithParam<Flavour> {};

TEST_P(RandomChanges, KeepTheBridgesOfARebuild) {
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ChangeScript script = random_changes(GetParam(), seed, 120, 4 + 8 * (seed % 4));
    World world = World::create(script.domain, kWithBridges).value();
    Random random(seed);
    for (const Step& step : script.steps) {
      static_cast<void>(perform(world, step));
      ASSERT_EQ(fault_of(world), "");
      if (!random.chance(5)) continue;
      world.shrink_to_fit();
      ASSERT_EQ(fault_of(world), "") << "after shrinking";
      World moved = std::move(world);
      world = std::move(moved);
    }
  }
}

// Without loose corners, the bridges belong to the mesh of the world.
TEST_P(RandomChanges, OfWallsAloneKeepTheBridgesOfARebuild) {
  for (std::uint64_t seed = 0; seed < (case_count() + 4) / 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ChangeScript script = random_changes(GetParam(), 1000 + seed, 120, 4 + 8 * (seed % 4));
    World world = World::create(script.domain, kWithBridges).value();
    for (Step& step : script.steps) {
      std::erase_if(step.changes, [](const Change& change) {
        return change.kind != Change::Kind::remove && !has_walls(change.shape);
      });
      if (step.changes.empty()) continue;
      static_cast<void>(perform(world, step));
      ASSERT_EQ(fault_of(world), "");
    }
  }
}

TEST_P(RandomChanges, HaveTheBridgesOfABulkLoad) {
  for (std::uint64_t seed = 0; seed < (case_count() + 4) / 5; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, 40);
    World world = World::create(scene.domain, kWithBridges).value();
    const std::size_t half = scene.items.size() / 2;
    const std::span<const Item> items = scene.items;
    world.insert_all(items.first(half)).value();
    ASSERT_EQ(fault_of(world), "") << "seed " << seed;
    world.insert_all(items.subspan(half)).value();
    ASSERT_EQ(fault_of(world), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Clearance, RandomChanges, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

Rational square(double value) { return Rational(value) * Rational(value); }

enum class Loose : std::uint8_t { none, some };

/// Returns a world of the scene's walls, in an order that depends on the seed. With loose corners, the world also has
/// points and polygons with a ring of one corner, which must not change any answer.
World world_of_walls(const NamedScene& scene, Loose loose, std::uint64_t seed) {
  World world = World::create(scene.domain, kWithBridges).value();
  Random random(seed);
  std::vector<Item> items;
  for (const auto& [a, b] : scene.walls.segments) {
    if (!(a == b)) items.push_back({ItemId{items.size() + 1}, Shape::segment(a, b)});
  }
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random.below(1025)) / 1024.0);
  };
  for (const Item& item : items) {
    world.insert(item.shape, item.id).value();
    if (loose == Loose::none) continue;
    const double x = between(scene.domain.min.x, scene.domain.max.x);
    const double y = between(scene.domain.min.y, scene.domain.max.y);
    const Point p{is_legal_coordinate(x) ? x : scene.domain.min.x, is_legal_coordinate(y) ? y : scene.domain.min.y};
    if (random.chance(50)) {
      world.insert_point(p, ItemId{item.id.value + 1000}).value();
    } else {
      const auto& [a, b] = scene.walls.segments.front();
      world.insert_polygon({{p}, {a, b}, {p, p}}, ItemId{item.id.value + 1000}).value();
    }
  }
  return world;
}

Ids wall_ids(const Ids& items) {
  Ids result;
  std::copy_if(items.begin(), items.end(), std::back_inserter(result), [](ItemId id) { return id.value <= 1000; });
  return result;
}

void check_fit(const World& world, const NamedScene& scene, const disc::Connectivity& oracle, const Point& p) {
  for (const double radius : scene.radii) {
    const DiscFit fit = world.fit_disc(p, {.radius = radius}).value();
    ASSERT_EQ(fit.fits, oracle.fits(p, radius)) << to_string(p) << ", radius " << radius;
    ASSERT_EQ(fit.fits, fit.items.empty());
    Ids expected;
    std::uint64_t id = 0;
    for (const auto& [a, b] : scene.walls.segments) {
      if (!(a == b) && disc::squared_distance(p, a, b) < square(radius)) expected.push_back({id + 1});
      id += a == b ? 0 : 1;
    }
    const auto& all = walls_of(scene).segments;
    const bool is_near_border = std::any_of(all.end() - 4, all.end(), [&](const auto& wall) {
      return disc::squared_distance(p, wall.first, wall.second) < square(radius);
    });
    if (is_near_border) expected.insert(expected.begin(), ItemId{0});
    ASSERT_EQ(wall_ids(fit.items), expected) << to_string(p) << ", radius " << radius;
  }
  ASSERT_TRUE(world.fit_disc(p, {.radius = 0.0}).value().fits);
}

void check_gap(const WidestPath& widest, const NamedScene& scene) {
  ASSERT_FALSE(widest.from_items.empty());
  ASSERT_FALSE(widest.to_items.empty());
  const auto is_near = [&](const Point& p, const Ids& items) {
    const double slack = 1e-9 * disc::largest_coordinate(scene.domain);
    std::uint64_t id = 0;
    for (const auto& [a, b] : scene.walls.segments) {
      if (a == b) continue;
      if (std::find(items.begin(), items.end(), ItemId{++id}) == items.end()) continue;
      if (disc::squared_distance(p, a, b) > square(slack)) return false;
    }
    return true;
  };
  EXPECT_TRUE(is_near(widest.from, widest.from_items));
  EXPECT_TRUE(is_near(widest.to, widest.to_items));
  EXPECT_NEAR(distance(widest.from, widest.to), 2 * widest.radius,
              1e-9 * std::abs(widest.radius) + 1e-13 * std::abs(scene.domain.max.x - scene.domain.min.x) +
                  1e-13 * std::abs(scene.domain.max.x));
}

// If another wall touches the circle whose diameter is a gap, the library does not call this gap a bridge. A disc whose
// diameter is longer than the gap then fits at no position left of the gap, or at no position right of it. So the
// library and the oracle agree about all discs that fit at both ends.
void check_widest(const World& world, const NamedScene& scene, const disc::Connectivity& oracle, const Point& start,
                  const Point& goal) {
  const WidestPath widest = world.widest_path(start, goal).value();
  const auto expected = oracle.widest(start, goal);
  ASSERT_EQ(widest.is_connected, expected.has_value());
  if (!expected) {
    ASSERT_EQ(widest, WidestPath{});
    return;
  }
  if (widest.is_limited) {
    check_gap(widest, scene);
    if (testing::Test::HasFatalFailure()) return;
  } else {
    ASSERT_EQ(widest.radius, kInfinity);
  }
  const Rational largest = disc::largest_at(walls_of(scene), start, goal);
  if (expected->is_limited && expected->squared_diameter < largest) {
    ASSERT_TRUE(widest.is_limited);
    ASSERT_LE(4 * square(widest.radius), expected->squared_diameter);
    ASSERT_GT(4 * square(std::nextafter(widest.radius, kInfinity)), expected->squared_diameter);
  } else if (widest.is_limited) {
    ASSERT_GT(4 * square(std::nextafter(widest.radius, kInfinity)), largest);
  }
  for (const double radius : scene.radii) {
    if (!oracle.fits(start, radius) || !oracle.fits(goal, radius)) continue;
    ASSERT_EQ(radius <= widest.radius, oracle.connected(start, goal, radius)) << "radius " << radius;
  }
}

void check_fits(const NamedScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(scene.name);
  const disc::Connectivity oracle(walls_of(scene));
  const World world = world_of_walls(scene, Loose::none, seed);
  const World other = world_of_walls(scene, Loose::some, seed + 1);
  for (const auto& [start, goal] : scene.queries) {
    SCOPED_TRACE(to_string(start) + " to " + to_string(goal));
    check_fit(world, scene, oracle, start);
    check_fit(other, scene, oracle, goal);
    check_widest(world, scene, oracle, start, goal);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// The order of the insertions and items without walls must not change an answer.
void check_order(const NamedScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(scene.name);
  const World world = world_of_walls(scene, Loose::none, seed);
  const World other = world_of_walls(scene, Loose::none, seed + 1);
  const World loose = world_of_walls(scene, Loose::some, seed + 2);
  for (const auto& [start, goal] : scene.queries) {
    const WidestPath widest = world.widest_path(start, goal).value();
    ASSERT_EQ(other.widest_path(start, goal).value(), widest);
    ASSERT_EQ(world.widest_path(goal, start).value(), widest);
    WidestPath with_loose = loose.widest_path(start, goal).value();
    with_loose.from_items = wall_ids(with_loose.from_items);
    with_loose.to_items = wall_ids(with_loose.to_items);
    ASSERT_EQ(with_loose, widest);
  }
}

TEST(Clearance, AgreesWithTheOracleInTrapScenes) {
  for (std::uint64_t seed = 0; seed < (case_count() + 99) / 100; ++seed) {
    const std::vector<NamedScene> scenes = disc::checked_trap_scenes(seed);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      check_order(scenes[i], seed);
      if (i % 4 == seed % 4 && !testing::Test::HasFatalFailure()) check_fits(scenes[i], seed);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

class RandomWalls : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(RandomWalls, AgreeWithTheOracle) {
  Random random(3);
  for (std::uint64_t i = 0; i < (case_count() + 9) / 10; ++i) {
    check_fits(disc::random_scene(random, GetParam()), i);
    if (testing::Test::HasFatalFailure()) FAIL() << "scene " << i;
  }
}

TEST_P(RandomWalls, HaveTheSameAnswersInAnyOrder) {
  Random random(4);
  for (std::uint64_t i = 0; i < (case_count() + 3) / 4; ++i) {
    check_order(disc::random_scene(random, GetParam()), i);
    if (testing::Test::HasFatalFailure()) FAIL() << "scene " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Clearance, RandomWalls, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

World three_rooms() {
  World world = World::create({{0, 0}, {20, 10}}, kWithBridges).value();
  world.insert_segment({10, 0}, {10, 4}, 1).value();
  world.insert_segment({10, 7}, {10, 10}, 2).value();
  world.insert(Shape::rectangle({{14, 1}, {16, 3}}), 3).value();
  return world;
}

TEST(FitDisc, CountsPolygonsAroundTheCentreAndTheDomain) {
  const World world = three_rooms();
  const auto fit = [&](Point centre, double radius) { return world.fit_disc(centre, {.radius = radius}).value(); };
  EXPECT_EQ(fit({5, 5}, 5), (DiscFit{true, {}}));
  EXPECT_EQ(fit({5, 5}, std::nextafter(5.0, 6.0)), (DiscFit{false, {0}}));
  EXPECT_EQ(fit({5, 5}, 5.5), (DiscFit{false, {0, 1, 2}}));
  EXPECT_EQ(fit({15, 2}, 0), (DiscFit{false, {3}}));
  EXPECT_EQ(fit({15, 2}, 0.5), (DiscFit{false, {3}}));
  EXPECT_EQ(fit({14, 2}, 0), (DiscFit{true, {}})) << "on its border";
  EXPECT_EQ(fit({14, 2}, 0x1p-60), (DiscFit{false, {3}}));
  EXPECT_EQ(fit({10, 2}, 0), (DiscFit{true, {}}));
  EXPECT_EQ(fit({0, 0}, 0), (DiscFit{true, {}}));
  EXPECT_EQ(fit({10, 2}, 100), (DiscFit{false, {0, 1, 2, 3}}));
  EXPECT_EQ(fit({10, 2}, 1e300), (DiscFit{false, {0, 1, 2, 3}}));
}

TEST(FitDisc, NeedsNoBridges) {
  World world = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = false}).value();
  world.insert_point({5, 5}, 1).value();
  EXPECT_TRUE(world.fit_disc({5, 5}, {.radius = 5}).value().fits) << "a point is no wall";
  EXPECT_EQ(world.fit_disc({5, 5}, {.radius = 5.5}).value().items, Ids{0});
}

TEST(WidestPath, NamesTheGapAndTheItemsAtItsEnds) {
  const World world = three_rooms();
  const WidestPath widest = world.widest_path({5, 5}, {15, 6}).value();
  EXPECT_EQ(widest, (WidestPath{true, true, 1.5, {10, 4}, {10, 7}, {1}, {2}}));
  const WidestPath same = world.widest_path({5, 5}, {4, 5.5}).value();
  EXPECT_EQ(same, (WidestPath{true, false, kInfinity, {}, {}, {}, {}}));
  // The gaps at the left and the right end of the rectangle are equal. Their positions decide.
  const WidestPath below = world.widest_path({15, 0.5}, {15, 6}).value();
  EXPECT_EQ(below, (WidestPath{true, true, 0.5, {16, 1}, {16, 0}, {3}, {0}}));
}

TEST(WidestPath, EndsAtTheFootOnAWallOfTheDomain) {
  World world = World::create({{0, 0}, {20, 10}}, kWithBridges).value();
  world.insert_segment({10, 0}, {10, 7}, 1).value();
  world.insert_point({10, 8}, 2).value();
  EXPECT_EQ(world.widest_path({5, 5}, {15, 5}).value(), (WidestPath{true, true, 1.5, {10, 7}, {10, 10}, {1}, {0}}));
  world.insert_segment({9, 10}, {11, 10}, 7).value();
  EXPECT_EQ(world.widest_path({5, 5}, {15, 5}).value().to_items, (Ids{0, 7}));
}

TEST(WidestPath, LeavesNoConnectionInPolygonsAndOnWalls) {
  World world = three_rooms();
  EXPECT_EQ(world.widest_path({15, 2}, {5, 5}).value(), WidestPath{}) << "inside a polygon";
  EXPECT_EQ(world.widest_path({15, 2}, {15, 2.5}).value(), WidestPath{}) << "inside the same polygon";
  EXPECT_EQ(world.widest_path({5, 5}, {10, 2}).value(), WidestPath{}) << "on a wall";
  EXPECT_EQ(world.widest_path({5, 5}, {20, 5}).value(), WidestPath{}) << "on the border of the domain";
  world.insert_segment({10, 3}, {10, 8}, 8).value();
  EXPECT_EQ(world.widest_path({5, 5}, {15, 5}).value(), WidestPath{});
}

TEST(WidestPath, IgnoresLooseCornersBeforeAndAfterTheyCome) {
  World world = three_rooms();
  const WidestPath widest = world.widest_path({5, 5}, {15, 6}).value();
  const std::size_t bridges = world.memory().bridges;
  world.insert_point({10, 5.5}, 10).value();
  world.insert_segment({10, 5}, {10, 5}, 11).value();
  world.insert_polygon({{{10, 6}}, {{1, 1}, {2, 1}, {2, 2}}}, 12).value();
  EXPECT_EQ(world.widest_path({5, 5}, {15, 6}).value(), widest);
  EXPECT_EQ(fault_of(world), "");
  EXPECT_GT(world.memory().bridges, 2 * bridges);
  world.remove(10).value();
  world.replace(11, Shape::point({10, 4.5})).value();
  world.remove(12).value();
  EXPECT_EQ(fault_of(world), "");
  world.remove(11).value();
  EXPECT_EQ(fault_of(world), "");
  world.shrink_to_fit();
  EXPECT_EQ(fault_of(world), "");
  EXPECT_LT(world.memory().bridges, 2 * bridges) << "the mesh of the walls is gone";
  EXPECT_EQ(world.widest_path({5, 5}, {15, 6}).value(), widest);
}

TEST(Clearance, QueriesRefuseWrongArguments) {
  const World world = three_rooms();
  const World without = World::create({{0, 0}, {20, 10}}).value();
  const auto fit_code = [&](Point centre, double radius) {
    return world.fit_disc(centre, {.radius = radius}).error().code;
  };
  EXPECT_EQ(fit_code({21, 1}, 1), ErrorCode::out_of_domain);
  EXPECT_EQ(fit_code({kInfinity, 1}, 1), ErrorCode::coordinate_range);
  EXPECT_EQ(fit_code({1, 1}, -1), ErrorCode::bad_radius);
  EXPECT_EQ(fit_code({1, 1}, kInfinity), ErrorCode::bad_radius);
  EXPECT_EQ(fit_code({1, 1}, std::numeric_limits<double>::quiet_NaN()), ErrorCode::bad_radius);
  EXPECT_EQ(world.widest_path({1, 1}, {21, 1}).error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(world.widest_path({1, 1}, {21, 1}).error().index, 1U);
  EXPECT_EQ(world.widest_path({1, 1e-200}, {2, 1}).error().code, ErrorCode::coordinate_range);
  EXPECT_EQ(without.widest_path({1, 1}, {2, 1}).error().code, ErrorCode::no_bridges);
  EXPECT_EQ(to_string(ErrorCode::no_bridges), "no-bridges");
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/live_items.hpp"
#include "support/new_vertices.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"
#include "support/world_internals.hpp"

namespace waywright::test {
namespace {

constexpr Box kHundred{{0, 0}, {100, 100}};

/// Upright segments, each from y = 5 to y = 95.
std::vector<Item> upright(std::size_t count, std::uint64_t first_id) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 + static_cast<double>(i);
    items.push_back({{first_id + i}, Shape::segment({x, 5}, {x, 95})});
  }
  return items;
}

/// A polyline that goes from left to right and back, `count` times. It crosses each upright segment `count` times, and
/// has 2 * count corners.
Shape zigzag(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 10 + static_cast<double>(2 * i);
    points.push_back({i % 2 == 0 ? 2.0 : 98.0, y});
    points.push_back({i % 2 == 0 ? 98.0 : 2.0, y});
  }
  return Shape::polyline(points);
}

/// What an error names.
struct Named {
  ItemId item;
  std::uint64_t index = 0;
};

/// Expects that `change(world)` is refused with the limit `made` - 1 and changes nothing, and that it is accepted with
/// the limit `made`. With the limit `made` - 1, the error must name `named`, if it is set.
template <class Perform>
void expect_made(World& world, std::size_t made, ErrorCode code, const std::optional<Named>& named, Perform&& change) {
  ASSERT_GT(made, 0U);
  const auto set_limit = [&](std::size_t limit) {
    if (code == ErrorCode::too_many_vertices) return world.set_new_vertex_limit(limit);
    WorldInternals::set_most_vertices(world, limit);
  };
  for (const std::size_t limit : {std::size_t{0}, made / 2, made - 1}) {
    set_limit(limit);
    const WorldState before(world);
    const auto refused = change(world);
    ASSERT_FALSE(refused.ok()) << "limit " << limit << ", of " << made;
    EXPECT_EQ(refused.error().code, code);
    if (named && limit == made - 1) {
      EXPECT_EQ(refused.error().item, named->item);
      EXPECT_EQ(refused.error().index, named->index);
    }
    EXPECT_EQ(WorldState(world), before) << "limit " << limit;
    EXPECT_EQ(world.validate().fault, "");
  }
  set_limit(made);
  const auto done = change(world);
  EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().message());
  EXPECT_EQ(world.validate().fault, "");
}

template <class Perform>
void expect_made(World& world, std::size_t made, ItemId item, std::uint64_t index, Perform&& change) {
  expect_made(world, made, ErrorCode::too_many_vertices, Named{item, index}, change);
}

/// The worlds in which the tests run: with and without data for paths and for discs.
std::vector<WorldOptions> all_options() { return {{}, {.keep_abstraction = false}, {.keep_bridges = true}}; }

class OperationLimit : public testing::TestWithParam<std::size_t> {
 protected:
  World world_ = World::create(kHundred, all_options().at(GetParam())).value();
};

INSTANTIATE_TEST_SUITE_P(Options, OperationLimit, testing::Range<std::size_t>(0, 3));

TEST_P(OperationLimit, CountsTheCrossingsOfAGrid) {
  constexpr std::size_t n = 7;
  world_.insert_all(upright(n, 1)).value();
  expect_made(world_, 2 * n + n * n, {50}, 0, [](World& w) { return w.insert(zigzag(n), {50}); });
  EXPECT_EQ(world_.vertex_count(), 4 + 2 * n + 2 * n + n * n);
}

TEST_P(OperationLimit, HoldsForEachFunctionThatInsertsOneItem) {
  world_.insert_segment({10, 5}, {10, 95}, 1).value();
  expect_made(world_, 1, {2}, 0, [](World& w) { return w.insert_point({20, 50}, 2); });
  expect_made(world_, 1, {3}, 0, [](World& w) { return w.insert_point({10, 50}, 3); });
  expect_made(world_, 3, {4}, 0, [](World& w) { return w.insert_segment({5, 20}, {15, 20}, 4); });
  expect_made(world_, 5, {5}, 0, [](World& w) { return w.insert_polyline({{5, 30}, {15, 31}, {5, 32}}, 5); });
  expect_made(world_, 6, {6}, 0, [](World& w) { return w.insert_polygon({{5, 40}, {15, 40}, {15, 45}, {5, 45}}, 6); });
}

// Corners at vertices and sides on edges make no vertices.
TEST_P(OperationLimit, CountsNoVertexThatExists) {
  world_.insert_segment({10, 5}, {10, 95}, 1).value();
  world_.insert_segment({5, 20}, {15, 20}, 2).value();
  world_.set_new_vertex_limit(0);
  EXPECT_TRUE(world_.insert_segment({10, 95}, {10, 20}, 3).ok());
  EXPECT_TRUE(world_.insert_point({0, 0}, 4).ok());
  EXPECT_TRUE(world_.insert_polyline({{5, 20}, {10, 95}, {15, 20}}, 5).ok());
  EXPECT_TRUE(world_.insert_points({{10, 5}, {15, 20}}, 6).ok());
  EXPECT_TRUE(world_.remove(1).ok());
  EXPECT_FALSE(world_.insert_point({50, 50}).ok());
  EXPECT_EQ(world_.validate().fault, "");
}

TEST_P(OperationLimit, HoldsForAReplacement) {
  world_.insert_all(upright(3, 1)).value();
  world_.insert_segment({2, 50}, {98, 50}, 9).value();
  // Three crossings and two ends, although as many vertices go.
  expect_made(world_, 5, {9}, 0, [](World& w) { return w.replace(9, Shape::segment({2, 60}, {98, 60})); });
  // The same shape again.
  expect_made(world_, 5, {9}, 0, [](World& w) { return w.replace(9, Shape::segment({98, 60}, {2, 60})); });
}

TEST_P(OperationLimit, HoldsForAllChangesOfABatchTogether) {
  world_.insert_all(upright(3, 1)).value();
  world_.insert_segment({2, 50}, {98, 50}, 9).value();
  const std::vector<Change> changes = {Change::insert(Shape::segment({2, 20}, {98, 20}), 11),    // 5
                                       Change::remove(9),                                        // 0
                                       Change::insert(Shape::point({50, 50}), 12),               // 1
                                       Change::insert(Shape::segment({2, 30}, {98, 30}), 13),    // 5
                                       Change::replace(2, Shape::segment({50, 25}, {50, 98}))};  // 3
  expect_made(world_, 14, {2}, 4, [&](World& w) { return w.apply(changes); });
  // The batch of two insertions passes the limit: at the last crossing of its second one.
  const std::vector<Change> two(changes.begin() + 2, changes.begin() + 4);
  world_.remove(12).value();
  world_.remove(13).value();
  expect_made(world_, 6, {13}, 3, [&](World& w) {
    return w.apply({Change::remove(11), Change::replace(2, Shape::point({60, 70})), two[0], two[1]});
  });
}

TEST_P(OperationLimit, HoldsForABulkLoadIntoAWorldWithAndWithoutItems) {
  for (const std::size_t threads : {1U, 2U}) {
    BulkOptions options;
    options.threads = threads;
    const std::uint64_t first = 1000 * threads;
    std::vector<Item> items = upright(3, first);
    items.push_back({{first + 3}, Shape::segment({2, 50}, {98, 50})});
    const Point shift{static_cast<double>(first) / 4000, static_cast<double>(first) / 4000};
    // The items of the first round stay. The items of the second round cross them, and each other.
    for (Item& item : items) {
      for (Point& p : item.shape.rings.points()) p = p - shift;
    }
    const std::size_t crossings = threads == 1 ? 3 : 9;
    expect_made(world_, 8 + crossings, ErrorCode::too_many_vertices, std::nullopt,
                [&](World& w) { return w.insert_all(items, options); });
  }
}

// Each new corner takes half of the edges of the corner before, which is costly. So the library inserts most corners in
// scattered order.
TEST_P(OperationLimit, HoldsForManyCornersBesideManyCorners) {
  constexpr std::size_t n = 320;
  const auto line = [](double y) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back({10 + static_cast<double>(i) / 8, y});
    return Shape::polyline(points);
  };
  world_.insert(line(10), 1).value();
  expect_made(world_, n, {2}, 0, [&](World& w) { return w.insert(line(90), 2); });
  const std::vector<Item> items = {{{3}, line(20)}, {{4}, line(80)}};
  expect_made(world_, 2 * n, ErrorCode::too_many_vertices, std::nullopt, [&](World& w) { return w.insert_all(items); });
}

TEST_P(OperationLimit, HoldsForPoints) {
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) points.push_back({5.0 + i % 8 * 10, 5.0 + i / 8 * 20});
  points.push_back(points.front());
  points.push_back({0, 0});
  std::vector<bool> is_refused(points.size(), false);
  for (int round = 0; round < 2; ++round) {
    world_.set_new_vertex_limit(39);
    const WorldState before(world_);
    const auto refused = world_.insert_points(points);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::too_many_vertices);
    EXPECT_LT(refused.error().index, 40U);
    EXPECT_EQ(refused.error().item.value, refused.error().index + (round == 0 ? 1 : 43));
    EXPECT_EQ(WorldState(world_), before);
    world_.set_new_vertex_limit(40);
    EXPECT_TRUE(world_.insert_points(points).ok());
    EXPECT_EQ(world_.validate().fault, "");
    for (Point& p : points) p.x += p.x == 0 ? 0 : 1;
  }
}

TEST_P(OperationLimit, LeavesTheNextIdToTheNextOperation) {
  world_.insert_all(upright(2, 1)).value();
  world_.set_new_vertex_limit(3);
  EXPECT_FALSE(world_.insert_segment({2, 50}, {98, 50}, 700).ok());
  EXPECT_FALSE(world_.insert_segment({2, 50}, {98, 50}).ok());
  EXPECT_FALSE(world_.insert_points({{1, 1}, {2, 1}, {3, 1}, {4, 1}}).ok());
  EXPECT_EQ(world_.insert_point({50, 50}).value(), ItemId{3});
}

TEST(OperationLimitOf, AWorldIsNoneUnlessSet) {
  World world = World::create(kHundred).value();
  EXPECT_EQ(world.new_vertex_limit(), kNoVertexLimit);
  world.set_new_vertex_limit(3);
  World moved = std::move(world);
  EXPECT_EQ(moved.new_vertex_limit(), 3U);
  moved.insert_points({{1, 1}, {2, 1}, {3, 1}}).value();
  EXPECT_EQ(moved.new_vertex_limit(), 3U);
  EXPECT_FALSE(moved.insert_points({{1, 2}, {2, 2}, {3, 2}, {4, 2}}).ok());
  moved.set_new_vertex_limit(kNoVertexLimit);
  EXPECT_TRUE(moved.insert_points({{1, 2}, {2, 2}, {3, 2}, {4, 2}}).ok());
  EXPECT_EQ(World::create(kHundred, {.new_vertex_limit = 7}).value().new_vertex_limit(), 7U);
}

TEST(OperationLimitOf, AWorldSaysWhatPassedWhichLimit) {
  World world = World::create(kHundred, {.new_vertex_limit = 3}).value();
  world.insert_segment({10, 50}, {90, 50}).value();
  EXPECT_EQ(
      world.insert_polyline({{20, 40}, {30, 60}, {40, 40}}, 7).error().message(),
      "item 7 would bring the operation to more than 3 new vertices, its limit; divide the operation or raise the "
      "limit");
  EXPECT_EQ(world.insert_all(std::vector<Item>{{{8}, Shape::point({1, 1})}, {{9}, Shape::segment({5, 5}, {30, 99})}})
                .error()
                .message(),
            "item 1: item 9 would bring the operation to more than 3 new vertices, its limit; divide the operation or "
            "raise the limit");
  EXPECT_EQ(to_string(ErrorCode::too_many_vertices), "too-many-vertices");
  WorldInternals::set_most_vertices(world, 7);
  EXPECT_EQ(world.insert_segment({20, 40}, {30, 30}, 7).error().message(),
            "item 7 would bring the world to more than 7 vertices; remove items or divide the world");
}

// A long side that would cross very many others does not cross them all before it is refused: the mesh allocates no
// memory for vertices that the limit does not allow.
TEST(OperationLimitOf, AWorldStopsTheOperationWhenItPassesTheLimit) {
  World world = World::create(kHundred).value();
  std::vector<Item> walls;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double x = 10 + static_cast<double>(i) / 16;
    walls.push_back({{i + 1}, Shape::segment({x, 5}, {x, 95})});
  }
  world.insert_all(walls).value();
  world.shrink_to_fit();
  const auto memory_of_refusal = [&](std::size_t limit) {
    World fresh = World::create(kHundred).value();
    fresh.insert_all(walls).value();
    fresh.set_new_vertex_limit(limit);
    const std::size_t before = fresh.memory().total();
    EXPECT_FALSE(fresh.insert(zigzag(40)).ok());
    return fresh.memory().total() - before;
  };
  EXPECT_LT(10 * memory_of_refusal(200), memory_of_refusal(40'000));
}

TEST(FullWorld, RefusesCrossingsThatItCannotNumber) {
  for (const WorldOptions& options : all_options()) {
    World world = World::create(kHundred, options).value();
    constexpr std::size_t n = 5;
    const std::vector<Item> items = upright(n, 1);
    expect_made(world, 4 + 2 * n, ErrorCode::too_large, std::nullopt, [&](World& w) { return w.insert_all(items); });
    expect_made(world, 4 + 4 * n + n * n, ErrorCode::too_large, Named{{50}},
                [](World& w) { return w.insert(zigzag(n), {50}); });
    // The world is full now, but a replacement first removes vertices.
    EXPECT_EQ(world.insert_point({99, 99}).error().code, ErrorCode::too_large);
    EXPECT_TRUE(world.replace(50, zigzag(n)).ok());
    EXPECT_EQ(world.replace(50, zigzag(n + 1)).error().code, ErrorCode::too_large);
    EXPECT_TRUE(world.apply({Change::remove(1), Change::insert(Shape::point({99, 99}), 60)}).ok());
    EXPECT_TRUE(world.insert_point({10, 10}).ok());
    WorldInternals::set_most_vertices(world, world.vertex_count() + 2);
    EXPECT_TRUE(world
                    .apply({Change::insert(Shape::point({98, 1}), 71), Change::remove(60),
                            Change::insert(Shape::segment({99, 1}, {99, 2}), 72)})
                    .ok());
    EXPECT_EQ(world.insert_point({99, 99}).error().code, ErrorCode::too_large);
    EXPECT_EQ(world.validate().fault, "");
  }
}

class OperationLimitOfRandomSteps : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, OperationLimitOfRandomSteps, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

/// Performs each step of a script in a world with limits: with one vertex too few, and then with as many vertices as
/// the changes make in another world, one after the other.
void check_limits(const ChangeScript& script, const WorldOptions& options) {
  World counted = World::create(script.domain).value();
  World world = World::create(script.domain, options).value();
  LiveItems live(script.domain);
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    SCOPED_TRACE("step " + std::to_string(i));
    const auto expected = live.apply(script.steps[i]);
    if (!expected) continue;
    const std::size_t made = count_new_vertices(counted, script.steps[i]);
    if (made > 0) {
      world.set_new_vertex_limit(made - 1);
      const WorldState before(world);
      const auto refused = perform(world, script.steps[i]);
      ASSERT_FALSE(refused.ok()) << "makes " << made;
      ASSERT_EQ(refused.error().code, ErrorCode::too_many_vertices);
      ASSERT_EQ(WorldState(world), before);
      ASSERT_EQ(world.validate().fault, "");
    }
    world.set_new_vertex_limit(made);
    const auto done = perform(world, script.steps[i]);
    ASSERT_TRUE(done.ok()) << done.error().message() << ", makes " << made;
    ASSERT_EQ(*done, *expected);
    ASSERT_EQ(world.dump(), counted.dump());
  }
}

TEST_P(OperationLimitOfRandomSteps, IsTheNumberOfVerticesThatTheyMake) {
  for (std::uint64_t seed = 1; seed <= case_count() / 10 + 1; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check_limits(random_changes(GetParam(), seed, 40, 8), all_options().at(seed % 3));
    if (HasFatalFailure()) return;
  }
}

TEST_P(OperationLimitOfRandomSteps, IsTheNumberOfVerticesThatABulkLoadMakes) {
  for (std::uint64_t seed = 1; seed <= case_count() / 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(GetParam(), seed, seed % 30 + 1);
    World counted = World::create(scene.domain).value();
    std::size_t made = 0;
    for (const Item& item : scene.items) made += count_new_vertices(counted, {{Change::insert(item.shape, item.id)}});
    if (made == 0) continue;
    World world = World::create(scene.domain, {.new_vertex_limit = made - 1}).value();
    const WorldState before(world);
    const auto refused = world.insert_all(scene.items);
    ASSERT_FALSE(refused.ok());
    ASSERT_EQ(refused.error().item, scene.items.at(refused.error().index).id);
    ASSERT_EQ(WorldState(world), before);
    world.set_new_vertex_limit(made);
    ASSERT_TRUE(world.insert_all(scene.items).ok());
    ASSERT_EQ(world.dump(), counted.dump());
  }
}

}  // namespace
}  // namespace waywright::test

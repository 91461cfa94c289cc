#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

namespace waywright::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

World small_world() { return World::create({{0, 0}, {4, 4}}).value(); }

Item item(std::uint64_t id, ItemKind kind, std::vector<Point> ring) { return {{id}, {kind, {std::move(ring)}}}; }

/// Returns a wall, a polygon that crosses it and repeats a corner, a point on both, and a point on a corner of the
/// domain.
std::vector<Item> crossing_items() {
  return {item(0, ItemKind::segment, {{0, 2}, {4, 2}}),
          item(9, ItemKind::polygon, {{1, 1}, {3, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}),
          item(0, ItemKind::point, {{1, 2}}), item(0, ItemKind::point, {{-0.0, 4}})};
}

TEST(Bulk, MakesWhatOneByOneMakes) {
  World one_by_one = small_world();
  std::vector<ItemId> ids;
  for (const Item& item : crossing_items()) ids.push_back(one_by_one.insert(item.shape, item.id).value());
  World at_once = small_world();
  EXPECT_EQ(at_once.insert_all(crossing_items()).value(), ids);
  EXPECT_EQ(ids, (std::vector<ItemId>{{1}, {9}, {10}, {11}}));
  EXPECT_EQ(at_once.dump(), one_by_one.dump());
  EXPECT_EQ(at_once.items_hash(), one_by_one.items_hash());
  EXPECT_EQ(at_once.item_ids(), one_by_one.item_ids());
  EXPECT_TRUE(at_once.validate().ok) << at_once.validate().fault;
  for (const ItemId id : ids) EXPECT_EQ(at_once.shape(id).value(), one_by_one.shape(id).value());
}

TEST(Bulk, RefusedBatchesChangeNothing) {
  for (const bool is_empty : {true, false}) {
    World world = small_world();
    if (!is_empty) world.insert_point({1, 2}, {3}).value();
    const std::string before = world.dump();
    const auto expect_refused = [&](std::vector<Item> items, ErrorCode code, std::uint64_t index) {
      const auto result = world.insert_all(items);
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code, code) << result.error().message();
      EXPECT_EQ(result.error().index, index);
      EXPECT_EQ(world.dump(), before);
      EXPECT_EQ(world.item_count(), is_empty ? 0U : 1U);
    };
    const Item good = item(0, ItemKind::point, {{1, 1}});
    expect_refused({good, item(7, ItemKind::point, {{5, 1}})}, ErrorCode::out_of_domain, 1);
    expect_refused({item(7, ItemKind::segment, {{1, 1}, {1, kInfinity}}), good}, ErrorCode::coordinate_range, 0);
    expect_refused({good, good, item(8, ItemKind::segment, {{1, 1}})}, ErrorCode::bad_shape, 2);
    expect_refused({item(7, ItemKind::point, {{1, 1}}), item(7, ItemKind::point, {{2, 2}})}, ErrorCode::id_in_use, 1);
    expect_refused(
        {item(9, ItemKind::point, {{1, 1}}), item(8, ItemKind::point, {{1, 1}}), item(8, ItemKind::point, {{1, 1}})},
        ErrorCode::id_in_use, 2);
    expect_refused({item(ItemId::kLargest, ItemKind::point, {{1, 1}}), good}, ErrorCode::bad_id, 1);
  }
}

TEST(Bulk, PointsHaveConsecutiveIds) {
  World world = small_world();
  const std::vector<Point> points = {{1, 1}, {2, 2}, {1, 1}, {-0.0, 0}};
  EXPECT_EQ(world.insert_points(points).value(), ItemId{1});
  EXPECT_EQ(world.insert_points(points, {20}).value(), ItemId{20});
  EXPECT_EQ(world.insert_points({}, {}).value(), ItemId{24});
  EXPECT_EQ(world.item_ids(), (std::vector<ItemId>{{1}, {2}, {3}, {4}, {20}, {21}, {22}, {23}}));
  EXPECT_EQ(world.vertex_count(), 6U) << "four corners and two points";
  EXPECT_EQ(world.shape({21}).value(), (Shape{ItemKind::point, {{{2, 2}}}}));
  EXPECT_TRUE(world.validate().ok);
  const std::string before = world.dump();
  EXPECT_EQ(world.insert_points(points, {17}).error().code, ErrorCode::id_in_use) << "the fourth would be 20";
  EXPECT_EQ(world.insert_points(points, {17}).error().index, 3U);
  EXPECT_EQ(world.insert_points(points, {ItemId::kLargest - 2}).error().code, ErrorCode::bad_id);
  EXPECT_EQ(world.insert_points(std::vector<Point>{{1, 1}, {1, 5}}).error().index, 1U);
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.insert_points(points, {5}).value(), ItemId{5});
  EXPECT_EQ(world.insert_point({3, 3}).value(), ItemId{24});
}

// The world never gives out an id twice, even after it was emptied.
TEST(Bulk, AnEmptiedWorldRemembersItsLargestId) {
  World world = small_world();
  world.insert_point({1, 1}, {40}).value();
  world.remove({40}).value();
  EXPECT_EQ(world.insert_all(std::vector<Item>{item(7, ItemKind::point, {{1, 1}})}).value(), std::vector{ItemId{7}});
  EXPECT_EQ(world.insert_point({1, 1}).value(), ItemId{41});
}

TEST(Bulk, ChangesInRunsAreThoseOneByOne) {
  const auto insertion = [](std::uint64_t id, Point a, Point b) {
    return Change{Change::Kind::insert, {id}, {ItemKind::segment, {{a, b}}}};
  };
  const std::vector<Change> changes = {
      insertion(1, {0, 0}, {4, 4}),    insertion(2, {0, 4}, {4, 0}), {Change::Kind::remove, {1}, {}},
      insertion(1, {0, 2}, {4, 2}),    insertion(3, {2, 0}, {2, 4}), insertion(4, {1, 0}, {3, 4}),
      {Change::Kind::remove, {3}, {}}, insertion(3, {1, 1}, {2, 1}),
  };
  World at_once = small_world();
  World one_by_one = small_world();
  ASSERT_TRUE(at_once.apply(changes).ok());
  for (const Change& change : changes) ASSERT_TRUE(one_by_one.apply({&change, 1}).ok());
  EXPECT_EQ(at_once.dump(), one_by_one.dump());
  EXPECT_TRUE(at_once.validate().ok);
}

TEST(Bulk, ProgressEndsAtItsTotal) {
  std::vector<Item> items;
  for (int i = 0; i < 3000; ++i) {
    const double x = (i % 60) / 16.0;
    const double y = (i / 60) / 16.0;
    items.push_back(item(0, ItemKind::segment, {{x, y}, {x + 0.03125, y + 0.03125}}));
  }
  for (const bool is_empty : {true, false}) {
    World world = small_world();
    if (!is_empty) world.insert_point({2, 2}).value();
    std::vector<std::size_t> seen;
    const auto progress = [&](std::size_t done, std::size_t total) {
      EXPECT_EQ(total, 9000U) << "corners and items";
      seen.push_back(done);
    };
    world.insert_all(items, {.threads = 1, .progress = progress}).value();
    EXPECT_GT(seen.size(), 4U);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), 9000U);
    EXPECT_TRUE(world.validate().ok);
  }
}

TEST(InsertPoints, ChecksTheIdWithoutPointsToo) {
  World world = World::create({{0, 0}, {1, 1}}).value();
  world.insert_point({0.5, 0.5}, 7).value();
  EXPECT_EQ(world.insert_points({}, {~std::uint64_t{0}}).error().code, ErrorCode::bad_id);
  EXPECT_EQ(world.insert_points({}, 7).error().code, ErrorCode::id_in_use);
  EXPECT_EQ(world.insert_points({}).value(), ItemId{8});
}

TEST(InsertPoints, TakesHugeNumbersOfThreads) {
  World world = World::create({{0, 0}, {1, 1}}).value();
  std::vector<Point> points;
  for (int i = 1; i < 500; ++i) points.push_back({i / 500.0, (i * 37 % 500) / 500.0});
  World other = World::create({{0, 0}, {1, 1}}).value();
  BulkOptions options;
  options.threads = std::numeric_limits<std::size_t>::max();
  world.insert_points(points, {}, options).value();
  other.insert_points(points).value();
  EXPECT_EQ(world.mesh_hash(), other.mesh_hash());
  const std::vector<PathQuery> queries(3, PathQuery{{0.1, 0.1}, {0.9, 0.9}});
  EXPECT_EQ(world.find_paths(queries, std::numeric_limits<std::size_t>::max()).value().size(), 3U);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

/// Returns how many allocations the call makes.
template <class Call>
std::size_t allocations_of(Call&& call) {
  const std::size_t before = allocation_count();
  call();
  return allocation_count() - before;
}

World world_of_things() {
  World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
  Random random(5);
  const auto between = [&](int low, int high) { return static_cast<double>(random.between(low, high)); };
  for (int i = 0; i < 120; ++i) {
    const Point at{between(5, 900), between(5, 900)};
    world.insert_polygon({at, at + Point{between(3, 90), between(0, 9)}, at + Point{between(0, 9), between(4, 90)}})
        .value();
    world.insert_segment(at, {between(1, 999), between(1, 999)}).value();
    world.insert_point({between(1, 999), between(1, 999)}).value();
  }
  world.insert_segment({500, 500}, {500, 500}).value();
  world.insert_polygon({{{10, 10}, {60, 10}, {60, 60}}, {{20, 15}, {40, 15}, {40, 30}}}).value();
  return world;
}

TEST(AllocationFree, WarmQueriesAboutItemsAndTheMesh) {
  const World world = world_of_things();
  QueryContext context;
  std::vector<ItemId> at;
  std::vector<ItemId> in;
  std::vector<ItemId> ids;
  std::vector<CrossedItem> crossed;
  std::vector<Item> items;
  DiscFit fit;
  NearestFit nearest;
  WidestPath widest;
  RayHit hit;
  Shape shape;
  MeshSnapshot snapshot;
  std::size_t answers = 0;
  const auto ask_all = [&] {
    for (int i = 0; i < 60; ++i) {
      const Point point{15.5 * i + 20, 900 - 14.25 * i};
      world.items_at(point, context, at).value();
      world.items_crossed(point, {1000 - point.y, point.x}, context, crossed).value();
      world.items_in({point - Point{20, 10}, point + Point{90, 60}}, context, in).value();
      world.items_in({{2000, 2000}, {3000, 3000}}, context, in).value();
      world.fit_disc(point, {.radius = 5.0 + i}, context, fit).value();
      world.nearest_fit({.point = point, .agent = {.radius = 1.0 + 0.1 * i}}, context, nearest).value();
      answers += nearest.is_found ? 1 : 0;
      world.nearest_fit({.point = point, .agent = {.radius = 1}, .goal = nearest.at}, context, nearest).value();
      world.widest_path(point, {1000 - point.y, point.x}, {}, context, widest).value();
      world.ray(point, {1000 - point.y, point.x}, {.radius = 0.1 + 0.25 * (i % 8)}, context, hit).value();
      world.ray({1 + point.x, 2}, {1 + point.x, 990}, {.radius = 1}, context, hit).value();
      answers += at.size() + crossed.size() + fit.items.size() + widest.to_items.size();
    }
    for (std::uint64_t id = 1; id <= world.item_count(); ++id) world.shape(id, shape).value();
    world.item_ids(ids);
    world.items(context, items);
    world.snapshot(context, snapshot);
  };
  ask_all();
  EXPECT_GT(answers, 1000U);
  EXPECT_EQ(allocations_of(ask_all), 0U);
}

TEST(AllocationFree, WarmPathsOfDiscs) {
  World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
  for (int i = 0; i < 60; ++i) {
    const Point at{40.0 + 97 * (i % 9), 30.0 + 131 * (i / 9) + 11 * (i % 7)};
    world.insert(Shape::rectangle({at, at + Point{40.0 + i, 25.0}})).value();
  }
  QueryContext context;
  Path path;
  std::size_t found = 0;
  const auto ask_all = [&] {
    for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal}) {
      for (int i = 0; i < 12; ++i) {
        const Point start{20, 20 + 80.0 * i};
        const PathQuery query{
            .start = start, .goal = {980, 980 - start.y}, .agent = {.radius = 0.5 + 2.0 * i}, .algorithm = algorithm};
        world.find_path(query, context, path).value();
        found += path.status == PathStatus::found ? 1 : 0;
      }
    }
  };
  ask_all();
  EXPECT_GT(found, 9U);
  EXPECT_EQ(allocations_of(ask_all), 0U);
}

TEST(AllocationFree, WalksOfDiscs) {
  World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
  for (int i = 1; i < 10; ++i) world.insert_segment({100.0 * i, 100}, {100.0 * i + 30, 900}).value();
  const std::uint64_t version = world.version();
  std::vector<Path> paths;
  for (int i = 1; i < 30; ++i) {
    paths.push_back(
        world.find_path({.start = {50, 30.0 * i + 20}, .goal = {980, 500}, .agent = {.radius = 0.5 * i}}).value());
  }
  world.insert_segment({400, 450}, {600, 550}).value();
  std::vector<Point> line;
  std::vector<std::size_t> affected;
  std::size_t positions = 0;
  const auto walk_all = [&] {
    for (const Path& path : paths) {
      if (path.status != PathStatus::found) continue;
      PathPosition position = path.at(0);
      for (; position.distance < path.length; ++positions) position = path.advance(position, path.length / 20);
      position = path.nearest(position.at);
      path.polyline(0.01, line).value();
      positions += line.size();
    }
    world.find_affected(paths, version, affected);
  };
  walk_all();
  EXPECT_GT(positions, 1000U);
  EXPECT_EQ(allocations_of(walk_all), 0U);
}

// Both forms of a query give the same answer, whatever the reused objects contained before.
TEST(AllocationFree, FormsOfAQueryAgree) {
  const World world = world_of_things();
  QueryContext context;
  std::vector<ItemId> ids;
  std::vector<CrossedItem> crossed;
  DiscFit fit;
  NearestFit nearest;
  WidestPath widest;
  RayHit hit;
  std::vector<Item> items(3, {77, Shape::polygon({{1, 2}, {3, 4}})});
  Shape shape;
  MeshSnapshot snapshot;
  for (int i = 0; i < 60; ++i) {
    const Point point{15.5 * i + 20, 900 - 14.25 * i};
    const Point other{1000 - point.y, point.x};
    const Box box{point - Point{20, 10}, point + Point{90, 60}};
    world.items_at(point, context, ids).value();
    ASSERT_EQ(ids, world.items_at(point).value());
    world.items_crossed(point, other, context, crossed).value();
    ASSERT_EQ(crossed, world.items_crossed(point, other).value());
    world.items_in(box, context, ids).value();
    ASSERT_EQ(ids, world.items_in(box).value());
    world.fit_disc(point, {.radius = 5.0 + i}, context, fit).value();
    ASSERT_EQ(fit, world.fit_disc(point, {.radius = 5.0 + i}).value());
    const NearestFitQuery query{.point = point, .agent = {.radius = 2}, .goal = other};
    world.nearest_fit(query, context, nearest).value();
    ASSERT_EQ(nearest, world.nearest_fit(query).value());
    world.widest_path(point, other, {}, context, widest).value();
    ASSERT_EQ(widest, world.widest_path(point, other).value());
    world.ray(point, other, {.radius = 0.5 * i}, context, hit).value();
    ASSERT_EQ(hit, world.ray(point, other, {.radius = 0.5 * i}).value());
  }
  world.items_in({{2000, 2000}, {3000, 3000}}, context, ids).value();
  EXPECT_EQ(ids, std::vector<ItemId>());
  world.item_ids(ids);
  EXPECT_EQ(ids, world.item_ids());
  ASSERT_EQ(ids.size(), world.item_count());
  for (int round = 0; round < 2; ++round) {
    world.items(context, items);
    ASSERT_EQ(items, world.items());
    world.snapshot(context, snapshot);
    const MeshSnapshot fresh = world.snapshot();
    EXPECT_EQ(snapshot.vertices, fresh.vertices);
    EXPECT_EQ(snapshot.triangles, fresh.triangles);
    EXPECT_EQ(snapshot.ids, fresh.ids);
    EXPECT_EQ(snapshot.constraints.size(), fresh.constraints.size());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    world.shape(ids[i], shape).value();
    ASSERT_EQ(shape, world.shape(ids[i]).value());
    ASSERT_EQ((Item{ids[i], shape}), items[i]);
  }
}

TEST(AllocationFree, Refusals) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  World world = world_of_things();
  const std::size_t before = world.item_count();
  const Shape inside = Shape::point({1, 1});
  const Shape outside = Shape::polygon({{1, 1}, {2, 1}, {2000, 5}});
  const Shape wrong = Shape::segment({1, 1}, {2, kNan});
  const Shape empty{ItemKind::polygon, {}};
  const std::vector<Point> points{{1, 1}, {2000, 2}};
  const std::vector<Point> goals{{1, 1}, {2, 2}, {3000, 3}};
  const std::vector<PathQuery> queries{{.start = {1, 1}, .goal = {2000, 2}}};
  std::vector<QueryContext> contexts(2);
  QueryContext& context = contexts[0];
  PathSearch search;
  Path path;
  std::vector<Path> paths;
  const World without_bridges = World::create({{0, 0}, {10, 10}}).value();
  Location location;
  RayHit hit;
  DiscFit fit;
  WidestPath widest;
  std::vector<ItemId> ids;
  std::vector<CrossedItem> crossed;
  std::vector<Point> line;
  Shape shape;
  std::size_t refusals = 0;
  const auto expect_refused = [&](const auto& result, ErrorCode code) {
    refusals += !result.ok() && result.error().code == code ? 1 : 0;
  };
  const std::size_t allocations = allocations_of([&] {
    expect_refused(world.insert(inside, 7), ErrorCode::id_in_use);
    expect_refused(world.insert(inside, -7), ErrorCode::bad_id);
    expect_refused(world.insert(outside), ErrorCode::out_of_domain);
    expect_refused(world.insert(wrong), ErrorCode::coordinate_range);
    expect_refused(world.insert(empty), ErrorCode::bad_shape);
    expect_refused(world.insert_points(points), ErrorCode::out_of_domain);
    expect_refused(world.remove(123456), ErrorCode::unknown_id);
    expect_refused(world.replace(123456, inside), ErrorCode::unknown_id);
    expect_refused(world.replace(7, outside), ErrorCode::out_of_domain);
    expect_refused(world.find_path(queries[0], context, path), ErrorCode::out_of_domain);
    expect_refused(world.find_path({{1, 1}, {2, 2}, -1.0}, context, path), ErrorCode::bad_radius);
    expect_refused(world.find_paths(queries, contexts, paths), ErrorCode::out_of_domain);
    expect_refused(world.find_paths_from({{1, 1}, goals}, context, paths), ErrorCode::out_of_domain);
    expect_refused(search.begin(world, queries[0]), ErrorCode::out_of_domain);
    expect_refused(world.locate({1, -1}, context, location), ErrorCode::out_of_domain);
    expect_refused(world.ray({1, 1}, {2000, 1}, {}, context, hit), ErrorCode::out_of_domain);
    expect_refused(world.ray({1, 1}, {2000, 1}, {.radius = 1}, context, hit), ErrorCode::out_of_domain);
    expect_refused(world.ray({1, 1}, {2, 1}, {.radius = -1}, context, hit), ErrorCode::bad_radius);
    expect_refused(world.fit_disc({1, -1}, {.radius = 1}, context, fit), ErrorCode::out_of_domain);
    expect_refused(world.fit_disc({1, 1}, {.radius = -1}, context, fit), ErrorCode::bad_radius);
    expect_refused(path.polyline(-1, line), ErrorCode::bad_distance);
    expect_refused(world.widest_path({1, 1}, {-1, 1}, {}, context, widest), ErrorCode::out_of_domain);
    expect_refused(without_bridges.widest_path({1, 1}, {2, 1}, {}, context, widest), ErrorCode::no_bridges);
    expect_refused(world.items_at({1, kNan}, context, ids), ErrorCode::coordinate_range);
    expect_refused(world.items_crossed({1, 1}, {-1, 1}, context, crossed), ErrorCode::out_of_domain);
    expect_refused(world.items_in({{3, 3}, {2, 2}}, context, ids), ErrorCode::bad_domain);
    expect_refused(world.shape(123456, shape), ErrorCode::unknown_id);
    expect_refused(World::create({{1, 1}, {0, 0}}), ErrorCode::bad_domain);
    expect_refused(World::create({{1, 1}, {kNan, 0}}), ErrorCode::coordinate_range);
  });
  EXPECT_EQ(refusals, 29U);
  EXPECT_EQ(allocations, 0U);
  EXPECT_EQ(world.item_count(), before);
}

TEST(Allocations, OfAShapeOfOneRingAreOne) {
  const std::vector<Point> list(40);
  const std::vector<std::vector<Point>> lists{list};
  Shape made;
  EXPECT_EQ(allocations_of([&] { made = Shape{ItemKind::polygon, {{{0, 0}, {1, 0}, {1, 1}}}}; }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::polygon({{0, 0}, {1, 0}, {1, 1}}); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::polygon(list); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::polygon(lists); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::polyline(list); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::segment({0, 0}, {1, 0}); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::point({0, 0}); }), 1U);
  EXPECT_EQ(allocations_of([&] { made = Shape::regular_polygon({0, 0}, 1, 100); }), 1U);
  const Shape shape = Shape::polygon(list);
  EXPECT_EQ(allocations_of([&] { Shape copy = shape; }), 1U);
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_polygon({{0, 0}, {5, 0}, {5, 5}, {4, 7}, {1, 4}}, 1).value();
  world.insert_segment({1, 1}, {1, 1}, 2).value();
  EXPECT_EQ(allocations_of([&] { static_cast<void>(world.shape(1).value()); }), 1U);
  EXPECT_EQ(allocations_of([&] { static_cast<void>(world.shape(2).value()); }), 1U);
  std::vector<Point> given(20);
  EXPECT_EQ(allocations_of([&] { made = Shape::polygon(std::move(given)); }), 0U);
}

}  // namespace
}  // namespace waywright::test

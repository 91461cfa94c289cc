#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/predicate_counts.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"

// Inputs for which the library has algorithms of their own, so that their cost grows no faster than their size. The
// mesh is canonical, so each state must equal a new world of the live items.

namespace waywright::test {
namespace {

constexpr Box kDomain = {{-1000, -1000}, {1000, 1000}};

void expect_right(const World& world) {
  const Validation validation = world.validate();
  ASSERT_TRUE(validation.ok) << validation.fault;
  World rebuilt = World::create(world.domain()).value();
  static_cast<void>(rebuilt.insert_all(world.items()).value());
  ASSERT_EQ(world.mesh_hash(), rebuilt.mesh_hash());
  ASSERT_EQ(world.dump(), rebuilt.dump());
}

/// Returns 0 to `count` - 1 in an order that looks random and is always the same.
std::vector<std::size_t> mixed(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::uint64_t state = count;
  for (std::size_t i = count; i > 1; --i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    std::swap(order[i - 1], order[static_cast<std::size_t>(state >> 33) % i]);
  }
  return order;
}

std::vector<Point> circle(double radius, std::size_t corners) {
  const Shape shape = Shape::regular_polygon({0, 0}, radius, corners);
  return {shape.rings.points().begin(), shape.rings.points().end()};
}

Shape square(const Point& centre, double half) {
  return Shape::rectangle({{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}});
}

/// Inserts the shapes, then removes them in the given order. Compares every `stride`-th state with a new world.
void insert_and_remove(World& world, const std::vector<Shape>& shapes, const std::vector<std::size_t>& removal,
                       std::size_t stride) {
  std::size_t operations = 0;
  std::vector<ItemId> ids;
  for (const Shape& shape : shapes) {
    ids.push_back(world.insert(shape).value());
    ++operations;
    if (operations % stride == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
    }
  }
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
  for (const std::size_t i : removal) {
    world.remove(ids[i]).value();
    ++operations;
    if (operations % stride == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
    }
  }
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
}

TEST(Growth, RingsBesideEachOther) {
  for (const std::size_t corners : {200U, 333U}) {
    World world = World::create(kDomain).value();
    const std::vector<Shape> shapes = {Shape::polygon({circle(900, corners), circle(800, corners)}),
                                       Shape::polygon(circle(700, corners)), Shape::polyline(circle(650, corners))};
    insert_and_remove(world, shapes, {1, 0, 2}, 1);
  }
}

TEST(Growth, RingsInsertedAtOnceIntoAWorld) {
  World world = World::create(kDomain).value();
  static_cast<void>(world.insert(Shape::polygon(circle(900, 300))).value());
  const std::vector<Item> items = {{ItemId{10}, Shape::polygon(circle(800, 300))},
                                   {ItemId{11}, Shape::polygon(circle(790, 300))}};
  static_cast<void>(world.insert_all(items).value());
  expect_right(world);
}

/// Square rings around the origin, each with a door.
std::vector<Item> rings_with_doors(std::size_t count) {
  std::vector<Item> items;
  for (std::size_t i = 1; i <= count; ++i) {
    const double half = 900.0 * static_cast<double>(i) / static_cast<double>(count);
    const double door = half / 128;
    const std::vector<Point> ring = {{-door, -half}, {-half, -half}, {-half, half},
                                     {half, half},   {half, -half},  {door, -half}};
    items.push_back({ItemId{i}, Shape::polyline(ring)});
  }
  return items;
}

/// Returns how many orientation and in-circle tests this thread has made.
std::uint64_t test_count() {
  const PredicateCounts counts = predicate_counts();
  const auto sum = [](const StageCounts& c) { return c.doubles + c.lattice + c.integers; };
  return sum(counts.orientation) + sum(counts.in_circle);
}

// If the sides are inserted from the centre outwards, each one crosses many edges.
TEST(Growth, RingsWithDoorsInsertedAtOnce) {
  for (const bool is_empty : {true, false}) {
    std::uint64_t tests[2] = {};
    for (const std::size_t i : {0U, 1U}) {
      World world = World::create(kDomain).value();
      if (!is_empty) world.insert_point({999, 999}, 5000).value();
      const std::uint64_t before = test_count();
      static_cast<void>(world.insert_all(rings_with_doors(i == 0 ? 1000 : 2000)).value());
      tests[i] = test_count() - before;
    }
    EXPECT_LT(tests[1], 3 * tests[0]) << tests[0];
  }
  World world = World::create(kDomain).value();
  World other = World::create(kDomain).value();
  const std::vector<Item> items = rings_with_doors(150);
  static_cast<void>(world.insert_all(items).value());
  for (const Item& item : items) other.insert(item.shape, item.id).value();
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
  EXPECT_EQ(world.dump(), other.dump());
}

TEST(Growth, VerticesWithManyNeighbours) {
  for (const std::size_t corners : {34U, 60U, 200U}) {
    World world = World::create(kDomain).value();
    std::vector<Point> points = circle(512, corners);
    static_cast<void>(world.insert_points(points).value());
    for (const Point& hub : {Point{0, 0}, Point{0.5, 0.25}, Point{1e-9, 0}}) {
      const ItemId id = world.insert_point(hub).value();
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
      world.remove(id).value();
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
    }
  }
}

// Rows of whole points to the left and to the right of a vertex: many neighbours on one line, and many on circles.
TEST(Growth, VerticesWithManyNeighboursOnLines) {
  for (const double height : {1.0, 40.0, 200.0, 900.0}) {
    World world = World::create(kDomain).value();
    for (int x = -60; x <= 60; ++x) {
      static_cast<void>(world.insert_point({static_cast<double>(x), -height}).value());
      static_cast<void>(world.insert_point({static_cast<double>(x), height}).value());
    }
    for (const Point& hub : {Point{0, 0}, Point{0.5, 0}, Point{0, 0.5}, Point{7, -0.125}}) {
      const ItemId id = world.insert_point(hub).value();
      world.remove(id).value();
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
    }
    // A corner on a wall, whose removal leaves a cavity on its left and one on its right.
    static_cast<void>(world.insert_segment({-900, 0}, {900, 0}).value());
    for (const Point& hub : {Point{0, 0}, Point{0.5, 0}, Point{-33, 0}}) {
      const ItemId id = world.insert_point(hub).value();
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
      world.remove(id).value();
      ASSERT_NO_FATAL_FAILURE(expect_right(world));
    }
  }
}

// Whole points on the circle of radius 5^4 * 13: exactly cocircular, so the tie rule decides everything.
TEST(Growth, VerticesWithManyNeighboursOnOneCircle) {
  std::vector<Point> points;
  constexpr std::int64_t kRadius = 5 * 5 * 13 * 17;
  for (std::int64_t x = -kRadius; x <= kRadius; ++x) {
    const std::int64_t rest = kRadius * kRadius - x * x;
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(rest))));
    if (y * y != rest) continue;
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) points.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  ASSERT_GT(points.size(), 80U);
  World world = World::create({{-10000, -10000}, {10000, 10000}}).value();
  static_cast<void>(world.insert_points(points).value());
  for (const Point& hub : {Point{0, 0}, Point{3, 5}, Point{-100, 17}, Point{0.5, -0.25}}) {
    const ItemId id = world.insert_point(hub).value();
    ASSERT_NO_FATAL_FAILURE(expect_right(world));
    world.remove(id).value();
    ASSERT_NO_FATAL_FAILURE(expect_right(world));
  }
}

TEST(Growth, NestedPolygons) {
  constexpr std::size_t kCount = 24;
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < kCount; ++i) shapes.push_back(Shape::polygon(circle(900.0 - 30.0 * double(i), 40)));
  std::vector<std::size_t> order = mixed(kCount);
  std::vector<Shape> shuffled;
  for (const std::size_t i : order) shuffled.push_back(shapes[i]);
  std::vector<std::size_t> forwards(kCount);
  for (std::size_t i = 0; i < kCount; ++i) forwards[i] = i;
  for (const auto& inserted : {shapes, shuffled}) {
    for (const auto& removal : {forwards, order}) {
      World world = World::create(kDomain).value();
      ASSERT_NO_FATAL_FAILURE(insert_and_remove(world, inserted, removal, 3));
    }
  }
}

/// Inserts a grid of `count` x `count` small squares, with the upper right corner at (0, 0).
void insert_town(World& world, int count) {
  std::vector<Item> town;
  for (int i = 0; i < count * count; ++i) {
    town.push_back({{}, square({-3.0 - 5.0 * (i % count), -3.0 - 5.0 * (i / count)}, 1.5)});
  }
  static_cast<void>(world.insert_all(town).value());
}

// The larger squares come first, so each square encloses all later ones of the operation.
TEST(Growth, NestedPolygonsInsertedAtOnceIntoATown) {
  World world = World::create(kDomain).value();
  insert_town(world, 30);
  std::vector<Item> nested;
  for (int i = 40; i > 0; --i) nested.push_back({{}, square({500, 500}, i)});
  const std::vector<ItemId> ids = world.insert_all(nested).value();
  EXPECT_EQ(world.items_at({500, 500}).value(), ids);
  EXPECT_EQ(world.items_at({510.5, 500}).value(), std::vector(ids.begin(), ids.begin() + 30));
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
  world.remove(ids[20]).value();
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
}

// The search for the winding number beside a ring ends left of the polygon. It does not go to the border of the domain.
TEST(Growth, ACourtyardInALargeTown) {
  const std::vector<Shape> buildings = {
      Shape::polygon(std::vector<std::vector<Point>>{{{-7, -7}, {-4.7, -7}, {-4.7, -4.7}, {-7, -4.7}},
                                                     {{-6.5, -6.5}, {-5, -6.5}, {-5, -5}, {-6.5, -5}}}),
      Shape::polygon(std::vector<std::vector<Point>>{{{-6.5, -6.5}, {-5, -6.5}, {-5, -5}, {-6.5, -5}},
                                                     {{-7, -7}, {-4.7, -7}, {-4.7, -4.7}, {-7, -4.7}}})};
  for (const Shape& building : buildings) {
    std::uint64_t comparisons[2] = {};
    for (const std::size_t i : {0U, 1U}) {
      World world = World::create(kDomain).value();
      insert_town(world, i == 0 ? 20 : 80);
      const StageCounts before = predicate_counts().order;
      world.insert(building).value();
      const StageCounts after = predicate_counts().order;
      comparisons[i] =
          after.doubles + after.lattice + after.integers - before.doubles - before.lattice - before.integers;
      ASSERT_TRUE(world.validate().ok);
      EXPECT_TRUE(world.items_at({-5.5, -5.5}).value().empty());
      EXPECT_EQ(world.items_at({-6.7, -5.5}).value().size(), 1U);
    }
    EXPECT_LT(comparisons[1], comparisons[0] + 50) << comparisons[0];
  }
}

/// Returns how many in-circle tests the library has made.
std::uint64_t in_circle_tests() {
  const StageCounts counts = predicate_counts().in_circle;
  return counts.doubles + counts.lattice + counts.integers;
}

// The wall crosses an edge for each point. After its removal, the flips on both sides of the wall must take turns.
TEST(Growth, TheRemovalOfAWallBetweenTwoRows) {
  constexpr int kPoints = 2000;
  World world = World::create(kDomain).value();
  for (int i = 1; i < kPoints; ++i) {
    const double x = -100 + 200.0 * i / kPoints;
    world.insert_point({x, i % 2 == 0 ? 1.0 : -1.0}).value();
  }
  const ItemId wall = world.insert_segment({-100, 0}, {100, 0}).value();
  const std::uint64_t before = in_circle_tests();
  world.remove(wall).value();
  EXPECT_LT(in_circle_tests() - before, 20U * kPoints);
  ASSERT_NO_FATAL_FAILURE(expect_right(world));
}

TEST(Growth, IdenticalItems) {
  std::vector<Shape> shapes(12, square({0, 0}, 4));
  shapes.push_back(Shape::polygon({{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, {{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}}));
  shapes.push_back(Shape::polyline({{-4, -4}, {4, -4}, {-4, -4}, {4, -4}, {-4, -4}, {4, -4}, {0, 0}}));
  shapes.insert(shapes.end(), 10, Shape::point({-4, -4}));
  World world = World::create(kDomain).value();
  insert_and_remove(world, shapes, mixed(shapes.size()), 1);
}

TEST(Growth, SpokesOfOneHub) {
  std::vector<Shape> shapes;
  bool is_outwards = false;
  for (const Point& end : circle(900, 80)) {
    shapes.push_back(is_outwards ? Shape::segment({1, 2}, end) : Shape::segment(end, {1, 2}));
    is_outwards = !is_outwards;
  }
  World world = World::create(kDomain).value();
  insert_and_remove(world, shapes, mixed(shapes.size()), 5);
}

TEST(Growth, ManyScales) {
  std::vector<Shape> shapes;
  for (int exponent = -90; exponent <= 90; exponent += 2) {
    const double size = std::ldexp(1.0, exponent);
    shapes.push_back(Shape::point({size, 1.25 * size}));
    shapes.push_back(Shape::point({-1.5 * size, size}));
    shapes.push_back(Shape::point({size, -1.75 * std::ldexp(1.0, -exponent)}));
  }
  const std::vector<std::size_t> order = mixed(shapes.size());
  std::vector<Shape> shuffled;
  for (const std::size_t i : order) shuffled.push_back(shapes[i]);
  World world = World::create({{-0x1p99, -0x1p99}, {0x1p99, 0x1p99}}).value();
  insert_and_remove(world, shuffled, order, 40);
}

/// Returns a polygon of random points near a centre: rings may cross themselves, each other and other items.
Shape random_polygon(std::uint64_t& state, const Point& centre, double size, std::size_t rings) {
  const auto below = [&](std::uint32_t count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state >> 33) % count;
  };
  Rings made;
  for (std::size_t i = 0; i < rings; ++i) {
    std::vector<Point> ring;
    for (std::size_t corners = 3 + below(4); corners > 0; --corners) {
      const double x = (static_cast<double>(below(41)) - 20.0) / 20.0;
      const double y = (static_cast<double>(below(41)) - 20.0) / 20.0;
      ring.push_back({centre.x + size * x, centre.y + size * y});
    }
    made.push_back(ring);
  }
  return Shape::polygon(std::move(made), below(3) == 0 ? FillRule::nonzero : FillRule::even_odd);
}

// Polygons around polygons of all kinds, some of them crossed: a polygon that is inserted around others covers all
// components inside it, and only those. validate() compares the covers with those of a rebuilt world.
TEST(Growth, PolygonsAroundOthers) {
  std::uint64_t state = 5;
  for (int scene = 0; scene < case_count(30); ++scene) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < 12; ++i) {
      const Point centre{-300.0 + 50.0 * static_cast<double>(state >> 40 & 15),
                         -300.0 + 50.0 * static_cast<double>(state >> 50 & 15)};
      shapes.push_back(random_polygon(state, centre, i % 4 == 0 ? 300 : 60, 1 + (i % 5 == 0 ? 1 : 0)));
    }
    shapes.push_back(Shape::polyline({{10, 0}, {0, 10}, {-10, 0}, {0, -10}, {10, 0}}));
    shapes.push_back(Shape::polygon({circle(700, 12), circle(650, 12)}));
    shapes.push_back(Shape::polygon(circle(750, 9)));
    shapes.push_back(Shape::polygon(circle(600, 7)));
    shapes.push_back(random_polygon(state, {0, 0}, 800, 1));
    std::vector<Shape> shuffled;
    for (const std::size_t i : mixed(shapes.size() + static_cast<std::size_t>(scene % 3))) {
      if (i < shapes.size()) shuffled.push_back(shapes[i]);
    }
    World world = World::create(kDomain).value();
    ASSERT_NO_FATAL_FAILURE(insert_and_remove(world, scene % 2 == 0 ? shapes : shuffled, mixed(shapes.size()), 1))
        << "scene " << scene;
  }
}

// Two horseshoes enclose an area that no face outside them reaches.
TEST(Growth, APolygonAroundAnAreaBetweenOthers) {
  const Shape left = Shape::polygon({{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 8}, {6, 8}, {6, 10}, {0, 10}}});
  const Shape right = Shape::polygon({{{10, 0}, {5, 0}, {5, 2}, {8, 2}, {8, 8}, {5, 8}, {5, 10}, {10, 10}}});
  const Shape eight = Shape::polygon({{{20, 0}, {24, 4}, {20, 4}, {24, 0}, {28, 8}, {16, 8}}});
  for (const bool has_item_in_area : {false, true}) {
    World world = World::create(kDomain).value();
    std::vector<Shape> shapes = {left, right, eight};
    if (has_item_in_area) shapes.push_back(square({5, 5}, 1));
    shapes.push_back(square({10, 5}, 40));
    shapes.push_back(square({10, 5}, 50));
    std::vector<std::size_t> removal(shapes.size());
    for (std::size_t i = 0; i < removal.size(); ++i) removal[i] = removal.size() - 1 - i;
    std::swap(removal[0], removal[1]);
    ASSERT_NO_FATAL_FAILURE(insert_and_remove(world, shapes, removal, 1));
  }
}

/// Returns `count` segments from x = 0 to x = 1, which cross each other. Their ends have heights of up to `height`.
std::vector<Item> bundle(std::size_t count, double height) {
  const double step = height * 1.9 / static_cast<double>(count);
  const auto level = [&](std::size_t i) { return step * static_cast<double>(i) - height * 0.95; };
  const std::vector<std::size_t> right = mixed(count);
  std::vector<Item> items;
  for (std::size_t i = 0; i < count; ++i) {
    items.push_back({ItemId{i + 1}, Shape::segment({0, level(i)}, {1, level(right[i])})});
  }
  return items;
}

// The filter treats x and y apart. So it decides nearly all tests of segments that are nearly collinear, and integers
// of any size decide few, as many as for a bundle of ordinary heights.
TEST(Growth, NearlyCollinearSegmentsNeedFewIntegersOfAnySize) {
  const auto all = [](const StageCounts& c) { return c.doubles + c.lattice + c.integers; };
  for (const bool is_at_once : {false, true}) {
    const std::vector<Item> items = bundle(150, 0x1p-40);
    World world = World::create({{-1, -1}, {2, 2}}).value();
    const PredicateCounts before = predicate_counts();
    if (is_at_once) {
      static_cast<void>(world.insert_all(items).value());
    } else {
      for (const Item& item : items) static_cast<void>(world.insert(item.shape, item.id).value());
    }
    const PredicateCounts after = predicate_counts();
    const std::uint64_t tests = all(after.in_circle) - all(before.in_circle);
    EXPECT_LT(after.in_circle.integers - before.in_circle.integers, tests / 20);
    EXPECT_LT(after.orientation.integers - before.orientation.integers, 10U);
    EXPECT_EQ(after.crossing.integers, before.crossing.integers);
    EXPECT_GT(all(after.crossing) - all(before.crossing), 4000U);
    ASSERT_NO_FATAL_FAILURE(expect_right(world));
  }
}

}  // namespace
}  // namespace waywright::test

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"
#include "waywright/world.hpp"

namespace waywright::test {
namespace {

using Lists = std::vector<std::vector<Point>>;

const std::vector<Point> kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const std::vector<Point> kHole{{1, 1}, {2, 1}, {2, 2}};

TEST(Rings, AreMadeFromWhatHoldsRings) {
  const Lists lists{kSquare, kHole};
  EXPECT_EQ(Lists(Rings(lists)), lists);
  EXPECT_EQ(Lists(Rings(std::span<const std::vector<Point>>(lists).first(1))), Lists{kSquare});
  EXPECT_EQ(Lists(Rings{kSquare, kHole}), lists);
  EXPECT_EQ(Lists(Rings{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {2, 1}, {2, 2}}}), lists);
  // One ring.
  EXPECT_EQ(Lists(Rings(kSquare)), Lists{kSquare});
  EXPECT_EQ(Lists(Rings{kSquare}), Lists{kSquare});
  EXPECT_EQ(Lists(Rings{{0, 0}, {4, 0}, {4, 4}, {0, 4}}), Lists{kSquare});
  EXPECT_EQ(Lists(Rings{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}), Lists{kSquare});
  EXPECT_EQ(Lists(Rings(std::array<Point, 2>{})), Lists{std::vector<Point>(2)});
  EXPECT_EQ(Lists(Rings(std::span<const Point>(kSquare).first(2))), (Lists{{{0, 0}, {4, 0}}}));
  EXPECT_EQ(Lists(Rings{{{3, 4}}}), (Lists{{{3, 4}}}));
  EXPECT_EQ(Lists(Rings{{3, 4}}), (Lists{{{3, 4}}}));
  // Rings without points, and no rings.
  EXPECT_EQ(Lists(Rings{{}}), Lists(1));
  EXPECT_EQ(Lists(Rings{{}, {}}), Lists(2));
  EXPECT_EQ(Lists(Rings{{}, kHole, {}}), (Lists{{}, kHole, {}}));
  EXPECT_EQ(Lists(Rings{}), Lists());
  EXPECT_EQ(Lists(Rings(Lists())), Lists());
}

// Every method to build the same list of rings gives equal objects. Different lists give different objects.
TEST(Rings, AreEqualWhenTheirListsAre) {
  const std::vector<Lists> all = {{},
                                  {{}},
                                  {{}, {}},
                                  {{{1, 2}}},
                                  {{{1, 2}}, {}},
                                  {{}, {{1, 2}}},
                                  {{{1, 2}, {3, 4}}},
                                  {{{1, 2}}, {{3, 4}}},
                                  {{{1, 2}, {3, 5}}}};
  for (const Lists& a : all) {
    Rings pushed;
    Rings added;
    for (const std::vector<Point>& ring : a) {
      pushed.push_back(ring);
      added.start_ring();
      for (const Point& point : ring) added.add_point(point);
    }
    EXPECT_EQ(pushed, added);
    for (const Lists& b : all) {
      EXPECT_EQ(Rings(a) == Rings(b), a == b);
      EXPECT_EQ(pushed == Rings(b), a == b);
      EXPECT_EQ(added == b, a == b);
    }
  }
}

TEST(Rings, ReadAsARangeOfRings) {
  const Rings rings{kSquare, {}, kHole};
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_FALSE(rings.empty());
  EXPECT_EQ(rings[0], kSquare);
  EXPECT_TRUE(rings[1].empty());
  EXPECT_EQ(rings[2], kHole);
  EXPECT_EQ(rings.front(), kSquare);
  EXPECT_EQ(rings.back(), kHole);
  EXPECT_EQ(rings[0][2], (Point{4, 4}));
  EXPECT_EQ(rings.points().size(), 7U);
  Lists read;
  for (const auto& ring : rings) {
    std::vector<Point>& list = read.emplace_back();
    for (const Point& point : ring) list.push_back(point);
  }
  EXPECT_EQ(read, (Lists{kSquare, {}, kHole}));
  std::size_t points = 0;
  for (const std::vector<Point> ring : rings) points += ring.size();
  EXPECT_EQ(points, 7U);
}

TEST(Rings, ChangeInPlace) {
  Rings rings{kSquare, kHole};
  rings[0][1] = {5, 0};
  rings.back().front() = {1.5, 1};
  for (auto& ring : rings) {
    for (Point& point : ring) point.x += 10;
  }
  EXPECT_EQ(rings, (Lists{{{10, 0}, {15, 0}, {14, 4}, {10, 4}}, {{11.5, 1}, {12, 1}, {12, 2}}}));
  rings.push_back({{7, 7}, {8, 8}});
  rings.push_back(std::as_const(rings)[1]);
  EXPECT_EQ(rings[3], (std::vector<Point>{{11.5, 1}, {12, 1}, {12, 2}}));
  rings.clear();
  EXPECT_EQ(rings, Rings());
}

// The ring's points move in memory while they are added.
TEST(Rings, TakeARingOfTheirOwn) {
  Rings rings{kSquare};
  for (int i = 0; i < 100; ++i) rings.push_back(rings[0]);
  ASSERT_EQ(rings.size(), 101U);
  for (const auto& ring : rings) EXPECT_EQ(ring, kSquare);
}

TEST(Shape, IsMadeByItsKind) {
  EXPECT_EQ(Shape::point({3, 4}), (Shape{ItemKind::point, {{{3, 4}}}}));
  EXPECT_EQ(Shape::segment({3, 4}, {5, 6}), (Shape{ItemKind::segment, {{{3, 4}, {5, 6}}}}));
  EXPECT_EQ(Shape::polyline({{3, 4}, {5, 6}}), (Shape{ItemKind::polyline, {{{3, 4}, {5, 6}}}}));
  EXPECT_EQ(Shape::polyline(kSquare), (Shape{ItemKind::polyline, {kSquare}}));
  EXPECT_EQ(Shape::polygon(kSquare), (Shape{ItemKind::polygon, {kSquare}}));
  EXPECT_EQ(Shape::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), Shape::polygon(kSquare));
  EXPECT_EQ(Shape::polygon({kSquare, kHole}), (Shape{ItemKind::polygon, {kSquare, kHole}}));
  EXPECT_EQ(Shape::polygon(Lists{kSquare, kHole}), Shape::polygon({kSquare, kHole}));
  EXPECT_EQ(Shape::rectangle({{0, 0}, {4, 4}}), Shape::polygon(kSquare));
}

// The standard library's functions are correct to about a unit in the last place.
TEST(Shape, OfARegularPolygonHasItsCornersOnACircle) {
  for (std::size_t n = 3; n < 200; ++n) {
    const Shape shape = Shape::regular_polygon({0, 0}, 1, n);
    ASSERT_EQ(shape.kind, ItemKind::polygon);
    ASSERT_EQ(shape.rings.size(), 1U);
    ASSERT_EQ(shape.rings[0].size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      const long double angle =
          2 * std::numbers::pi_v<long double> * static_cast<long double>(i) / static_cast<long double>(n);
      EXPECT_NEAR(shape.rings[0][i].x, static_cast<double>(std::cos(angle)), 0x1p-52) << i << " of " << n;
      EXPECT_NEAR(shape.rings[0][i].y, static_cast<double>(std::sin(angle)), 0x1p-52) << i << " of " << n;
    }
  }
  EXPECT_EQ(Shape::regular_polygon({10, 20}, 2, 4), Shape::polygon({{12, 20}, {10, 22}, {8, 20}, {10, 18}}));
}

TEST(Shape, OfARegularPolygonOfFewerThanThreeCornersIsRefused) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  for (const std::size_t n : {0, 1, 2}) {
    const Shape shape = Shape::regular_polygon({5, 5}, 1, n);
    EXPECT_EQ(shape.kind, ItemKind::polygon);
    EXPECT_TRUE(shape.rings.empty());
    EXPECT_EQ(world.insert(shape).error().code, ErrorCode::bad_shape);
  }
}

TEST(World, TakesBraces) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  const Lists lists{{{1, 1}, {9, 1}, {9, 9}}, {{5, 2}, {8, 2}, {8, 5}}};
  ASSERT_TRUE(world.insert_polygon({{2, 2}, {4, 2}, {4, 4}}).ok());
  ASSERT_TRUE(world.insert_polygon({{2, 2}, {4, 2}, {4, 4}}, 20).ok());
  ASSERT_TRUE(world.insert_polygon({{{1, 1}, {9, 1}, {9, 9}}, {{5, 2}, {8, 2}, {8, 5}}}, 30).ok());
  ASSERT_TRUE(world.insert_polygon({{{2, 2}, {4, 2}, {4, 4}}}, 40).ok());
  ASSERT_TRUE(world.insert_polygon(lists, 50).ok());
  ASSERT_TRUE(world.insert_polygon({lists[0], lists[1]}, 60).ok());
  ASSERT_TRUE(world.insert_polygon(lists[0], 70).ok());
  ASSERT_TRUE(world.insert_polygon(std::span<const Point>(lists[0]), 80).ok());
  ASSERT_TRUE(world.insert_polygon(std::span<const std::vector<Point>>(lists), 90).ok());
  ASSERT_TRUE(world.insert_polyline({{1, 1}, {2, 2}}, 100).ok());
  ASSERT_TRUE(world.insert_polyline({{1, 1}, {2, 2}, {3, 1}}).ok());
  ASSERT_TRUE(world.insert_polyline(lists[0]).ok());
  ASSERT_TRUE(world.insert_points({{1, 1}, {2, 2}, {3, 3}}, 200).ok());
  const Shape triangle = Shape::polygon({{2, 2}, {4, 2}, {4, 4}});
  for (const ItemId id : {1, 20, 40}) EXPECT_EQ(world.shape(id).value(), triangle);
  for (const ItemId id : {30, 50, 60, 90}) EXPECT_EQ(world.shape(id).value(), Shape::polygon(lists));
  for (const ItemId id : {70, 80}) EXPECT_EQ(world.shape(id).value(), Shape::polygon(lists[0]));
  EXPECT_EQ(world.shape(100).value(), Shape::polyline({{1, 1}, {2, 2}}));
  EXPECT_EQ(world.shape(101).value(), Shape::polyline({{1, 1}, {2, 2}, {3, 1}}));
  EXPECT_EQ(world.shape(202).value(), Shape::point({3, 3}));
  EXPECT_EQ(world.item_count(), 15U);
}

TEST(World, AppliesChangesByName) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  const std::vector<ItemId> ids =
      world
          .apply({Change::insert(Shape::point({1, 1}), 7), Change::insert(Shape::point({2, 2})),
                  Change::replace(7, Shape::point({3, 3})), Change::remove(8)})
          .value();
  EXPECT_EQ(ids, (std::vector<ItemId>{7, 8, 7, 8}));
  EXPECT_EQ(world.items(), (std::vector<Item>{{7, Shape::point({3, 3})}}));
  EXPECT_EQ(world.apply({}).value(), std::vector<ItemId>());
}

TEST(Rings, MovedFromAreNone) {
  Rings rings{{{1, 1}, {5, 1}, {5, 5}}, {{2, 2}, {3, 2}, {3, 3}}};
  const Rings taken = std::move(rings);
  EXPECT_EQ(taken.size(), 2U);
  EXPECT_TRUE(rings.empty());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(rings, Rings{});
  rings = taken;
  Rings other;
  other = std::move(rings);
  EXPECT_EQ(other, taken);
  rings.push_back(taken[1]);  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(rings.size(), 1U);
}

}  // namespace
}  // namespace waywright::test

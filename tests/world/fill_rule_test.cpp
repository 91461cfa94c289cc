#include <cstdint>
#include <gmock/gmock.h>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

namespace waywright::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Box kTwenty{{0, 0}, {20, 20}};
constexpr ItemId kId{7};

const std::vector<Point> kOuter = {{1, 1}, {9, 1}, {9, 9}, {1, 9}};
const std::vector<Point> kInner = {{3, 3}, {7, 3}, {7, 7}, {3, 7}};
const std::vector<Point> kInnerBack = {{3, 7}, {7, 7}, {7, 3}, {3, 3}};
/// A pentagram. Its ring goes twice around the pentagon in its middle, near (10, 10).
const std::vector<Point> kStar = {{10, 18}, {5, 3}, {18, 12}, {2, 12}, {15, 3}};

World world_with(const Shape& shape, bool keep_abstraction = true) {
  World world = World::create(kTwenty, {.keep_abstraction = keep_abstraction}).value();
  world.insert(shape, kId).value();
  return world;
}

/// Checks that the shape covers the points in `inside` and not those in `outside`, for worlds that got the shape by
/// different operations and with different options.
void expect_inside(const Shape& shape, const std::vector<Point>& inside, const std::vector<Point>& outside) {
  std::vector<World> worlds;
  worlds.push_back(world_with(shape));
  worlds.push_back(world_with(shape, false));
  worlds.push_back(World::create(kTwenty).value());
  worlds.back().insert_all(std::vector<Item>{{kId, shape}}).value();
  worlds.push_back(world_with({ItemKind::polygon, {{{2, 2}, {3, 2}, {2, 3}}}}));
  worlds.back().replace(kId, shape).value();
  for (const World& world : worlds) {
    const Validation validation = world.validate();
    EXPECT_TRUE(validation.ok) << validation.fault;
    const auto expect = [&](const Point& p, bool is_inside) {
      SCOPED_TRACE(testing::Message() << p.x << ' ' << p.y);
      EXPECT_EQ(world.locate(p)->polygons, is_inside ? std::vector<ItemId>{kId} : std::vector<ItemId>{});
      EXPECT_EQ(world.items_at(p).value(), world.locate(p)->polygons);
      EXPECT_EQ(world.items_in({p, {p.x + 0x1p-20, p.y + 0x1p-20}}).value(), world.locate(p)->polygons);
      const PathStatus status = world.find_path({p, {p.x + 0x1p-20, p.y}})->status;
      EXPECT_EQ(status, is_inside ? PathStatus::start_blocked : PathStatus::found);
    };
    for (const Point& p : inside) expect(p, true);
    for (const Point& p : outside) expect(p, false);
  }
}

TEST(FillRule, ARingInARingIsAHoleDependingOnItsDirection) {
  const Point between{2, 5};
  const Point middle{5, 5};
  const Point beyond{12, 5};
  expect_inside({ItemKind::polygon, {kOuter, kInner}}, {between}, {middle, beyond});
  expect_inside({ItemKind::polygon, {kOuter, kInnerBack}}, {between}, {middle, beyond});
  expect_inside({ItemKind::polygon, {kOuter, kInner}, FillRule::nonzero}, {between, middle}, {beyond});
  expect_inside({ItemKind::polygon, {kOuter, kInnerBack}, FillRule::nonzero}, {between}, {middle, beyond});
  expect_inside({ItemKind::polygon, {kInnerBack, kOuter}, FillRule::nonzero}, {between}, {middle, beyond});
  expect_inside({ItemKind::polygon, {kOuter, kInnerBack, kInnerBack}, FillRule::nonzero}, {between, middle}, {beyond});
  expect_inside({ItemKind::polygon, {kInnerBack, kOuter, kInner}, FillRule::nonzero}, {between, middle}, {beyond});
}

TEST(FillRule, AStarHasItsMiddleInsideWhereTurnsCount) {
  const std::vector<Point> points = {{10, 16}, {4, 11.5}, {16, 11.5}, {6, 4}, {14, 4}};
  const Point middle{10, 9};
  expect_inside({ItemKind::polygon, {kStar}}, points, {middle, {10, 1}, {19, 19}});
  std::vector<Point> all = points;
  all.push_back(middle);
  expect_inside({ItemKind::polygon, {kStar}, FillRule::nonzero}, all, {{10, 1}, {19, 19}});
  expect_inside({ItemKind::polygon, {{kStar.rbegin(), kStar.rend()}}, FillRule::nonzero}, all, {{10, 1}, {19, 19}});
}

TEST(FillRule, ARingTwiceRoundIsInsideWhereTurnsCount) {
  std::vector<Point> twice = kOuter;
  twice.insert(twice.end(), kOuter.begin(), kOuter.end());
  std::vector<Point> to_and_fro = kOuter;
  to_and_fro.push_back(kOuter.front());
  to_and_fro.insert(to_and_fro.end(), kOuter.rbegin(), kOuter.rend());
  expect_inside({ItemKind::polygon, {twice}}, {}, {{5, 5}, {12, 5}});
  expect_inside({ItemKind::polygon, {twice}, FillRule::nonzero}, {{5, 5}}, {{12, 5}});
  expect_inside({ItemKind::polygon, {kOuter, kOuter}, FillRule::nonzero}, {{5, 5}}, {{12, 5}});
  expect_inside({ItemKind::polygon, {to_and_fro}, FillRule::nonzero}, {}, {{5, 5}, {12, 5}});
}

// Two squares with opposite directions: where they overlap, the winding numbers cancel out.
TEST(FillRule, AFaceWithWindingNumberZeroIsFreeBetweenItsWalls) {
  const std::vector<Point> other = {{5, 5}, {5, 13}, {13, 13}, {13, 5}};
  const Shape shape{ItemKind::polygon, {kOuter, other}, FillRule::nonzero};
  expect_inside(shape, {{2, 2}, {12, 12}}, {{7, 7}, {12, 2}});
  const World world = world_with(shape);
  EXPECT_EQ(world.find_path({{6, 6}, {8, 7}})->status, PathStatus::found);
  EXPECT_EQ(world.find_path({{6, 6}, {12, 2}})->status, PathStatus::no_path);
  EXPECT_EQ(world.find_path({{12, 2}, {6, 6}})->status, PathStatus::no_path);
}

// A wall inside the polygon is a side of it, and a point on it is not strictly inside.
TEST(FillRule, AWallBetweenTwoInsidesIsASideAllTheSame) {
  const World world = world_with({ItemKind::polygon, {kStar}, FillRule::nonzero});
  EXPECT_TRUE(world.ray({10, 9}, {10, 13})->hit);
  EXPECT_EQ(world.ray({10, 9}, {10, 13})->at, (Point{10, 12}));
  EXPECT_EQ(world.find_path({{10, 12}, {19, 19}})->status, PathStatus::no_path);
}

// Changes inside a pentagram must not change which areas between its sides are covered.
TEST(FillRule, IsKeptWhileOtherItemsChange) {
  for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero}) {
    World world = world_with({ItemKind::polygon, {kStar, kOuter}, rule});
    const std::vector<Point> points = {{10, 9}, {8, 8}, {6, 4}, {2, 2}, {14, 4}, {10, 16}, {8.5, 10}, {10, 12.0625}};
    std::vector<std::vector<ItemId>> before;
    for (const Point& p : points) before.push_back(world.locate(p)->polygons);
    for (double x = 0.5; x < 20; x += 1.25) {
      const ItemId wall = world.insert_segment({x, 0}, {20 - x, 20}).value();
      const ItemId crossing = world.insert_segment({0, x}, {20, x}).value();
      const Validation validation = world.validate();
      ASSERT_TRUE(validation.ok) << validation.fault;
      for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(world.locate(points[i])->polygons, before[i]);
      world.remove(wall).value();
      ASSERT_TRUE(world.validate().ok);
      world.remove(crossing).value();
      ASSERT_TRUE(world.validate().ok);
    }
  }
}

TEST(FillRule, BelongsToTheShape) {
  const Shape even_odd{ItemKind::polygon, {kStar}};
  const Shape nonzero{ItemKind::polygon, {kStar}, FillRule::nonzero};
  EXPECT_NE(even_odd, nonzero);
  World world = world_with(nonzero);
  EXPECT_EQ(world.shape(kId).value(), nonzero);
  EXPECT_THAT(world.items(), ElementsAre(Item{kId, nonzero}));
  const World plain = world_with(even_odd);
  EXPECT_EQ(world.dump(), plain.dump()) << "the mesh is the same";
  EXPECT_NE(world.items_hash(), plain.items_hash());

  world.replace(kId, even_odd).value();
  EXPECT_EQ(world.shape(kId).value(), even_odd);
  EXPECT_THAT(world.locate({10, 9})->polygons, IsEmpty());
  EXPECT_EQ(world.items_hash(), plain.items_hash());
  world.apply(std::vector<Change>{{Change::Kind::replace, kId, nonzero}}).value();
  EXPECT_THAT(world.locate({10, 9})->polygons, ElementsAre(kId));
}

TEST(FillRule, MeansNothingForOtherKinds) {
  for (const ItemKind kind : {ItemKind::point, ItemKind::segment, ItemKind::polyline}) {
    const std::vector<Point> points(kStar.begin(), kStar.begin() + (kind == ItemKind::point ? 1 : 2));
    const World world = world_with({kind, {points}, FillRule::nonzero});
    EXPECT_EQ(world.shape(kId).value(), (Shape{kind, {points}}));
    EXPECT_EQ(world.items_hash(), world_with({kind, {points}}).items_hash());
  }
}

TEST(FillRule, HasAName) {
  EXPECT_EQ(to_string(FillRule::even_odd), "even-odd");
  EXPECT_EQ(to_string(FillRule::nonzero), "nonzero");
}

// A square of 8 x 8 that contains a square of 2 x 2 to the right of the middle: areas 64 and 4.
TEST(FillRule, DecidesWhereTheCentroidIs) {
  const std::vector<Point> small = {{6, 4}, {8, 4}, {8, 6}, {6, 6}};
  const std::vector<Point> back(small.rbegin(), small.rend());
  const Point holed{(64 * 5.0 - 4 * 7.0) / 60, 5};
  const auto expect_near = [](const Shape& shape, const Point& expected) {
    const Point centre = centroid(shape);
    EXPECT_NEAR(centre.x, expected.x, 1e-12);
    EXPECT_NEAR(centre.y, expected.y, 1e-12);
  };
  expect_near({ItemKind::polygon, {kOuter, small}}, holed);
  expect_near({ItemKind::polygon, {kOuter, back}}, holed);
  expect_near({ItemKind::polygon, {kOuter, back}, FillRule::nonzero}, holed);
  expect_near({ItemKind::polygon, {kOuter, small}, FillRule::nonzero}, {5, 5});
  expect_near({ItemKind::polygon, {small, kOuter}, FillRule::nonzero}, {5, 5});
}

}  // namespace
}  // namespace waywright::test

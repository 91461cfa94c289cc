#include <algorithm>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/random.hpp"
#include "support/random_scenes.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

Shape rectangle(double x0, double y0, double x1, double y1) {
  return {ItemKind::polygon, {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
}

World furnished_world() {
  World world = World::create(kTen).value();
  EXPECT_TRUE(world.insert(rectangle(2, 2, 4, 4), {1}).ok());
  EXPECT_TRUE(world.insert(rectangle(3, 3, 6, 6), {2}).ok());
  EXPECT_TRUE(world.insert_segment({0, 5}, {10, 5}, {3}).ok());
  EXPECT_TRUE(world.insert_point({8, 8}, {4}).ok());
  EXPECT_TRUE(world.insert_polyline(std::vector<Point>{{8, 1}, {9, 2}, {8, 3}}, {5}).ok());
  return world;
}

std::vector<ItemId> ids(std::initializer_list<std::uint64_t> values) {
  std::vector<ItemId> result;
  for (const std::uint64_t value : values) result.push_back({value});
  return result;
}

TEST(ItemsAt, CoverSidesCornersAndPoints) {
  const World world = furnished_world();
  EXPECT_EQ(world.items_at({3.5, 3.5}).value(), ids({1, 2}));
  EXPECT_EQ(world.items_at({3, 3}).value(), ids({1, 2}));
  EXPECT_EQ(world.items_at({5, 5}).value(), ids({2, 3}));
  EXPECT_EQ(world.items_at({1, 5}).value(), ids({3}));
  EXPECT_EQ(world.items_at({8, 8}).value(), ids({4}));
  EXPECT_EQ(world.items_at({8.5, 1.5}).value(), ids({5}));
  EXPECT_EQ(world.items_at({0, 0}).value(), ids({}));
  EXPECT_EQ(world.items_at({11, 0}).error().code, ErrorCode::out_of_domain);
}

TEST(ItemsCrossed, AreSortedAndHaveTheirPositions) {
  const World world = furnished_world();
  using Crossed = std::vector<CrossedItem>;
  EXPECT_EQ(world.items_crossed({2.5, 0}, {2.5, 10}).value(),
            (Crossed{{{1}, {2.5, 2}}, {{1}, {2.5, 4}}, {{3}, {2.5, 5}}}));
  EXPECT_EQ(world.items_crossed({2.5, 10}, {2.5, 0}).value(),
            (Crossed{{{3}, {2.5, 5}}, {{1}, {2.5, 4}}, {{1}, {2.5, 2}}}));
  // Along a side, from before it to beyond it. Item 2 crosses there.
  EXPECT_EQ(world.items_crossed({1, 4}, {9, 4}).value(), (Crossed{{{1}, {2, 4}}, {{2}, {3, 4}}, {{2}, {6, 4}}}));
  // Through corners, and from a point on a side to a point on another side.
  EXPECT_EQ(world.items_crossed({1, 1}, {3, 3}).value(), (Crossed{{{1}, {2, 2}}, {{2}, {3, 3}}}));
  EXPECT_EQ(world.items_crossed({2, 3}, {1, 3}).value(), (Crossed{{{1}, {2, 3}}}));
  EXPECT_EQ(world.items_crossed({5, 5}, {7, 5}).value(), (Crossed{{{3}, {5, 5}}, {{2}, {6, 5}}}));
  EXPECT_EQ(world.items_crossed({7, 7}, {9, 9}).value(), Crossed{}) << "a point has no side";
  EXPECT_EQ(world.items_crossed({2, 3}, {2, 3}).value(), (Crossed{{{1}, {2, 3}}}));
  EXPECT_EQ(world.items_crossed({1, 1}, {1, 1}).value(), Crossed{});
}

TEST(Ray, StopsAtTheFirstWallItTouches) {
  const World world = furnished_world();
  const auto hit = [&](Point from, Point to) { return world.ray(from, to).value(); };
  EXPECT_EQ(hit({2.5, 0.5}, {2.5, 10}), (RayHit{true, {2.5, 2}, ids({1}), {2.5, 2}}));
  EXPECT_EQ(hit({2.5, 9}, {2.5, 0}), (RayHit{true, {2.5, 5}, ids({3}), {2.5, 5}}));
  // At a corner that the ray only touches, at the end of a polyline, and where walls cross.
  EXPECT_EQ(hit({1, 3}, {3, 1}), (RayHit{true, {2, 2}, ids({1}), {2, 2}}));
  EXPECT_EQ(hit({7, 1}, {9, 1}), (RayHit{true, {8, 1}, ids({5}), {8, 1}}));
  EXPECT_EQ(hit({2.75, 4.25}, {7, 0}), (RayHit{true, {3, 4}, ids({1, 2}), {3, 4}}));
  // Along a side, from before it; from a wall; from inside a polygon; to a wall and not further.
  EXPECT_EQ(hit({1, 2}, {9, 2}), (RayHit{true, {2, 2}, ids({1}), {2, 2}}));
  EXPECT_EQ(hit({5, 5}, {7, 5}), (RayHit{true, {5, 5}, ids({3}), {5, 5}}));
  EXPECT_EQ(hit({2.5, 2.5}, {2.5, 3.5}), RayHit{});
  EXPECT_EQ(hit({2.5, 2.5}, {2.5, 9}), (RayHit{true, {2.5, 4}, ids({1}), {2.5, 4}}));
  EXPECT_EQ(hit({1, 1}, {1, 5}), (RayHit{true, {1, 5}, ids({3}), {1, 5}}));
  EXPECT_EQ(hit({9, 9}, {9, 10}), (RayHit{true, {9, 10}, ids({0}), {9, 10}}));
  EXPECT_EQ(hit({0, 5}, {1, 9}), (RayHit{true, {0, 5}, ids({0, 3}), {0, 5}}));
  EXPECT_EQ(hit({7, 7}, {9, 9}), RayHit{}) << "a point is no wall";
  EXPECT_EQ(world.ray({1, 1}, {11, 1}).error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(world.ray({1, 1}, {11, 1}).error().index, 1U);
}

TEST(Ray, GivesTheNearestDoublesOfAPositionWithoutDoubles) {
  World world = World::create({{0, 0}, {8, 8}}).value();
  ASSERT_TRUE(world.insert_segment({1, 1}, {4, 3}, {1}).ok());
  EXPECT_EQ(world.ray({1, 2}, {4, 1}).value(), (RayHit{true, {2, 5.0 / 3.0}, ids({1}), {2, 5.0 / 3.0}}));
}

TEST(ItemsIn, BoxesAreClosedAndMayBeCovered) {
  const World world = furnished_world();
  EXPECT_EQ(world.items_in({{0, 0}, {10, 10}}).value(), ids({1, 2, 3, 4, 5}));
  EXPECT_EQ(world.items_in({{-50, -50}, {50, 50}}).value(), ids({1, 2, 3, 4, 5}));
  EXPECT_EQ(world.items_in({{2.25, 2.25}, {2.5, 2.5}}).value(), ids({1}));
  EXPECT_EQ(world.items_in({{4, 0}, {5, 2}}).value(), ids({1})) << "touches a corner";
  EXPECT_EQ(world.items_in({{4.5, 0}, {5, 2.5}}).value(), ids({}));
  EXPECT_EQ(world.items_in({{8.25, 1.5}, {8.5, 1.75}}).value(), ids({5})) << "its side runs through a corner";
  EXPECT_EQ(world.items_in({{8, 8}, {8, 8}}).value(), ids({4}));
  EXPECT_EQ(world.items_in({{20, 20}, {30, 30}}).value(), ids({}));
  EXPECT_EQ(world.items_in({{3, 3}, {2, 4}}).error().code, ErrorCode::bad_domain);
}

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool lies_on(const Point& a, const Point& b, const Point& p) {
  return turn(a, b, p) == 0 && p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

/// Returns whether two segments meet. Exact for coordinates that are small multiples of a power of two.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b)) return true;
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool meets_side(const Shape& shape, const Point& from, const Point& to) {
  for (const PointSpan& ring : shape.rings) {
    const std::size_t sides = shape.kind == ItemKind::polygon ? ring.size() : ring.size() - 1;
    for (std::size_t i = 0; i < sides; ++i) {
      const Point& next = ring[(i + 1) % ring.size()];
      if (next != ring[i] && meet(ring[i], next, from, to)) return true;
    }
  }
  return false;
}

/// Calls check(scene, world, p, q) for pairs of random points in the worlds of random scenes.
template <class Check>
void for_random_pairs(Check&& check) {
  for (const Flavour flavour : {Flavour::lattice, Flavour::small}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const Scene scene = random_scene(flavour, seed, 20);
      World world = World::create(scene.domain, {.keep_abstraction = seed % 2 == 0}).value();
      for (const Item& item : scene.items) ASSERT_TRUE(world.insert(item.shape, item.id).ok());
      Random random(seed);
      for (int i = 0; i < 20; ++i) {
        const Point p = random_point(flavour, scene.domain, random);
        const Point q = random_point(flavour, scene.domain, random);
        check(scene, world, p, q);
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
      }
    }
  }
}

TEST(ItemsCrossed, AgreeWithBruteForceOnRandomScenes) {
  for_random_pairs([](const Scene& scene, const World& world, const Point& from, const Point& to) {
    std::vector<ItemId> expected;
    for (const Item& item : scene.items) {
      if (meets_side(item.shape, from, to)) expected.push_back(item.id);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<ItemId> met;
    double last = -1.0;
    for (const auto& [id, at] : world.items_crossed(from, to).value()) {
      met.push_back(id);
      const double along = (at.x - from.x) * (to.x - from.x) + (at.y - from.y) * (to.y - from.y);
      EXPECT_GE(along, last - 1e-6) << "out of order";
      last = along;
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    EXPECT_EQ(met, expected);
  });
}

TEST(ItemsIn, AgreeWithBruteForceOnRandomScenes) {
  for_random_pairs([](const Scene& scene, const World& world, const Point& p, const Point& q) {
    const Box box{{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
    const auto holds = [&](const Point& r) {
      return r.x >= box.min.x && r.x <= box.max.x && r.y >= box.min.y && r.y <= box.max.y;
    };
    const std::vector<ItemId> covering = world.locate(box.min).value().polygons;
    std::vector<ItemId> expected;
    for (const Item& item : scene.items) {
      bool meets = std::find(covering.begin(), covering.end(), item.id) != covering.end();
      for (const auto& ring : item.shape.rings) meets = meets || std::any_of(ring.begin(), ring.end(), holds);
      const Point c{box.max.x, box.min.y}, d{box.min.x, box.max.y};
      for (const auto& [from, to] : {std::pair{box.min, c}, {c, box.max}, {box.max, d}, {d, box.min}}) {
        meets = meets || meets_side(item.shape, from, to);
      }
      if (meets) expected.push_back(item.id);
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(world.items_in(box).value(), expected);
  });
}

TEST(Shapes, CentroidIsTheCentreOfArea) {
  EXPECT_EQ(centroid(rectangle(2, 2, 4, 6)), (Point{3, 4}));
  EXPECT_EQ(centroid({ItemKind::polygon, {{{0, 0}, {0, 3}, {3, 0}}}}), (Point{1, 1}));
  EXPECT_EQ(centroid({ItemKind::segment, {{{0, 0}, {4, 2}}}}), (Point{2, 1}));
  EXPECT_EQ(centroid({ItemKind::polygon, {{{1, 1}, {3, 1}}}}), (Point{2, 1})) << "no area: the mean of its points";
  // A square of side 4 with a hole in its right half.
  const Shape holed{ItemKind::polygon,
                    {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {2, 3.5}}}};
  const Point centre = centroid(holed);
  EXPECT_DOUBLE_EQ(centre.x, (16 * 2.0 - 4.5 * 2.75) / 11.5);
  EXPECT_DOUBLE_EQ(centre.y, 2.0);
}

// A square of side 2 and half of another beside it, with both directions of the ring.
TEST(Shapes, CentroidIsTheSameOfARingTurnedRound) {
  std::vector<Point> ring = {{0, 0}, {4, 0}, {2, 2}, {0, 2}};
  for (int direction = 0; direction < 2; ++direction) {
    const Point centre = centroid({ItemKind::polygon, {ring}});
    EXPECT_DOUBLE_EQ(centre.x, (4 * 1.0 + 2 * (2 + 2 / 3.0)) / 6);
    EXPECT_DOUBLE_EQ(centre.y, (4 * 1.0 + 2 * (2 / 3.0)) / 6);
    std::reverse(ring.begin(), ring.end());
  }
}

TEST(Shapes, TranslatedMovesEveryPoint) {
  EXPECT_EQ(translated(rectangle(0, 0, 1, 1), 2, -3), rectangle(2, -3, 3, -2));
}

}  // namespace
}  // namespace waywright::test

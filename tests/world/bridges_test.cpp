#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/clearance.hpp"
#include "waywright/world.hpp"

#include "support/bridges_oracle.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

using bridge_oracle::exactly;
using bridge_oracle::expected_bridges;
using bridge_oracle::ordered;
using bridge_oracle::Rational;
using bridge_oracle::Segment;
using bridge_oracle::Vector;
using Ids = std::vector<ItemId>;

constexpr WorldOptions kKeepsBridges = {.keep_bridges = true};

Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

bool is_on(const Vector& at, const Segment& side) {
  return cross(side.second - side.first, at - side.first) == 0 && (at - side.first) * (at - side.second) <= 0;
}

/// A side of an item, in the direction of its ring.
struct ItemSide {
  ItemId item;
  Vector from;
  Vector to;
};

std::vector<ItemSide> sides_of(const Item& item) {
  std::vector<ItemSide> sides;
  for (const auto& ring : item.shape.rings) {
    const std::size_t count = ring.size();
    const bool is_closed = item.shape.kind == ItemKind::polygon;
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < count; ++i) {
      const Point& to = ring[(i + 1) % count];
      if (!(ring[i] == to)) sides.push_back({item.id, exactly(ring[i]), exactly(to)});
    }
  }
  return sides;
}

std::vector<ItemSide> sides_of(const Scene& scene) {
  const Box& box = scene.domain;
  std::vector<ItemSide> sides =
      sides_of({{}, Shape::polygon({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}})});
  for (const Item& item : scene.items) {
    const std::vector<ItemSide> more = sides_of(item);
    sides.insert(sides.end(), more.begin(), more.end());
  }
  return sides;
}

/// Whether the polygon covers a position on none of its sides. Counts how often a ray to the right crosses sides
/// upwards and downwards.
bool covers(const Item& item, const Vector& at) {
  if (item.shape.kind != ItemKind::polygon) return false;
  int winding = 0;
  for (const ItemSide& side : sides_of(item)) {
    const bool goes_up = side.from.y <= at.y && at.y < side.to.y;
    const bool goes_down = side.to.y <= at.y && at.y < side.from.y;
    const Rational turn = cross(side.to - side.from, at - side.from);
    if (goes_up && turn > 0) ++winding;
    if (goes_down && turn < 0) --winding;
  }
  return item.shape.fill == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
}

/// The bridges of a scene outside of polygons, from the definition.
std::vector<Segment> expected_list(const Scene& scene, const std::vector<ItemSide>& sides) {
  std::vector<Segment> walls;
  for (const ItemSide& side : sides) walls.push_back(ordered(side.from, side.to));
  std::vector<Segment> result;
  for (const Segment& bridge : expected_bridges(walls)) {
    const Vector middle = Rational(1, 2) * (bridge.first + bridge.second);
    const bool is_covered =
        std::any_of(scene.items.begin(), scene.items.end(), [&](const Item& item) { return covers(item, middle); });
    if (!is_covered) result.push_back(bridge);
  }
  return result;
}

Ids items_at(const std::vector<ItemSide>& sides, const Vector& at) {
  Ids ids;
  for (const ItemSide& side : sides) {
    if (is_on(at, {side.from, side.to})) ids.push_back(side.item);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

Ids list_of(std::span<const ItemId> ids) { return {ids.begin(), ids.end()}; }

Rational squared(const Vector& v) { return v * v; }

/// Removes from `expected` the bridge whose rounded form is `bridge`. Returns its ends: the start first.
Segment take_match(std::vector<Segment>& expected, const Bridge& bridge) {
  const Vector from = exactly(bridge.from);
  const Vector to = exactly(bridge.to);
  std::size_t best = expected.size();
  Rational least;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!(expected[i].first == from) && !(expected[i].second == from)) continue;
    const Rational distance = squared((expected[i].first == from ? expected[i].second : expected[i].first) - to);
    if (best == expected.size() || distance < least) std::tie(best, least) = std::tuple(i, distance);
  }
  if (best == expected.size()) return {};
  Segment match = expected[best];
  if (!(match.first == from)) std::swap(match.first, match.second);
  expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(best));
  return match;
}

bool is_near(const Vector& p, const Vector& q) {
  const auto is_close = [](const Rational& a, const Rational& b) {
    return abs(Rational(a - b)) <= abs(b) * Rational(std::ldexp(1.0, -48)) + Rational(std::ldexp(1.0, -1000));
  };
  return is_close(p.x, q.x) && is_close(p.y, q.y);
}

World world_of(const Scene& scene, const WorldOptions& options = kKeepsBridges) {
  World world = World::create(scene.domain, options).value();
  world.insert_all(scene.items).value();
  return world;
}

class RandomScenes : public testing::TestWithParam<Flavour> {};

TEST_P(RandomScenes, ListTheBridgesOfTheDefinition) {
  for (std::uint64_t seed = 0; seed < (case_count() + 4) / 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(GetParam(), seed, 1 + seed % 9);
    const World world = world_of(scene);
    const BridgeList list = world.bridges(scene.domain).value();
    const std::vector<ItemSide> sides = sides_of(scene);
    std::vector<Segment> expected = expected_list(scene, sides);
    ASSERT_EQ(list.bridges.size(), expected.size());
    for (const Bridge& bridge : list.bridges) {
      const Segment match = take_match(expected, bridge);
      const Vector along = match.second - match.first;
      ASSERT_GT(squared(along), 0) << "no such bridge";
      EXPECT_TRUE(is_near(exactly(bridge.to), match.second)) << to_string(bridge.to);
      const Rational least = Rational(bridge.radius);
      const Rational most = Rational(std::nextafter(bridge.radius, std::numeric_limits<double>::infinity()));
      EXPECT_LE(4 * least * least, squared(along)) << "the disc passes";
      EXPECT_GT(4 * most * most, squared(along)) << "no larger disc passes";
      EXPECT_EQ(list_of(list.from_items(bridge)), items_at(sides, match.first));
      EXPECT_EQ(list_of(list.to_items(bridge)), items_at(sides, match.second));
      const auto is_corner = [&](const ItemSide& side) { return side.from == match.second || side.to == match.second; };
      EXPECT_EQ(bridge.has_foot, std::none_of(sides.begin(), sides.end(), is_corner));
      EXPECT_TRUE(bridge.has_foot || match.first < match.second);
    }
    const auto key = [](const Bridge& b) { return std::tuple(b.from.x, b.from.y, b.to.x, b.to.y); };
    EXPECT_TRUE(std::is_sorted(list.bridges.begin(), list.bridges.end(),
                               [&](const Bridge& p, const Bridge& q) { return key(p) < key(q); }));
  }
}

// Neither the order of the insertions nor removed items nor the abstraction changes the list.
TEST_P(RandomScenes, ListTheSameBridgesAfterOtherChanges) {
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(GetParam(), 500 + seed, 12);
    World other = World::create(scene.domain, {.keep_abstraction = false, .keep_bridges = true}).value();
    other.insert_point(scene.domain.min, 999999).value();
    for (std::size_t i = scene.items.size(); i-- > 0;) other.insert(scene.items[i].shape, scene.items[i].id).value();
    EXPECT_EQ(other.bridges(scene.domain).value(), world_of(scene).bridges(scene.domain).value());
  }
}

/// Whether the segment has a position in common with the closed box: clips the segment at the four lines.
bool meets(const Segment& segment, const Box& box) {
  Rational first = 0;
  Rational last = 1;
  const Vector along = segment.second - segment.first;
  const auto clip = [&](const Rational& at, const Rational& step, const Rational& least, const Rational& most) {
    if (step == 0) return at >= least && at <= most;
    Rational enter = (least - at) / step;
    Rational leave = (most - at) / step;
    if (enter > leave) std::swap(enter, leave);
    if (enter > first) first = enter;
    if (leave < last) last = leave;
    return true;
  };
  const Vector min = exactly(box.min);
  const Vector max = exactly(box.max);
  return clip(segment.first.x, along.x, min.x, max.x) && clip(segment.first.y, along.y, min.y, max.y) && first <= last;
}

/// A random box: a large one, a small one or a point. Some boxes have a corner at an end of a bridge.
Box random_box(Flavour flavour, const Box& domain, const std::vector<Bridge>& bridges, Random& random) {
  const auto point = [&] { return random_point(flavour, domain, random); };
  const bool is_at_bridge = !bridges.empty() && random.chance(30);
  const Bridge bridge = is_at_bridge ? bridges[random.below(bridges.size())] : Bridge{point(), point()};
  const Point first = random.chance(80) ? bridge.to : bridge.from;
  const double share = random.chance(30) ? 0.0 : std::ldexp(1.0, -static_cast<int>(random.below(8)));
  const std::array<Point, 2> corners = {first, lerp(first, point(), share)};
  return Box::bounding(corners);
}

TEST_P(RandomScenes, ListTheBridgesThatMeetABox) {
  QueryContext context;
  BridgeList list;
  std::size_t listed = 0;
  std::size_t missing = 0;
  for (std::uint64_t seed = 0; seed < 20 + case_count() / 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(GetParam(), 700 + seed, 2 + 3 * (seed % 10));
    const World world = world_of(scene, {.keep_abstraction = seed % 3 != 0, .keep_bridges = true});
    const BridgeList all = world.bridges(scene.domain).value();
    Random random(seed);
    for (int i = 0; i < 10; ++i) {
      const Box box = random_box(GetParam(), scene.domain, all.bridges, random);
      if (!is_in_range(box.min) || !is_in_range(box.max)) continue;
      SCOPED_TRACE("box " + to_string(box.min) + ' ' + to_string(box.max));
      ASSERT_TRUE(world.bridges(box, context, list).ok());
      std::vector<std::tuple<Point, Point, Ids, Ids>> expected;
      std::vector<std::tuple<Point, Point, Ids, Ids>> found;
      const auto entry = [](const BridgeList& of, const Bridge& bridge) {
        return std::tuple(bridge.from, bridge.to, list_of(of.from_items(bridge)), list_of(of.to_items(bridge)));
      };
      for (const Bridge& bridge : all.bridges) {
        if (meets({exactly(bridge.from), exactly(bridge.to)}, box)) expected.push_back(entry(all, bridge));
      }
      for (const Bridge& bridge : list.bridges) found.push_back(entry(list, bridge));
      ASSERT_TRUE(found == expected) << found.size() << " bridges, expected " << expected.size();
      listed += found.size();
      missing += all.bridges.size() - found.size();
    }
  }
  EXPECT_GT(listed, 0U);
  EXPECT_GT(missing, 0U);
}

INSTANTIATE_TEST_SUITE_P(Bridges, RandomScenes, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

// A square of side 2 in the middle of a square room of side 10: two feet on each side of the room.
TEST(Bridges, OfARoomWithAPillar) {
  World room = World::create({{0, 0}, {10, 10}}, kKeepsBridges).value();
  room.insert(Shape::rectangle({{4, 4}, {6, 6}}), 7).value();
  const BridgeList list = room.bridges({{-5, -5}, {15, 15}}).value();
  std::vector<Bridge> expected;
  for (const auto& [from, to] : std::vector<std::array<Point, 2>>{{{{4, 4}, {0, 4}}},
                                                                  {{{4, 4}, {4, 0}}},
                                                                  {{{4, 6}, {0, 6}}},
                                                                  {{{4, 6}, {4, 10}}},
                                                                  {{{6, 4}, {6, 0}}},
                                                                  {{{6, 4}, {10, 4}}},
                                                                  {{{6, 6}, {6, 10}}},
                                                                  {{{6, 6}, {10, 6}}}}) {
    expected.push_back({from, to, 2.0, true, static_cast<std::uint32_t>(2 * expected.size()), 1, 1});
  }
  EXPECT_EQ(list.bridges, expected);
  for (const Bridge& bridge : list.bridges) {
    EXPECT_EQ(list_of(list.from_items(bridge)), Ids{7});
    EXPECT_EQ(list_of(list.to_items(bridge)), Ids{ItemId{}});
  }
  EXPECT_EQ(room.bridges({{1, 5}, {2, 7}}).value().bridges.size(), 1U) << "only the bridge at y = 6 meets the box";
  EXPECT_EQ(room.bridges({{11, 11}, {12, 12}}).value(), BridgeList{}) << "beyond the domain";
}

// The notch of the shape reaches down to (5, 3), and the shape ends at y = 1. No disc gets into the polygon, but a disc
// fits inside the polyline.
TEST(Bridges, InsideAPolygonAreNotListed) {
  const std::vector<Point> notched = {{1, 1}, {9, 1}, {9, 9}, {5, 3}, {1, 9}};
  const Box inside{{5, 1.5}, {5, 2.5}};
  World solid = World::create({{0, 0}, {10, 10}}, kKeepsBridges).value();
  solid.insert_polygon(notched).value();
  EXPECT_TRUE(solid.bridges(inside).value().bridges.empty());
  World hollow = World::create({{0, 0}, {10, 10}}, kKeepsBridges).value();
  std::vector<Point> closed = notched;
  closed.push_back(notched.front());
  hollow.insert_polyline(closed).value();
  const BridgeList list = hollow.bridges(inside).value();
  ASSERT_EQ(list.bridges.size(), 1U);
  EXPECT_EQ(list.bridges.front(), (Bridge{{5, 3}, {5, 1}, 1.0, true, 0, 1, 1}));
}

TEST(Bridges, AreRefusedWithoutKeepingThem) {
  const World world = World::create({{0, 0}, {10, 10}}).value();
  const Result<BridgeList> list = world.bridges(world.domain());
  ASSERT_FALSE(list.ok());
  EXPECT_EQ(list.error().code, ErrorCode::no_bridges);
}

TEST(Bridges, AreRefusedForABadBox) {
  const World world = World::create({{0, 0}, {10, 10}}, kKeepsBridges).value();
  EXPECT_EQ(world.bridges({{3, 0}, {2, 5}}).error().code, ErrorCode::bad_domain);
  const Result<BridgeList> list = world.bridges({{0, 0}, {std::numeric_limits<double>::infinity(), 1}});
  EXPECT_EQ(list.error().code, ErrorCode::coordinate_range);
  EXPECT_EQ(list.error().index, 1U);
}

}  // namespace
}  // namespace waywright::test

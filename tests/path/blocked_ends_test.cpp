#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "support/case_count.hpp"
#include "support/oracle_adapter.hpp"
#include "support/point_text.hpp"
#include "support/random.hpp"
#include "support/random_path_cases.hpp"

namespace waywright::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Point> square(double min, double max) { return {{min, min}, {max, min}, {max, max}, {min, max}}; }

World world_with_square() {
  World world = World::create({{0, 0}, {16, 16}}).value();
  world.insert_polygon(square(4, 8), {7}).value();
  return world;
}

TEST(BlockedEnds, AreMovedByDefaultIfRoundingExplainsThem) {
  const World world = world_with_square();
  EXPECT_EQ(world.default_end_tolerance(), 16 * 0x1p-20);
  const Point start{4 + 0x1p-40, 6};
  const Path path = world.find_path({start, {1, 6}}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.moved_start, (MovedEnd{start, {4, 6}}));
  EXPECT_EQ(path.moved_goal, std::nullopt);
  EXPECT_EQ(path.points, (std::vector<Point>{{4, 6}, {1, 6}}));
  EXPECT_EQ(path.length, 3.0);
  const Path back = world.find_path({{1, 6}, start}).value();
  ASSERT_EQ(back.status, PathStatus::found);
  EXPECT_EQ(back.moved_goal, (MovedEnd{start, {4, 6}}));
  EXPECT_EQ(back.points.back(), (Point{4, 6}));
}

TEST(BlockedEnds, StayBlockedByMoreAndNameTheItems) {
  World world = world_with_square();
  world.insert_polygon(square(5, 9), {3}).value();
  world.insert_polygon(square(12, 13), {4}).value();
  const Path path = world.find_path({{6, 6}, {1, 6}}).value();
  EXPECT_EQ(path.status, PathStatus::start_blocked);
  EXPECT_EQ(path.blockers, (std::vector<ItemId>{{3}, {7}}));
  EXPECT_EQ(path.moved_start, std::nullopt);
  const Path other = world.find_path({{1, 6}, {12.5, 12.5}}).value();
  EXPECT_EQ(other.status, PathStatus::goal_blocked);
  EXPECT_EQ(other.blockers, (std::vector<ItemId>{{4}}));
  EXPECT_TRUE(world.find_path({{1, 1}, {2, 2}}).value().blockers.empty());
}

TEST(BlockedEnds, AreMovedAsFarAsTheQueryAllows) {
  const World world = world_with_square();
  PathQuery query{{5.5, 6.25}, {1, 6}};
  query.end_tolerance = 1.5;
  const Path path = world.find_path(query).value();
  EXPECT_EQ(path.moved_start, (MovedEnd{{5.5, 6.25}, {4, 6.25}}));
  query.end_tolerance = std::nextafter(1.5, 0.0);
  EXPECT_EQ(world.find_path(query).value().status, PathStatus::start_blocked) << "the limit holds to the last bit";
  query.end_tolerance = kInfinity;
  EXPECT_EQ(world.find_path(query).value().status, PathStatus::found);
  query.end_tolerance = 0.0;
  query.start = {4 + 0x1p-40, 6};
  EXPECT_EQ(world.find_path(query).value().status, PathStatus::start_blocked) << "0 moves nothing";
  for (const double bad : {-1.0, std::nan("")}) {
    query.end_tolerance = bad;
    EXPECT_EQ(world.find_path(query).error().code, ErrorCode::bad_distance);
  }
}

// Of two points that are equally near, the library takes the first in (x, y) order. It decides exactly which point is
// nearer.
TEST(BlockedEnds, TiesAreBrokenByOrder) {
  World world = world_with_square();
  PathQuery query{{6, 5}, {1, 1}};
  query.end_tolerance = kInfinity;
  EXPECT_EQ(world.find_path(query).value().moved_start->to, (Point{6, 4}));
  query.start = {6, 6};
  EXPECT_EQ(world.find_path(query).value().moved_start->to, (Point{4, 6}));
  query.start = {std::nextafter(6.0, 7.0), 6};
  EXPECT_EQ(world.find_path(query).value().moved_start->to, (Point{8, 6}));
}

// The square in the ring's hole is nearer, but no path leads out of the hole.
TEST(BlockedEnds, GoWhereTheOtherEndCanBeReached) {
  World world = World::create({{0, 0}, {16, 16}}).value();
  const std::vector<std::vector<Point>> ring = {square(2, 14), square(6, 10)};
  world.insert_polygon(ring).value();
  PathQuery query{{5.5, 8}, {1, 1}};
  query.end_tolerance = kInfinity;
  EXPECT_EQ(world.find_path(query).value().moved_start->to, (Point{2, 8}));
  query.goal = {8, 8};
  EXPECT_EQ(world.find_path(query).value().moved_start->to, (Point{6, 8}));
  const std::vector<Point> goals = {{1, 1}, {8, 8}, {5, 8}};
  ManyGoalsQuery many{.start = {5.5, 8}, .goals = goals};
  many.end_tolerance = kInfinity;
  const std::vector<Path> paths = world.find_paths_from(many).value();
  EXPECT_EQ(paths[0].status, PathStatus::no_path) << "the start is moved once, to the nearest free position";
  EXPECT_EQ(paths[1].status, PathStatus::found);
  EXPECT_EQ(paths[2].moved_start->to, (Point{6, 8}));
  EXPECT_EQ(paths[2].moved_goal->to, (Point{6, 8}));
}

// The point lies on a closed polyline. The program has rounded it into the area that the polyline encloses.
TEST(BlockedEnds, BesideAThinWallChangeSidesOnlyByRounding) {
  World world = World::create({{0, 0}, {16, 16}}).value();
  world.insert_polyline(std::vector<Point>{{4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}}).value();
  PathQuery query{{4 + 0x1p-40, 6}, {1, 6}};
  const Path path = world.find_path(query).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.moved_start->to, (Point{4, 6}));
  query.start = {4.5, 6};
  query.end_tolerance = kInfinity;
  EXPECT_EQ(world.find_path(query).value().status, PathStatus::no_path) << "no tolerance takes a unit through a wall";
  query.start = {4 + 0x1p-40, 6};
  query.end_tolerance = 0.0;
  EXPECT_EQ(world.find_path(query).value().status, PathStatus::no_path);
}

/// Returns the distance from `p` to the nearest point next to which no polygon covers. Checks the feet of `p` on all
/// sides, all corners and all crossings, in doubles.
double distance_to_free(const Scene& scene, const oracle::Oracle& oracle, const Point& p) {
  std::vector<std::array<Point, 2>> sides;
  for (const Item& item : scene.items) {
    for (const auto& ring : item.shape.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  const Box& box = scene.domain;
  const auto is_free = [&](const Point& q) {
    constexpr double kNear = 1e-6;
    for (int i = 0; i < 48; ++i) {
      const double angle = i * 3.14159265358979 / 24 + 0.01;
      const Point near{q.x + kNear * std::cos(angle), q.y + kNear * std::sin(angle)};
      if (near.x < box.min.x || near.x > box.max.x || near.y < box.min.y || near.y > box.max.y) continue;
      if (oracle.covering_polygons(oracle::to_oracle(near)).empty()) return true;
    }
    return false;
  };
  std::vector<std::pair<double, Point>> candidates;
  const auto add = [&](const Point& q) { candidates.emplace_back(std::hypot(q.x - p.x, q.y - p.y), q); };
  for (const auto& [a, b] : sides) {
    const Point edge{b.x - a.x, b.y - a.y};
    const double squared = edge.x * edge.x + edge.y * edge.y;
    const double share = squared == 0 ? 0 : ((p.x - a.x) * edge.x + (p.y - a.y) * edge.y) / squared;
    add({a.x + std::clamp(share, 0.0, 1.0) * edge.x, a.y + std::clamp(share, 0.0, 1.0) * edge.y});
    for (const auto& [c, d] : sides) {
      const Point other{d.x - c.x, d.y - c.y};
      const double cross = edge.x * other.y - edge.y * other.x;
      if (cross == 0) continue;
      const double t = ((c.x - a.x) * other.y - (c.y - a.y) * other.x) / cross;
      const double u = ((c.x - a.x) * edge.y - (c.y - a.y) * edge.x) / cross;
      if (t >= 0 && t <= 1 && u >= 0 && u <= 1) add({a.x + t * edge.x, a.y + t * edge.y});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [&](const auto& c) { return is_free(c.second); });
  return found == candidates.end() ? kInfinity : found->first;
}

TEST(BlockedEnds, AreMovedToTheNearestFreePosition) {
  std::size_t moved = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const PathCase path_case = random_path_case(Obstacles::boxes, 300 + seed, 12);
    const oracle::Oracle oracle(oracle::to_oracle(path_case.scene));
    World world = World::create(path_case.scene.domain, {.keep_abstraction = seed % 2 == 0}).value();
    for (const Item& item : path_case.scene.items) world.insert(item.shape, item.id).value();
    for (const Ends& ends : path_case.queries) {
      if (!oracle.strictly_inside(oracle::to_oracle(ends.start))) continue;
      const std::vector<Point> goals = {ends.goal};
      ManyGoalsQuery query{.start = ends.start, .goals = goals};
      query.end_tolerance = kInfinity;
      const Path path = world.find_paths_from(query).value().front();
      const double expected = distance_to_free(path_case.scene, oracle, ends.start);
      ASSERT_EQ(path.moved_start.has_value(), expected < kInfinity) << "seed " << seed << text_of(ends.start);
      if (!path.moved_start) continue;
      ++moved;
      const Point& to = path.moved_start->to;
      EXPECT_FALSE(oracle.strictly_inside(oracle::to_oracle(to))) << text_of(to);
      EXPECT_NEAR(std::hypot(to.x - ends.start.x, to.y - ends.start.y), expected, 1e-9 * path_case.scene.domain.max.x)
          << "seed " << seed << ": " << text_of(ends.start) << " to " << text_of(to);
    }
  }
  EXPECT_GT(moved, 100U);
}

// The sides of two triangles cross at (32/9, 5/3). Below lies a wedge of free ground. No double next to the rounded
// crossing lies in it.
TEST(BlockedEnds, AreMovedIntoNarrowWedges) {
  World world = World::create({{0, 0}, {8, 8}}).value();
  world.insert_polygon({{0, 7}, {5, 5}, {4, 1}}, 1).value();
  world.insert_polygon({{3, 0}, {3, 7}, {4, 3}}, 2).value();
  const Point crossing{32.0 / 9, 5.0 / 3};
  const Path path = world.find_path({.start = crossing, .goal = {6, 1}}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  ASSERT_TRUE(path.moved_start.has_value());
  EXPECT_LT(distance(path.moved_start->to, crossing), 1e-13);
  const Path back = world.find_path({.start = {6, 1}, .goal = crossing}).value();
  EXPECT_EQ(back.moved_goal->to, path.moved_start->to);
  const NearestFit fit = world.nearest_fit({.point = {3.6, 2}}).value();
  EXPECT_NEAR(fit.distance, distance(crossing, {3.6, 2}), 1e-12);
  const double limit = distance(crossing, {3.6, 2});
  EXPECT_TRUE(world.nearest_fit({.point = {3.6, 2}, .limit = 1.000001 * limit}).value().is_found);
  EXPECT_FALSE(world.nearest_fit({.point = {3.6, 2}, .limit = 0.999999 * limit}).value().is_found);
}

// The rounded crossing of two closed polylines lies in an area without a way out.
TEST(BlockedEnds, AreMovedAcrossWallsIntoNarrowWedges) {
  World world = World::create({{0, 0}, {6, 6}}).value();
  world.insert_polyline(std::vector<Point>{{5, 4}, {2, 4}, {3, 1}, {5, 4}}, 1).value();
  world.insert_polyline(std::vector<Point>{{2, 1}, {5, 5}, {2, 5}, {2, 1}}, 2).value();
  const Point crossing{35.0 / 13, 25.0 / 13};
  const Path path = world.find_path({.start = crossing, .goal = {0.5, 0.5}}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_LT(distance(path.moved_start->to, crossing), 1e-12);
  EXPECT_LT(world.nearest_fit({.point = crossing, .goal = Point{0.5, 0.5}}).value().distance, 1e-12);
}

/// Returns a number from `low` to `high`.
double number_between(Random& random, double low, double high) {
  return low + (high - low) * 0x1p-30 * static_cast<double>(random.below(1U << 30));
}

/// A town of rotated houses, which overlap.
Scene random_houses(Random& random) {
  Scene scene{{{0, 0}, {100, 100}}, {}};
  for (std::uint64_t id = 1; id <= 24; ++id) {
    const Point middle{number_between(random, 15, 85), number_between(random, 15, 85)};
    const double angle = number_between(random, 0, 6.28);
    const Point side{10 * std::cos(angle), 10 * std::sin(angle)};
    scene.items.push_back({{id},
                           Shape::polygon({{middle.x + side.x, middle.y + side.y},
                                           {middle.x - side.y, middle.y + side.x},
                                           {middle.x - side.x, middle.y - side.y},
                                           {middle.x + side.y, middle.y - side.x}})});
  }
  return scene;
}

TEST(BlockedEnds, AreMovedToTheNearestFreePositionBetweenHouses) {
  std::size_t moved = 0;
  for (std::uint64_t seed = 1; seed <= case_count(); ++seed) {
    Random random(seed);
    const Scene scene = random_houses(random);
    const oracle::Oracle oracle(oracle::to_oracle(scene));
    World world = World::create(scene.domain).value();
    for (const Item& item : scene.items) world.insert(item.shape, item.id).value();
    for (int i = 0; i < 12; ++i) {
      const Point p{number_between(random, 20, 80), number_between(random, 20, 80)};
      if (!oracle.strictly_inside(oracle::to_oracle(p))) continue;
      const NearestFit fit = world.nearest_fit({.point = p}).value();
      ASSERT_TRUE(fit.is_found);
      ++moved;
      EXPECT_FALSE(oracle.strictly_inside(oracle::to_oracle(fit.at))) << text_of(fit.at);
      EXPECT_LE(fit.distance, distance_to_free(scene, oracle, p) + 1e-9) << "seed " << seed << ": " << text_of(p);
    }
  }
  EXPECT_GT(moved, 3 * case_count());
}

// One polygon rests on another. The gap between them is nearer than the outside, but no double lies in it.
TEST(BlockedEnds, AreMovedPastGapsThatAreTooNarrowForADouble) {
  const double ulp = std::nextafter(5.0, 6.0) - 5.0;
  for (const bool keep_abstraction : {false, true}) {
    World world = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = keep_abstraction}).value();
    world.insert_polygon({{2, 2}, {8, 2}, {8, 5 + ulp}, {2, 5}}, 1).value();
    world.insert_polygon({{2, 5}, {7.5, 5 + ulp}, {7.5, 9}, {2, 9}}, 2).value();
    PathQuery query;
    query.start = {5, 4};
    query.goal = {0.5, 0.5};
    for (const double tolerance : {2.0, 2.9, 100.0, std::numeric_limits<double>::infinity()}) {
      query.end_tolerance = tolerance;
      const Path path = world.find_path(query).value();
      ASSERT_EQ(path.status, PathStatus::found) << tolerance;
      ASSERT_TRUE(path.moved_start.has_value());
      EXPECT_EQ(path.moved_start->to, (Point{5, 2}));
    }
    query.end_tolerance = 1.9;
    EXPECT_EQ(world.find_path(query).value().status, PathStatus::start_blocked);
  }
}

}  // namespace
}  // namespace waywright::test

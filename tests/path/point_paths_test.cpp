#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

namespace waywright::test {
namespace {

World world_of(const Box& domain, const std::vector<Shape>& shapes) {
  World world = World::create(domain).value();
  for (const Shape& shape : shapes) EXPECT_TRUE(world.insert(shape).ok());
  EXPECT_TRUE(world.validate().ok);
  return world;
}

Shape rectangle(double x0, double y0, double x1, double y1) {
  return {ItemKind::polygon, {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
}

Shape wall(Point a, Point b) { return {ItemKind::segment, {{a, b}}}; }

constexpr Box kTen = {{0, 0}, {10, 10}};

/// Tests each algorithm on scenes so simple that every algorithm finds a shortest path.
class PointPaths : public testing::TestWithParam<PathAlgorithm> {
 protected:
  [[nodiscard]] static Path path_of(const World& world, Point start, Point goal) {
    return world.find_path({start, goal, {}, GetParam()}).value();
  }
};

INSTANTIATE_TEST_SUITE_P(Algorithms, PointPaths,
                         testing::Values(PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal),
                         [](const auto& algorithm) { return std::string(to_string(algorithm.param)); });

TEST_P(PointPaths, StraightThroughEmptySpace) {
  const World world = world_of(kTen, {});
  const Path path = path_of(world, {1, 1}, {9, 7});
  EXPECT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.points, (std::vector<Point>{{1, 1}, {9, 7}}));
  EXPECT_DOUBLE_EQ(path.length, 10.0);
}

// The diagonal of the box starts at its first corner.
TEST_P(PointPaths, AStraightPathCrossesTheEdgesOnIt) {
  const World world = world_of(kTen, {});
  PathQuery query{{1, 2}, {9, 7}, {}, GetParam()};
  query.wants_channel = true;
  const Path there = world.find_path(query).value();
  EXPECT_EQ(there.channel, (std::vector<Portal>{{{10, 10}, {0, 0}}}));
  EXPECT_EQ(there.expansions, 1U);
  EXPECT_EQ(there.lower_bound, there.length);
  std::swap(query.start, query.goal);
  EXPECT_EQ(world.find_path(query)->channel, (std::vector<Portal>{{{0, 0}, {10, 10}}}));
  query.goal = {4, 4};
  EXPECT_EQ(world.find_path(query)->channel, std::vector<Portal>{}) << "an edge that it ends on is not crossed";
}

TEST_P(PointPaths, StraightFromWallToWall) {
  const World world = world_of(kTen, {wall({3, 0}, {3, 6}), wall({7, 4}, {7, 10}), rectangle(8, 1, 9, 2)});
  const auto expect_straight = [&](Point start, Point goal) {
    EXPECT_EQ(path_of(world, start, goal).points, (std::vector<Point>{start, goal}));
    EXPECT_EQ(path_of(world, goal, start).points, (std::vector<Point>{goal, start}));
  };
  expect_straight({3, 5}, {7, 5});   // from side to side
  expect_straight({3, 6}, {7, 4});   // from end to end
  expect_straight({3, 6}, {7, 10});  // from an end to the border
  expect_straight({3, 2}, {3, 6});   // along a wall
  expect_straight({8, 1.5}, {3, 6});
  expect_straight({8, 2}, {9, 2});
  // A point behind a wall or behind the inside of a polygon is not near.
  EXPECT_EQ(path_of(world, {1, 5}, {3, 5}).length, 2.0) << "a path may end on the wall, and cross no wall for this";
  EXPECT_DOUBLE_EQ(path_of(world, {2, 5}, {4, 5}).length, 2 * std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(path_of(world, {8, 1}, {9, 2}).length, 2.0);
  EXPECT_DOUBLE_EQ(path_of(world, {8, 1.5}, {9, 1.5}).length, 2.0);
}

TEST_P(PointPaths, AroundAWallsEnd) {
  const World world = world_of(kTen, {wall({5, 0}, {5, 6})});
  const Path path = path_of(world, {1, 3}, {9, 3});
  EXPECT_EQ(path.points, (std::vector<Point>{{1, 3}, {5, 6}, {9, 3}}));
  EXPECT_DOUBLE_EQ(path.length, 10.0);
}

TEST_P(PointPaths, AroundTheNearerSideOfASolid) {
  const World world = world_of(kTen, {rectangle(4, 2, 6, 9)});
  const Path path = path_of(world, {2, 4}, {8, 4});
  EXPECT_EQ(path.points, (std::vector<Point>{{2, 4}, {4, 2}, {6, 2}, {8, 4}}));
  EXPECT_DOUBLE_EQ(path.length, 2 + 4 * std::numbers::sqrt2);
}

// Around a triangle whose tip touches the border. A path can reach the tip from its left and from its right, and all
// faces there belong to dead ends. The item that was inserted and removed may have changed which face is the root.
TEST_P(PointPaths, TakesTheShorterWayToATipThatDividesTheGround) {
  const double length = 2 * std::numbers::sqrt2 + std::sqrt(45.0);
  for (int guest = 0; guest < 10; ++guest) {
    World world = world_of(kTen, {{ItemKind::polygon, {{{5, 0}, {8, 6}, {2, 6}}}}});
    const double x = guest + 0.25;
    const auto id = world.insert(wall({x, 9}, {x, 9.5})).value();
    ASSERT_TRUE(world.remove(id).ok());
    const Path on_the_left = path_of(world, {4, 8}, {5, 0});
    EXPECT_EQ(on_the_left.points, (std::vector<Point>{{4, 8}, {2, 6}, {5, 0}})) << guest;
    EXPECT_DOUBLE_EQ(on_the_left.length, length);
    const Path on_the_right = path_of(world, {6, 8}, {5, 0});
    EXPECT_EQ(on_the_right.points, (std::vector<Point>{{6, 8}, {8, 6}, {5, 0}})) << guest;
    EXPECT_DOUBLE_EQ(on_the_right.length, length);
  }
}

TEST_P(PointPaths, WallsThatMeetLeaveNoPath) {
  const World crossing = world_of(kTen, {wall({5, 0}, {5, 5}), wall({5, 5}, {5, 10})});
  EXPECT_EQ(path_of(crossing, {1, 5}, {9, 5}).status, PathStatus::no_path);
  const World corners = world_of(kTen, {rectangle(0, 0, 5, 5), rectangle(5, 5, 10, 10)});
  EXPECT_EQ(path_of(corners, {1, 9}, {9, 1}).status, PathStatus::no_path) << "two polygons touch at a corner";
  const World border = world_of(kTen, {wall({5, 0}, {5, 10})});
  EXPECT_EQ(path_of(border, {1, 5}, {9, 5}).status, PathStatus::no_path);
  const World ajar = world_of(kTen, {wall({5, 0}, {5, 9.999})});
  EXPECT_EQ(path_of(ajar, {1, 5}, {9, 5}).status, PathStatus::found);
}

TEST_P(PointPaths, FreePointsAreNoWalls) {
  World world = world_of(kTen, {});
  for (int i = 1; i < 10; ++i) ASSERT_TRUE(world.insert_point({5, static_cast<double>(i)}).ok());
  const Path path = path_of(world, {1, 5}, {9, 5});
  EXPECT_EQ(path.status, PathStatus::found);
  EXPECT_DOUBLE_EQ(path.length, 8.0);
}

TEST_P(PointPaths, EndsInsideSolidsAreBlockedOnTheirSidesFree) {
  const World world = world_of(kTen, {rectangle(4, 4, 6, 6)});
  EXPECT_EQ(path_of(world, {5, 5}, {1, 1}).status, PathStatus::start_blocked);
  EXPECT_EQ(path_of(world, {1, 1}, {5, 5}).status, PathStatus::goal_blocked);
  const Path along = path_of(world, {4, 4}, {6, 4});
  EXPECT_EQ(along.status, PathStatus::found);
  EXPECT_DOUBLE_EQ(along.length, 2.0);
  // From one side of the polygon to the opposite side: around it, not through it.
  const Path around = path_of(world, {4, 5}, {6, 5});
  EXPECT_EQ(around.status, PathStatus::found);
  EXPECT_DOUBLE_EQ(around.length, 4.0);
}

TEST_P(PointPaths, HolesAreRoomsOfTheirOwn) {
  const World world =
      world_of(kTen, {{ItemKind::polygon, {{{1, 1}, {9, 1}, {9, 9}, {1, 9}}, {{3, 3}, {7, 3}, {7, 7}, {3, 7}}}}});
  EXPECT_EQ(path_of(world, {4, 4}, {6, 6}).status, PathStatus::found);
  EXPECT_EQ(path_of(world, {4, 4}, {0.5, 0.5}).status, PathStatus::no_path);
  EXPECT_EQ(path_of(world, {2, 2}, {4, 4}).status, PathStatus::start_blocked);
  EXPECT_EQ(path_of(world, {3, 5}, {5, 5}).status, PathStatus::found);
}

TEST_P(PointPaths, NoPathAlongASideThatTwoSolidsShare) {
  const World world = world_of(kTen, {rectangle(2, 2, 5, 8), rectangle(5, 2, 8, 8)});
  // The point is strictly inside neither polygon, but one polygon lies left of it, and the other one right of it.
  EXPECT_EQ(path_of(world, {5, 5}, {1, 1}).status, PathStatus::no_path);
  EXPECT_EQ(path_of(world, {5, 5}, {5, 5}).status, PathStatus::found);
  EXPECT_EQ(path_of(world, {5, 2}, {5, 8}).points.size(), 4U) << "around one of the polygons";
}

TEST_P(PointPaths, StartEqualsGoal) {
  const World world = world_of(kTen, {rectangle(4, 4, 6, 6)});
  const Path path = path_of(world, {4, 4}, {4, 4});
  EXPECT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.length, 0.0);
}

double length_of(const std::vector<Point>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

// One wall begins 10^-20 above another, which only exact arithmetic can tell. The shortest path leads through the gap.
TEST(ShortestPaths, ThroughAGapBetweenWallsThatSeemToTouch) {
  const Point end{-0.7959918567436949, -0.00013992622587844495};
  const Point tip{-0.8163014956418463, -0.0040801744508494105};
  const World world = world_of({{-1, -1}, {1, 1}}, {wall(end, {-0.8569207734381491, -0.011960670900791342}),
                                                    wall(tip, {-0.543217257907694, 0.1472487340776012})});
  const PathQuery query{{-0.5779020981534886, -0.17469550198635064}, {-0.8154634610772286, 1.7861308928303587e-06}};
  const Path path = world.find_path(query).value();
  EXPECT_NEAR(path.length, length_of({query.start, end, tip, query.goal}), 1e-12);
}

TEST(ShortestPaths, AroundATipThatAlmostTouchesAWall) {
  const Point corner{-0.7046079265601128, 0.1763215604562075};
  const Point end{-0.8104237720459804, 0.28636250175253153};
  const Point tip{-0.5454068349674981, 0.019255250921814793};
  const std::vector<Point> walls = {
      {-1, -0.33959029372497385}, {-0.38620574337488345, -0.1378110586125778}, corner, end};
  const World world =
      world_of({{-1.5, -2}, {2.5, 1.5}}, {{ItemKind::polyline, {walls}}, wall(tip, {-1, 0.2766477831232632})});
  const PathQuery query{{1, 1}, {-0.5454068349674981, 0.01925525092181468}};
  const Path path = world.find_path(query).value();
  EXPECT_NEAR(path.length, length_of({query.start, end, corner, tip, query.goal}), 1e-12);
}

// In the wedge outside of a bent wall, the path to the bend is short. In the wedge inside, it is long. The search must
// not use the length of the first path in the second wedge.
TEST(ShortestPaths, TheDistanceOfABendInOneWedgeIsNotItsDistanceInTheOther) {
  const World world = world_of(kTen, {{ItemKind::polyline, {{{0, 6}, {6, 6}, {6, 1}}}}});
  const Path path = world.find_path({{9, 7}, {1, 5}}).value();
  EXPECT_NEAR(path.length, length_of({{9, 7}, {6, 1}, {1, 5}}), 1e-12);
}

TEST(PathQueries, RefuseWhatCannotBeDone) {
  const World world = world_of(kTen, {});
  const World bare = World::create(kTen, {.keep_abstraction = false}).value();
  const auto code = [&](const PathQuery& query) { return world.find_path(query).error().code; };
  EXPECT_EQ(code({{-1, 0}, {1, 1}}), ErrorCode::out_of_domain);
  EXPECT_EQ(code({{0, 0}, {std::nan(""), 1}}), ErrorCode::coordinate_range);
  EXPECT_EQ(code({{0, 0}, {1, 1}, -1.0}), ErrorCode::bad_radius);
  EXPECT_EQ(code({{0, 0}, {1, 1}, std::nan("")}), ErrorCode::bad_radius);
  EXPECT_EQ(code({{0, 0}, {1, 1}, 1.0}), ErrorCode::no_bridges);
  EXPECT_EQ(bare.find_path({{0, 0}, {1, 1}, {}, PathAlgorithm::tra}).error().code, ErrorCode::not_supported);
}

TEST_P(PointPaths, AnswersDependOnTheWorldAlone) {
  const std::vector<Shape> shapes = {rectangle(2, 2, 3, 8), rectangle(4, 1, 5, 7), wall({6, 3}, {7, 9}),
                                     rectangle(7, 1, 8, 6), wall({1, 5}, {9, 5.5})};
  const World forwards = world_of(kTen, shapes);
  const World backwards = world_of(kTen, {shapes.rbegin(), shapes.rend()});
  QueryContext context;
  Path path;
  for (int i = 0; i < 20; ++i) {
    const PathQuery query{{0.5, 0.5 * i}, {9.5, 9.5 - 0.4 * i}, {}, GetParam()};
    ASSERT_TRUE(forwards.find_path(query, context, path).ok());
    const Path other = backwards.find_path(query).value();
    EXPECT_EQ(path.points, other.points);
    EXPECT_EQ(path.length, other.length);
    EXPECT_EQ(path.expansions, other.expansions);
  }
}

}  // namespace
}  // namespace waywright::test

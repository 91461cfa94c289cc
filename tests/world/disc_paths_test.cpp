#include "support/disc_paths.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"

namespace waywright::test {
namespace {

World world_with_bridges(const Box& domain) { return World::create(domain, {.keep_bridges = true}).value(); }

/// A wall from the bottom and one from the top, with a gap from y = 60 to y = 70.
World two_walls() {
  World world = world_with_bridges({{0, 0}, {100, 100}});
  world.insert_segment({50, 0}, {50, 60}, 1).value();
  world.insert_segment({50, 70}, {50, 100}, 2).value();
  return world;
}

TEST(DiscPaths, PassAGapOfExactlyTheirDiameter) {
  const World world = two_walls();
  const Path path = world.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  ASSERT_EQ(path.pieces.size(), 3U);
  EXPECT_EQ(path.pieces[1].centre, (Point{50, 60}));
  EXPECT_EQ(path.pieces[1].radius, 5);
  EXPECT_GT(path.pieces[1].start_angle, path.pieces[1].end_angle);
  EXPECT_TRUE(path.points.empty());
}

TEST(DiscPaths, SayWhichGapIsTooNarrowByOneUlp) {
  const World world = two_walls();
  const double radius = std::nextafter(5.0, 6.0);
  const Path path = world.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = radius}}).value();
  ASSERT_EQ(path.status, PathStatus::no_path);
  ASSERT_TRUE(path.widest.has_value());
  EXPECT_EQ(path.widest->radius, 5.0);
  EXPECT_EQ(path.widest->from_items, (std::vector<ItemId>{1}));
  EXPECT_EQ(path.widest->to_items, (std::vector<ItemId>{2}));
}

TEST(DiscPaths, NameTheItemsThatBlockAnEnd) {
  const World world = two_walls();
  const Path start = world.find_path({.start = {48, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
  EXPECT_EQ(start.status, PathStatus::start_blocked);
  EXPECT_EQ(start.blockers, (std::vector<ItemId>{1}));
  const Path goal = world.find_path({.start = {20, 50}, .goal = {80, 97}, .agent = {.radius = 5}}).value();
  EXPECT_EQ(goal.status, PathStatus::goal_blocked);
  EXPECT_EQ(goal.blockers, (std::vector<ItemId>{ItemId{}}));
}

TEST(DiscPaths, StartAndEndAtTheNearestPositionWithinTheTolerance) {
  const World world = two_walls();
  const Path path =
      world.find_path({.start = {48, 50}, .goal = {80, 97}, .agent = {.radius = 5}, .end_tolerance = 3}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.moved_start, (MovedEnd{{48, 50}, {45, 50}}));
  EXPECT_EQ(path.moved_goal, (MovedEnd{{80, 97}, {80, 95}}));
  EXPECT_EQ(path.pieces.front().from, (Point{45, 50}));
  EXPECT_EQ(path.pieces.back().to, (Point{80, 95}));
  const Path blocked =
      world.find_path({.start = {45, 50}, .goal = {80, 97}, .agent = {.radius = 5}, .end_tolerance = 1.5}).value();
  EXPECT_EQ(blocked.status, PathStatus::goal_blocked);
  EXPECT_FALSE(blocked.moved_goal);
  EXPECT_EQ(blocked.blockers, (std::vector<ItemId>{ItemId{}}));
}

TEST(DiscPaths, MoveAnEndThatRoundingHasBlocked) {
  const World world = two_walls();
  const Point start{45.00001, 50};
  EXPECT_TRUE(world.find_path({.start = start, .goal = {80, 50}, .agent = {.radius = 5}}).value().moved_start);
  const Path refused =
      world.find_path({.start = start, .goal = {80, 50}, .agent = {.radius = 5}, .end_tolerance = 0}).value();
  EXPECT_EQ(refused.status, PathStatus::start_blocked);
}

// A vertex is nearer to the straight line than the radius, by less than the rounding error of a crossing in this
// domain. World `changed` has had a crossing. It contains the same items as the other world, so it must give the same
// answer.
TEST(DiscPaths, DoNotDependOnCrossingsThatAreGone) {
  const Box domain{{1e6, 0}, {1001000, 1000}};
  World changed = world_with_bridges(domain);
  changed.insert_segment({1000010, 10}, {1000023, 20}, 1).value();
  changed.insert_segment({1000011, 20}, {1000020, 10}, 2).value();
  changed.remove(1).value();
  changed.remove(2).value();
  World fresh = world_with_bridges(domain);
  for (World* const world : {&changed, &fresh}) {
    world->insert_segment({1000500, 500.5 - 3e-10}, {1000500, 600}, 3).value();
  }
  const PathQuery query{.start = {1000100, 500}, .goal = {1000900, 500}, .agent = {.radius = 0.5}};
  const Path path = fresh.find_path(query).value();
  EXPECT_EQ(changed.find_path(query).value().length, path.length);
  EXPECT_EQ(changed.find_path(query).value().pieces.size(), path.pieces.size());
  EXPECT_EQ(changed.items_hash(), fresh.items_hash());
}

// The disc does not pass the gap from y = 60 to y = 70. The nearest position to the end lies beyond the wall.
TEST(DiscPaths, PreferPositionsThatAreConnectedWithTheOtherEnd) {
  const World world = two_walls();
  const PathQuery query{.start = {48, 50}, .goal = {80, 50}, .agent = {.radius = 6}, .end_tolerance = 10};
  const Path path = world.find_path(query).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.moved_start->to, (Point{56, 50}));
  const Path back =
      world.find_path({.start = {80, 50}, .goal = {48, 50}, .agent = {.radius = 6}, .end_tolerance = 10}).value();
  EXPECT_EQ(back.moved_goal->to, (Point{56, 50}));
  // No connected position is within the tolerance.
  const Path near =
      world.find_path({.start = {48, 50}, .goal = {80, 50}, .agent = {.radius = 6}, .end_tolerance = 5}).value();
  EXPECT_EQ(near.status, PathStatus::no_path);
  EXPECT_EQ(near.moved_start->to, (Point{44, 50}));
  EXPECT_EQ(near.widest->radius, 5);
}

TEST(DiscPaths, NeedBridges) {
  const World world = World::create({{0, 0}, {100, 100}}).value();
  const auto refused = world.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::no_bridges);
}

TEST(DiscPaths, AreOneLineWithoutLengthIfStartAndGoalAreEqual) {
  const World world = two_walls();
  const Path path = world.find_path({.start = {20, 50}, .goal = {20, 50}, .agent = {.radius = 5}}).value();
  EXPECT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.length, 0.0);
  ASSERT_EQ(path.pieces.size(), 1U);
  EXPECT_EQ(path.pieces[0].from, (Point{20, 50}));
  EXPECT_EQ(path.pieces[0].to, (Point{20, 50}));
}

TEST(DiscPaths, SayHowLongTheSearchTookIfAsked) {
  const World world = two_walls();
  PathQuery query{.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 4.5}};
  EXPECT_EQ(world.find_path(query).value().time.count(), 0);
  query.wants_time = true;
  EXPECT_GT(world.find_path(query).value().time.count(), 0);
  query.agent.radius = 6;
  EXPECT_GT(world.find_path(query).value().time.count(), 0) << "no path";
  query.end_tolerance = 0;
  query.start = {48, 50};
  EXPECT_GT(world.find_path(query).value().time.count(), 0) << "a blocked start";
}

TEST(DiscPaths, DoNotDependOnPoints) {
  World world = two_walls();
  const PathQuery query{.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 4.5}};
  const Path before = world.find_path(query).value();
  for (int i = 1; i < 10; ++i) world.insert_point({50, 60.0 + i}).value();
  world.insert_point({50, 30}).value();
  const Path after = world.find_path(query).value();
  EXPECT_EQ(before.pieces, after.pieces);
  EXPECT_EQ(before.length, after.length);
}

// As the radius grows, lengths never shrink, and the path ends at the radius that widest_path() gives. (A path could
// shrink if the search moved a blocked end.)
TEST(DiscPaths, GrowWithTheRadiusUpToTheWidest) {
  Random random(11);
  for (std::uint64_t i = 0; i < (case_count() + 3) / 4; ++i) {
    const disc::NamedScene scene = disc::random_scene(random, disc::SceneKind::mixture);
    World world = world_with_bridges(scene.domain);
    for (const auto& [a, b] : scene.walls.segments) world.insert_segment(a, b).value();
    const disc::Walls walls = walls_of(scene);
    for (const auto& [start, goal] : scene.queries) {
      SCOPED_TRACE(to_string(start) + " to " + to_string(goal) + " in scene " + std::to_string(i));
      const double widest = world.widest_path(start, goal).value().radius;
      double length = 0.0;
      for (double radius = scene.radii[0] / 8; radius < scene.radii[3]; radius *= 1.25) {
        const Path path =
            world.find_path({.start = start, .goal = goal, .agent = {.radius = radius}, .end_tolerance = 0}).value();
        if (path.status == PathStatus::start_blocked || path.status == PathStatus::goal_blocked) break;
        ASSERT_EQ(path.status == PathStatus::found, radius <= widest) << "radius " << radius;
        if (path.status != PathStatus::found) break;
        ASSERT_GE(path.length, length * (1 - 1e-12)) << "radius " << radius;
        length = path.length;
        const disc::PathReport report = disc::check_path(walls, start, goal, radius, disc::pieces_of(path));
        ASSERT_EQ(report.fault, "") << "radius " << radius;
        ASSERT_NEAR(report.length, length, 1e-9 * length) << "radius " << radius;
        const Path back =
            world.find_path({.start = goal, .goal = start, .agent = {.radius = radius}, .end_tolerance = 0}).value();
        ASSERT_NEAR(back.length, length, 1e-12 * length) << "radius " << radius;
      }
    }
  }
}

// The last digits of these coordinates are worth 2^-33, about a tenth of the radius. Rounding must not make the search
// treat a wall beside its path as an obstacle. When it did, the reverse path was three times as long.
TEST(DiscPaths, AreAsLongInTheOtherDirectionFarFromTheOrigin) {
  World world = World::create({{1000000, -1000000}, {1000037, -999963}}, {.keep_bridges = true}).value();
  const Point hub{1000004.7578321772, -999983.11326095706};
  const Point rim[] = {{1000014.5438500382, -999977.54028188449}, {1000016.0650284011, -999985.2118008571},
                       {1000024.7855980641, -999969.26652659266}, {1000031.982693447, -999987.75430667365},
                       {1000001.9057568077, -999965.53287352377}, {1000010.9893986493, -999982.29252512718},
                       {1000032.8734998998, -999987.57315376482}, {1000031.5259393362, -999974.92124571605},
                       {1000005.8764557497, -999980.8618856041},  {1000026.7730222761, -999999.1721696452}};
  for (const Point& end : rim) world.insert_segment(hub, end).value();
  const Point start{1000004, -999968};
  const Point goal{1000009, -999988};
  for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::tra}) {
    const Path path =
        world.find_path({.start = start, .goal = goal, .agent = {.radius = 1e-9}, .algorithm = algorithm}).value();
    const Path back =
        world.find_path({.start = goal, .goal = start, .agent = {.radius = 1e-9}, .algorithm = algorithm}).value();
    ASSERT_EQ(path.status, PathStatus::found);
    ASSERT_EQ(back.status, PathStatus::found);
    // The shortest path is that of a point, up to arcs of this radius.
    const double length = world.find_path({.start = start, .goal = goal}).value().length;
    EXPECT_NEAR(path.length, length, 1e-7);
    EXPECT_NEAR(back.length, length, 1e-7);
  }
}

}  // namespace
}  // namespace waywright::test

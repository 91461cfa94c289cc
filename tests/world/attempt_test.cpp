#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/path_watch.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

const Shape kWall = Shape::segment({50, 0}, {50, 100});

TEST(Attempt, ReturnsWhatTheQuestionReturns) {
  World world = world_of_hundred();
  const std::vector<Change> changes{Change::insert(kWall)};
  EXPECT_EQ(world.attempt(changes, [](const World& w) { return w.item_count(); }).value(), 1U);
  const Result<Path> path = world.attempt(changes, [](const World& w) {
    return w.find_path({.start = {10, 50}, .goal = {90, 50}});
  });
  EXPECT_EQ(path.value().status, PathStatus::no_path);
  const Result<Location> refused = world.attempt(changes, [](const World& w) { return w.locate({200, 0}); });
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_domain);
  std::size_t calls = 0;
  const Result<void> done = world.attempt(changes, [&](const World&) { ++calls; });
  EXPECT_TRUE(done.ok());
  EXPECT_EQ(calls, 1U);
  EXPECT_EQ(world.item_count(), 0U);
}

TEST(Attempt, AsksNothingIfTheWorldRefusesAChange) {
  World world = world_of_hundred();
  bool is_asked = false;
  const Result<void> done =
      world.attempt({Change::insert(kWall, 3), Change::remove(7)}, [&](const World&) { is_asked = true; });
  EXPECT_EQ(done.error().code, ErrorCode::unknown_id);
  EXPECT_EQ(done.error().index, 1U);
  EXPECT_FALSE(is_asked);
  EXPECT_TRUE(world.insert(kWall).ok()) << "the attempt is over";
}

TEST(Attempt, IsTakenBackIfTheQuestionThrows) {
  World world = world_of_hundred();
  const std::string before = world.dump();
  EXPECT_THROW(static_cast<void>(world.attempt({Change::insert(kWall)},
                                               [](const World&) { throw std::runtime_error("asked too much"); })),
               std::runtime_error);
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.insert(kWall).value(), ItemId{1});
}

// An attempt that changes most of the mesh rebuilds the abstraction, and replaces it again when it is taken back.
TEST(Attempt, TakesBackARebuild) {
  World world = world_of_hundred();
  world.insert(kWall, 1).value();
  world.insert(Shape::rectangle({{10, 10}, {20, 20}}), 2).value();
  std::vector<Change> changes;
  for (int i = 0; i < 400; ++i) {
    const Point at{1.0 + 2.4 * (i % 40), 1.0 + 9.5 * (i / 40)};
    changes.push_back(Change::insert(Shape::rectangle({at, at + Point{1.5, 7}})));
  }
  const std::string fault = world.attempt(changes, [](const World& w) { return w.validate().fault; }).value();
  EXPECT_EQ(fault, "");
  EXPECT_EQ(world.validate().fault, "");
  EXPECT_EQ(world.find_path({.start = {40, 50}, .goal = {60, 50}}).value().status, PathStatus::no_path);
  world.remove(1).value();
  EXPECT_EQ(world.validate().fault, "");
}

TEST(Attempt, LeavesARunningSearchAlone) {
  World world = world_of_hundred();
  for (int i = 0; i < 40; ++i) {
    const double x = 2.0 + 2.4 * i;
    world.insert_segment({x, i % 2 == 0 ? 0.0 : 10.0}, {x, i % 2 == 0 ? 90.0 : 100.0}).value();
  }
  const PathQuery query{.start = {1, 1}, .goal = {99, 99}};
  const Path expected = world.find_path(query).value();
  PathSearch search;
  search.begin(world, query).value();
  std::size_t steps = 0;
  while (!search.step(10).value()) {
    ++steps;
    const Point at{4.0 + static_cast<double>(steps % 90), 50};
    world.attempt({Change::insert(Shape::segment(at, at + Point{3, 1}))}, [](const World&) {}).value();
  }
  EXPECT_GT(steps, 3U);
  EXPECT_EQ(search.restarts(), 0U);
  EXPECT_EQ(search.path().points, expected.points);
}

TEST(Attempt, ForbidsOperationsInTheQuestion) {
  World world = world_of_hundred();
  const std::vector<Change> changes{Change::insert(kWall)};
  const char* const why = "the question of World::attempt\\(\\) must not change or clone the world";
  EXPECT_DEATH(static_cast<void>(world.attempt(changes, [&](const World&) { return world.insert(kWall).ok(); })), why);
  EXPECT_DEATH(static_cast<void>(world.attempt(changes, [&](const World&) { world.keep_history(3); })), why);
  EXPECT_DEATH(static_cast<void>(
                   world.attempt(changes, [&](const World&) { return world.attempt(changes, [](const World&) {}); })),
               why);
  PathSearch search;
  EXPECT_DEATH(static_cast<void>(world.attempt(changes,
                                               [&](const World& w) {
                                                 return search.begin(w, {.start = {1, 1}, .goal = {2, 2}});
                                               })),
               why);
  EXPECT_DEATH(static_cast<void>(world.attempt(changes, [&](const World& w) { const PathWatch watch(w); })), why);
  PathWatch watch(world);
  PathChanges answer;
  EXPECT_DEATH(static_cast<void>(world.attempt(changes, [&](const World& w) { watch.update(w, answer); })), why);
}

TEST(WouldDisconnect, SaysWhetherAWallSeparatesPoints) {
  World world = world_of_hundred();
  const std::vector<Point> ends{{10, 50}, {90, 50}};
  EXPECT_TRUE(world.would_disconnect(kWall, ends).value());
  EXPECT_FALSE(world.would_disconnect(Shape::segment({50, 0}, {50, 99}), ends).value());
  EXPECT_FALSE(world.would_disconnect(Shape::segment({50, 0}, {50, 99}), ends, {.radius = 0.5}).value());
  EXPECT_TRUE(world.would_disconnect(Shape::segment({50, 0}, {50, 99}), ends, {.radius = 0.75}).value());
  EXPECT_FALSE(world.would_disconnect(kWall, {{10, 50}, {20, 50}}).value());
  EXPECT_EQ(world.item_count(), 0U);
}

TEST(WouldDisconnect, SaysWhetherAPolygonBlocksAPoint) {
  World world = world_of_hundred();
  const Shape house = Shape::rectangle({{40, 40}, {60, 60}});
  EXPECT_TRUE(world.would_disconnect(house, {{50, 50}}).value());
  EXPECT_FALSE(world.would_disconnect(house, {{40, 50}}).value()) << "a point on its border is free";
  EXPECT_FALSE(world.would_disconnect(house, {{30, 50}}, {.radius = 10}).value());
  EXPECT_TRUE(world.would_disconnect(house, {{31, 50}}, {.radius = 10}).value());
  world.insert(house).value();
  EXPECT_FALSE(world.would_disconnect(house, {{50, 50}, {10, 10}}).value()) << "the point is blocked already";
}

// A point on a wall belongs to both areas beside it.
TEST(WouldDisconnect, KnowsBothAreasBesideAWall) {
  World world = world_of_hundred();
  world.insert(kWall).value();
  const std::vector<Point> points{{10, 50}, {50, 50}, {90, 50}};
  EXPECT_FALSE(world.would_disconnect(Shape::segment({0, 80}, {50, 80}), points).value());
  EXPECT_TRUE(world.would_disconnect(Shape::segment({70, 0}, {70, 100}), points).value());
  EXPECT_TRUE(world.would_disconnect(Shape::rectangle({{0, 0}, {50, 100}}), points).value());
}

TEST(WouldDisconnect, RefusesWhatItCannotAnswer) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_abstraction = false}).value();
  EXPECT_EQ(world.would_disconnect(kWall, {{10, 50}}).error().code, ErrorCode::not_supported);
  EXPECT_EQ(world.would_disconnect(kWall, {{10, 50}}, {.radius = 1}).error().code, ErrorCode::no_bridges);
  EXPECT_EQ(world.would_disconnect(kWall, {{10, 50}}, {.radius = -1}).error().code, ErrorCode::bad_radius);
  EXPECT_EQ(world.would_disconnect(kWall, {{10, 50}, {200, 50}}).error().index, 1U);
  World other = world_of_hundred();
  EXPECT_EQ(other.would_disconnect(Shape::segment({0, 0}, {200, 0}), {{1, 1}}).error().code, ErrorCode::out_of_domain);
}

/// Returns whether an agent gets from one point to the other or, if both are the same point, whether it can stand
/// there.
bool is_connected(const World& world, const Point& start, const Point& goal, double radius) {
  if (start == goal)
    return world.nearest_fit({.point = start, .agent = {.radius = radius}, .limit = 0.0}).value().is_found;
  const PathQuery query{.start = start, .goal = goal, .agent = {.radius = radius}, .end_tolerance = 0.0};
  return world.find_path(query).value().status == PathStatus::found;
}

/// The answer from path queries for all pairs of points.
bool is_any_pair_lost(const World& before, const World& after, const std::vector<Point>& points, double radius) {
  for (const Point& p : points) {
    for (const Point& q : points) {
      if (is_connected(before, p, q, radius) && !is_connected(after, p, q, radius)) return true;
    }
  }
  return false;
}

TEST(WouldDisconnect, AgreesWithPathsBetweenAllPairs) {
  std::size_t lost = 0;
  std::size_t kept = 0;
  for (std::uint64_t seed = 0; seed < 2 * case_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto coordinate = [&] { return static_cast<double>(random.between(0, 12)); };
    World world = World::create({{0, 0}, {12, 12}}, {.keep_bridges = true}).value();
    const auto shape = [&] {
      const Point at{coordinate(), coordinate()};
      return random.chance(70) ? Shape::segment(at, {coordinate(), coordinate()})
                               : Shape::polygon({at, {coordinate(), coordinate()}, {coordinate(), coordinate()}});
    };
    for (std::size_t i = random.below(7); i > 0; --i) world.insert(shape()).value();
    const Shape change = shape();
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i) points.push_back({coordinate(), coordinate()});
    World after = World::create(world.domain(), {.keep_bridges = true}).value();
    after.insert_all(world.items()).value();
    after.insert(change).value();
    for (const double radius : {0.0, 0.25, 1.0}) {
      const bool expected = is_any_pair_lost(world, after, points, radius);
      ++(expected ? lost : kept);
      ASSERT_EQ(world.would_disconnect(change, points, {.radius = radius}).value(), expected) << "radius " << radius;
    }
  }
  EXPECT_GT(lost, case_count() / 2);
  EXPECT_GT(kept, case_count() / 2);
}

}  // namespace
}  // namespace waywright::test

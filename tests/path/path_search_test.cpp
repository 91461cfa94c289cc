#include "waywright/path_search.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/random.hpp"
#include "support/random_path_cases.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

struct Setting {
  World world;
  std::vector<PathQuery> queries;
};

Setting random_setting(std::uint64_t seed, const WorldOptions& options = {}) {
  const Scene scene = random_scene(Flavour::small, seed, 60);
  Setting setting{World::create(scene.domain, options).value(), {}};
  for (const Item& item : scene.items) EXPECT_TRUE(setting.world.insert(item.shape, item.id).ok());
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    PathQuery query{random_point(Flavour::small, scene.domain, random),
                    random_point(Flavour::small, scene.domain, random)};
    query.algorithm = i % 2 == 0 ? PathAlgorithm::optimal : PathAlgorithm::ta;
    query.budget.expansions = i % 4 == 1 ? PathBudget::kNoLimit : 20U;
    query.wants_channel = true;
    setting.queries.push_back(query);
  }
  return setting;
}

void expect_equal(const Path& path, const Path& other) {
  EXPECT_EQ(path.status, other.status);
  EXPECT_EQ(path.length, other.length);
  EXPECT_EQ(path.lower_bound, other.lower_bound);
  EXPECT_EQ(path.points, other.points);
  EXPECT_EQ(path.channel, other.channel);
}

double turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

TEST(PathSearch, InSlicesAnswersAsInOneGo) {
  const Setting setting = random_setting(11);
  PathSearch search;
  std::size_t slices = 0;
  for (const PathQuery& query : setting.queries) {
    ASSERT_TRUE(search.begin(setting.world, query).ok());
    EXPECT_TRUE(search.is_running());
    while (!search.step(3).value()) {
      ++slices;
      EXPECT_LE(search.path().lower_bound, search.path().length);
    }
    EXPECT_FALSE(search.is_running());
    EXPECT_TRUE(search.step(1).value()) << "done stays done";
    expect_equal(search.path(), setting.world.find_path(query).value());
  }
  EXPECT_GT(slices, 2 * setting.queries.size());
}

// Without components only a search can tell that there is no path, and only a walk can tell what covers an end.
TEST(PathSearch, FindsTheSameInAWorldThatKeepsNoAbstraction) {
  std::map<PathStatus, std::size_t> counts;
  for (std::uint64_t seed = 30; seed < 45; ++seed) {
    const Setting kept = random_setting(seed);
    const Setting bare = random_setting(seed, {.keep_abstraction = false});
    std::vector<Point> goals;
    for (const PathQuery& query : kept.queries) {
      const Path path = bare.world.find_path(query).value();
      const Path other = kept.world.find_path(query).value();
      ASSERT_EQ(path.status, other.status);
      ++counts[path.status];
      goals.push_back(query.goal);
      if (path.status != PathStatus::found) continue;
      EXPECT_NEAR(path.length, other.length, 1e-12 * other.length);
    }
    const ManyGoalsQuery many{.start = kept.queries.front().start, .goals = goals};
    const std::vector<Path> paths = bare.world.find_paths_from(many).value();
    const std::vector<Path> others = kept.world.find_paths_from(many).value();
    ASSERT_EQ(paths.size(), goals.size());
    for (std::size_t i = 0; i < goals.size(); ++i) {
      ASSERT_EQ(paths[i].status, others[i].status);
      if (paths[i].status != PathStatus::found) continue;
      EXPECT_NEAR(paths[i].length, others[i].length, 1e-12 * others[i].length);
    }
  }
  EXPECT_GT(counts[PathStatus::found], 100U);
  EXPECT_GT(counts[PathStatus::no_path], 20U);
}

/// Returns a world of walls with doors at their lower and upper ends in turn.
World world_of_doors() {
  World world = World::create({{0, 0}, {100, 10}}).value();
  for (int i = 1; i < 9; ++i) {
    const double y = i % 2 == 0 ? 0 : 1;
    world.insert_segment({static_cast<double>(i), y}, {static_cast<double>(i), y + 9}).value();
  }
  return world;
}

const PathQuery kThroughTheDoors{{0.5, 5}, {9.5, 5}};

TEST(PathSearch, ContinuesWhenAChangeDoesNotConcernIt) {
  World world = world_of_doors();
  for (double x = 20; x < 90; x += 5) world.insert_segment({x, 2}, {x, 8}).value();
  PathSearch search;
  ASSERT_TRUE(search.begin(world, kThroughTheDoors).ok());
  bool is_done = search.step(1).value();
  EXPECT_FALSE(is_done);
  for (double x = 80; !is_done; x += 0.125) {
    ASSERT_LT(x, 90.0);
    world.insert_polygon(std::vector<Point>{{x, 4}, {x + 2, 4}, {x + 1, 6}}).value();
    is_done = search.step(1).value();
  }
  EXPECT_EQ(search.restarts(), 0U);
  expect_equal(search.path(), world.find_path(kThroughTheDoors).value());
}

TEST(PathSearch, BeginsAgainWhenAChangeConcernsIt) {
  World world = world_of_doors();
  PathSearch search;
  ASSERT_TRUE(search.begin(world, kThroughTheDoors).ok());
  ASSERT_FALSE(search.step(2).value());
  world.insert_segment({0.25, 8}, {0.75, 8}).value();  // beside the start
  ASSERT_FALSE(search.step(1).value());
  EXPECT_EQ(search.restarts(), 1U);
  EXPECT_FALSE(world.remove({77}).ok());
  ASSERT_FALSE(search.step(1).value());
  EXPECT_EQ(search.restarts(), 1U) << "a refused operation changes nothing";
  World moved = std::move(world);
  ASSERT_FALSE(search.step(1).value()) << "a world may move";
  moved.insert_polygon(std::vector<Point>{{9.25, 4.75}, {9.75, 4.75}, {9.75, 5.25}, {9.25, 5.25}}).value();
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.restarts(), 2U);
  EXPECT_EQ(search.path().status, PathStatus::goal_blocked);
  EXPECT_EQ(search.path().blockers, (std::vector<ItemId>{{10}}));
  ASSERT_TRUE(search.begin(moved, kThroughTheDoors).ok());
  EXPECT_EQ(search.restarts(), 0U);
}

// No wall comes near the faces that the search has visited, but now a polygon covers the ends.
TEST(PathSearch, SeesThatAPolygonHasComeToCoverItsEnds) {
  World world = World::create({{-1000, -1000}, {1000, 1000}}).value();
  for (int i = 1; i < 9; ++i) {
    const double y = i % 2 == 0 ? 0 : 1;
    world.insert_segment({static_cast<double>(i), y}, {static_cast<double>(i), y + 9}).value();
  }
  world.insert_polyline(std::vector<Point>{{-5, -5}, {20, -5}, {20, 20}, {-5, 20}, {-5, -5}}).value();
  PathSearch search;
  ASSERT_TRUE(search.begin(world, kThroughTheDoors).ok());
  ASSERT_FALSE(search.step(2).value());
  world.insert_polygon(std::vector<Point>{{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}).value();
  ASSERT_TRUE(search.step(1).value());
  EXPECT_EQ(search.path().status, PathStatus::start_blocked);
}

TEST(PathSearch, OfAStraightPathNoticesAWallInsertedBeforeTheFirstStep) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  PathSearch search;
  ASSERT_TRUE(search.begin(world, {{1, 5}, {9, 5}}).ok());
  world.insert_segment({5, 0}, {5, 9}).value();
  while (!search.step(1).value()) {
  }
  expect_equal(search.path(), world.find_path({{1, 5}, {9, 5}}).value());
  ASSERT_TRUE(search.begin(world, {{1, 5}, {4, 5}}).ok());
  world.insert_all(std::vector<Item>{{{9}, {ItemKind::segment, {{{2, 0}, {2, 9}}}}}}).value();
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.path().points.size(), 3U);
}

// The search has not visited the faces beside the wall between its ends. The change only makes the straight path free.
TEST(PathSearch, NoticesThatTheStraightPathHasBecomeFree) {
  for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::ta, PathAlgorithm::tra}) {
    World world = World::create({{0, 0}, {100, 100}}).value();
    // Small faces: those beside the wall have no vertex in common with those at the ends.
    for (double x = 2; x < 99; x += 3) {
      for (double y = 1.5; y < 99; y += 3) world.insert_point({x, y}).value();
    }
    const ItemId wall = world.insert_segment({60.5, 43}, {60.5, 56}).value();
    const PathQuery query{{1, 50}, {99, 50}, {}, algorithm};
    PathSearch search;
    ASSERT_TRUE(search.begin(world, query).ok());
    world.remove(wall).value();
    while (!search.step(1).value()) {
    }
    EXPECT_EQ(search.restarts(), 1U) << to_string(algorithm);
    expect_equal(search.path(), world.find_path(query).value());
  }
}

// The polygon that moved an end has been removed, so another free point is nearer now.
TEST(PathSearch, NoticesThatAnEndWouldBeMovedElsewhere) {
  World world = World::create({{-100, -100}, {1100, 1100}}, {.keep_abstraction = false}).value();
  const std::vector<std::vector<Point>> ring = {{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}},
                                                {{400, 400}, {600, 400}, {600, 600}, {400, 600}}};
  world.insert_polygon(ring).value();
  const ItemId filling =
      world.insert_polygon(std::vector<Point>{{399, 399}, {601, 399}, {601, 601}, {399, 601}}).value();
  // Small faces: those beside the filling have no vertex in common with those at the border.
  for (double x = 20; x < 1000; x += 20) {
    for (double y = 20; y < 1000; y += 20) {
      if (x < 380 || x > 620 || y < 380 || y > 620) world.insert_point({x, y}).value();
    }
  }
  for (double y = -90; y < 1090; y += 40) world.insert_segment({-50, y}, {-20, y}).value();
  PathQuery query{{300, 500}, {-90, -90}};
  query.end_tolerance = 1e9;
  PathSearch search;
  ASSERT_TRUE(search.begin(world, query).ok());
  world.remove(filling).value();
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.restarts(), 1U);
  EXPECT_EQ(search.path().moved_start, world.find_path(query).value().moved_start);
  EXPECT_EQ(search.path().status, world.find_path(query).value().status);
}

TEST(PathSearch, NoticesThatAnEmptyWorldHasBeenFilled) {
  World filled = World::create({{0, 0}, {10, 10}}).value();
  PathSearch search;
  ASSERT_TRUE(search.begin(filled, {{1, 1}, {9, 1}}).ok());
  filled.insert_all(std::vector<Item>{{{1}, {ItemKind::segment, {{{5, 0}, {5, 9}}}}}}).value();
  while (!search.step(1).value()) {
  }
  EXPECT_EQ(search.restarts(), 1U);
  expect_equal(search.path(), filled.find_path({{1, 1}, {9, 1}}).value());
}

class SlicedSearch : public testing::TestWithParam<std::tuple<bool, PathAlgorithm>> {};

INSTANTIATE_TEST_SUITE_P(Worlds, SlicedSearch,
                         testing::Combine(testing::Bool(), testing::Values(PathAlgorithm::optimal, PathAlgorithm::ta)),
                         [](const auto& setting) {
                           return std::string(std::get<0>(setting.param) ? "WithAbstraction" : "WithoutAbstraction") +
                                  "By" + std::string(to_string(std::get<1>(setting.param)));
                         });

// Whatever changes between the slices, the answer has the same bits as find_path in the world at the last slice.
TEST_P(SlicedSearch, AnswersAsFindPathDoesInTheWorldOfItsLastSlice) {
  const auto [keeps_abstraction, algorithm] = GetParam();
  std::size_t restarts = 0;
  std::size_t undisturbed = 0;
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    const Obstacles obstacles = kObstacles[seed % kObstacles.size()];
    const PathCase path_case = random_path_case(obstacles, seed, 12);
    const PathCase more = random_path_case(obstacles, seed + 1000, 1);
    World world = World::create(path_case.scene.domain, {.keep_abstraction = keeps_abstraction}).value();
    for (const Item& item : path_case.scene.items) world.insert(item.shape, item.id).value();
    Random random(seed);
    PathSearch search;
    for (const Ends& ends : path_case.queries) {
      PathQuery query{ends.start, ends.goal, {}, algorithm};
      query.budget.expansions = random.chance(50) ? PathBudget::kNoLimit : 0;
      query.wants_channel = true;
      ASSERT_TRUE(search.begin(world, query).ok());
      std::size_t changes = 0;
      for (bool is_done = false; !is_done;) {
        is_done = search.step(1 + random.below(6)).value();
        if (is_done || changes == 25) continue;
        ++changes;
        const Item& item = path_case.scene.items[random.below(path_case.scene.items.size())];
        if (world.contains(item.id) && random.chance(60)) {
          world.remove(item.id).value();
        } else if (world.contains(item.id)) {
          const Box& domain = path_case.scene.domain;
          const double x = domain.min.x + static_cast<double>(random.below(15)) / 16 * (domain.max.x - domain.min.x);
          const double y = domain.min.y + static_cast<double>(random.below(15)) / 16 * (domain.max.y - domain.min.y);
          const double side = (domain.max.x - domain.min.x) / 32;
          world.replace(item.id, {ItemKind::polygon, {{{x, y}, {x + side, y}, {x, y + side}}}}).value();
        } else {
          world.insert(item.shape, item.id).value();
        }
      }
      expect_equal(search.path(), world.find_path(query).value());
      EXPECT_EQ(search.path().moved_start, world.find_path(query).value().moved_start);
      restarts += search.restarts();
      undisturbed += changes > 0 && search.restarts() < changes ? 1 : 0;
      if (HasFailure()) FAIL() << "seed " << seed;
    }
  }
  EXPECT_GT(restarts, 50U);
  EXPECT_GT(undisturbed, 50U);
}

TEST(PathSearch, EndsWhenTheWorldGoes) {
  const PathQuery query{{0.5, 5}, {9.5, 5}};
  PathSearch search;
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_segment({5, 0}, {5, 9}).value();
  ASSERT_TRUE(search.begin(world, query).ok());
  world = World::create({{0, 0}, {10, 10}}).value();
  const Result<bool> stepped = search.step(1);
  ASSERT_FALSE(stepped.ok()) << "another world has taken its place";
  EXPECT_EQ(stepped.error().code, ErrorCode::world_gone);
  EXPECT_FALSE(search.is_running());
  {
    World short_lived = World::create({{0, 0}, {10, 10}}).value();
    short_lived.insert_segment({5, 0}, {5, 9}).value();
    ASSERT_TRUE(search.begin(short_lived, query).ok());
  }
  EXPECT_EQ(search.step(1).error().code, ErrorCode::world_gone);
  EXPECT_TRUE(search.step(1).value()) << "nothing is left to do";
}

TEST(PathSearch, RefusesWhatFindPathRefusesAndCanBeGivenUp) {
  const World world = World::create({{0, 0}, {10, 10}}).value();
  PathSearch search;
  EXPECT_EQ(search.begin(world, {{-1, 0}, {1, 1}}).error().code, ErrorCode::out_of_domain);
  EXPECT_FALSE(search.is_running());
  ASSERT_TRUE(search.begin(world, {{1, 1}, {2, 2}}).ok());
  search.cancel();
  EXPECT_FALSE(search.is_running());
}

// The piece of the path that crosses an edge of the channel must meet that edge between its ends.
TEST(PathChannels, AreCrossedByTheirPathInOrder) {
  std::size_t portals = 0;
  for (const std::uint64_t seed : {3U, 4U, 5U, 6U, 7U, 8U}) {
    const Setting setting = random_setting(seed);
    for (const PathQuery& query : setting.queries) {
      const Path path = setting.world.find_path(query).value();
      std::size_t piece = 0;
      for (const Portal& portal : path.channel) {
        const auto meets = [&](std::size_t i) {
          const Point a = path.points[i];
          const Point b = path.points[i + 1];
          const double slack = 1e-9 * (std::abs(b.x - a.x) + std::abs(b.y - a.y)) * 16000;
          return turn(a, b, portal.left) >= -slack && turn(a, b, portal.right) <= slack &&
                 turn(portal.right, portal.left, a) >= -slack && turn(portal.right, portal.left, b) <= slack;
        };
        while (piece + 1 < path.points.size() && !meets(piece)) ++piece;
        ASSERT_LT(piece + 1, path.points.size()) << "portal " << portals;
        ++portals;
      }
    }
  }
  EXPECT_GT(portals, 100U);
}

TEST(ManyPaths, OnManyThreadsAreThoseFoundAlone) {
  const Setting setting = random_setting(12);
  for (const std::size_t threads : {1U, 2U, 7U, 100U}) {
    const std::vector<Path> paths = setting.world.find_paths(setting.queries, threads).value();
    ASSERT_EQ(paths.size(), setting.queries.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
      expect_equal(paths[i], setting.world.find_path(setting.queries[i]).value());
    }
  }
  EXPECT_TRUE(setting.world.find_paths({}, 3).value().empty());
  std::vector<PathQuery> queries = setting.queries;
  queries[5].agent.radius = -1.0;
  const auto refused = setting.world.find_paths(queries, 2);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::bad_radius);
  EXPECT_EQ(refused.error().index, 5U);
}

class FromOneStart : public testing::TestWithParam<std::size_t> {};

// With few goals the library searches for each goal alone, with many it searches for all at once.
INSTANTIATE_TEST_SUITE_P(GoalCounts, FromOneStart, testing::Values(60, 600));

TEST_P(FromOneStart, PathsAreAsLongAsThoseFoundAlone) {
  for (const std::uint64_t seed : {13U, 14U, 15U, 16U}) {
    const Setting setting = random_setting(seed);
    ManyGoalsQuery query;
    query.start = setting.queries[0].start;
    std::vector<Point> goals = {query.start, setting.queries[0].goal, setting.queries[0].goal};
    Random random(seed + 100);
    while (goals.size() < GetParam()) goals.push_back(random_point(Flavour::small, setting.world.domain(), random));
    query.goals = goals;
    query.wants_points = true;
    const std::vector<Path> paths = setting.world.find_paths_from(query).value();
    query.wants_points = false;
    const std::vector<Path> lengths = setting.world.find_paths_from(query).value();
    ASSERT_EQ(paths.size(), goals.size());
    for (std::size_t i = 0; i < goals.size(); ++i) {
      const Path alone = setting.world.find_path({query.start, goals[i]}).value();
      ASSERT_EQ(paths[i].status, alone.status);
      EXPECT_NEAR(paths[i].length, alone.length, 1e-9 * alone.length);
      EXPECT_EQ(lengths[i].length, paths[i].length);
      EXPECT_TRUE(lengths[i].points.empty());
      if (alone.status != PathStatus::found) continue;
      EXPECT_EQ(paths[i].points.front(), query.start);
      EXPECT_EQ(paths[i].points.back(), goals[i]);
    }
  }
}

/// Returns a world of walls that cross, with a point at the rounded position of each crossing.
World world_with_edges_without_length(Random& random) {
  const auto fraction = [&] { return static_cast<double>(random.below(1U << 27)) * 0x1p-27; };
  World world = World::create({{0, 0}, {40, 40}}).value();
  for (int i = 0; i < 60; ++i) {
    const Point at{1 + 28 * fraction(), 1 + 28 * fraction()};
    world.insert_segment(at, {at.x + 1.5 * fraction(), at.y + 1.5 * fraction()}).value();
    world.insert_segment({at.x + 1.5 * fraction(), at.y}, {at.x, at.y + 1.5 * fraction()}).value();
  }
  for (const Point& vertex : world.snapshot().vertices) world.insert_point(vertex).value();
  return world;
}

// An edge between a crossing and a point at its rounded position has two different ends, but no length in doubles.
TEST(ManyPaths, FromOneStartCrossEdgesWithoutLength) {
  Random random(17);
  const auto coordinate = [&] { return static_cast<double>(random.below(1U << 27)) * 0x1p-27 * 30; };
  for (int i = 0; i < 40; ++i) {
    const World world = world_with_edges_without_length(random);
    std::vector<Point> goals;
    while (goals.size() < 400) goals.push_back({coordinate(), coordinate()});
    for (int j = 0; j < 4; ++j) {
      const Point start{coordinate(), coordinate()};
      const std::vector<Path> paths = world.find_paths_from({start, goals}).value();
      for (std::size_t goal = 0; goal < goals.size(); ++goal) {
        const Path alone = world.find_path({start, goals[goal]}).value();
        ASSERT_EQ(paths[goal].status, alone.status);
        EXPECT_NEAR(paths[goal].length, alone.length, 1e-9 * alone.length);
      }
    }
  }
}

TEST(ManyPaths, FromOneStartAreRefusedAsOne) {
  const World world = World::create({{0, 0}, {10, 10}}).value();
  const std::vector<Point> outside = {{1, 1}, {11, 1}};
  const auto refused = world.find_paths_from({{5, 5}, outside});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(refused.error().index, 2U);
}

TEST(TaStar, BettersItsPathUntilItIsTheShortestOrTheBudgetIsSpent) {
  std::size_t bettered = 0;
  std::size_t proven_first = 0;
  for (std::uint64_t seed = 20; seed < 40; ++seed) {
    const Setting setting = random_setting(seed);
    for (PathQuery query : setting.queries) {
      query.algorithm = PathAlgorithm::optimal;
      const Path shortest = setting.world.find_path(query).value();
      query.algorithm = PathAlgorithm::ta;
      query.budget.expansions = 0;
      const Path first = setting.world.find_path(query).value();
      query.budget.expansions = first.expansions + 5;
      const Path second = setting.world.find_path(query).value();
      query.budget.expansions = PathBudget::kNoLimit;
      const Path last = setting.world.find_path(query).value();
      ASSERT_EQ(first.status, shortest.status);
      if (shortest.status != PathStatus::found) continue;
      EXPECT_NEAR(last.length, shortest.length, 1e-9 * shortest.length);
      EXPECT_EQ(last.lower_bound, last.length);
      for (const Path* path : {&first, &second}) {
        EXPECT_LE(path->lower_bound, shortest.length * (1 + 1e-12));
        EXPECT_GE(path->length, shortest.length * (1 - 1e-12));
      }
      EXPECT_LE(second.length, first.length);
      EXPECT_GE(second.lower_bound, first.lower_bound) << "what is proven stays so";
      EXPECT_LE(second.expansions, first.expansions + 40) << "hardly more than the budget";
      if (last.length < first.length) ++bettered;
      if (first.lower_bound == first.length) ++proven_first;
    }
  }
  EXPECT_GT(bettered, 0U);
  EXPECT_GT(proven_first, 0U);
}

}  // namespace
}  // namespace waywright::test

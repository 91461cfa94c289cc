#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "support/job_systems.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

/// A difficult script: inserts the items of a random scene, moves or removes some of them in between, several in one
/// operation, until few are left.
struct Script {
  Box domain;
  std::vector<std::vector<Change>> operations;
};

/// What the items of a script may be.
enum class Items { all, without_loose_corners };

/// Returns whether each ring of the shape has a side.
bool has_walls(const Shape& shape) {
  if (shape.kind == ItemKind::point) return false;
  return std::all_of(shape.rings.begin(), shape.rings.end(), [](const auto& ring) {
    return std::any_of(ring.begin(), ring.end(), [&](const Point& p) { return !(p == ring.front()); });
  });
}

Script random_script(Flavour flavour, std::uint64_t seed, Items items = Items::all) {
  Scene scene = random_scene(flavour, seed, 14);
  if (items == Items::without_loose_corners) {
    std::erase_if(scene.items, [](const Item& item) { return !has_walls(item.shape); });
  }
  Random random(seed);
  Script script{scene.domain, {}};
  std::vector<Item> live;
  for (const Item& item : scene.items) {
    std::vector<Change> changes = {{Change::Kind::insert, item.id, item.shape}};
    live.push_back(item);
    if (live.size() > 3 && random.chance(50)) {
      const std::size_t i = random.below(live.size());
      const std::size_t j = random.below(live.size());
      if (random.chance(50)) {
        changes.push_back({Change::Kind::replace, live[i].id, live[j].shape});
        live[i].shape = live[j].shape;
      } else {
        changes.push_back({Change::Kind::remove, live[i].id, {}});
        live.erase(live.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    script.operations.push_back(changes);
  }
  while (live.size() > 2) {
    const std::size_t i = random.below(live.size());
    script.operations.push_back({{Change::Kind::remove, live[i].id, {}}});
    live.erase(live.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return script;
}

struct Reference {
  std::vector<std::string> dumps;  ///< before the first operation and after each operation
  std::size_t allocations = 0;
};

/// What the test does before each operation.
enum class Before { nothing, shrink_to_fit };

Reference undisturbed(const Script& script, Before before_each, const WorldOptions& options) {
  Reference reference;
  World world = World::create(script.domain, options).value();
  reference.dumps.push_back(world.dump());
  for (const std::vector<Change>& changes : script.operations) {
    if (before_each == Before::shrink_to_fit) world.shrink_to_fit();
    const std::size_t before = allocation_count();
    EXPECT_TRUE(world.apply(changes).ok());
    reference.allocations += allocation_count() - before;
    reference.dumps.push_back(world.dump());
  }
  return reference;
}

/// Applies the operation while the n-th allocation from now on fails. Returns whether the operation succeeded. Reduces
/// n by the number of allocations made, down to 0.
bool apply_with_failure(World& world, const std::vector<Change>& changes, std::size_t& n) {
  const std::size_t before = allocation_count();
  bool is_accepted = false;
  const bool is_through = gets_through(n, [&] { is_accepted = world.apply(changes).ok(); });
  const std::size_t used = allocation_count() - before;
  n = n > used ? n - used : 0;
  return is_through && is_accepted;
}

/// Runs the script once for every n, with the n-th allocation failing. The operation that fails must change nothing.
/// When repeated, that operation and all later ones must have the same results as without a failure.
void expect_nothing_changes_on_failure(const Script& script, Before before_each, const WorldOptions& options = {}) {
  const Reference reference = undisturbed(script, before_each, options);
  ASSERT_GT(reference.allocations, 100U);
  std::size_t failures = 0;
  for (std::size_t n = 1; n <= reference.allocations; ++n) {
    World world = World::create(script.domain, options).value();
    std::size_t left = n;
    for (std::size_t i = 0; i < script.operations.size(); ++i) {
      if (before_each == Before::shrink_to_fit) world.shrink_to_fit();
      if (apply_with_failure(world, script.operations[i], left)) continue;
      ++failures;
      ASSERT_EQ(world.dump(), reference.dumps[i]) << "allocation " << n << ", operation " << i;
      const Validation validation = world.validate();
      ASSERT_TRUE(validation.ok) << validation.fault << " at allocation " << n;
      ASSERT_TRUE(world.apply(script.operations[i]).ok());
      ASSERT_EQ(world.dump(), reference.dumps[i + 1]) << "the second time, after allocation " << n << " failed";
    }
    ASSERT_EQ(world.dump(), reference.dumps.back());
    ASSERT_EQ(world.validate().fault, "");
  }
  // Bridges that are built anew give spare memory back. If there is no memory for a smaller array, this changes
  // nothing.
  const std::size_t tolerated = options.keep_bridges ? script.operations.size() : 0;
  EXPECT_LE(failures, reference.allocations);
  EXPECT_GE(failures + tolerated, reference.allocations);
}

class MemoryFailure : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, MemoryFailure, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

TEST_P(MemoryFailure, AnywhereInAnOperationChangesNothing) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_nothing_changes_on_failure(random_script(GetParam(), seed), Before::nothing);
  }
}

TEST_P(MemoryFailure, AfterShrinkingChangesNothing) {
  expect_nothing_changes_on_failure(random_script(GetParam(), 4), Before::shrink_to_fit);
}

TEST_P(MemoryFailure, WithBridgesChangesNothing) {
  for (const Before before_each : {Before::nothing, Before::shrink_to_fit}) {
    expect_nothing_changes_on_failure(random_script(GetParam(), 5), before_each, {.keep_bridges = true});
    expect_nothing_changes_on_failure(random_script(GetParam(), 6, Items::without_loose_corners), before_each,
                                      {.keep_bridges = true});
  }
}

// A search through the components that failed must not affect a later search with what it wrote to its scratch.
TEST(MemoryFailureOf, SeveralObstaclesLeavesTheComponentsToTheNext) {
  std::vector<Change> obstacles;
  for (int i = 0; i < 16; ++i) {
    const double x = 100.0 + 200.0 * (i % 4);
    const double y = 100.0 + 200.0 * (i / 4);
    obstacles.push_back({Change::Kind::insert, {}, {ItemKind::polygon, {{{x, y}, {x + 9, y + 1}, {x + 3, y + 8}}}}});
  }
  const std::vector<Point> around = {{50.5, 50.5}, {950.5, 60.5}, {940.5, 930.5}, {60.5, 940.5}};
  Random random(7);
  std::vector<Point> points;
  for (int i = 0; i < 600; ++i) {
    const auto x = static_cast<double>(random.between(0, 1000));
    points.push_back({x, static_cast<double>(random.between(0, 1000))});
  }
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = World::create({{0, 0}, {1000, 1000}}).value();
    world.insert_points(points).value();
    std::size_t left = n;
    if (apply_with_failure(world, obstacles, left)) break;
    world.insert_polygon(around).value();
    const Validation validation = world.validate();
    ASSERT_TRUE(validation.ok) << validation.fault << " after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 100U);
}

// Checks state that a dump does not contain: the next id, and whether there are polygons at all.
TEST(MemoryFailureOf, AnInsertionGivesItsIdToTheNext) {
  const std::vector<Change> insertion = {{Change::Kind::insert, {1000}, {ItemKind::point, {{{3, 4}}}}}};
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = World::create({{0, 0}, {10, 10}}).value();
    ASSERT_EQ(world.insert_point({1, 1}).value(), ItemId{1});
    std::size_t left = n;
    if (apply_with_failure(world, insertion, left)) break;
    EXPECT_EQ(world.insert_point({2, 7}).value(), ItemId{2}) << "after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 3U);
}

TEST(MemoryFailureOf, ARemovalLeavesTheOnlyPolygonWhereItWas) {
  const std::vector<Change> removal = {{Change::Kind::remove, {1}, {}}};
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = false}).value();
    world.insert_polygon(std::vector<std::vector<Point>>{{{2, 2}, {6, 2}, {4, 6}}}, {1}).value();
    std::size_t left = n;
    if (apply_with_failure(world, removal, left)) break;
    EXPECT_EQ(world.items_at({4, 3}).value(), std::vector<ItemId>{{1}}) << "after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 0U);
}

/// Returns squares that a scene of 2,000 faces can hold.
std::vector<Item> squares(std::size_t count) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at{10.0 + 20.0 * static_cast<double>(i % 20), 10.0 + 20.0 * static_cast<double>(i / 20)};
    items.push_back({ItemId{i + 1}, Shape::rectangle({at, at + Point{9.0, 8.0}})});
  }
  return items;
}

// An operation that changes most of the mesh rebuilds the bridges and the abstraction.
TEST(MemoryFailureOf, ARebuildLeavesTheBridgesAsTheyWere) {
  const std::vector<Item> items = squares(400);
  for (const bool has_loose_corners : {false, true}) {
    std::size_t failures = 0;
    for (std::size_t n = 1;; n += 1 + n / 40, ++failures) {
      World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
      world.insert_segment({500, 500}, {600, 510}, 1000).value();
      if (has_loose_corners) world.insert_point({700, 700}, 1001).value();
      if (gets_through(n, [&] { world.insert_all(items).value(); })) break;
      ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
      world.insert_segment({100, 500}, {600, 710}, 1002).value();
      ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
    }
    EXPECT_GT(failures, 20U);
  }
}

TEST(MemoryFailureOf, ABulkLoadLeavesTheWorldAndItsBridgesEmpty) {
  std::vector<Item> items = squares(50);
  for (const bool has_loose_corners : {false, true}) {
    if (has_loose_corners) items.push_back({1000, Shape::point({700, 700})});
    std::size_t failures = 0;
    for (std::size_t n = 1;; ++n, ++failures) {
      World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
      if (gets_through(n, [&] { world.insert_all(items).value(); })) break;
      ASSERT_EQ(world.item_count(), 0U) << "after allocation " << n << " failed";
      ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
    }
    EXPECT_GT(failures, 50U);
  }
}

// The first loose corner makes the mesh of the walls. shrink_to_fit() drops it after the last one has gone.
TEST(MemoryFailureOf, TheFirstLooseCornerLeavesTheBridgesAsTheyWere) {
  const std::vector<Item> items = squares(50);
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n) {
    World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
    world.insert_all(items).value();
    const bool is_inserted = gets_through(n, [&] { world.insert_point({500, 500}, 1000).value(); });
    ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
    if (!is_inserted) {
      ++failures;
      continue;
    }
    world.remove(1000).value();
    const bool is_shrunk = gets_through(n, [&] { world.shrink_to_fit(); });
    ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
    world.insert_segment({100, 500}, {600, 710}, 1002).value();
    ASSERT_EQ(world.validate().fault, "") << "after allocation " << n << " failed";
    if (is_shrunk) break;
  }
  EXPECT_GT(failures, 20U);
}

World world_of_triangles() {
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  Random random(11);
  const auto between = [&](int low, int high) { return static_cast<double>(random.between(low, high)); };
  for (int i = 0; i < 300; ++i) {
    const Point at{between(5, 960), between(5, 960)};
    const std::vector<Point> ring = {
        at, {at.x + between(3, 30), at.y + between(0, 3)}, {at.x + between(0, 9), at.y + between(4, 30)}};
    world.insert_polygon(ring).value();
  }
  return world;
}

PathQuery query_by(PathAlgorithm algorithm, const Point& start, const Point& goal) {
  PathQuery query{start, goal, {}, algorithm};
  query.budget.expansions = PathBudget::kNoLimit;
  query.wants_channel = true;
  return query;
}

void expect_equal(const Path& path, const Path& expected, std::size_t n) {
  EXPECT_EQ(path.status, expected.status) << "after allocation " << n << " failed";
  EXPECT_EQ(path.points, expected.points) << "after allocation " << n << " failed";
  EXPECT_EQ(path.channel, expected.channel) << "after allocation " << n << " failed";
  EXPECT_EQ(path.expansions, expected.expansions) << "after allocation " << n << " failed";
}

class MemoryFailureBy : public testing::TestWithParam<PathAlgorithm> {};

INSTANTIATE_TEST_SUITE_P(Algorithms, MemoryFailureBy,
                         testing::Values(PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal),
                         [](const auto& algorithm) { return std::string(to_string(algorithm.param)); });

// The unfinished work of a search that ran out of memory must not affect the next search.
TEST_P(MemoryFailureBy, AQueryLeavesNothingToTheNext) {
  const World world = world_of_triangles();
  const PathQuery across = query_by(GetParam(), {1, 1}, {999, 999});
  const PathQuery back = query_by(GetParam(), {999, 1}, {1, 999});
  const Path expected = world.find_path(back).value();
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    QueryContext context;
    Path path;
    if (gets_through(n, [&] { world.find_path(across, context, path).value(); })) break;
    world.find_path(back, context, path).value();
    expect_equal(path, expected, n);
  }
  EXPECT_GT(failures, 20U);
}

/// Runs a search in slices again and again. In each run another allocation fails, and the search gives up. Passes the
/// path of the next search and the number of the allocation to `expect`. Returns the number of failures.
template <class Expect>
std::size_t count_given_up_searches(const World& world, const PathQuery& query, Expect&& expect) {
  constexpr std::size_t kToTheEnd = std::numeric_limits<std::size_t>::max();
  for (std::size_t n = 1;; ++n) {
    PathSearch search;
    search.begin(world, query).value();
    if (gets_through(n, [&] { search.step(kToTheEnd).value(); })) return n - 1;
    EXPECT_FALSE(search.is_running());
    search.begin(world, query).value();
    EXPECT_TRUE(search.step(kToTheEnd).value());
    expect(search.path(), n);
  }
}

TEST_P(MemoryFailureBy, ASearchInSlicesIsGivenUp) {
  const World world = world_of_triangles();
  const PathQuery across = query_by(GetParam(), {1, 1}, {999, 999});
  const Path expected = world.find_path(across).value();
  const auto expect = [&](const Path& path, std::size_t n) { expect_equal(path, expected, n); };
  EXPECT_GT(count_given_up_searches(world, across, expect), 10U);
}

TEST(MemoryFailureOf, ASearchForManyGoalsLeavesNothingToTheNext) {
  const World world = world_of_triangles();
  Random random(12);
  std::vector<Point> goals;
  while (goals.size() < 300) {
    goals.push_back({static_cast<double>(random.between(1, 999)), static_cast<double>(random.between(1, 999))});
  }
  const ManyGoalsQuery from_one_corner{{1, 1}, goals};
  const ManyGoalsQuery from_another{{999, 1}, goals};
  const std::vector<Path> expected = world.find_paths_from(from_another).value();
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    QueryContext context;
    std::vector<Path> paths;
    if (gets_through(n, [&] { world.find_paths_from(from_one_corner, context, paths).value(); })) break;
    world.find_paths_from(from_another, context, paths).value();
    for (std::size_t i = 0; i < goals.size(); ++i) expect_equal(paths[i], expected[i], n);
  }
  EXPECT_GT(failures, 20U);
}

World world_for_discs() {
  World world = World::create({{0, 0}, {1000, 1000}}, {.keep_bridges = true}).value();
  Random random(13);
  for (int i = 0; i < 60; ++i) {
    const Point at{static_cast<double>(random.between(40, 900)), static_cast<double>(random.between(40, 900))};
    world.insert(Shape::rectangle({at, at + Point{30.0, 25.0}})).value();
  }
  return world;
}

void expect_equal_pieces(const Path& path, const Path& expected, std::size_t n) {
  expect_equal(path, expected, n);
  EXPECT_EQ(path.pieces, expected.pieces) << "after allocation " << n << " failed";
}

TEST(MemoryFailureOf, QueriesForDiscsLeaveNothingToTheNext) {
  const World world = world_for_discs();
  const PathQuery back{.start = {980, 20}, .goal = {20, 980}, .agent = {.radius = 3}};
  const std::vector<Point> goals{{980, 980}, {20, 980}, {5, 5}};
  const std::vector<Path> expected = world.find_paths_from({back.start, goals, 3, true}).value();
  const RayHit expected_hit = world.ray({980, 20}, {20, 980}, {.radius = 3}).value();
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    QueryContext context;
    std::vector<Path> paths;
    RayHit hit;
    const bool is_through = gets_through(n, [&] {
      world.find_paths_from({{20, 20}, goals, 5, true}, context, paths).value();
      world.ray({20, 20}, {980, 980}, {.radius = 2}, context, hit).value();
    });
    if (is_through) break;
    world.ray({980, 20}, {20, 980}, {.radius = 3}, context, hit).value();
    EXPECT_EQ(hit, expected_hit) << "after allocation " << n << " failed";
    world.find_paths_from({back.start, goals, 3, true}, context, paths).value();
    for (std::size_t i = 0; i < goals.size(); ++i) expect_equal_pieces(paths[i], expected[i], n);
  }
  EXPECT_GT(failures, 20U);
}

TEST(MemoryFailureOf, ASearchForADiscInSlicesIsGivenUp) {
  const World world = world_for_discs();
  for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::tra}) {
    SCOPED_TRACE(to_string(algorithm));
    const PathQuery across{.start = {20, 20}, .goal = {980, 980}, .agent = {.radius = 3}, .algorithm = algorithm};
    const Path expected = world.find_path(across).value();
    const auto expect = [&](const Path& path, std::size_t n) { expect_equal_pieces(path, expected, n); };
    EXPECT_GT(count_given_up_searches(world, across, expect), 5U);
  }
}

// If an allocation fails in a job, the call that the job belongs to fails and changes nothing.
TEST(MemoryFailureOf, AJobLeavesTheWorldEmpty) {
  Random random(12);
  std::vector<Point> points;
  while (points.size() < 3000) {
    points.push_back({static_cast<double>(random.below(1U << 20)), static_cast<double>(random.below(1U << 20))});
  }
  OneThread jobs(OneThread::Order::backwards);
  BulkOptions options;
  options.threads = 3;
  options.jobs = &jobs;
  std::size_t failures = 0;
  for (std::size_t n = 1;; ++n, ++failures) {
    World world = World::create({{0, 0}, {1 << 20, 1 << 20}}).value();
    if (gets_through(n, [&] { world.insert_points(points, {}, options).value(); })) break;
    EXPECT_EQ(world.item_count(), 0U) << "after allocation " << n << " failed";
    EXPECT_EQ(world.vertex_count(), 4U) << "after allocation " << n << " failed";
    ASSERT_TRUE(world.validate().ok) << "after allocation " << n << " failed";
  }
  EXPECT_GT(failures, 50U);
}

}  // namespace
}  // namespace waywright::test

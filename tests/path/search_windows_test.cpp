#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "support/random.hpp"

namespace waywright::test {
namespace {

using Windows = std::vector<SearchWindow>;

constexpr std::size_t kInOneGo = std::numeric_limits<std::size_t>::max();
constexpr double kRounding = 1e-9;

/// A world of obstacles that do not meet: one in each square of a grid, up to `squares` squares in a row.
World scattered_world(std::uint64_t seed, int squares, const WorldOptions& options = {}) {
  Random random(seed);
  World world = World::create({{0, 0}, {10.0 * squares, 10.0 * squares}}, options).value();
  const auto within = [&] { return 1.0 + static_cast<double>(random.below(65)) / 8.0; };
  for (int i = 0; i < squares * squares; ++i) {
    const Point square{10.0 * (i % squares), 10.0 * (i / squares)};  // NOLINT(bugprone-integer-division): the row
    const Point a = square + Point{within(), within()};
    const Point b = square + Point{within(), within()};
    if (random.chance(2)) {
      world.insert_segment(a, b).value();
    } else {
      world.insert_polygon({a, b, square + Point{within(), within()}}).value();
    }
  }
  return world;
}

PathQuery random_query(const World& world, Random& random) {
  const auto coordinate = [&] { return world.domain().max.x * static_cast<double>(random.below(1000)) / 999.0; };
  const Point start{coordinate(), coordinate()};
  return {.start = start, .goal = {coordinate(), coordinate()}, .wants_channel = true};
}

/// Runs a search that records its windows.
PathSearch searched(const World& world, const PathQuery& query, std::size_t slice = kInOneGo) {
  PathSearch search;
  search.record_windows(true);
  EXPECT_TRUE(search.begin(world, query).ok());
  while (!search.step(slice).value()) {
  }
  return search;
}

Windows list_of(const PathSearch& search) { return {search.windows().begin(), search.windows().end()}; }

std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> edges_of(const World& world) {
  const MeshSnapshot mesh = world.snapshot();
  std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> edges;
  const auto at = [&](std::uint32_t v) { return std::pair(mesh.vertices[v].x, mesh.vertices[v].y); };
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges.insert({at(p), at(q)});
      edges.insert({at(q), at(p)});
    }
  }
  return edges;
}

/// Where `p` lies between the ends of the portal: 0 at the left end, 1 at the right end.
double share_of(const Portal& portal, const Point& p) {
  const Point along = portal.right - portal.left;
  return dot(p - portal.left, along) / squared_length(along);
}

/// Returns the number of steps, if each sequence of windows on one edge is one step.
std::size_t steps_of(const Windows& windows) {
  std::size_t steps = windows.empty() ? 0 : 1;
  for (std::size_t i = 1; i < windows.size(); ++i) steps += windows[i].edge == windows[i - 1].edge ? 0 : 1;
  return steps;
}

Point middle_of(const Portal& portal) { return lerp(portal.left, portal.right, 0.5); }

/// Returns the length of the shortest path, or infinity.
double shortest(const World& world, const Point& from, const Point& to) {
  const Path path = world.find_path({.start = from, .goal = to}).value();
  return path.status == PathStatus::found ? path.length : std::numeric_limits<double>::infinity();
}

TEST(SearchWindows, LieOnEdgesThatTheRootSees) {
  std::size_t seen = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const World world = scattered_world(seed, 6);
    const auto edges = edges_of(world);
    Random random(seed);
    for (int i = 0; i < 12; ++i) {
      const PathSearch search = searched(world, random_query(world, random));
      for (const SearchWindow& window : search.windows()) {
        const Portal& edge = window.edge;
        ASSERT_TRUE(edges.contains({{edge.left.x, edge.left.y}, {edge.right.x, edge.right.y}}));
        const double left = share_of(edge, window.interval.left);
        const double right = share_of(edge, window.interval.right);
        EXPECT_TRUE(left >= -kRounding && left <= right + kRounding && right <= 1 + kRounding) << left << " " << right;
        for (const Point& end : {window.interval.left, window.interval.right}) {
          EXPECT_NEAR(cross(edge.right - edge.left, end - edge.left), 0.0, 1e-7);
        }
        EXPECT_GE(cross(window.interval.right - window.root, window.interval.left - window.root), -1e-7)
            << "left and right as seen from the root";
        if (right - left < 1e-6) continue;
        ++seen;
        const Point before = lerp(window.root, middle_of(window.interval), 1.0 - 1e-7);
        EXPECT_TRUE(world.is_clear(window.root, before).value()) << to_string(window.root) << to_string(before);
      }
    }
  }
  EXPECT_GT(seen, 1000U);
}

TEST(SearchWindows, HaveOneOrMoreForEachTriangleAndChangeNoAnswer) {
  std::size_t turns = 0;
  std::size_t joined = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const World world = scattered_world(100 + seed, 6, {.keep_abstraction = seed % 2 == 0});
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const PathQuery query = random_query(world, random);
      const Path path = world.find_path(query).value();
      const PathSearch search = searched(world, query);
      EXPECT_EQ(search.path().points, path.points);
      EXPECT_EQ(search.path().channel, path.channel);
      EXPECT_EQ(search.path().expansions, path.expansions);
      EXPECT_EQ(list_of(searched(world, query, 1)), list_of(search)) << "in slices";
      if (path.points.size() > 2) {
        ++turns;
        const Windows windows = list_of(search);
        ASSERT_LE(steps_of(windows), path.expansions);
        ASSERT_GE(windows.size(), path.expansions);
        joined += windows.size() - path.expansions;
        EXPECT_EQ(search.windows().front().root, path.points.front());
        EXPECT_EQ(search.windows().front().length, 0.0);
      }
    }
  }
  EXPECT_GT(turns, 50U);
  EXPECT_GT(joined, 0U);
}

TEST(SearchWindows, BoundTheLengthsOfPathsThroughThem) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const World world = scattered_world(200 + seed, 5);
    Random random(seed);
    for (int i = 0; i < 5; ++i) {
      const PathQuery query = random_query(world, random);
      const PathSearch search = searched(world, query);
      const Point start = search.path().points.empty() ? query.start : search.path().points.front();
      for (const SearchWindow& window : search.windows()) {
        EXPECT_GE(window.length, shortest(world, start, window.root) - kRounding);
        const Point middle = middle_of(window.interval);
        const double there = window.length + length(middle - window.root);
        EXPECT_LE(window.bound, there + shortest(world, middle, query.goal) + 1e-6);
        EXPECT_GE(window.bound, window.length);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500U);
}

/// Returns where the straight line from `p` to `q` crosses the portal, as a share of the portal, or -1.
double crossing_of(const Portal& portal, const Point& p, const Point& q) {
  const double left = cross(q - p, portal.left - p);
  const double right = cross(q - p, portal.right - p);
  const double before = cross(portal.right - portal.left, p - portal.left);
  const double after = cross(portal.right - portal.left, q - portal.left);
  const bool crosses = left > kRounding && right < -kRounding && before * after < 0.0;
  return crosses ? left / (left - right) : -1.0;
}

TEST(SearchWindows, ContainThePath) {
  std::size_t crossed = 0;
  std::size_t after_turns = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const World world = scattered_world(300 + seed, 6);
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const PathSearch search = searched(world, random_query(world, random));
      const Path& path = search.path();
      if (search.windows().empty()) continue;
      for (std::size_t leg = 0; leg + 1 < path.points.size(); ++leg) {
        for (const Portal& portal : path.channel) {
          const double at = crossing_of(portal, path.points[leg], path.points[leg + 1]);
          if (at < 0.0) continue;
          ++crossed;
          if (leg > 0) ++after_turns;
          const bool is_seen =
              std::any_of(search.windows().begin(), search.windows().end(), [&](const SearchWindow& window) {
                return window.root == path.points[leg] && window.edge == portal &&
                       share_of(portal, window.interval.left) <= at + kRounding &&
                       share_of(portal, window.interval.right) >= at - kRounding &&
                       window.bound <= path.length + kRounding;
              });
          EXPECT_TRUE(is_seen) << "leg " << leg << " of " << path.points.size() - 1;
        }
      }
    }
  }
  EXPECT_GT(crossed, 500U);
  EXPECT_GT(after_turns, 100U);
}

TEST(SearchWindows, AreEmptyUnlessTheyAreRecorded) {
  const World world = scattered_world(7, 6, {.keep_bridges = true});
  const PathQuery query{.start = {0.5, 0.5}, .goal = {59.5, 59.5}};
  PathSearch search;
  ASSERT_TRUE(search.begin(world, query).ok());
  search.record_windows(true);  // concerns the next search
  ASSERT_TRUE(search.step(kInOneGo).value());
  EXPECT_GT(search.path().expansions, 0U);
  EXPECT_TRUE(search.windows().empty());
  EXPECT_FALSE(searched(world, query).windows().empty());
  for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra}) {
    PathQuery other = query;
    other.algorithm = algorithm;
    EXPECT_TRUE(searched(world, other).windows().empty());
  }
  PathQuery disc = query;
  disc.agent.radius = 0.25;
  EXPECT_TRUE(searched(world, disc).windows().empty());
  EXPECT_TRUE(searched(world, {.start = {0.5, 0.5}, .goal = {0.5, 0.75}}).windows().empty()) << "nothing between";
}

TEST(SearchWindows, BeginAgainWithTheSearch) {
  World world = scattered_world(8, 6);
  const PathQuery query{.start = {0.5, 0.5}, .goal = {59.5, 59.5}};
  PathSearch search;
  search.record_windows(true);
  ASSERT_TRUE(search.begin(world, query).ok());
  ASSERT_FALSE(search.step(20).value());
  EXPECT_GE(search.windows().size(), search.path().expansions);
  world.insert_segment({0.25, 0.75}, {0.75, 0.75}).value();  // beside the start
  while (!search.step(20).value()) EXPECT_GE(search.windows().size(), search.path().expansions);
  EXPECT_EQ(search.restarts(), 1U);
  const Windows windows = list_of(search);
  EXPECT_EQ(windows, list_of(searched(world, query)));
  world.remove({1}).value();
  EXPECT_EQ(list_of(search), windows) << "a change after the search does not matter";
}

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

namespace waywright::test {
namespace {

constexpr Box kDomain = {{-1000, -1000}, {1000, 1000}};

/// The length of the convex hull's border from the first to the last point in (x, y) order, above the points or below.
double hull_length(std::vector<Point> points, bool is_above) {
  std::sort(points.begin(), points.end(),
            [](const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  std::vector<Point> hull;
  for (const Point& p : points) {
    const auto turns_wrong = [&] {
      const double turn = cross(hull.back() - hull[hull.size() - 2], p - hull.back());
      return is_above ? turn >= 0.0 : turn <= 0.0;
    };
    while (hull.size() >= 2 && turns_wrong()) hull.pop_back();
    hull.push_back(p);
  }
  double length = 0.0;
  for (std::size_t i = 1; i < hull.size(); ++i) length += distance(hull[i - 1], hull[i]);
  return length;
}

/// The shortest path round a convex polygon runs along the convex hull of the polygon, the start and the goal.
double length_round(const Shape& polygon, const Point& start, const Point& goal) {
  std::vector<Point> points(polygon.rings.points().begin(), polygon.rings.points().end());
  points.push_back(start);
  points.push_back(goal);
  return std::min(hull_length(points, true), hull_length(points, false));
}

class RoundPolygon : public testing::TestWithParam<std::size_t> {
 protected:
  RoundPolygon() { static_cast<void>(world_.insert(polygon_).value()); }

  Shape polygon_ = Shape::regular_polygon({0, 0}, 500, GetParam());
  World world_ = World::create(kDomain).value();
};

INSTANTIATE_TEST_SUITE_P(Corners, RoundPolygon, testing::Values(500, 4000));

// One window for each pair of a corner and a face behind the polygon would be an eighth of the square of the corners.
TEST_P(RoundPolygon, TakesStepsInProportionToItsCorners) {
  for (const double y : {1.0, -30.0, 0.0}) {
    const Path path = world_.find_path({.start = {-900, y}, .goal = {900, y}}).value();
    EXPECT_NEAR(path.length, length_round(polygon_, {-900, y}, {900, y}), 1e-9);
    EXPECT_LE(path.expansions, 10 * GetParam()) << y;
  }
}

TEST_P(RoundPolygon, TakesStepsInProportionToItsCornersToSeveralGoals) {
  const std::vector<PathQuery> queries = {{.start = {-900, 1}, .goal = {900, 1}},
                                          {.start = {-900, 1}, .goal = {500, 600}},
                                          {.start = {-900, 1}, .goal = {510, -20}}};
  std::vector<Point> goals;
  for (const PathQuery& query : queries) goals.push_back(query.goal);
  const std::vector<Path> paths = world_.find_paths_from({.start = {-900, 1}, .goals = goals}).value();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_NEAR(paths[i].length, length_round(polygon_, queries[i].start, queries[i].goal), 1e-9);
    EXPECT_LE(paths[i].expansions, 20 * GetParam());
  }
}

// A window of each corner, in the order in which a point on the edge sees the corners.
TEST_P(RoundPolygon, ShowsTheWindowsOfAllCorners) {
  PathSearch search;
  search.record_windows(true);
  ASSERT_TRUE(search.begin(world_, {.start = {-900, 1}, .goal = {900, 1}}).ok());
  while (!search.step(1000).value()) {
  }
  for (const SearchWindow& window : search.windows()) {
    const Point along = window.edge.right - window.edge.left;
    for (const Point& end : {window.interval.left, window.interval.right}) {
      EXPECT_LE(std::abs(cross(along, end - window.edge.left)), 1e-9 * squared_length(along));
    }
    EXPECT_LE(cross(window.interval.left - window.root, window.interval.right - window.root), 1e-6);
  }
  EXPECT_GE(search.windows().size(), GetParam() / 2);
}

}  // namespace
}  // namespace waywright::test

#include "locate/sectors.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using locate::Sectors;
using mesh::kNoVertex;
using mesh::Vertex;

constexpr Box kUnit{{0, 0}, {1, 1}};

TEST(Sectors, RememberTheLastVertexUntilItGoes) {
  Sectors sectors(kUnit);
  EXPECT_EQ(sectors.near({0.1, 0.1}), kNoVertex);
  sectors.remember({0.1, 0.1}, Vertex{1}, 5);
  sectors.remember({0.9, 0.9}, Vertex{2}, 6);
  sectors.remember({0.2, 0.2}, Vertex{3}, 7);
  EXPECT_EQ(sectors.near({0.1, 0.1}), Vertex{3});
  EXPECT_EQ(sectors.near({0.6, 0.6}), Vertex{2});
  EXPECT_EQ(sectors.near({0.6, 0.1}), kNoVertex);
  sectors.forget({0.1, 0.1}, Vertex{1}, Vertex{9});
  EXPECT_EQ(sectors.near({0.1, 0.1}), Vertex{3}) << "vertex 1 wasn't remembered";
  sectors.forget({0.2, 0.2}, Vertex{3}, Vertex{9});
  EXPECT_EQ(sectors.near({0.1, 0.1}), Vertex{9});
}

TEST(Sectors, QuartersRememberWhatTheirSectorDid) {
  Sectors sectors(kUnit);
  sectors.remember({0.1, 0.1}, Vertex{1}, 5);
  EXPECT_TRUE(sectors.are_in_one({0.1, 0.1}, {0.4, 0.4}));
  EXPECT_FALSE(sectors.are_in_one({0.1, 0.1}, {0.6, 0.1}));
  sectors.divide({0.1, 0.1}, 5);
  EXPECT_FALSE(sectors.are_in_one({0.1, 0.1}, {0.4, 0.4}));
  EXPECT_EQ(sectors.near({0.4, 0.4}), Vertex{1});
  sectors.remember({0.4, 0.4}, Vertex{2}, 6);
  EXPECT_EQ(sectors.near({0.1, 0.1}), Vertex{1});
  EXPECT_EQ(sectors.near({0.4, 0.4}), Vertex{2});
  EXPECT_EQ(sectors.near({0.3, 0.1}), Vertex{1});
}

// Sectors at several depths, then ever more vertices: what was remembered at a place still is.
TEST(Sectors, GrowingLosesNothing) {
  Sectors sectors(kUnit);
  const Point crowd{0.01, 0.02};
  for (int i = 0; i < 6; ++i) sectors.divide(crowd, 1000);
  sectors.remember(crowd, Vertex{1}, 5);
  sectors.remember({0.3, 0.3}, Vertex{2}, 5);
  sectors.remember({0.99, 0.5}, Vertex{3}, 5);
  for (std::size_t count = 17; count < 100000; count *= 4) {
    sectors.remember({0.5, 0.99}, Vertex{4}, count);
    ASSERT_EQ(sectors.near(crowd), Vertex{1}) << count;
    ASSERT_EQ(sectors.near({0.3, 0.3}), Vertex{2}) << count;
    ASSERT_EQ(sectors.near({0.99, 0.5}), Vertex{3}) << count;
    ASSERT_EQ(sectors.near({0.5, 0.99}), Vertex{4}) << count;
  }
  EXPECT_FALSE(sectors.are_in_one({0.3, 0.3}, {0.31, 0.3}));
}

// A place that is divided over and over while there are few vertices: in the end its sectors are whole again.
TEST(Sectors, NeverGrowFarBeyondTheVertices) {
  Sectors sectors(kUnit);
  Random random(9);
  bool was_whole_again = false;
  for (int i = 0; i < 200; ++i) {
    const Point place{static_cast<double>(random.below(1024)) / 1024, static_cast<double>(random.below(1024)) / 1024};
    sectors.divide(place, 10);
    sectors.remember(place, Vertex{7}, 10);
    ASSERT_EQ(sectors.near(place), Vertex{7});
    was_whole_again = was_whole_again || (i > 20 && sectors.are_in_one({0.01, 0.01}, {0.49, 0.49}));
  }
  EXPECT_TRUE(was_whole_again);
}

// Down to single points, where nothing is left to divide.
TEST(Sectors, DividesNoPoint) {
  Sectors sectors(kUnit);
  for (int i = 0; i < 100; ++i) sectors.divide({0.3, 0.3}, 1000);
  sectors.remember({0.3, 0.3}, Vertex{1}, 5);
  EXPECT_EQ(sectors.near({0.3, 0.3}), Vertex{1});
  EXPECT_TRUE(sectors.are_in_one({0.3, 0.3}, {0.3, 0.3}));
}

using Triangulation = delaunay::Triangulation<exact::Geometry>;

/// A crowd of 3 in 4 points in a thousandth of the box, the rest anywhere.
std::vector<Point> uneven_points(std::size_t count) {
  Random random(21);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double scale = random.chance(75) ? 1.0 / 32 : 1.0;
    const auto fraction = [&] { return static_cast<double>(random.below(1 << 30)) * 0x1p-30; };
    points.push_back({fraction() * scale, fraction() * scale});
  }
  return points;
}

double mean_steps(const Triangulation& triangulation, const std::vector<Point>& targets) {
  double steps = 0;
  for (const Point& target : targets) steps += static_cast<double>(triangulation.locate(target).steps);
  return steps / static_cast<double>(targets.size());
}

// However many vertices and wherever they are, and whether they came at once or not.
TEST(Sectors, WalksAreShortInTheCrowdAndOutside) {
  for (const std::size_t count : {2000U, 20000U}) {
    const std::vector<Point> points = uneven_points(count);
    const std::array<Point, 4> corners = Triangulation::corners_of(kUnit);
    std::vector<Point> all(corners.begin(), corners.end());
    all.insert(all.end(), points.begin(), points.end());
    const Triangulation at_once(kUnit, {1, 2, 3, 4}, locate::sort_along_curve(kUnit, all));
    EXPECT_LT(mean_steps(at_once, points), 8.0);
    Triangulation one_by_one(kUnit, {1, 2, 3, 4});
    for (const Point& point : points) one_by_one.insert(point);
    EXPECT_LT(mean_steps(one_by_one, points), 12.0);
  }
}

}  // namespace
}  // namespace waywright::test

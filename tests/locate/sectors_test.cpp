#include "locate/sectors.hpp"

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "locate/curve.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using locate::Sectors;
using mesh::kNoVertex;
using mesh::Vertex;

constexpr Box kUnit{{0, 0}, {1, 1}};

Vertex near(const Sectors& sectors, const Point& point) { return sectors.near(sectors.at(point)); }

std::vector<std::uint32_t> around(const Sectors& sectors, const Point& point) {
  std::vector<std::uint32_t> result;
  sectors.for_each_around(sectors.at(point), [&](Vertex v) { result.push_back(number(v)); });
  return result;
}

TEST(Sectors, RememberTheLastVertexUntilItGoes) {
  Sectors sectors(kUnit);
  EXPECT_EQ(near(sectors, {0.1, 0.1}), kNoVertex);
  sectors.remember({0.1, 0.1}, Vertex{1}, 5);
  sectors.remember({0.9, 0.9}, Vertex{2}, 6);
  sectors.remember({0.2, 0.2}, Vertex{3}, 7);
  EXPECT_EQ(near(sectors, {0.1, 0.1}), Vertex{3});
  EXPECT_EQ(near(sectors, {0.6, 0.6}), Vertex{2});
  EXPECT_EQ(near(sectors, {0.6, 0.1}), kNoVertex);
  sectors.replace({0.1, 0.1}, Vertex{1}, Vertex{9});
  EXPECT_EQ(near(sectors, {0.1, 0.1}), Vertex{3}) << "vertex 1 wasn't remembered";
  sectors.replace({0.2, 0.2}, Vertex{3}, Vertex{9});
  EXPECT_EQ(near(sectors, {0.1, 0.1}), Vertex{9});
}

TEST(Sectors, QuartersRememberWhatTheirSectorDid) {
  Sectors sectors(kUnit);
  sectors.remember({0.1, 0.1}, Vertex{1}, 5);
  EXPECT_TRUE(sectors.are_in_one({0.1, 0.1}, {0.4, 0.4}));
  EXPECT_FALSE(sectors.are_in_one({0.1, 0.1}, {0.6, 0.1}));
  sectors.divide({0.1, 0.1}, 5);
  EXPECT_FALSE(sectors.are_in_one({0.1, 0.1}, {0.4, 0.4}));
  EXPECT_EQ(near(sectors, {0.4, 0.4}), Vertex{1});
  sectors.remember({0.4, 0.4}, Vertex{2}, 6);
  EXPECT_EQ(near(sectors, {0.1, 0.1}), Vertex{1});
  EXPECT_EQ(near(sectors, {0.4, 0.4}), Vertex{2});
  EXPECT_EQ(near(sectors, {0.3, 0.1}), Vertex{1});
}

// All points lie in one square of the curve of the domain, or in a few squares beside each other.
TEST(Sectors, FillingDividesACrowdedCell) {
  const Box domain{{-1e15, -1e15}, {1e15, 1e15}};
  for (const double width : {1e3, 1e-12}) {
    Random random(1);
    std::vector<Point> points;
    for (int i = 0; i < 2000; ++i) {
      const double x = 5.0 + width * static_cast<double>(random.below(1U << 20U)) * 0x1p-20;
      points.push_back({x, width * static_cast<double>(random.below(1U << 20U)) * 0x1p-20});
    }
    const locate::SortedPoints sorted = locate::sort_along_curve(domain, points);
    Sectors sectors(domain);
    sectors.fill(sorted.points, sorted.keys, 1);
    std::set<std::uint32_t> remembered;
    for (const Point& point : sorted.points) {
      const Vertex v = near(sectors, point);
      ASSERT_NE(v, kNoVertex);
      EXPECT_TRUE(sectors.are_in_one(point, sorted.points[number(v) - 1]));
      remembered.insert(number(v));
    }
    EXPECT_GE(remembered.size(), sorted.points.size() / 8) << width;
  }
}

// Divides sectors to several depths, then increases the number of vertices. Each sector must still remember its vertex.
TEST(Sectors, GrowingLosesNothing) {
  Sectors sectors(kUnit);
  const Point crowd{0.01, 0.02};
  for (int i = 0; i < 6; ++i) sectors.divide(crowd, 1000);
  sectors.remember(crowd, Vertex{1}, 5);
  sectors.remember({0.3, 0.3}, Vertex{2}, 5);
  sectors.remember({0.99, 0.5}, Vertex{3}, 5);
  for (std::size_t count = 17; count < 100000; count *= 4) {
    sectors.remember({0.5, 0.99}, Vertex{4}, count);
    ASSERT_EQ(near(sectors, crowd), Vertex{1}) << count;
    ASSERT_EQ(near(sectors, {0.3, 0.3}), Vertex{2}) << count;
    ASSERT_EQ(near(sectors, {0.99, 0.5}), Vertex{3}) << count;
    ASSERT_EQ(near(sectors, {0.5, 0.99}), Vertex{4}) << count;
  }
  EXPECT_FALSE(sectors.are_in_one({0.3, 0.3}, {0.31, 0.3}));
}

// Divides sectors again and again while there are few vertices. In the end the sectors are undivided again.
TEST(Sectors, NeverGrowFarBeyondTheVertices) {
  Sectors sectors(kUnit);
  Random random(9);
  bool was_whole_again = false;
  for (int i = 0; i < 200; ++i) {
    const Point point{static_cast<double>(random.below(1024)) / 1024, static_cast<double>(random.below(1024)) / 1024};
    sectors.divide(point, 10);
    sectors.remember(point, Vertex{7}, 10);
    ASSERT_EQ(near(sectors, point), Vertex{7});
    was_whole_again = was_whole_again || (i > 20 && sectors.are_in_one({0.01, 0.01}, {0.49, 0.49}));
  }
  EXPECT_TRUE(was_whole_again);
}

// Divides until a sector holds a single point and cannot be divided further.
TEST(Sectors, DividesNoPoint) {
  Sectors sectors(kUnit);
  for (int i = 0; i < 100; ++i) sectors.divide({0.3, 0.3}, 1000);
  sectors.remember({0.3, 0.3}, Vertex{1}, 5);
  EXPECT_EQ(near(sectors, {0.3, 0.3}), Vertex{1});
  EXPECT_TRUE(sectors.are_in_one({0.3, 0.3}, {0.3, 0.3}));
}

using Triangulation = delaunay::Triangulation;

/// Returns points of which 3 in 4 are crowded in a thousandth of the box and the rest lie anywhere.
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

// 8 x 8 sectors, each an eighth wide. The blocks are the quarters of the square. One of the sectors is divided once.
TEST(Sectors, OnesAroundKnowWhatIsNear) {
  Sectors sectors(kUnit);
  sectors.remember({0.9, 0.9}, Vertex{1}, 13);
  sectors.remember({0.9, 0.9}, Vertex{1}, 49);
  EXPECT_EQ(around(sectors, {0.1, 0.1}), (std::vector<std::uint32_t>{}));
  sectors.remember({0.01, 0.01}, Vertex{2}, 49);
  sectors.remember({0.49, 0.3}, Vertex{3}, 49);
  sectors.remember({0.51, 0.3}, Vertex{4}, 49);
  EXPECT_EQ(around(sectors, {0.2, 0.2}), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(around(sectors, {0.6, 0.4}), (std::vector<std::uint32_t>{4}));
  sectors.divide({0.01, 0.01}, 49);
  sectors.remember({0.12, 0.12}, Vertex{5}, 49);
  EXPECT_EQ(around(sectors, {0.01, 0.01}), (std::vector<std::uint32_t>{2, 2, 2, 5}));
  EXPECT_EQ(around(sectors, {0.2, 0.2}), (std::vector<std::uint32_t>{2, 3}));
  const Sectors::Sector whole = sectors.at({0.2, 0.2});
  EXPECT_FALSE(sectors.is_far(whole, 0.37 * 0.37));
  EXPECT_TRUE(sectors.is_far(whole, 0.38 * 0.38));
  const Sectors::Sector quarter = sectors.at({0.01, 0.01});
  EXPECT_FALSE(sectors.is_far(quarter, 0.18 * 0.18));
  EXPECT_TRUE(sectors.is_far(quarter, 0.19 * 0.19));
}

// For several numbers and distributions of vertices, inserted in one operation or one by one.
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

// Inserts and removes crowds of vertices, and reuses the slots of vertices. So the vertex that a sector remembers may
// be anywhere.
TEST(Sectors, WalksStayShortWhenCrowdsMove) {
  Triangulation triangulation(kUnit, {1, 2, 3, 4});
  Random random(8);
  const auto fraction = [&] { return static_cast<double>(random.below(1 << 30)) * 0x1p-30; };
  std::vector<std::array<Vertex, 6>> crowds;
  const auto add_crowd = [&] {
    const Point centre{0.02 + 0.96 * fraction(), 0.02 + 0.96 * fraction()};
    for (Vertex& v : crowds.emplace_back()) {
      v = triangulation.insert({centre.x + 0.01 * fraction(), centre.y + 0.01 * fraction()}).vertex;
    }
  };
  while (crowds.size() < 500) add_crowd();
  for (int i = 0; i < 5000; ++i) {
    std::swap(crowds[random.below(500)], crowds.back());
    for (const Vertex v : crowds.back()) triangulation.remove_vertex(triangulation.star(v));
    crowds.pop_back();
    add_crowd();
  }
  std::vector<Point> targets;
  while (targets.size() < 1000) targets.push_back({fraction(), fraction()});
  EXPECT_LT(mean_steps(triangulation, targets), 6.0);
}

}  // namespace
}  // namespace waywright::test

#include "delaunay/divide_and_conquer.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using mesh::HalfEdge;

constexpr std::array<mesh::Label, 4> kSides = {1, 2, 3, 4};

Triangulation made_at_once(const Box& box, const std::vector<Point>& points) {
  const std::array<Point, 4> corners = Triangulation::corners_of(box);
  std::vector<Point> all(corners.begin(), corners.end());
  all.insert(all.end(), points.begin(), points.end());
  return Triangulation(box, kSides, locate::sort_along_curve(box, all));
}

Triangulation made_one_by_one(const Box& box, const std::vector<Point>& points) {
  Triangulation triangulation(box, kSides);
  for (const Point& point : points) triangulation.insert(point);
  return triangulation;
}

using Coordinates = std::pair<double, double>;
using Edge = std::pair<Coordinates, Coordinates>;

/// Returns the half-edges by the positions of their ends, with their labels. Two meshes with equal sets are equal.
std::set<std::pair<Edge, mesh::Label>> edges_of(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::set<std::pair<Edge, mesh::Label>> edges;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (triangulation.is_ghost_face(h)) continue;
    const auto coordinates = [&](mesh::Vertex v) {
      const Point& point = triangulation.geometry().rounded(number(v));
      return Coordinates{point.x, point.y};
    };
    edges.insert({{coordinates(mesh.origin(h)), coordinates(mesh.target(h))}, mesh.label(h)});
  }
  return edges;
}

void expect_same(const Box& box, const std::vector<Point>& points) {
  const Triangulation at_once = made_at_once(box, points);
  ASSERT_EQ(at_once.topology().find_fault(), std::nullopt);
  ASSERT_EQ(edges_of(at_once), edges_of(made_one_by_one(box, points)));
}

/// Returns a point in the box [0, 1] x [0, 1]; `kind` selects the distribution.
Point random_point(std::size_t kind, Random& random) {
  const auto fraction = [&](std::size_t steps) {
    return static_cast<double>(random.below(steps + 1)) / static_cast<double>(steps);
  };
  switch (kind) {
    case 0:
      return {fraction(std::size_t{1} << 40), fraction(std::size_t{1} << 40)};
    case 1:  // a lattice: many points on one line or on one circle
      return {fraction(8), fraction(8)};
    case 2:  // in columns
      return {fraction(3), fraction(1000)};
    case 3:  // in rows
      return {fraction(1000), fraction(3)};
    case 4:  // on the boundary of the box
      return random.chance(50) ? Point{fraction(1), fraction(50)} : Point{fraction(50), fraction(1)};
    case 5: {  // on a line
      const double t = fraction(64);
      return {t, 1.0 - t};
    }
    case 6:  // in one cell of the curve
      return {0.25 + fraction(8) * 0x1p-40, 0.75 + fraction(8) * 0x1p-40};
    case 7:  // in one of few cells
      return {0.25 + fraction(64) * 0x1p-34, 0.75 + fraction(64) * 0x1p-34};
    default: {  // most in one corner, a few elsewhere
      const double scale = random.chance(80) ? 0x1p-12 : 1.0;
      return {fraction(1000) * scale, fraction(1000) * scale};
    }
  }
}

TEST(DivideAndConquer, MakesTheMeshThatInsertionMakes) {
  Random random(11);
  for (std::size_t kind = 0; kind < 9; ++kind) {
    for (std::size_t round = 0; round < 60; ++round) {
      std::vector<Point> points;
      const std::size_t count = round < 20 ? round : random.below(120);
      for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(kind, random));
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", round " << round);
      expect_same({{0, 0}, {1, 1}}, points);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(DivideAndConquer, TakesBoxesOfAnyForm) {
  Random random(12);
  for (const Point& far : {Point{1000, 1}, Point{1, 1000}, Point{0x1p60, 0x1p-60}}) {
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) {
      points.push_back(
          {far.x * static_cast<double>(random.below(101)) / 128, far.y * static_cast<double>(random.below(9)) / 8});
    }
    expect_same({{0, 0}, far}, points);
  }
}

// Two vertices and the ghost vertex form a sphere of two faces; each further vertex adds two faces.
TEST(DivideAndConquer, NumbersFacesAsVertices) {
  const Triangulation triangulation = made_at_once({{0, 0}, {8, 8}}, {{3, 4}, {5, 1}, {6, 6}});
  EXPECT_EQ(triangulation.topology().vertex_slots(), 8U);
  EXPECT_EQ(triangulation.topology().face_slots(), 2 * 7U - 2);
  EXPECT_EQ(triangulation.topology().face_count(), 2 * 7U - 2);
}

}  // namespace
}  // namespace waywright::test

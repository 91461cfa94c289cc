#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/face_corners.hpp"
#include "delaunay/polygon_triangles.hpp"
#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "exact/predicates.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using Triangle = mesh::TriangleMesh::Triangle;
using mesh::HalfEdge;
using mesh::Vertex;

constexpr std::array<mesh::Label, 4> kBorderLabels = {1, 2, 3, 4};
constexpr mesh::Label kSegmentLabel = 5;
const Box kSegmentDomain{{-256, -256}, {256, 256}};
struct Segment {
  Point start;
  Point end;
};
constexpr Segment kSegment{{-100, 0}, {100, 0}};

/// The edges that the segment from `u` to `w` crosses, as force_edge() takes them. Empty if u - w is an edge.
std::vector<HalfEdge> edges_across(const Triangulation& triangulation, Vertex u, Vertex w) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::vector<HalfEdge> crossed;
  if (mesh.find(u, w) != mesh::kNoHalfEdge) return crossed;
  HalfEdge h = mesh.outgoing(u);
  while (triangulation.orientation(u, w, mesh.target(h)) != exact::Sign::negative ||
         triangulation.orientation(u, w, mesh.apex(h)) != exact::Sign::positive) {
    h = mesh.next_around(h);
  }
  for (h = next(h);;) {
    crossed.push_back(h);
    const HalfEdge t = mesh.twin(h);
    if (mesh.apex(t) == w) return crossed;
    h = triangulation.orientation(u, w, mesh.apex(t)) == exact::Sign::positive ? next(t) : previous(t);
  }
}

/// The vertices of the polygon left of the segment, counter-clockwise, so that the last is the start of the segment.
/// `crossed` lists the edges across the segment.
std::vector<Vertex> polygon_left(const Triangulation& triangulation, const std::vector<HalfEdge>& crossed, Vertex u,
                                 Vertex w) {
  std::vector<Vertex> polygon = {u};
  for (const HalfEdge h : crossed) {
    const Vertex v = triangulation.topology().target(h);
    if (polygon.back() != v) polygon.push_back(v);
  }
  polygon.push_back(w);
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// The faces of a triangulation that has the segment from the start, before it has the points.
std::set<FaceCorners> faces_beside_wall(const Segment& segment, std::span<const Point> points) {
  Triangulation triangulation(kSegmentDomain, kBorderLabels);
  const Vertex u = triangulation.insert(segment.start).vertex;
  const Vertex w = triangulation.insert(segment.end).vertex;
  const std::vector<HalfEdge> crossed = edges_across(triangulation, u, w);
  if (crossed.empty()) {
    triangulation.fix(triangulation.topology().find(u, w), kSegmentLabel);
  } else {
    triangulation.force_edge(u, w, crossed, kSegmentLabel);
  }
  for (const Point& p : points) static_cast<void>(triangulation.insert(p));
  return faces_of(triangulation);
}

/// A number between 0 and 1.
double unit(Random& random) { return static_cast<double>(random.between(0, 1 << 30)) * 0x1p-30; }

/// What check_polygons() has met.
struct Met {
  std::size_t polygons = 0;
  std::size_t dangling = 0;  ///< polygons in which a vertex occurs more than once
  std::size_t refused = 0;   ///< polygons that SegmentCavity did not triangulate
};

/// The polygons on both sides of the segment must get the faces of a triangulation that has the segment first.
void check_polygons(const Segment& segment, const std::vector<Point>& points, Met& met) {
  Triangulation triangulation(kSegmentDomain, kBorderLabels);
  const Vertex start = triangulation.insert(segment.start).vertex;
  const Vertex end = triangulation.insert(segment.end).vertex;
  for (const Point& p : points) static_cast<void>(triangulation.insert(p));
  const auto expected = faces_beside_wall(segment, points);
  for (const auto& [u, w] : {std::pair{start, end}, std::pair{end, start}}) {
    const std::vector<HalfEdge> crossed = edges_across(triangulation, u, w);
    if (crossed.empty()) return;
    const std::vector<Vertex> polygon = polygon_left(triangulation, crossed, u, w);
    const auto rounded = [&](std::uint32_t i) { return triangulation.geometry().rounded(number(polygon[i])); };
    delaunay::SegmentCavity cavity;
    cavity.clear();
    for (std::uint32_t i = 0; i < polygon.size(); ++i) cavity.add(triangulation.view(polygon[i]), rounded(i));
    ++met.polygons;
    met.dangling += std::set(polygon.begin(), polygon.end()).size() < polygon.size() ? 1 : 0;
    std::vector<Triangle> triangles;
    if (!cavity.triangulate(triangulation.geometry(), triangles)) {
      ++met.refused;
      continue;
    }
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    for (const auto& [from, apex, to] : triangles) {
      ASSERT_LT(from, apex);
      ASSERT_LT(apex, to);
      ASSERT_TRUE(expected.contains(face_corners(rounded(from), rounded(apex), rounded(to))));
    }
  }
}

bool is_on_line(const Segment& segment, const Point& p) {
  using exact::explicit_position;
  return exact::orientation(explicit_position(segment.start), explicit_position(segment.end), explicit_position(p)) ==
         exact::Sign::zero;
}

/// Checks scenes of points that point(random) makes. Skips the points on the line of the segment.
template <class MakePoint>
Met check_scenes(std::size_t scenes, std::uint32_t most_points, MakePoint&& point, const Segment& segment = kSegment) {
  Met met;
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    Random random(scene);
    std::vector<Point> points;
    const auto count = random.between(2, most_points);
    for (std::int64_t i = 0; i < count; ++i) {
      const Point p = point(random);
      if (!is_on_line(segment, p)) points.push_back(p);
    }
    check_polygons(segment, points, met);
    if (testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "scene " << scene;
      return met;
    }
  }
  return met;
}

TEST(SegmentCavity, PolygonsBesideASegmentAgreeWithFreshTriangulations) {
  const Met met = check_scenes(4000, 60, [](Random& random) {
    return Point{200 * unit(random) - 100, 2 * unit(random) - 1};
  });
  EXPECT_GT(met.polygons, 7000U);
  EXPECT_GT(met.dangling, 3000U);
  EXPECT_EQ(met.refused, 0U);
}

TEST(SegmentCavity, PolygonsInALatticeAgreeWithFreshTriangulations) {
  const Met met = check_scenes(500, 120, [](Random& random) {
    return Point{static_cast<double>(random.between(-100, 100)), static_cast<double>(random.between(-3, 3))};
  });
  EXPECT_GT(met.polygons, 900U);
  EXPECT_GT(met.dangling, 100U);
  EXPECT_EQ(met.refused, 0U);
}

// Most points are far from the segment, so the polygons have deep pockets.
TEST(SegmentCavity, DeepPolygonsAgreeWithFreshTriangulations) {
  const Met met = check_scenes(500, 60, [](Random& random) {
    const double y = 100 * std::pow(unit(random), 3);
    return Point{200 * unit(random) - 100, random.between(0, 1) == 0 ? y : -y};
  });
  EXPECT_GT(met.polygons, 900U);
  EXPECT_EQ(met.refused, 0U);
}

// Two vertices are nearer to the segment than the rounding errors of products of doubles. The order of the insertions
// depends on the positions, so each scale has another order.
TEST(SegmentCavity, VerticesAFewUlpsFromTheSegmentAreNotRefused) {
  const std::vector<Point> polygon = {
      {-167.06160221963461, 193.97531044905838}, {-1024, -1024},
      {-68.435696924742487, 79.460722155185948}, {-61.318808222151169, 71.197299099410344},
      {-68.435696924742487, 79.460722155185948}, {124.30923493549697, -144.33551527057003},
      {167.06160221963461, -193.97531044905838}};
  for (int exponent = -60; exponent <= 60; ++exponent) {
    const double scale = std::ldexp(1.0, exponent);
    Triangulation triangulation(Box{scale * Point{-1024, -1024}, scale * Point{1024, 1024}}, kBorderLabels);
    delaunay::SegmentCavity cavity;
    for (const Point& p : polygon) {
      const Vertex v = triangulation.insert(scale * p).vertex;
      cavity.add(triangulation.view(v), triangulation.geometry().rounded(number(v)));
    }
    std::vector<Triangle> triangles;
    EXPECT_TRUE(cavity.triangulate(triangulation.geometry(), triangles)) << exponent;
  }
}

// Above the segment, the polygon is a wedge with many vertices on both sides. All crossed edges end at one vertex below
// the segment. The ears of such a polygon are far from Delaunay: with flips alone, the number of changed faces was
// quadratic.
TEST(SegmentCavity, TheNumberOfChangedFacesIsLinearInAWedge) {
  Triangulation triangulation(kSegmentDomain, kBorderLabels);
  const Vertex u = triangulation.insert(kSegment.start).vertex;
  const Vertex w = triangulation.insert(kSegment.end).vertex;
  triangulation.insert({0, -0.5});
  for (int i = 1; i < 1000; ++i) {
    const double x = 90 - 0.09 * i;
    triangulation.insert({-x, 0.09 * i});
    triangulation.insert({x, 0.09 * i});
  }
  const std::vector<HalfEdge> crossed = edges_across(triangulation, u, w);
  ASSERT_GT(crossed.size(), 1'000U);
  triangulation.begin();
  triangulation.force_edge(u, w, crossed, kSegmentLabel);
  std::size_t changed = 0;
  triangulation.topology().for_each_touched_face([&](mesh::Face, mesh::TriangleMesh::Touch) { ++changed; });
  EXPECT_LT(changed, 16 * crossed.size());
  EXPECT_FALSE(triangulation.topology().find_fault().has_value());
}

}  // namespace
}  // namespace waywright::test

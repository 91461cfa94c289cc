#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/face_corners.hpp"
#include "delaunay/polygon_triangles.hpp"
#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using mesh::HalfEdge;

constexpr std::array<mesh::Label, 4> kCavitySides = {1, 2, 3, 4};

Triangulation triangulate(double size, std::span<const Point> points) {
  Triangulation triangulation({{0, 0}, {size, size}}, kCavitySides);
  for (const Point& p : points) static_cast<void>(triangulation.insert(p));
  return triangulation;
}

/// The cavity around the last of the points must get the faces of a triangulation without this point, whichever side of
/// the cavity is its base.
void check_cavity(double size, const std::vector<Point>& points) {
  const Triangulation with = triangulate(size, points);
  const auto expected = faces_of(triangulate(size, std::span(points).first(points.size() - 1)));
  const mesh::TriangleMesh& mesh = with.topology();
  const mesh::Vertex v = mesh.origin(with.locate(points.back()).h);
  std::vector<mesh::Vertex> link;
  mesh.for_each_outgoing(v, [&](HalfEdge h) { link.push_back(mesh.target(h)); });
  delaunay::LargeCavity cavity;
  std::vector<mesh::TriangleMesh::Triangle> triangles;
  for (std::size_t k = 0; k < link.size(); ++k) {
    std::vector<exact::Geometry::View> positions;
    for (const mesh::Vertex w : link) positions.push_back(with.view(w));
    cavity.triangulate(with.geometry(), positions, k, triangles);
    ASSERT_EQ(triangles.size(), link.size() - 2);
    for (const auto& [from, apex, to] : triangles) {
      ASSERT_LT(from, apex);
      ASSERT_LT(apex, to);
      const auto point = [&](std::uint32_t i) { return with.geometry().rounded(number(link[i])); };
      ASSERT_TRUE(expected.contains(face_corners(point(from), point(apex), point(to))));
    }
    std::rotate(link.begin(), link.begin() + 1, link.end());
  }
}

// Small lattices: nearly every decision is a tie, many neighbours are collinear, and three vertices of the border are
// often clockwise in the plane.
TEST(LargeCavity, CavitiesInRandomLatticesAgreeWithFreshTriangulations) {
  std::uint64_t state = 1;
  const auto below = [&](std::uint32_t count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state >> 33) % count;
  };
  for (int scene = 0; scene < 3000; ++scene) {
    const std::uint32_t size = 4 + below(9);
    std::set<std::pair<double, double>> taken;
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < 4 + below(3 * size); ++i) {
      const Point p{static_cast<double>(below(size + 1)), static_cast<double>(below(size + 1))};
      if (taken.insert({p.x, p.y}).second) points.push_back(p);
    }
    Point hub{static_cast<double>(1 + below(size - 1)), static_cast<double>(1 + below(size - 1))};
    if (below(2) == 0) hub.x += 0.5;
    if (hub.x >= size || !taken.insert({hub.x, hub.y}).second) continue;
    points.push_back(hub);
    ASSERT_NO_FATAL_FAILURE(check_cavity(static_cast<double>(size), points)) << "scene " << scene;
  }
}

}  // namespace
}  // namespace waywright::test

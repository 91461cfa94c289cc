#include "delaunay/triangulation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "exact/geometry.hpp"
#include "exact/rational.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using mesh::HalfEdge;
using mesh::Vertex;

constexpr std::array<mesh::Label, 4> kDomainSides = {1, 2, 3, 4};

/// Checks the Delaunay rule with rationals and over all vertices: no vertex is inside the circle of a face, and of the
/// vertices on the circle the first in order is a corner of the face. Requires: only the sides of the box are fixed
/// edges.
testing::AssertionResult is_delaunay(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const HalfEdge h = mesh::first(mesh::Face{i});
    if (!mesh.is_live(mesh::Face{i}) || triangulation.is_ghost_face(h)) continue;
    const std::array<Vertex, 3> corners = {mesh.origin(h), mesh.target(h), mesh.apex(h)};
    std::array<RationalPoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = rational(triangulation.geometry().exact(number(corners[k])));
    if (rational_orientation(p[0], p[1], p[2]) != exact::Sign::positive) {
      return testing::AssertionFailure() << "face " << i << " is not counter-clockwise";
    }
    for (std::uint32_t j = 0; j < mesh.vertex_slots(); ++j) {
      if (!mesh.is_live(Vertex{j}) || Vertex{j} == triangulation.ghost()) continue;
      if (std::find(corners.begin(), corners.end(), Vertex{j}) != corners.end()) continue;
      const RationalPoint q = rational(triangulation.geometry().exact(j));
      const exact::Sign sign = rational_in_circle(p[0], p[1], p[2], q);
      if (sign == exact::Sign::positive) return testing::AssertionFailure() << "vertex " << j << " in circle " << i;
      const bool is_first = std::all_of(
          p.begin(), p.end(), [&](const RationalPoint& r) { return rational_order(q, r) == exact::Sign::negative; });
      if (sign == exact::Sign::zero && is_first) return testing::AssertionFailure() << "tie broken wrongly at " << i;
    }
  }
  return testing::AssertionSuccess();
}

Triangulation lattice(int size) {
  return Triangulation({{0, 0}, {static_cast<double>(size), static_cast<double>(size)}}, kDomainSides);
}

TEST(Triangulation, EmptyBoxIsCutFromItsFirstCorner) {
  const Triangulation triangulation = lattice(4);
  EXPECT_EQ(triangulation.topology().vertex_count(), 5U);
  EXPECT_TRUE(is_delaunay(triangulation));
}

TEST(Triangulation, InsertsInFacesOnEdgesOnTheBorderAndOnVertices) {
  Triangulation triangulation = lattice(4);
  const auto insert = [&](double x, double y) {
    const auto inserted = triangulation.insert({x, y});
    EXPECT_EQ(triangulation.topology().find_fault(), std::nullopt);
    EXPECT_TRUE(is_delaunay(triangulation));
    return inserted;
  };
  EXPECT_TRUE(insert(1, 3).is_new);
  EXPECT_TRUE(insert(2, 2).is_new) << "on the diagonal, or what it became";
  const auto on_side = insert(3, 0);
  EXPECT_TRUE(on_side.is_new);
  ASSERT_NE(on_side.split, mesh::kNoHalfEdge) << "the box's side is fixed";
  EXPECT_EQ(triangulation.topology().origin(on_side.split), on_side.vertex);
  EXPECT_EQ(triangulation.topology().label(on_side.split), 1U);
  const auto again = insert(2, 2);
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(triangulation.geometry().rounded(number(again.vertex)), (Point{2, 2}));
  EXPECT_FALSE(insert(0, 0).is_new) << "a corner of the box";
}

TEST(Triangulation, RandomLatticePointsAreDelaunayTiesIncluded) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Triangulation triangulation = lattice(6);
    Random random(seed);
    for (int i = 0; i < 25; ++i) {
      const Point p{static_cast<double>(random.below(7)), static_cast<double>(random.below(7))};
      const auto inserted = triangulation.insert(p);
      ASSERT_EQ(triangulation.geometry().rounded(number(inserted.vertex)), p);
    }
    ASSERT_EQ(triangulation.topology().find_fault(), std::nullopt) << "seed " << seed;
    ASSERT_TRUE(is_delaunay(triangulation)) << "seed " << seed;
  }
}

/// Returns the free edges between `u` and `w` in the order in which force_edge takes them, found by a brute-force walk
/// from face to face.
std::vector<HalfEdge> edges_between(const Triangulation& triangulation, Vertex u, Vertex w) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::vector<HalfEdge> crossed;
  HalfEdge exit = mesh::kNoHalfEdge;
  mesh.for_each_outgoing(u, [&](HalfEdge h) {
    if (triangulation.is_ghost_face(h)) return;
    if (triangulation.orientation(u, w, mesh.target(h)) == exact::Sign::negative &&
        triangulation.orientation(u, w, mesh.apex(h)) == exact::Sign::positive) {
      exit = mesh::next(h);
    }
  });
  for (;;) {
    crossed.push_back(exit);
    const HalfEdge t = mesh.twin(exit);
    if (mesh.apex(t) == w) return crossed;
    const bool is_left = triangulation.orientation(u, w, mesh.apex(t)) == exact::Sign::positive;
    exit = is_left ? mesh::next(t) : mesh::previous(t);
  }
}

/// Returns the corners of each face that has no edge in `crossed`, by the face's first half-edge.
std::map<HalfEdge, std::array<Vertex, 3>> faces_beyond(const Triangulation& triangulation,
                                                       const std::vector<HalfEdge>& crossed) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::map<HalfEdge, std::array<Vertex, 3>> faces;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const HalfEdge h = mesh::first(mesh::Face{i});
    faces[h] = {mesh.origin(h), mesh.target(h), mesh.apex(h)};
  }
  for (const HalfEdge h : crossed) {
    for (const HalfEdge half : {h, mesh.twin(h)}) faces.erase(mesh::first(mesh::face(half)));
  }
  return faces;
}

// Two rows of points lie between the ends, so the forced edge crosses every edge between the rows. Afterwards every
// free edge must be locally Delaunay; with the forced edge fixed, only one mesh is like that. The faces outside the
// cavity must not change, though an edge on the cavity's border may fail the Delaunay test for a time.
TEST(Triangulation, ForcedEdgeLeavesEveryOtherEdgeLegal) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Triangulation triangulation({{-10, -200}, {1010, 200}}, kDomainSides);
    Random random(seed);
    const auto insert = [&](double x, double y) { return triangulation.insert({x, y}).vertex; };
    const Vertex u = insert(0, 0);
    const Vertex w = insert(1000, 0);
    for (int i = 0; i < 40; ++i) {
      const auto height = static_cast<double>(random.between(1, 150));
      insert(static_cast<double>(random.between(1, 999)), random.chance(50) ? height : -height);
    }
    ASSERT_EQ(triangulation.topology().find(u, w), mesh::kNoHalfEdge) << "nothing to force at seed " << seed;
    const std::vector<HalfEdge> crossed = edges_between(triangulation, u, w);
    const auto beyond = faces_beyond(triangulation, crossed);
    const HalfEdge edge = triangulation.force_edge(u, w, crossed, 9);
    const mesh::TriangleMesh& mesh = triangulation.topology();
    ASSERT_EQ(mesh.find_fault(), std::nullopt) << "seed " << seed;
    ASSERT_EQ(mesh.origin(edge), u);
    ASSERT_EQ(mesh.target(edge), w);
    ASSERT_EQ(mesh.label(edge), 9U);
    for (const auto& [h, corners] : beyond) {
      ASSERT_EQ((std::array{mesh.origin(h), mesh.target(h), mesh.apex(h)}), corners) << "seed " << seed;
    }
    for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
      const HalfEdge h{i};
      if (triangulation.is_ghost_face(h)) continue;
      ASSERT_EQ(triangulation.orientation(mesh.origin(h), mesh.target(h), mesh.apex(h)), exact::Sign::positive);
      ASSERT_TRUE(mesh.is_fixed(h) || triangulation.is_legal(h)) << "seed " << seed;
    }
  }
}

// Vertex `near` lies close to the forced edge. The two faces that lie beyond the cavity, to the left and to the right
// of `near`, share the edge from `near` to `behind`: that edge dangles.
TEST(Triangulation, ForcedEdgePassesDanglingEdges) {
  Triangulation triangulation({{-10, -60}, {30, 60}}, kDomainSides);
  const auto insert = [&](double x, double y) { return triangulation.insert({x, y}).vertex; };
  const Vertex u = insert(0, 0);
  const Vertex w = insert(20, 0);
  const Vertex near = insert(10, 0.25);
  const Vertex behind = insert(10, 3);
  insert(7, -1);
  insert(13, -1);
  insert(10, -0.5);
  ASSERT_NE(triangulation.topology().find(near, behind), mesh::kNoHalfEdge);
  triangulation.force_edge(u, w, edges_between(triangulation, u, w), 9);
  EXPECT_EQ(triangulation.topology().find_fault(), std::nullopt);
  EXPECT_NE(triangulation.topology().find(near, behind), mesh::kNoHalfEdge);
}

}  // namespace
}  // namespace waywright::test

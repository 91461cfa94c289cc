#include "mesh/triangle_mesh.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/square_mesh.hpp"

namespace waywright::test {
namespace {

using mesh::Face;
using mesh::HalfEdge;
using mesh::kNoHalfEdge;
using mesh::TriangleMesh;
using mesh::Vertex;

using Square = SquareMesh;

std::set<Vertex> neighbours(const TriangleMesh& mesh, Vertex v) {
  std::set<Vertex> result;
  mesh.for_each_outgoing(v, [&](HalfEdge h) { result.insert(mesh.target(h)); });
  return result;
}

TEST(TriangleMesh, SquareIsTwoTrianglesAndFourGhosts) {
  const Square square;
  const TriangleMesh& mesh = square.mesh;
  EXPECT_EQ(mesh.find_fault(), std::nullopt);
  EXPECT_EQ(mesh.vertex_count(), 5U);
  EXPECT_EQ(mesh.face_count(), 6U);
  EXPECT_NE(mesh.find(square.a, square.c), kNoHalfEdge);
  EXPECT_EQ(mesh.find(square.b, square.d), kNoHalfEdge);
  EXPECT_EQ(neighbours(mesh, square.ghost), (std::set{square.a, square.b, square.c, square.d}));
  EXPECT_EQ(mesh.apex(mesh.find(square.a, square.b)), square.c);
  EXPECT_EQ(mesh.apex(mesh.find(square.b, square.a)), square.ghost);
}

TEST(TriangleMesh, FlipTurnsTheDiagonal) {
  Square square;
  TriangleMesh& mesh = square.mesh;
  const HalfEdge ac = mesh.find(square.a, square.c);
  const Vertex left = mesh.apex(ac);
  const Vertex right = mesh.apex(mesh.twin(ac));
  const auto flipped = mesh.flip(ac);
  EXPECT_EQ(mesh.find_fault(), std::nullopt);
  EXPECT_EQ(mesh.find(square.a, square.c), kNoHalfEdge);
  EXPECT_EQ(mesh.origin(flipped.diagonal), right);
  EXPECT_EQ(mesh.target(flipped.diagonal), left);
  // Both edges opposite the old apex. The legalisation of an insertion needs them.
  EXPECT_EQ(mesh.apex(ac), left);
  EXPECT_EQ(mesh.apex(flipped.opposite), left);
  EXPECT_NE(mesh::face(ac), mesh::face(flipped.opposite));
}

TEST(TriangleMesh, SplitFaceJoinsTheVertexToItsCorners) {
  Square square;
  TriangleMesh& mesh = square.mesh;
  const HalfEdge ab = mesh.find(square.a, square.b);
  const Vertex v = mesh.add_vertex();
  const auto opposite = mesh.split_face(mesh::face(ab), v);
  EXPECT_EQ(mesh.find_fault(), std::nullopt);
  EXPECT_EQ(neighbours(mesh, v), (std::set{square.a, square.b, square.c}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.apex(opposite[i]), v);
    EXPECT_EQ(mesh.target(opposite[i]), mesh.origin(opposite[(i + 1) % 3])) << "not counter-clockwise around it";
  }
}

TEST(TriangleMesh, SplitEdgeKeepsTheLabelOnBothHalves) {
  Square square;
  TriangleMesh& mesh = square.mesh;
  const HalfEdge ac = mesh.find(square.a, square.c);
  mesh.set_label(ac, 7);
  mesh.set_label(mesh.find(square.a, square.b), 8);
  const Vertex v = mesh.add_vertex();
  const auto opposite = mesh.split_edge(ac, v);
  EXPECT_EQ(mesh.find_fault(), std::nullopt);
  EXPECT_EQ(neighbours(mesh, v), (std::set{square.a, square.b, square.c, square.d}));
  EXPECT_EQ(mesh.label(mesh.find(square.a, v)), 7U);
  EXPECT_EQ(mesh.label(mesh.find(v, square.c)), 7U);
  EXPECT_EQ(mesh.label(mesh.find(v, square.b)), 0U);
  EXPECT_EQ(mesh.label(mesh.find(square.b, square.a)), 8U);
  EXPECT_EQ(mesh.origin(ac), square.a);
  EXPECT_EQ(mesh.target(ac), v);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.apex(opposite[i]), v);
    EXPECT_EQ(mesh.target(opposite[i]), mesh.origin(opposite[(i + 1) % 4])) << "not counter-clockwise around it";
  }
}

TEST(TriangleMesh, FreedSlotsAreReusedLastFirst) {
  TriangleMesh mesh;
  const Face f = mesh.add_face();
  const Face g = mesh.add_face();
  mesh.free_face(f);
  mesh.free_face(g);
  EXPECT_FALSE(mesh.is_live(f));
  EXPECT_EQ(mesh.add_face(), g);
  EXPECT_EQ(mesh.add_face(), f);
  const Vertex v = mesh.add_vertex();
  const Vertex w = mesh.add_vertex();
  mesh.free_vertex(v);
  mesh.free_vertex(w);
  EXPECT_FALSE(mesh.is_live(w));
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_EQ(mesh.add_vertex(), w);
  EXPECT_EQ(mesh.add_vertex(), v);
}

// Random splits and flips. The mesh must stay a sphere, and the label of each edge must stay between the same two
// vertices.
TEST(TriangleMesh, RandomSplitsAndFlipsKeepItASphere) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Square square;
    TriangleMesh& mesh = square.mesh;
    Random random(seed);
    std::vector<std::pair<std::pair<Vertex, Vertex>, mesh::Label>> labelled;
    for (int step = 0; step < 200; ++step) {
      const HalfEdge h{static_cast<std::uint32_t>(random.below(mesh.face_slots() * std::size_t{3}))};
      switch (random.below(4)) {
        case 0: {
          const Vertex v = mesh.add_vertex();
          mesh.split_face(mesh::face(h), v);
          break;
        }
        case 1:
          if (!mesh.is_fixed(h)) mesh.split_edge(h, mesh.add_vertex());
          break;
        case 2:
          if (!mesh.is_fixed(h) && mesh.find(mesh.apex(h), mesh.apex(mesh.twin(h))) == kNoHalfEdge) mesh.flip(h);
          break;
        default:
          if (!mesh.is_fixed(h) && random.chance(20)) {
            const auto label = static_cast<mesh::Label>(step + 1);
            mesh.set_label(h, label);
            labelled.push_back({{mesh.origin(h), mesh.target(h)}, label});
          }
      }
      ASSERT_EQ(mesh.find_fault(), std::nullopt) << "seed " << seed << ", step " << step;
    }
    for (const auto& [ends, label] : labelled) {
      const HalfEdge h = mesh.find(ends.first, ends.second);
      ASSERT_NE(h, kNoHalfEdge);
      ASSERT_EQ(mesh.label(h), label);
      ASSERT_EQ(mesh.label(mesh.twin(h)), label);
    }
  }
}

TEST(TriangleMesh, FaultsAreFound) {
  {
    Square square;
    square.mesh.link(square.mesh.find(square.a, square.b), square.mesh.find(square.a, square.c), 0);
    EXPECT_NE(square.mesh.find_fault(), std::nullopt);
  }
  {
    Square square;
    square.mesh.set_outgoing(square.a, square.mesh.find(square.b, square.c));
    EXPECT_NE(square.mesh.find_fault(), std::nullopt);
  }
  {
    Square square;
    square.mesh.free_face(mesh::face(square.mesh.find(square.a, square.b)));
    EXPECT_NE(square.mesh.find_fault(), std::nullopt);
  }
  {
    Square square;
    (void)square.mesh.add_vertex();
    EXPECT_NE(square.mesh.find_fault(), std::nullopt) << "a vertex without faces";
  }
}

}  // namespace
}  // namespace waywright::test

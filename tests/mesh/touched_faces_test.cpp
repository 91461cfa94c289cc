#include "mesh/touched_faces.hpp"

#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "support/square_mesh.hpp"

namespace waywright::test {
namespace {

using mesh::Face;
using mesh::HalfEdge;
using mesh::TouchedFaces;
using mesh::TriangleMesh;

/// Returns the faces that the class has collected. Checks that they agree with contains().
std::set<Face> collected(const TouchedFaces& touched, const TriangleMesh& mesh) {
  const std::set<Face> faces(touched.faces().begin(), touched.faces().end());
  EXPECT_EQ(faces.size(), touched.faces().size()) << "a face is listed twice";
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) EXPECT_EQ(touched.contains(Face{i}), faces.contains(Face{i}));
  return faces;
}

TEST(TouchedFaces, ListsEachFaceOnce) {
  SquareMesh square;
  TriangleMesh& mesh = square.mesh;
  const HalfEdge h = mesh.find(square.a, square.b);
  TouchedFaces touched;
  mesh.begin();
  mesh.split_face(mesh::face(h), mesh.add_vertex());
  mesh.split_face(mesh::face(mesh.find(square.a, square.b)), mesh.add_vertex());
  {
    const TouchedFaces::Guard guard(touched);
    touched.collect(mesh);
    EXPECT_FALSE(touched.are_most_faces());
    // Each split keeps one face and makes two others. Only the faces inside the triangle a b c are touched.
    EXPECT_EQ(collected(touched, mesh), (std::set{mesh::face(h), Face{6}, Face{7}, Face{8}, Face{9}}));
  }
  EXPECT_EQ(collected(touched, mesh), std::set<Face>{});
}

TEST(TouchedFaces, LeavesOutFacesOfWhichOnlyLabelsChange) {
  SquareMesh square;
  TriangleMesh& mesh = square.mesh;
  const HalfEdge h = mesh.find(square.a, square.c);
  mesh.make_room_for_labels();
  TouchedFaces touched;
  mesh.begin();
  mesh.set_label(h, 1);
  {
    const TouchedFaces::Guard guard(touched);
    touched.collect(mesh);
    EXPECT_EQ(collected(touched, mesh), (std::set{mesh::face(h), mesh::face(mesh.twin(h))}));
  }
  mesh.begin();
  mesh.set_label(h, 2);
  const TouchedFaces::Guard guard(touched);
  touched.collect(mesh);
  EXPECT_EQ(collected(touched, mesh), std::set<Face>{});
}

TEST(TouchedFaces, AreEmptyIfMostFacesAreTouched) {
  SquareMesh square;
  TriangleMesh& mesh = square.mesh;
  const auto split = [&] { mesh.split_face(mesh::face(mesh.find(square.a, square.b)), mesh.add_vertex()); };
  TouchedFaces touched;
  mesh.begin();
  for (int i = 0; i < 600; ++i) split();
  {
    const TouchedFaces::Guard guard(touched);
    touched.collect(mesh);
    EXPECT_TRUE(touched.are_most_faces());
    EXPECT_EQ(collected(touched, mesh), std::set<Face>{});
  }
  mesh.begin();
  split();
  const TouchedFaces::Guard guard(touched);
  touched.collect(mesh);
  EXPECT_FALSE(touched.are_most_faces());
  EXPECT_EQ(collected(touched, mesh).size(), 3U);
}

}  // namespace
}  // namespace waywright::test

#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "constraint/constrained_triangulation.hpp"
#include "exact/geometry.hpp"

namespace waywright::test {
namespace {

class FindFault : public testing::Test {
 protected:
  void insert(const Shape& shape) { triangulation_.insert(shape, {++last_id_}); }
  void insert_point(double x, double y) { insert({ItemKind::point, {{{x, y}}}}); }

  // The next two functions make a mesh incorrect. The class itself lets nobody change its parts.

  void displace(const Point& point, const Point& by) {
    ASSERT_EQ(triangulation_.find_fault(), std::nullopt);
    const auto located = triangulation_.triangulation().locate(point);
    ASSERT_EQ(located.kind, locate::LocatedKind::vertex);
    auto& geometry = const_cast<exact::Geometry&>(triangulation_.triangulation().geometry());
    geometry.set_position(number(triangulation_.topology().origin(located.h)), point + by);
  }

  /// Flips an edge that is a diagonal of a strictly convex quadrilateral.
  void flip_an_edge() {
    ASSERT_EQ(triangulation_.find_fault(), std::nullopt);
    auto& mesh = const_cast<mesh::TriangleMesh&>(triangulation_.topology());
    const auto& delaunay = triangulation_.triangulation();
    for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
      const mesh::HalfEdge h{i};
      if (mesh.is_fixed(h) || delaunay.is_ghost_face(h) || delaunay.is_ghost_face(mesh.twin(h))) continue;
      const mesh::Vertex c = mesh.apex(h);
      const mesh::Vertex d = mesh.apex(mesh.twin(h));
      if (delaunay.orientation(d, mesh.target(h), c) != exact::Sign::positive) continue;
      if (delaunay.orientation(c, mesh.origin(h), d) != exact::Sign::positive) continue;
      mesh.flip(h);
      return;
    }
    FAIL() << "no edge can be flipped";
  }

  void expect_fault(const std::string& words) {
    const std::optional<std::string> fault = triangulation_.find_fault();
    ASSERT_TRUE(fault.has_value());
    EXPECT_NE(fault->find(words), std::string::npos) << *fault;
  }

  constraint::ConstrainedTriangulation triangulation_{Box{{0, 0}, {16, 16}}};
  std::uint64_t last_id_ = 0;
};

TEST_F(FindFault, EdgesThatAreNotDelaunay) {
  insert_point(8, 15);
  insert_point(7, 14);
  insert_point(9, 2);
  flip_an_edge();
  expect_fault("neither fixed nor Delaunay");
}

TEST_F(FindFault, FacesTurnedOver) {
  insert_point(4, 8);
  insert_point(12, 8);
  displace({4, 8}, {10, 0});
  expect_fault("not counter-clockwise");
}

TEST_F(FindFault, VerticesOffTheBorder) {
  insert_point(8, 0);
  displace({8, 0}, {0, -0.25});
  expect_fault("not on the domain's side");
}

TEST_F(FindFault, SidesThatAreNotStraight) {
  insert({ItemKind::segment, {{{2, 8}, {14, 8}}}});
  insert_point(8, 8);
  displace({8, 8}, {0, 0.25});
  expect_fault("a side of item 1 does not reach its end");
}

}  // namespace
}  // namespace waywright::test

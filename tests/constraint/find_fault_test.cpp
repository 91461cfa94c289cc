#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "constraint/constrained_triangulation.inl"
#include "exact/geometry.hpp"

namespace waywright::test {
namespace {

/// Answers as exact::Geometry does, except where a test sets one of the static members below. These wrong answers make
/// a mesh incorrect without changing it.
class LyingGeometry : public exact::Geometry {
 public:
  using exact::Geometry::Geometry;

  static inline bool every_circle_is_empty = false;
  static inline std::optional<std::uint32_t> displaced_vertex;
  static inline Point displacement;

  [[nodiscard]] View view(std::uint32_t vertex) const {
    View view = exact::Geometry::view(vertex);
    if (displaced_vertex == vertex) {
      view.x += displacement.x;
      view.y += displacement.y;
    }
    return view;
  }
  [[nodiscard]] static View view(const Point& point) { return exact::Geometry::view(point); }
  [[nodiscard]] exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d) const {
    return every_circle_is_empty ? exact::Sign::negative : exact::Geometry::in_circle(a, b, c, d);
  }
};

using Triangulation = constraint::ConstrainedTriangulation<LyingGeometry>;

class FindFault : public testing::Test {
 protected:
  ~FindFault() override {
    LyingGeometry::every_circle_is_empty = false;
    LyingGeometry::displaced_vertex.reset();
  }

  void insert(const Shape& shape) { triangulation_.insert(shape, {++last_id_}); }
  void insert_point(double x, double y) { insert({ItemKind::point, {{{x, y}}}}); }

  void displace(const Point& point, const Point& by) {
    ASSERT_EQ(triangulation_.find_fault(), std::nullopt);
    const auto located = triangulation_.triangulation().locate(point);
    ASSERT_EQ(located.kind, locate::LocatedKind::vertex);
    LyingGeometry::displaced_vertex = number(triangulation_.topology().origin(located.h));
    LyingGeometry::displacement = by;
  }

  void expect_fault(const std::string& words) {
    const std::optional<std::string> fault = triangulation_.find_fault();
    ASSERT_TRUE(fault.has_value());
    EXPECT_NE(fault->find(words), std::string::npos) << *fault;
  }

  Triangulation triangulation_{Box{{0, 0}, {16, 16}}};
  std::uint64_t last_id_ = 0;
};

TEST_F(FindFault, EdgesThatAreNotDelaunay) {
  LyingGeometry::every_circle_is_empty = true;
  insert_point(8, 15);
  insert_point(7, 14);
  insert_point(9, 2);
  LyingGeometry::every_circle_is_empty = false;
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

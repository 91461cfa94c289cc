#include "locate/walk.hpp"

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using locate::Located;
using locate::LocatedKind;
using mesh::HalfEdge;

Triangulation lattice_world(std::uint64_t seed) {
  Triangulation triangulation({{0, 0}, {8, 8}}, {1, 2, 3, 4});
  Random random(seed);
  for (int i = 0; i < 12; ++i) {
    triangulation.insert({static_cast<double>(random.below(9)), static_cast<double>(random.below(9))});
  }
  return triangulation;
}

/// Checks that `location` is the location of `point`, by orientation tests on the face, edge or vertex that it names.
void expect_true(const Triangulation& triangulation, const Located& location, const Point& point) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto view = exact::Geometry::view(point);
  const auto orientation = [&](HalfEdge h) {
    return triangulation.geometry().orientation(triangulation.view(mesh.origin(h)), triangulation.view(mesh.target(h)),
                                                view);
  };
  ASSERT_FALSE(triangulation.is_ghost_face(location.h) && location.kind == LocatedKind::face);
  const Point origin = triangulation.geometry().rounded(number(mesh.origin(location.h)));
  switch (location.kind) {
    case LocatedKind::vertex:
      EXPECT_EQ(origin, point);
      break;
    case LocatedKind::edge: {
      EXPECT_EQ(orientation(location.h), exact::Sign::zero);
      const Point target = triangulation.geometry().rounded(number(mesh.target(location.h)));
      const double along = (point.x - origin.x) * (target.x - origin.x) + (point.y - origin.y) * (target.y - origin.y);
      const double length =
          (target.x - origin.x) * (target.x - origin.x) + (target.y - origin.y) * (target.y - origin.y);
      EXPECT_GT(along, 0.0);
      EXPECT_LT(along, length);
      break;
    }
    case LocatedKind::face:
      for (const HalfEdge h : {location.h, mesh::next(location.h), mesh::previous(location.h)}) {
        EXPECT_EQ(orientation(h), exact::Sign::positive);
      }
  }
}

TEST(Walk, AnswersVertexEdgeOrFaceFromAnyStart) {
  std::size_t counts[3] = {0, 0, 0};
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Triangulation triangulation = lattice_world(seed);
    const mesh::TriangleMesh& mesh = triangulation.topology();
    for (int x = 0; x <= 16; ++x) {
      for (int y = 0; y <= 16; ++y) {
        const Point point{x / 2.0, y / 2.0};
        for (std::uint32_t f = 0; f < mesh.face_slots(); f += 5) {
          const HalfEdge start = mesh::first(mesh::Face{f});
          if (triangulation.is_ghost_face(start)) continue;
          const Located location = triangulation.locate(point, start);
          expect_true(triangulation, location, point);
          ++counts[static_cast<std::size_t>(location.kind)];
        }
      }
    }
  }
  for (const std::size_t count : counts) EXPECT_GT(count, 100U);
}

TEST(Walk, AgreesWithSearchingAllFaces) {
  const Triangulation triangulation = lattice_world(77);
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Point point{static_cast<double>(random.below(33)) / 4, static_cast<double>(random.below(33)) / 4};
    const Located walked = triangulation.locate(point);
    const Located found = locate::search_all(triangulation.topology(), triangulation.geometry(),
                                             exact::Geometry::view(point), triangulation.ghost());
    ASSERT_EQ(walked.kind, found.kind);
    expect_true(triangulation, found, point);
  }
}

TEST(Walk, SameQuestionSameCoins) {
  locate::Random one({3, 4});
  locate::Random other({3, 4});
  locate::Random third({4, 3});
  bool differs = false;
  for (int i = 0; i < 200; ++i) {
    const bool coin = one.coin();
    EXPECT_EQ(coin, other.coin());
    differs = differs || coin != third.coin();
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace waywright::test

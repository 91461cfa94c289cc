#include "location_strategies.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using Ground = bench::Ground<exact::Geometry>;
using locate::Located;
using locate::LocatedKind;
using mesh::HalfEdge;

constexpr Box kBox = {{0, 0}, {32, 32}};

Ground ground_of(const Triangulation& triangulation) {
  return {triangulation.topology(), triangulation.geometry(), triangulation.ghost()};
}

Point random_point(Random& random) {
  return {static_cast<double>(random.below(65)) / 2, static_cast<double>(random.below(65)) / 2};
}

/// Returns the number of the vertex, edge or face of `location`. Two results with the same name are the same location.
std::uint32_t name(const Triangulation& triangulation, const Located& location) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  if (location.kind == LocatedKind::vertex) return number(mesh.origin(location.h));
  if (location.kind == LocatedKind::edge) return number(std::min(location.h, mesh.twin(location.h)));
  return number(mesh::face(location.h));
}

/// Inserts and removes points between the searches, so that what a strategy remembers becomes out of date.
template <class Strategy>
void expect_what_search_of_all_faces_finds(Strategy strategy) {
  Random random(11);
  Triangulation triangulation(kBox, {1, 2, 3, 4});
  std::vector<mesh::Vertex> vertices;
  std::size_t counts[3] = {0, 0, 0};
  for (int round = 0; round < 2000; ++round) {
    if (vertices.size() < 40 || random.chance(50)) {
      const auto inserted = triangulation.insert(random_point(random));
      if (inserted.is_new && inserted.split == mesh::kNoHalfEdge) vertices.push_back(inserted.vertex);
    } else {
      const std::size_t removed_index = random.below(vertices.size());
      triangulation.remove_vertex(triangulation.star(vertices[removed_index]));
      vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(removed_index));
    }
    const Point point = random_point(random);
    const Ground ground = ground_of(triangulation);
    ASSERT_TRUE(ground.contains(strategy.start(ground, point)));
    const Located location = bench::locate_by(strategy, ground, point);
    const Located right = locate::search_all(ground.mesh, ground.geometry, exact::Geometry::view(point), ground.ghost);
    ASSERT_EQ(location.kind, right.kind);
    ASSERT_EQ(name(triangulation, location), name(triangulation, right));
    ++counts[static_cast<std::size_t>(location.kind)];
  }
  for (const std::size_t count : counts) EXPECT_GT(count, 10U);
}

TEST(Strategies, LastFaceFindsWhatIsThere) { expect_what_search_of_all_faces_finds(bench::LastFace()); }

TEST(Strategies, CubeRootSamplingFindsWhatIsThere) { expect_what_search_of_all_faces_finds(bench::CubeRootSampling()); }

TEST(Strategies, SectorsOfSearchesFindWhatIsThere) {
  expect_what_search_of_all_faces_finds(bench::SectorsOfSearches(kBox));
}

/// A triangulation of two hundred points, and two of its faces that are far from each other.
struct World {
  World() : triangulation(kBox, {1, 2, 3, 4}) {
    Random random(12);
    for (int i = 0; i < 200; ++i) triangulation.insert(random_point(random));
  }

  Triangulation triangulation;
  HalfEdge low = triangulation.locate({3.3, 3.1}).h;
  HalfEdge high = triangulation.locate({29.3, 29.1}).h;
};

TEST(Strategies, LastFaceStartsWhereTheLastSearchEnded) {
  const World world;
  bench::LastFace strategy;
  strategy.found({3.3, 3.1}, world.low);
  strategy.found({29.3, 29.1}, world.high);
  EXPECT_EQ(strategy.start(ground_of(world.triangulation), {3.3, 3.1}), world.high);
}

TEST(Strategies, SectorsRememberTheLastSearchInEach) {
  const World world;
  const Ground ground = ground_of(world.triangulation);
  bench::SectorsOfSearches strategy(kBox);
  strategy.found({3.3, 3.1}, world.low);
  strategy.found({29.3, 29.1}, world.high);
  // Each sector is 2 x 2. The first two points share a sector with a search result; the sector of the third has none.
  EXPECT_EQ(strategy.start(ground, {2.1, 3.9}), world.low);
  EXPECT_EQ(strategy.start(ground, {28.1, 28.1}), world.high);
  EXPECT_EQ(strategy.start(ground, {2.1, 4.1}), world.high);
}

// The nearest of k random points of a square is about 1 / (2 sqrt(k)) of the square's width away. Here k = 6, so this
// is about a fifth. A single random point is about half the width away.
TEST(Strategies, CubeRootSamplingStartsNear) {
  const World world;
  const Ground ground = ground_of(world.triangulation);
  const bench::CubeRootSampling strategy;
  Random random(13);
  double sum = 0.0;
  constexpr int kRounds = 200;
  for (int i = 0; i < kRounds; ++i) {
    const Point point = random_point(random);
    const Point start = ground.geometry.rounded(number(ground.mesh.origin(strategy.start(ground, point))));
    sum += std::hypot(start.x - point.x, start.y - point.y);
  }
  EXPECT_LT(sum / kRounds, 0.3 * 32);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/random.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kPoints = 3'000;
constexpr double kLength = 4'096.0;
const Box kBand{{0.0, 0.0}, {kLength, 64.0}};

std::vector<Change> insertions(const std::vector<Point>& points) {
  std::vector<Change> changes;
  for (const Point& point : points) {
    changes.push_back({Change::Kind::insert, ItemId{}, Shape{ItemKind::point, {{point}}}});
  }
  return changes;
}

/// Compares two worlds: one inserts a wall last, so that it crosses the whole mesh; the other inserts it first, when
/// there is nothing to cross. Their meshes must be equal.
void expect_the_same_mesh(const std::vector<Point>& points, const std::vector<Point>& wall) {
  const ItemId id{1'000'000};
  World wall_last = World::create(kBand).value();
  wall_last.apply(insertions(points)).value();
  wall_last.insert_polyline(wall, id).value();
  World wall_first = World::create(kBand).value();
  wall_first.insert_polyline(wall, id).value();
  for (const Point& point : points) wall_first.insert_point(point).value();
  EXPECT_EQ(wall_last.mesh_hash(), wall_first.mesh_hash());
  EXPECT_TRUE(wall_last.validate().ok);
  wall_last.remove(id).value();
  EXPECT_TRUE(wall_last.validate().ok);
}

const std::vector<Point> kAcross{{0.0, 31.0}, {kLength, 33.0}};
const std::vector<Point> kToAndFro{{0.0, 1.0}, {kLength, 21.0}, {0.0, 40.0}, {kLength, 63.0}};

TEST(LongWalls, CrossRandomPoints) {
  Random random(1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const auto x = static_cast<double>(random.between(1, 4'095));
    points.push_back({x, static_cast<double>(random.between(1, 63))});
  }
  expect_the_same_mesh(points, kAcross);
  expect_the_same_mesh(points, kToAndFro);
}

TEST(LongWalls, CrossALattice) {
  std::vector<Point> points;
  for (int x = 1; x < 200; ++x) {
    for (int y = 1; y < 16; ++y) points.push_back({x * 16.0, y * 4.0});
  }
  expect_the_same_mesh(points, kAcross);
  expect_the_same_mesh(points, kToAndFro);
}

// The chains left and right of the wall are curved over their whole length, so the flips after the first triangulation
// of the cavity must replace many edges.
TEST(LongWalls, PassBetweenArcs) {
  std::vector<Point> points;
  for (int i = -500; i <= 500; ++i) {
    const double x = kLength / 2 + i * 4.0;
    const double rise = i * i * 0x1p-14;
    points.push_back({x, 32.5 + rise});
    points.push_back({x + 2.0, 31.5 - rise});
    points.push_back({x + 1.0, 60.0 - rise});
  }
  expect_the_same_mesh(points, kAcross);
}

}  // namespace
}  // namespace waywright::test

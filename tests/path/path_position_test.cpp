#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

namespace waywright::test {
namespace {

Path path_of(std::vector<Point> points) {
  Path path;
  path.status = PathStatus::found;
  path.points = std::move(points);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    path.length += std::hypot(path.points[i].x - path.points[i - 1].x, path.points[i].y - path.points[i - 1].y);
  }
  return path;
}

void expect_position(const PathPosition& position, Point at, Point heading, std::size_t segment, double distance) {
  EXPECT_EQ(position.at, at);
  EXPECT_EQ(position.heading, heading);
  EXPECT_EQ(position.segment, segment);
  EXPECT_EQ(position.distance, distance);
}

const Path kCorner = path_of({{0, 0}, {4, 0}, {4, 8}});

TEST(PathPosition, LiesAtADistanceFromTheStart) {
  expect_position(kCorner.at(0), {0, 0}, {1, 0}, 0, 0);
  expect_position(kCorner.at(1), {1, 0}, {1, 0}, 0, 1);
  expect_position(kCorner.at(4), {4, 0}, {0, 1}, 1, 4);
  expect_position(kCorner.at(6), {4, 2}, {0, 1}, 1, 6);
  expect_position(kCorner.at(12), {4, 8}, {0, 1}, 1, 12);
  expect_position(kCorner.at(100), {4, 8}, {0, 1}, 1, 12);
  expect_position(kCorner.at(-3), {0, 0}, {1, 0}, 0, 0);
  expect_position(path_of({{3, 3}}).at(2), {3, 3}, {0, 0}, 0, 0);
}

TEST(PathPosition, AdvancesAsFarAsAUnitGoes) {
  PathPosition position = kCorner.at(0);
  for (const double expected : {3.0, 6.0, 9.0, 12.0, 12.0}) {
    position = kCorner.advance(position, 3);
    const PathPosition same = kCorner.at(expected);
    expect_position(position, same.at, same.heading, same.segment, expected);
  }
  position = kCorner.advance(position, -11);
  expect_position(position, {1, 0}, {1, 0}, 0, 1);
}

TEST(PathPosition, IsFoundNearAPoint) {
  expect_position(kCorner.nearest({1, 1}), {1, 0}, {1, 0}, 0, 1);
  expect_position(kCorner.nearest({-2, 5}), {0, 0}, {1, 0}, 0, 0);
  expect_position(kCorner.nearest({5, 3}), {4, 3}, {0, 1}, 1, 7);
  expect_position(kCorner.nearest({9, 99}), {4, 8}, {0, 1}, 1, 12);
  expect_position(path_of({{3, 3}}).nearest({9, 9}), {3, 3}, {0, 0}, 0, 0);
}

/// Returns 1 if the point is left of the line from (0, 0) to `direction`, -1 if it is right of it. Exact if `direction`
/// is whole numbers: where both products round to the same double, their rounding errors decide.
int side_of(Point direction, Point p) {
  const double one = direction.x * p.y;
  const double other = direction.y * p.x;
  const double difference =
      one != other ? one - other : std::fma(direction.x, p.y, -one) - std::fma(direction.y, p.x, -other);
  return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

// The path turns left around a wall, so the wall is to its left.
TEST(PathPosition, LiesOnTheSideThatTurnsKeepFree) {
  const Path left = path_of({{0, 0}, {7, 3}, {8, 9}});
  const Path right = path_of({{0, 0}, {3, 7}, {9, 8}});
  for (int i = 1; i < 1000; ++i) {
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      const double distance = i * std::hypot(7.0, 3.0) / 1000;
      const PathPosition on_left = left.at(distance, precision);
      ASSERT_EQ(on_left.segment, 0U);
      EXPECT_LE(side_of({7, 3}, on_left.at), 0) << i;
      const PathPosition on_right = right.at(distance, precision);
      EXPECT_GE(side_of({3, 7}, on_right.at), 0) << i;
      for (const PathPosition& position : {on_left, on_right}) {
        if (precision == Precision::float64) continue;
        EXPECT_EQ(static_cast<double>(static_cast<float>(position.at.x)), position.at.x);
        EXPECT_EQ(static_cast<double>(static_cast<float>(position.at.y)), position.at.y);
      }
    }
  }
}

// Near 0 the distance between doubles is far smaller than the error of a position on a long piece.
TEST(PathPosition, IsFoundNextToTheOriginAtOnce) {
  World world = World::create({{-50, -50}, {50, 50}}).value();
  world.insert_segment({-50, 20.1}, {10.3, 20.1}).value();
  const Path path = world.find_path({{-10.3, -20.099999}, {-40, 40}}).value();
  const double half = std::hypot(path.points.at(1).x - path.points[0].x, path.points[1].y - path.points[0].y) / 2;
  const Path hand_made = path_of({{-0.3, -0.7}, {0.30000000000000004, 0.7}, {5, 0.7}});
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    for (const double offset : {0.0, 1e-3, 1e-5, 1e-9, 1e-14, -1e-5, -1e-14}) {
      const PathPosition position = path.at(half - offset, precision);
      EXPECT_LT(std::hypot(position.at.x, position.at.y), 0.01);
      EXPECT_TRUE(world.find_path({position.at, {-40, 40}}).ok());
      const PathPosition other = hand_made.at(std::hypot(0.3, 0.7) - offset, precision);
      EXPECT_LT(std::hypot(other.at.x, other.at.y), 0.01);
    }
  }
}

TEST(PathPosition, AtADistanceThatIsNoNumberIsTheStart) {
  const double nan = std::nan("");
  expect_position(kCorner.at(nan), {0, 0}, {1, 0}, 0, 0);
}

// The wall has no thickness and reaches from border to border. No path leads across it.
TEST(PathPosition, DoesNotGetBeyondAThinWall) {
  World world = World::create({{0, 0}, {64, 64}}).value();
  world.insert_polyline(std::vector<Point>{{20, 0}, {23, 7}, {29, 8}, {64, 8}}).value();
  PathQuery query{{20, 0}, {40, 9}};
  query.end_tolerance = 0.0;
  const Path path = world.find_path(query).value();
  ASSERT_EQ(path.points.at(1), (Point{23, 7}));
  for (int i = 0; i <= 1000; ++i) {
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      const PathPosition position = path.at(i * path.length / 1000, precision);
      query.start = position.at;
      const Path again = world.find_path(query).value();
      ASSERT_EQ(again.status, PathStatus::found) << i;
      EXPECT_LE(again.length, path.length - position.distance + 1e-5) << i;
    }
  }
}

TEST(PathPosition, OnAPathOfOnePointIsRoundedToo) {
  const Path path = path_of({{0.1, 0.2}});
  const Point expected{static_cast<double>(0.1F), static_cast<double>(0.2F)};
  EXPECT_EQ(path.at(1, Precision::float32).at, expected);
  EXPECT_EQ(path.nearest({5, 5}, Precision::float32).at, expected);
  EXPECT_EQ(path.at(1).at, (Point{0.1, 0.2}));
}

TEST(PathPosition, AStepThatIsNaNIsNoStep) {
  const Path path = path_of({{0, 0}, {8, 0}});
  const PathPosition from = path.at(3);
  EXPECT_EQ(path.advance(from, std::numeric_limits<double>::quiet_NaN()).at, from.at);
}

}  // namespace
}  // namespace waywright::test

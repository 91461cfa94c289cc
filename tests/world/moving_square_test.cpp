#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

namespace waywright::test {
namespace {

struct Turn {
  const char* name;
  double angle;
};

/// Returns a rotated square around (x, y). Its corners are rounded to doubles.
Shape square(double x, double y, double half_side, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::vector<Point> ring;
  for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    ring.push_back({x + half_side * (dx * c - dy * s), y + half_side * (dx * s + dy * c)});
  }
  return Shape::polygon(ring);
}

class MovingSquare : public testing::TestWithParam<Turn> {};

INSTANTIATE_TEST_SUITE_P(Turns, MovingSquare,
                         testing::Values(Turn{"aligned", 0.0}, Turn{"by45", std::numbers::pi / 4},
                                         Turn{"by30", std::numbers::pi / 6}),
                         [](const auto& turn) { return std::string(turn.param.name); });

// Experiment 6 of Chen's thesis: a small square moves along the diagonal through nested squares; it is removed,
// translated and inserted 8,000 times. (The baseline of that experiment leaves vertices behind: 44 become 361.) At its
// start and its end the square touches no other, so the number of vertices must be equal.
TEST_P(MovingSquare, LeavesNothingBehind) {
  constexpr int kSteps = 8000;
  constexpr ItemId kMoving{9};
  const double angle = GetParam().angle;
  World world = World::create({{-100000, -100000}, {100000, 100000}}).value();
  for (int i = 1; i <= 7; ++i) {
    world.insert(square(0, 0, 10000.0 * i, angle), {static_cast<std::uint64_t>(100 + i)}).value();
  }
  const Shape start = square(-5000, -5000, 500, angle);
  world.insert(start, kMoving).value();
  const std::string dump = world.dump();
  const std::size_t vertices = world.vertex_count();
  EXPECT_EQ(vertices, 4U + 4U * 8U);
  for (int step = 1; step <= kSteps; ++step) {
    const Shape moved = translated(world.shape(kMoving).value(), 10, 10);
    world.remove(kMoving).value();
    world.insert(moved, kMoving).value();
    if (step % 100 != 0) continue;
    const Validation validation = world.validate();
    ASSERT_TRUE(validation.ok) << validation.fault << " after step " << step;
  }
  EXPECT_EQ(world.vertex_count(), vertices) << "the motion ends beyond the last square that it crosses";
  world.replace(kMoving, start).value();
  EXPECT_EQ(world.dump(), dump);
}

}  // namespace
}  // namespace waywright::test

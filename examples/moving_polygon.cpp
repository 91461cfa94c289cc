// A polygon with id 9 moves diagonally through nested squares: the program fetches it, takes its centroid, translates
// it by (10, 10) and puts it back. This is the third test program of Chen's thesis (appendix, experiment 6).

#include <cstdio>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

std::vector<waywright::Point> square(double radius) {
  return {{-radius, -radius}, {radius, -radius}, {radius, radius}, {-radius, radius}};
}

}  // namespace

int main() {
  constexpr int kSteps = 1000;
  constexpr waywright::ItemId kMoving{9};
  waywright::World world = waywright::World::create({{-100000, -100000}, {100000, 100000}}).value();
  for (int i = 1; i <= 8; ++i) world.insert_polygon(square(10000.0 * i), {static_cast<std::uint64_t>(100 + i)}).value();
  world.insert_polygon(square(100), kMoving).value();
  const std::size_t vertices = world.vertex_count();

  for (int step = 0; step < kSteps; ++step) {
    const waywright::Shape polygon = world.shape(kMoving).value();
    world.replace(kMoving, waywright::translated(polygon, 10, 10)).value();
  }
  const waywright::Point centre = waywright::centroid(world.shape(kMoving).value());
  std::printf("after %d steps the square is at (%g, %g)\n", kSteps, centre.x, centre.y);

  // When the polygon is back where it started, the mesh equals the mesh at the start.
  world.replace(kMoving, {waywright::ItemKind::polygon, {square(100)}}).value();
  const bool is_right = centre == waywright::Point{10.0 * kSteps, 10.0 * kSteps} && world.vertex_count() == vertices;
  std::printf("%zu vertices before, %zu after\n", vertices, world.vertex_count());
  return is_right && world.validate().ok ? 0 : 1;
}

// Locates and then inserts random points, one after the other, as the first test program of Chen's thesis (appendix)
// does.

#include <cstdio>
#include <random>

#include "waywright/waywright.hpp"

int main() {
  constexpr int kPoints = 1000;
  waywright::World world = waywright::World::create({{-8000, -8000}, {8000, 8000}}).value();
  waywright::QueryContext context;
  waywright::Location location;
  std::mt19937 random(2009);
  const auto coordinate = [&] { return static_cast<double>(random() % 16001) - 8000; };

  int on_vertex = 0;
  for (int i = 0; i < kPoints; ++i) {
    const waywright::Point point{coordinate(), coordinate()};
    world.locate(point, context, location).value();
    if (location.kind == waywright::LocationKind::vertex) ++on_vertex;
    world.insert_point(point).value();
  }
  const std::size_t vertices = world.vertex_count();
  std::printf("%d points, %d of them where one was already: %zu vertices, %zu triangles\n", kPoints, on_vertex,
              vertices, world.triangle_count());
  // Every new point made a vertex. The domain has four vertices of its own.
  const bool is_right = vertices == static_cast<std::size_t>(4 + kPoints - on_vertex) && world.validate().ok;
  return is_right ? 0 : 1;
}

// The work of bench/wasm/compare.mjs, natively: prints the name, the seconds and a check sum of each piece of work.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using namespace waywright;

constexpr double kSize = 1000.0;

/// Random numbers in [0, 1), the same as in compare.mjs.
class Random {
 public:
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return state_ / 4294967296.0;
  }

 private:
  std::uint32_t state_ = 1;
};

Shape square(Random& random) {
  const double x = 10.0 + 970.0 * random.next();
  const double y = 10.0 + 970.0 * random.next();
  const double dx = 4.0 * random.next();
  const double dy = 4.0 * random.next();
  return Shape::polygon({{{x, y}, {x + 4.0, y + dy}, {x + 4.0 - dx, y + 6.0}, {x - dx, y + 4.0}}});
}

template <class Work>
void time(const char* name, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  const double sum = work();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%s %.6f %.17g\n", name, seconds.count(), sum);
}

double find_paths(const World& world, Random& random, int count, double radius) {
  QueryContext context;
  Path path;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    PathQuery query{.start = {}, .goal = {}, .agent = {.radius = radius}};
    query.start.x = kSize * random.next();
    query.start.y = kSize * random.next();
    query.goal.x = kSize * random.next();
    query.goal.y = kSize * random.next();
    if (world.find_path(query, context, path).ok()) sum += path.length;
  }
  return sum;
}

}  // namespace

int main() {
  Random random;
  World world = World::create({{0.0, 0.0}, {kSize, kSize}}, {.keep_bridges = true}).value();
  time("insert_polygons", [&] {
    for (std::uint64_t id = 1; id <= 2000; ++id) world.insert(square(random), {id}).value();
    return static_cast<double>(world.vertex_count());
  });
  time("drag_polygons", [&] {
    for (std::uint64_t id = 1; id <= 2000; ++id) world.replace({id}, square(random)).value();
    return static_cast<double>(world.vertex_count());
  });
  time("point_paths", [&] { return find_paths(world, random, 1000, 0.0); });
  time("disc_paths", [&] { return find_paths(world, random, 100, 2.0); });
  time("insert_points", [&] {
    World points = World::create({{0.0, 0.0}, {kSize, kSize}}).value();
    std::vector<Point> list(100000);
    for (Point& point : list) {
      point.x = kSize * random.next();
      point.y = kSize * random.next();
    }
    points.insert_points(PointSpan(list)).value();
    return static_cast<double>(points.triangle_count());
  });
  return 0;
}

// usage: waywright_python_bench FOLDER
// The part in C++ of bench.py: reads arrays of doubles from FOLDER, does what Python does, and prints the best time of
// each measurement as a line of JSON.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using namespace waywright;

constexpr int kRounds = 5;

std::vector<Point> read_points(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::vector<Point> points(bytes.size() / sizeof(Point));
  std::copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(points.size() * sizeof(Point)),
            reinterpret_cast<char*>(points.data()));
  return points;
}

/// Prints the shortest of some times.
template <class Function>
void measure(const char* name, int rounds, const Function& function) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < rounds; ++i) {
    const auto start = std::chrono::steady_clock::now();
    function();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  std::printf("{\"name\":\"%s\",\"seconds\":%.9g}\n", name, best);
  std::fflush(stdout);
}

void measure_points(const std::vector<Point>& points) {
  measure("load points", kRounds, [&] {
    World world = World::create({{0, 0}, {1000, 1000}}).value();
    world.insert_points(points).value();
  });
}

void measure_queries(const World& world, const std::vector<Point>& starts, const std::vector<Point>& goals) {
  std::vector<PathQuery> queries(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) queries[i] = {.start = starts[i], .goal = goals[i]};
  std::vector<QueryContext> contexts(1);
  std::vector<Path> paths;
  measure("path batch", kRounds, [&] { world.find_paths(queries, contexts, paths).value(); });
  paths = {};
  measure("path batch, new memory", kRounds, [&] { world.find_paths(queries, 1).value(); });
  Path path;
  measure("path single", kRounds, [&] {
    for (const PathQuery& query : queries) world.find_path(query, contexts.front(), path).value();
  });
  RayHit hit;
  measure("ray single", kRounds, [&] {
    for (std::size_t i = 0; i < starts.size(); ++i) world.ray(starts[i], goals[i], {}, contexts.front(), hit).value();
  });
  DiscFit fit;
  measure("fit_disc single", kRounds, [&] {
    for (const Point& start : starts) world.fit_disc(start, {.radius = 0.5}, contexts.front(), fit).value();
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = std::string(argv[1]) + "/";
  measure_points(read_points(folder + "points"));
  const std::vector<Point> ends = read_points(folder + "walls");
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  std::vector<Item> walls;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) walls.push_back({{}, Shape::segment(ends[i], ends[i + 1])});
  world.insert_all(walls).value();
  measure_queries(world, read_points(folder + "starts"), read_points(folder + "goals"));
  return 0;
}

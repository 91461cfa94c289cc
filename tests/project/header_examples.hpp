#pragma once

// The names that the examples in the public headers may use. scripts/extract_examples.py makes the program.

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

// Examples declare variables that only their reader uses, and names that the fixture has, too.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wshadow"
#endif

namespace {

using namespace waywright;

int failures = 0;
const char* running = "";

/// Reports an expectation of an example that does not hold.
void check(bool holds, const char* name) {
  if (holds) return;
  std::printf("%s: `%s` has another value\n", running, name);
  ++failures;
}

/// A thread pool of a program, which has one thread.
struct Pool {
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t i = 0; i < count; ++i) job(i);
  }
};

struct Unit {
  PathQuery query;
  Path path;
};

/// A square house, item 1, and a wall, item 2.
inline World make_world() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert(Shape::rectangle({{40, 40}, {60, 60}}), 1).value();
  world.insert_segment({20, 10}, {20, 30}, 2).value();
  return world;
}

struct Fixture {
  World world = make_world();
  QueryContext context;
  Path path;
  Point start{10, 50};
  Point goal{90, 50};
  Shape house = Shape::rectangle({{70, 45}, {75, 55}});
  std::vector<PathQuery> queries = {{.start = start, .goal = goal}, {.start = goal, .goal = start}};
  std::vector<Unit> units = {{queries[0], world.find_path(queries[0]).value()}};
  Pool pool;

  static void draw_triangle(Point, Point, Point) {}
  static void draw_line(Point, Point) {}
  static void run_one_frame(World&) {}
};

template <class Example>
void run(const char* name) {
  running = name;
  try {
    Example example;
    example.run();
  } catch (const BadResult& bad) {
    std::printf("%s: %s\n", name, bad.what());
    ++failures;
  }
  set_assertion_handler(nullptr);
}

}  // namespace

#include <cstdio>
#include <waywright/waywright.hpp>

// Ends with 0 only if headers, library and language standard all came along with the target.
int main() {
  waywright::World world = waywright::World::create({{0, 0}, {4, 3}}).value();
  world.insert_segment({2, 0}, {2, 2}).value();
  const waywright::Path path = world.find_path({.start = {1, 0}, .goal = {3, 0}}).value();
  // Up and around the wall's upper end: (1, 0), (2, 2), (3, 0).
  if (path.status != waywright::PathStatus::found || path.points.size() != 3) {
    std::puts("no way around the wall");
    return 1;
  }
  return 0;
}

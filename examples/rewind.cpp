// A player places buildings. The program goes back to an earlier state, tries changes, and finds the paths that a
// building affects. docs/guides/rewind.md explains this example.

#include <cstdint>
#include <cstdio>
#include <vector>

#include "waywright/waywright.hpp"

using waywright::Change;
using waywright::Path;
using waywright::PathChanges;
using waywright::PathStatus;
using waywright::PathWatch;
using waywright::Point;
using waywright::Shape;
using waywright::World;

namespace {

const Shape kWall = Shape::segment({50, 0}, {50, 80});
const Shape kFence = Shape::segment({50, 80}, {50, 100});
const Shape kBarn = Shape::rectangle({{20, 60}, {40, 75}});
const std::vector<Point> kDoors = {{10, 50}, {90, 50}, {30, 90}};

/// Changes a world and goes back to its earlier state.
void go_back(World& world) {
  world.keep_history(8);
  const std::uint64_t before = world.mark();
  const waywright::ItemsHash hash = world.items_hash();
  world.insert(kBarn, 2).value();
  world.remove(1).value();
  std::printf("%zu item, then ", world.item_count());
  world.rewind(before).value();
  std::printf("%zu item, and the world is %s\n", world.item_count(), world.items_hash() == hash ? "as before" : "new");
}

/// Finds out how long a path would be with a building, without building it.
void try_out(World& world) {
  const auto find = [](const World& changed) { return changed.find_path({.start = {10, 50}, .goal = {90, 50}}); };
  const Path now = find(world).value();
  const Path then = world.attempt({Change::insert(kBarn)}, find).value();
  std::printf("with the barn, the path is %.2f longer\n", then.length - now.length);
  for (const Shape& shape : {kBarn, kFence}) {
    const bool walls_in = world.would_disconnect(shape, kDoors).value();
    std::printf("this building %s\n", walls_in ? "walls somebody in" : "leaves all doors connected");
  }
}

/// Finds the paths of three agents that a change affects.
void watch_paths(World& world) {
  PathWatch watch(world);
  std::vector<Path> paths;
  for (const Point& start : {Point{10, 20}, Point{10, 50}, Point{10, 95}}) {
    paths.push_back(world.find_path({.start = start, .goal = {90, 95}}).value());
    watch.add(paths.size(), paths.back());
  }
  PathChanges changes;
  world.insert(kBarn, 2).value();
  watch.update(world, changes);
  for (const std::uint64_t agent : changes.blocked) {
    std::printf("the path of agent %d is blocked\n", static_cast<int>(agent));
  }
  world.remove(1).value();
  watch.update(world, changes);
  for (const std::uint64_t agent : changes.may_be_too_long) {
    std::printf("agent %d may find a shorter path\n", static_cast<int>(agent));
  }
}

}  // namespace

int main() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert(kWall, 1).value();
  go_back(world);
  try_out(world);
  watch_paths(world);
}

// One thread changes a world, and another one finds paths in snapshots of it. docs/guides/snapshots.md explains this
// example.

#include <cstdio>
#include <thread>

#include "waywright/waywright.hpp"

using waywright::PathQuery;
using waywright::PathStatus;
using waywright::QueryContext;
using waywright::Shape;
using waywright::World;
using waywright::WorldSnapshot;

namespace {

/// A reader: it uses its own handle and its own context.
void find_paths(const WorldSnapshot& snapshot, bool& is_reachable) {
  QueryContext context;
  waywright::Path path;
  const PathQuery query{.start = {10, 50}, .goal = {90, 50}};
  for (int i = 0; i < 1000; ++i) snapshot->find_path(query, context, path).value();
  is_reachable = path.status == PathStatus::found;
}

/// The reader finds paths in the old state while this thread closes the door.
void close_door(World& world) {
  bool is_reachable = false;
  WorldSnapshot snapshot = world.publish();
  std::thread reader([copy = snapshot, &is_reachable] { find_paths(copy, is_reachable); });
  world.insert(Shape::segment({50, 80}, {50, 100}), 2).value();
  reader.join();
  std::printf("the reader %s path, with %zu item\n", is_reachable ? "found a" : "found no", snapshot->item_count());
  snapshot.release();  // its memory can be used again

  snapshot = world.publish();
  find_paths(snapshot, is_reachable);
  std::printf("then it %s path, with %zu items\n", is_reachable ? "finds a" : "finds no", snapshot->item_count());
}

/// A player fired along the line from (10, 95) to (90, 95), and the message arrives at the server a moment later. Then
/// the door has already opened.
void judge_shot(World& world) {
  world.keep_history(8);
  const std::uint64_t tick_of_shot = world.mark();
  world.remove(2).value();
  const WorldSnapshot then = world.publish(tick_of_shot).value();
  std::printf("the shot %s", then->is_clear({10, 95}, {90, 95}).value() ? "passed" : "hit the door");
  std::printf(", now it would %s\n", world.is_clear({10, 95}, {90, 95}).value() ? "pass" : "hit the door");
}

}  // namespace

int main() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert(Shape::segment({50, 0}, {50, 80}), 1).value();
  close_door(world);
  judge_shot(world);
}

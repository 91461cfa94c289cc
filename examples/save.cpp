// Saves a world, loads it again, tries a change in a copy, and writes a replay log. docs/guides/save.md explains this
// example.

#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "waywright/waywright.hpp"

using waywright::Change;
using waywright::ItemId;
using waywright::Path;
using waywright::PathStatus;
using waywright::ReplayResult;
using waywright::ReplayWriter;
using waywright::Result;
using waywright::Script;
using waywright::Shape;
using waywright::World;

namespace {

const char* const kFile = "example_save.wwb";

/// Saves the world to a file and loads it again. Returns the loaded world.
World save_and_load(const World& world) {
  const Result<void> saved = save_world_file(world, kFile);
  if (!saved) std::puts(saved.error().message().c_str());

  Result<World> loaded = waywright::load_world_file(kFile);
  if (!loaded) std::puts(loaded.error().message().c_str());
  return std::move(loaded).value();
}

/// Returns whether a building would leave a path from the left to the right.
bool keeps_path(const World& world, const Shape& building) {
  World copy = world.clone();
  copy.insert(building).value();
  const Path path = copy.find_path({.start = {5, 50}, .goal = {95, 50}}).value();
  return path.status == PathStatus::found;
}

/// Plays three ticks and writes their log.
std::string play(World& world) {
  std::ostringstream file;
  ReplayWriter log(file, world, 2);  // a hash every 2 ticks
  for (int tick = 1; tick <= 3; ++tick) {
    const std::vector<Change> changes = {Change::insert(Shape::rectangle({{10.0 * tick, 70}, {10.0 * tick + 5, 75}}))};
    const std::vector<ItemId> ids = world.apply(changes).value();
    log.record(changes, ids).value();
    log.tick(world).value();
  }
  return file.str();
}

}  // namespace

int main() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert_segment({50, 0}, {50, 80}).value();
  world.insert_polygon({{20, 20}, {30, 20}, {30, 30}}).value();

  World loaded = save_and_load(world);
  std::printf("%zu items, the same hash: %s\n", loaded.item_count(),
              loaded.items_hash() == world.items_hash() ? "yes" : "no");

  const Shape fence = Shape::rectangle({{45, 75}, {55, 95}});
  const Shape barrier = Shape::rectangle({{45, 75}, {55, 100}});
  std::printf("with the fence: %s, with the barrier: %s\n", keeps_path(loaded, fence) ? "a path" : "no path",
              keeps_path(loaded, barrier) ? "a path" : "no path");

  const std::string log = play(loaded);
  std::fputs(log.c_str(), stdout);
  const Script script = waywright::parse_script(log, "the log").value();
  const ReplayResult result = waywright::replay(script).value();
  std::printf("%d ticks, the same: %s\n", static_cast<int>(result.ticks), result.is_same ? "yes" : "no");
  std::remove(kFile);
  return result.is_same && loaded.item_count() == 5 ? 0 : 1;
}

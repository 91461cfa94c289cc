// Two players of a lockstep game carry out the same commands, each in its own world. A third player joins late and
// receives the items. At every tick all worlds have the same hash, and units take the same path in each.

#include <cstdint>
#include <cstdio>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using waywright::Change;
using waywright::Shape;
using waywright::World;

World new_world() { return World::create({{0, 0}, {1000, 1000}}).value(); }

/// The commands that the network brings at a tick: to build a house and, at some ticks, to destroy an old one. The game
/// chooses the ids, so that all players use the same ids.
std::vector<Change> commands_of(std::uint64_t tick) {
  const double x = 50.0 + static_cast<double>(tick * 137 % 900);
  const double y = 50.0 + static_cast<double>(tick * 211 % 900);
  const std::vector<waywright::Point> house = {{x, y}, {x + 40, y + 10}, {x + 30, y + 45}, {x - 10, y + 35}};
  std::vector<Change> commands{Change::insert(Shape::polygon(house), tick)};
  if (tick % 3 == 0) commands.push_back(Change::remove(tick / 3));
  return commands;
}

}  // namespace

int main() {
  constexpr std::uint64_t kTicks = 60;
  constexpr std::uint64_t kJoins = 30;
  World first = new_world();
  World second = new_world();
  World third = new_world();
  bool is_right = true;

  for (std::uint64_t tick = 1; tick <= kTicks; ++tick) {
    const std::vector<Change> commands = commands_of(tick);
    first.apply(commands).value();
    second.apply(commands).value();
    if (tick > kJoins) third.apply(commands).value();
    if (tick == kJoins) third.insert_all(first.items()).value();
    is_right = is_right && second.items_hash() == first.items_hash();
    if (tick >= kJoins) is_right = is_right && third.items_hash() == first.items_hash();
  }
  std::printf("after %d ticks and %zu houses all have the hash %s\n", static_cast<int>(kTicks), first.item_count(),
              to_string(first.items_hash()).c_str());

  const waywright::PathQuery query{.start = {1, 1}, .goal = {999, 999}};
  const waywright::Path path = first.find_path(query).value();
  for (const World* const world : {&second, &third}) {
    is_right = is_right && world->find_path(query).value().points == path.points;
    is_right = is_right && world->mesh_hash() == first.mesh_hash();
  }
  std::printf("and units take the same path, with %zu turns\n", path.points.size() - 2);
  return is_right ? 0 : 1;
}

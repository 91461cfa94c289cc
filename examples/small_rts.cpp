// A small real-time strategy game without a player: units walk where they are sent, and buildings come and go in their
// way. docs/guides/small_rts.md explains it piece by piece.

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using waywright::Box;
using waywright::ItemId;
using waywright::Path;
using waywright::PathPosition;
using waywright::PathStatus;
using waywright::Point;
using waywright::World;

constexpr Box kMap{{0, 0}, {120, 60}};  // metres
constexpr double kTick = 0.1;           // seconds
constexpr double kSpeed = 6.0;          // metres per second
constexpr double kBuildingSize = 16.0;  // metres, the largest
constexpr int kAskEvery = 20;           // ticks

struct Unit {
  PathPosition position;  // position.at is where the unit stands
  Point goal;
  Path path;
};

std::vector<Point> corners_of(const Box& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

class Game {
 public:
  /// A river flows through the map from south to north. Two bridges cross it.
  Game() : world_(World::create(kMap).value()) {
    build({{56, 0}, {64, 12}});
    build({{56, 16}, {64, 44}});
    build({{56, 48}, {64, 60}});
  }

  void add_unit(const Point& at) {
    Unit& unit = units_.emplace_back();
    unit.position.at = unit.goal = at;
    find_way(unit);
  }

  /// Sends all units to places beside each other, around `goal`.
  void send_all(const Point& goal) {
    double offset = -0.5 * static_cast<double>(units_.size() - 1);
    for (Unit& unit : units_) {
      unit.goal = {goal.x, goal.y + 2 * offset};
      offset += 1;
      find_way(unit);
    }
  }

  ItemId build(const Box& box) {
    const std::uint64_t before = world_.version();
    const ItemId id = world_.insert_polygon(corners_of(box)).value();
    ask_again(before);
    return id;
  }

  void destroy(ItemId building) {
    const std::uint64_t before = world_.version();
    world_.remove(building).value();
    ask_again(before);
  }

  void tick() {
    ++tick_;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      Unit& unit = units_[i];
      if ((static_cast<std::size_t>(tick_) + i) % kAskEvery == 0) find_way(unit);
      if (unit.path.status == PathStatus::found) {
        unit.position = unit.path.advance(unit.position, kSpeed * kTick);
      }
    }
  }

  /// The map in characters: `#` is a building or the river, a letter is a unit.
  void print(const char* title) const {
    constexpr double kWidth = 2;   // of a character, in metres
    constexpr double kHeight = 4;  // of a line
    std::printf("%.1f s: %s\n", kTick * tick_, title);
    for (double y = kMap.max.y - kHeight / 2; y > kMap.min.y; y -= kHeight) {
      std::string line;
      for (double x = kMap.min.x + kWidth / 2; x < kMap.max.x; x += kWidth) {
        char letter = world_.locate({x, y}).value().inside.empty() ? '.' : '#';
        for (std::size_t i = 0; i < units_.size(); ++i) {
          const Point at = units_[i].position.at;
          const bool is_in_x = at.x >= x - kWidth / 2 && at.x < x + kWidth / 2;
          const bool is_in_y = at.y >= y - kHeight / 2 && at.y < y + kHeight / 2;
          if (is_in_x && is_in_y) letter = static_cast<char>('a' + i);
        }
        line += letter;
      }
      std::puts(line.c_str());
    }
  }

 private:
  void find_way(Unit& unit) {
    world_
        .find_path({.start = unit.position.at, .goal = unit.goal, .end_tolerance = kBuildingSize}, context_, unit.path)
        .value();
    if (unit.path.status == PathStatus::found) unit.position = unit.path.at(0);
  }

  /// After a change of the world: finds new ways for the units whose path is blocked now.
  void ask_again(std::uint64_t before) {
    int count = 0;
    for (Unit& unit : units_) {
      if (!world_.is_affected(unit.path.points, before)) continue;
      if (world_.is_clear(unit.path.points, context_).value()) continue;
      find_way(unit);
      ++count;
    }
    if (count > 0) std::printf("%.1f s: %d units need a new way\n", kTick * tick_, count);
  }

  World world_;
  waywright::QueryContext context_;
  std::vector<Unit> units_;
  int tick_ = 0;
};

}  // namespace

int main() {
  Game game;
  for (const double y : {4.0, 8.0, 12.0, 16.0}) game.add_unit({8, y});
  game.send_all({112, 14});
  for (int i = 0; i < 60; ++i) game.tick();
  game.print("four units walk east, to the bridge in the south");

  const ItemId tower = game.build({{52, 8}, {60, 20}});
  for (int i = 0; i < 80; ++i) game.tick();
  game.print("a tower blocks the bridge, so they turn to the other one");

  game.destroy(tower);
  game.build({{60, 40}, {70, 56}});
  for (int i = 0; i < 120; ++i) game.tick();
  game.print("the tower is gone, and now the other bridge is blocked");
  return 0;
}

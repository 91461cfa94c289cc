// A small real-time strategy game that plays by itself: units walk to the goals that they are given, and buildings
// appear and disappear on their paths. docs/guides/small_rts.md explains it piece by piece.

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using waywright::Box;
using waywright::ItemId;
using waywright::Path;
using waywright::PathPosition;
using waywright::PathQuery;
using waywright::PathStatus;
using waywright::Point;
using waywright::Shape;
using waywright::World;

constexpr Box kMap{{0, 0}, {120, 60}};  // metres
constexpr double kTick = 0.1;           // seconds
constexpr double kSpeed = 6.0;          // metres per second
constexpr double kBuildingSize = 16.0;  // metres, the largest
constexpr std::size_t kAskEvery = 20;   // ticks

struct Unit {
  PathPosition position;  // position.at is where the unit stands
  Point goal;
  Path path;
};

class Game {
 public:
  /// A river flows through the map from south to north. It has two fords.
  Game() : world_(World::create(kMap).value()) {
    build({{56, 0}, {64, 12}});
    build({{56, 16}, {64, 44}});
    build({{56, 48}, {64, 60}});
  }

  void add_unit(const Point& at) {
    Unit& unit = units_.emplace_back();
    unit.position.at = unit.goal = at;
    find_path(unit);
  }

  /// Sends all units to points beside each other, around `goal`.
  void send_all(const Point& goal) {
    double y = goal.y - static_cast<double>(units_.size() - 1);
    for (Unit& unit : units_) {
      unit.goal = {goal.x, y};
      y += 2;
      find_path(unit);
    }
  }

  ItemId build(const Box& box) {
    const std::uint64_t before = world_.version();
    const ItemId id = world_.insert(Shape::rectangle(box)).value();
    ask_again(before);
    return id;
  }

  void destroy(ItemId building) {
    const std::uint64_t before = world_.version();
    world_.remove(building).value();
    ask_again(before);
  }

  void run(int ticks) {
    for (const int end = tick_ + ticks; tick_ < end; ++tick_) {
      for (std::size_t i = 0; i < units_.size(); ++i) {
        Unit& unit = units_[i];
        const bool asks = (static_cast<std::size_t>(tick_) + i) % kAskEvery == 0;
        if (asks) find_path(unit);
        if (unit.path.status != PathStatus::found) continue;
        unit.position = unit.path.advance(unit.position, kSpeed * kTick);
      }
    }
  }

  /// Returns the map in characters of 2 x 4 metres: `#` is a building or the river, a letter is a unit.
  void print(const char* title) const {
    std::printf("%.1f s: %s\n", kTick * tick_, title);
    for (double y = kMap.max.y - 2; y > kMap.min.y; y -= 4) {
      std::string line;
      for (double x = kMap.min.x + 1; x < kMap.max.x; x += 2) {
        char letter = world_.locate({x, y}).value().polygons.empty() ? '.' : '#';
        for (std::size_t i = 0; i < units_.size(); ++i) {
          const Point at = units_[i].position.at;
          if (at.x >= x - 1 && at.x < x + 1 && at.y >= y - 2 && at.y < y + 2) letter = static_cast<char>('a' + i);
        }
        line += letter;
      }
      std::puts(line.c_str());
    }
  }

 private:
  void find_path(Unit& unit) {
    const PathQuery query{.start = unit.position.at, .goal = unit.goal, .end_tolerance = kBuildingSize};
    world_.find_path(query, context_, unit.path).value();
    if (unit.path.status != PathStatus::found) return;
    unit.position = unit.path.at(0);
    if (unit.path.moved_start) std::printf("%.1f s: a unit steps aside\n", kTick * tick_);
  }

  /// After a change of the world: finds new paths for the units whose path is blocked now.
  void ask_again(std::uint64_t before) {
    int count = 0;
    for (Unit& unit : units_) {
      if (unit.path.points.empty()) continue;
      const auto ahead = std::span(unit.path.points).subspan(unit.position.segment);
      if (!world_.is_affected(ahead, before) || world_.is_clear(ahead, {}, context_).value()) continue;
      find_path(unit);
      ++count;
    }
    if (count > 0) std::printf("%.1f s: %d units need a new path\n", kTick * tick_, count);
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
  game.run(60);
  game.print("four units walk east, to the ford in the south");

  const ItemId tower = game.build({{52, 8}, {60, 20}});
  game.run(12);
  game.print("a tower blocks the ford, so they turn to the other one");

  game.destroy(tower);
  game.run(36);
  game.print("the tower is gone, so they have turned back");

  game.build({{56, 12}, {64, 16}});
  game.run(180);
  game.print("a house pushed them out of the ford, and all are there");
}

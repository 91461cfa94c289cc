// Units follow their paths while the program inserts and removes buildings. docs/guides/moving_a_unit.md explains the
// functions. The program checks its results, and exits with an error if a check fails.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using waywright::ItemId;
using waywright::Path;
using waywright::PathPosition;
using waywright::PathQuery;
using waywright::PathSearch;
using waywright::PathStatus;
using waywright::Point;
using waywright::Precision;
using waywright::QueryContext;
using waywright::World;

// ---- One unit ----

struct Unit {
  PathPosition position;  // position.at is where the unit stands, position.heading where it looks
  Point goal;
  Path path;
};

/// Returns whether there is a path to the goal.
bool find_path(const World& world, QueryContext& context, Unit& unit) {
  const PathQuery query{.start = unit.position.at, .goal = unit.goal};
  world.find_path(query, context, unit.path).value();
  if (unit.path.status != PathStatus::found) return false;
  unit.position = unit.path.at(0);
  return true;
}

/// Moves the unit by one tick. Returns whether it is at its goal.
bool walk(Unit& unit, double step) {
  unit.position = unit.path.advance(unit.position, step);
  return unit.position.distance >= unit.path.length;
}

// ---- A unit that keeps its position as float ----

struct FloatUnit {
  float x = 0;
  float y = 0;
  Path path;
  PathPosition position;
};

void walk(FloatUnit& unit, double step) {
  unit.position = unit.path.advance(unit.position, step, Precision::float32);
  unit.x = static_cast<float>(unit.position.at.x);  // exact
  unit.y = static_cast<float>(unit.position.at.y);
}

// ---- Ends that are blocked ----

/// Does what find_path does. If the unit or its goal is inside a building, moves it to the nearest free position within
/// `tolerance`.
bool find_path_with_moved_ends(const World& world, QueryContext& context, Unit& unit, double tolerance) {
  const PathQuery query{.start = unit.position.at, .goal = unit.goal, .end_tolerance = tolerance};
  world.find_path(query, context, unit.path).value();
  if (unit.path.status == PathStatus::start_blocked || unit.path.status == PathStatus::goal_blocked) {
    for (const ItemId id : unit.path.blockers)
      std::printf("blocked by item %ju\n", static_cast<std::uintmax_t>(id.value));
  }
  if (unit.path.status != PathStatus::found) return false;
  if (unit.path.moved_goal) unit.goal = unit.path.moved_goal->to;
  unit.position = unit.path.at(0);  // at moved_start->to, if the start was moved
  return true;
}

// ---- A unit that was pushed off its path ----

void return_to_path(const World& world, QueryContext& context, Unit& unit, const Point& pushed_to) {
  const PathPosition nearest = unit.path.nearest(pushed_to);
  unit.position.at = pushed_to;
  if (world.is_clear(pushed_to, nearest.at, {}, context).value()) {
    unit.position = nearest;  // or let the unit walk there first
  } else {
    find_path(world, context, unit);
  }
}

// ---- After a change of the world ----

/// Finds new paths for the units whose paths a change blocks. `before` is World::version() before the change.
std::size_t find_new_paths(const World& world, QueryContext& context, std::span<Unit> units, std::uint64_t before) {
  std::size_t count = 0;
  for (Unit& unit : units) {
    if (!world.is_affected(unit.path.points, before)) continue;
    const auto rest = std::span(unit.path.points).subspan(unit.position.segment);
    if (world.is_clear(rest, {}, context).value()) continue;
    find_path(world, context, unit);
    ++count;
  }
  return count;
}

// ---- Searches in slices ----

/// Finds paths for units that wait for them. Limits the work in each frame.
class PathQueue {
 public:
  void ask(Unit& unit) { waiting_.push_back(&unit); }

  /// Continues to search, for `slices` slices of 250 triangles each. Returns whether no unit waits any more.
  bool work(const World& world, int slices) {
    for (; slices > 0 && !waiting_.empty(); --slices) {
      Unit& unit = *waiting_.front();
      if (!search_.is_running()) search_.begin(world, {.start = unit.position.at, .goal = unit.goal}).value();
      if (!search_.step(250).value()) continue;
      unit.path = search_.path();
      if (unit.path.status == PathStatus::found) unit.position = unit.path.at(0);
      waiting_.pop_front();
    }
    return waiting_.empty();
  }

 private:
  PathSearch search_;
  std::deque<Unit*> waiting_;
};

// ---- Many units ----

/// Finds paths for all units, on as many threads as there are contexts.
void find_all_paths(const World& world, std::span<QueryContext> contexts, std::span<Unit> units) {
  std::vector<PathQuery> queries;
  for (const Unit& unit : units) queries.push_back({.start = unit.position.at, .goal = unit.goal});
  std::vector<Path> paths;
  world.find_paths(queries, contexts, paths).value();
  for (std::size_t i = 0; i < units.size(); ++i) {
    units[i].path = std::move(paths[i]);
    if (units[i].path.status == PathStatus::found) units[i].position = units[i].path.at(0);
  }
}

// ---- The checks ----

bool is_right = true;

void expect(bool condition, const char* what) {
  if (condition) return;
  std::printf("wrong: %s\n", what);
  is_right = false;
}

bool is_blocked(const World& world, const Point& point) {
  const PathQuery query{.start = point, .goal = {1, 1}, .end_tolerance = 0};
  return world.find_path(query).value().status == PathStatus::start_blocked;
}

/// A triangle. The path leads along one of its slanted sides.
World world_with_triangle() {
  World world = World::create({{0, 0}, {100, 100}}).value();
  world.insert_polygon({{20, 0}, {80, 0}, {61, 47}, {33, 53}}, 1).value();
  return world;
}

void check_one_unit() {
  const World world = world_with_triangle();
  QueryContext context;
  Unit unit{.position = {}, .goal = {95, 10}, .path = {}};
  unit.position.at = {5, 10};
  FloatUnit copy;
  expect(find_path(world, context, unit), "there is a path");
  copy.path = unit.path;
  bool is_there = false;
  for (int tick = 0; tick < 1000 && !is_there; ++tick) {
    is_there = walk(unit, 0.3);
    walk(copy, 0.3);
    expect(!is_blocked(world, unit.position.at), "the unit stands on a free position");
    expect(!is_blocked(world, {copy.x, copy.y}), "and so does the one in float");
  }
  expect(is_there && unit.position.at == unit.goal, "the unit gets to its goal");
}

/// If a program computes positions on a path by itself, rounding may put them inside a polygon, or beyond a wall
/// without thickness. The positions that the library computes here never lie there.
void check_positions() {
  const World with_triangle = world_with_triangle();
  World with_fence = World::create({{0, 0}, {100, 100}}).value();
  with_fence.insert_polyline({{20, 5}, {33, 53}, {61, 47}, {80, 0}}, 1).value();
  const Path path = with_triangle.find_path({.start = {5, 10}, .goal = {95, 10}}).value();
  const Point& a = path.points[1];
  const Point& b = path.points[2];
  const double before = path.nearest(a).distance;
  const double length = path.nearest(b).distance - before;
  int blocked_by_hand = 0;
  int beyond_by_hand = 0;
  for (int i = 1; i < 1000; ++i) {
    const double share = i / 1000.0;
    const Point by_hand{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    blocked_by_hand += is_blocked(with_triangle, by_hand) ? 1 : 0;
    beyond_by_hand += with_fence.is_clear(std::vector<Point>{path.points[0], a, by_hand}).value() ? 0 : 1;
    const Point position = path.at(before + share * length).at;
    expect(!is_blocked(with_triangle, position), "a position from the library is free");
    expect(with_fence.is_clear(std::vector<Point>{path.points[0], a, position}).value(), "and right of a fence");
  }
  std::printf("of 999 positions computed by hand, %d lie inside a polygon, %d beyond a fence\n", blocked_by_hand,
              beyond_by_hand);
  expect(blocked_by_hand > 0 && beyond_by_hand > 0, "positions computed by hand can be wrong");
}

void check_blocked_ends() {
  World world = world_with_triangle();
  QueryContext context;
  Unit unit{.position = {}, .goal = {50, 20}, .path = {}};  // a goal inside the triangle
  unit.position.at = {5, 10};
  expect(!find_path(world, context, unit) && unit.path.blockers == std::vector<ItemId>{1}, "the goal is blocked");
  expect(find_path_with_moved_ends(world, context, unit, 30) && !is_blocked(world, unit.goal),
         "a free goal is taken instead");

  world.insert_polygon({{1, 5}, {11, 5}, {11, 13}, {1, 13}}, 2).value();  // on the unit
  expect(find_path_with_moved_ends(world, context, unit, 30) && unit.position.at == Point{5, 13},
         "the unit goes out of the house");

  return_to_path(world, context, unit, {6, 15});
  expect(unit.position.distance > 0 && world.is_clear({6, 15}, unit.position.at).value(),
         "the unit continues from the nearest position on its path");
}

void check_changes() {
  World world = world_with_triangle();
  std::vector<QueryContext> contexts(2);
  std::vector<Unit> units(20);
  for (std::size_t i = 0; i < units.size(); ++i) {
    units[i].position.at = {2.0, 5.0 + 4.0 * static_cast<double>(i)};
    units[i].goal = {98.0, 90.0 - 4.0 * static_cast<double>(i)};
  }
  find_all_paths(world, contexts, units);

  PathQueue queue;
  for (Unit& unit : units) queue.ask(unit);
  std::vector<Path> before;
  for (const Unit& unit : units) before.push_back(unit.path);
  int frames = 1;
  while (!queue.work(world, 4)) ++frames;
  expect(frames == 5, "each of the 20 searches takes one slice");
  for (std::size_t i = 0; i < units.size(); ++i) expect(units[i].path.points == before[i].points, "the same paths");

  const std::uint64_t version = world.version();
  world.insert_segment({47, 53}, {47, 99}, 3).value();  // leaves a gap above its upper end
  expect(find_new_paths(world, contexts[0], units, version) > 0, "the wall blocks paths");
  for (const Unit& unit : units) {
    expect(unit.path.status == PathStatus::found && world.is_clear(unit.path.points).value(), "all paths are clear");
  }
  const std::uint64_t later = world.version();
  world.insert_point({50, 1}, 4).value();
  expect(find_new_paths(world, contexts[0], units, later) == 0, "a point blocks nothing");
}

}  // namespace

int main() {
  check_one_unit();
  check_positions();
  check_blocked_ends();
  check_changes();
  return is_right ? 0 : 1;
}

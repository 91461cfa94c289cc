#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/change.hpp"
#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/random.hpp"

// Operations that make and open many walls at once, far from each other and close to each other. Sets of rooms with
// common walls say which rooms are connected, and know nothing of a mesh.

namespace waywright::test {
namespace {

constexpr double kRoom = 10;

/// A grid of rooms. Each wall between two rooms may exist or not. Each room has 0 to 30 points, so that the rooms have
/// different numbers of faces.
class Rooms {
 public:
  Rooms(std::size_t columns, std::size_t rows, std::uint64_t seed) : columns_(columns), rows_(rows), random_(seed) {
    world_ = World::create({{0, 0}, {kRoom * static_cast<double>(columns), kRoom * static_cast<double>(rows)}}).value();
    std::vector<Point> points;
    for (std::size_t room = 0; room < columns * rows; ++room) {
      for (std::size_t i = random_.below(2) * random_.below(31); i-- > 0;) points.push_back(place_in(room));
      if ((room + 1) % columns != 0) walls_.push_back({room, room + 1, false});
      if (room + columns < columns * rows) walls_.push_back({room, room + columns, false});
    }
    if (!points.empty()) world_.insert_points(points, {1'000'000}).value();
  }

  /// Makes or opens up to `count` walls in one operation.
  void change_walls(std::size_t count) {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t wall = random_.below(walls_.size());
      walls_[wall].exists = !walls_[wall].exists;
      changes.push_back(walls_[wall].exists ? Change::insert(shape_of(wall), {wall + 1}) : Change::remove({wall + 1}));
    }
    world_.apply(changes).value();
  }

  /// Compares whether paths exist between room `from` and all other rooms with the sets of rooms.
  void check(std::size_t from) {
    const std::vector<std::size_t> sets = connected_sets();
    QueryContext context;
    Path path;
    for (std::size_t to = 0; to < sets.size(); ++to) {
      world_.find_path({.start = centre(from), .goal = centre(to)}, context, path).value();
      ASSERT_EQ(path.status == PathStatus::found, sets[from] == sets[to]) << "from room " << from << " to room " << to;
    }
    const Validation validation = world_.validate();
    ASSERT_TRUE(validation.ok) << validation.fault;
  }
  std::size_t random_room() { return random_.below(columns_ * rows_); }
  std::size_t random_count() { return 1 + random_.below(walls_.size()); }

 private:
  struct Wall {
    std::size_t room, other;
    bool exists;
  };

  [[nodiscard]] Point centre(std::size_t room) const {
    return {kRoom * (static_cast<double>(room % columns_) + 0.5), kRoom * (static_cast<double>(room / columns_) + 0.5)};
  }
  [[nodiscard]] Point place_in(std::size_t room) {
    const auto offset = [&] { return static_cast<double>(random_.between(-450, 450)) / 100; };
    return centre(room) + Point{offset(), offset()};
  }
  [[nodiscard]] Shape shape_of(std::size_t wall) const {
    const Point a = centre(walls_[wall].room);
    const bool is_upright = walls_[wall].other == walls_[wall].room + 1;
    return is_upright ? Shape::segment(a + Point{kRoom / 2, -kRoom / 2}, a + Point{kRoom / 2, kRoom / 2})
                      : Shape::segment(a + Point{-kRoom / 2, kRoom / 2}, a + Point{kRoom / 2, kRoom / 2});
  }
  /// Returns the set of each room.
  [[nodiscard]] std::vector<std::size_t> connected_sets() const {
    std::vector<std::size_t> sets(columns_ * rows_);
    std::iota(sets.begin(), sets.end(), std::size_t{0});
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const Wall& wall : walls_) {
        if (wall.exists || sets[wall.room] == sets[wall.other]) continue;
        sets[wall.room] = sets[wall.other] = std::min(sets[wall.room], sets[wall.other]);
        has_changed = true;
      }
    }
    return sets;
  }

  std::size_t columns_, rows_;
  Random random_;
  std::vector<Wall> walls_;
  World world_ = World::create({{0, 0}, {1, 1}}).value();
};

void play(std::size_t columns, std::size_t rows) {
  for (std::uint64_t seed = 1; seed <= 1 + case_count() / 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rooms rooms(columns, rows, seed);
    for (int i = 0; i < 30; ++i) {
      rooms.change_walls(rooms.random_count());
      rooms.check(rooms.random_room());
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Rooms, OfAnAlleyAreConnectedAsTheirWallsSay) { play(16, 1); }
TEST(Rooms, OfALongAlleyAreConnectedAsTheirWallsSay) { play(60, 1); }
TEST(Rooms, OfAGridAreConnectedAsTheirWallsSay) { play(6, 6); }

// The room between two new walls is the smallest of three pieces. When the library has found this piece, it must still
// find out that no way leads from the left of it to the right.
TEST(Rooms, OnBothSidesOfASmallRoomAreDivided) {
  World world = World::create({{0, 0}, {1000, 10}}).value();
  std::vector<Point> points;
  for (int i = 1; i < 1000; ++i) {
    points.push_back({static_cast<double>(i) + 0.5, 5 * static_cast<double>(i % 3)});
  }
  world.insert_points(points).value();
  world
      .apply({Change::insert(Shape::segment({480, 0}, {480, 10})), Change::insert(Shape::segment({520, 0}, {520, 10}))})
      .value();
  for (const auto& [start, goal] : {std::pair{100.0, 900.0}, {100.0, 500.0}, {500.0, 900.0}})
    EXPECT_EQ(world.find_path({.start = {start, 5}, .goal = {goal, 5}}).value().status, PathStatus::no_path);
  EXPECT_EQ(world.find_path({.start = {100, 5}, .goal = {400, 5}}).value().status, PathStatus::found);
  EXPECT_TRUE(world.validate().ok);
}

}  // namespace
}  // namespace waywright::test

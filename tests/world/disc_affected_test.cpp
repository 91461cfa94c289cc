#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "path/pieces.hpp"
#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_paths.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

TEST(AffectedDiscPaths, APolylineTakesAnAgent) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  const std::vector<Point> line = {{10, 50}, {90, 50}};
  const std::uint64_t before = world.version();
  world.insert_segment({40, 54}, {60, 54}).value();
  EXPECT_FALSE(world.is_affected(line, before));
  EXPECT_FALSE(world.is_affected(line, before, {.radius = 3}));
  EXPECT_TRUE(world.is_affected(line, before, {.radius = 4}));
  EXPECT_TRUE(world.is_affected(std::span(line).first(1), before, {.radius = 31}));
  EXPECT_FALSE(world.is_affected(std::span(line).first(1), before, {.radius = 30}));
  EXPECT_FALSE(world.is_affected({}, before, {.radius = 1000}));
  EXPECT_FALSE(world.is_affected(line, before, {.radius = -1}));
}

TEST(AffectedDiscPaths, OnlyPointsCanBeClear) {
  const World world = World::create({{0, 0}, {100, 100}}).value();
  EXPECT_TRUE(world.is_clear({10, 50}, {90, 50}).value());
  EXPECT_EQ(world.is_clear({10, 50}, {90, 50}, {.radius = 5}).error().code, ErrorCode::not_supported);
  EXPECT_EQ(world.is_clear({10, 50}, {90, 50}, {.radius = -5}).error().code, ErrorCode::bad_radius);
}

TEST(AffectedDiscPaths, AreNearAnItem) {
  World world = world_of_hundred();
  const Path path = world.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
  std::uint64_t version = world.version();
  const auto is_affected_by = [&](const Shape& shape) {
    version = world.version();
    world.insert(shape).value();
    return world.is_affected(path, version);
  };
  EXPECT_FALSE(world.is_affected(path, version));
  EXPECT_FALSE(is_affected_by(Shape::segment({10, 55.01}, {90, 55.01})));
  EXPECT_TRUE(is_affected_by(Shape::segment({10, 55}, {90, 55}))) << "the disc touches it";
  EXPECT_FALSE(is_affected_by(Shape::segment({10, 40}, {14.99, 60})));
  EXPECT_TRUE(is_affected_by(Shape::segment({10, 40}, {15.01, 60})));
  EXPECT_FALSE(is_affected_by(Shape::segment({10, 40}, {16.4, 46.4}))) << "the disc is round: 3.6^2 + 3.6^2 > 5^2";
  EXPECT_TRUE(is_affected_by(Shape::segment({10, 40}, {16.5, 46.5})));
  EXPECT_FALSE(is_affected_by(Shape::point({50, 50}))) << "a point is no wall";
  EXPECT_TRUE(is_affected_by(Shape::segment({50, 40}, {50, 60})));
  EXPECT_TRUE(is_affected_by(Shape::rectangle({{1, 1}, {99, 99}}))) << "the path is in its interior";
}

TEST(AffectedDiscPaths, EndAtTheirGoal) {
  World world = world_of_hundred();
  const Path path = world.find_path({.start = {20, 20}, .goal = {50, 50}, .agent = {.radius = 5}}).value();
  const std::uint64_t version = world.version();
  world.insert_segment({53.6, 53.6}, {60, 60}).value();
  EXPECT_FALSE(world.is_affected(path, version)) << "the line of the path leads to it";
  world.insert_segment({53.5, 53.5}, {60, 60}).value();
  EXPECT_TRUE(world.is_affected(path, version));
}

// A line of a path is as far as the radius from the corner around which the path turns next, up to rounding errors.
TEST(AffectedDiscPaths, TouchTheirCorners) {
  std::size_t lines = 0;
  disc::for_each_path([&](const disc::NamedScene&, const disc::Walls&, const Path& path) {
    for (std::size_t i = 1; i < path.pieces.size(); ++i) {
      const std::span two(path.pieces.data() + i - 1, 2);
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const Point corner = two[1 - k].centre;
        if (two[k].kind != PathPiece::Kind::line || two[1 - k].kind != PathPiece::Kind::arc) continue;
        ++lines;
        ASSERT_TRUE(path::may_touch(two.subspan(k, 1), path.agent.radius, {corner, corner})) << "piece " << i - 1 + k;
      }
    }
  });
  EXPECT_GT(lines, 100U);
}

TEST(AffectedDiscPaths, CountReplacementsAndRemovals) {
  World world = world_of_hundred();
  world.insert_segment({50, 0}, {50, 44}, 1).value();
  world.insert_segment({50, 0}, {60, 10}, 2).value();
  const Path path = world.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
  std::uint64_t version = world.version();
  world.replace(1, Shape::segment({50, 0}, {50, 43})).value();
  EXPECT_FALSE(world.is_affected(path, version));
  world.replace(1, Shape::segment({50, 0}, {50, 45})).value();
  EXPECT_TRUE(world.is_affected(path, version));
  version = world.version();
  world.remove(2).value();
  EXPECT_FALSE(world.is_affected(path, version));
  world.remove(1).value();
  EXPECT_TRUE(world.is_affected(path, version)) << "a shorter path may be there";
}

TEST(AffectedDiscPaths, TurnAroundCorners) {
  World world = world_of_hundred();
  world.insert_segment({50, 0}, {50, 60}, 1).value();
  const Path path = world.find_path({.start = {40, 10}, .goal = {60, 10}, .agent = {.radius = 10}}).value();
  const auto is_affected_by = [&](Point a, Point b) {
    const std::uint64_t version = world.version();
    world.insert_segment(a, b).value();
    return world.is_affected(path, version);
  };
  ASSERT_EQ(path.pieces.size(), 3U);
  EXPECT_FALSE(is_affected_by({45, 80.4}, {55, 81}));
  EXPECT_TRUE(is_affected_by({45, 80}, {55, 81})) << "it touches the disc above the corner";
  EXPECT_FALSE(is_affected_by({64.6, 74.6}, {70, 80})) << "beyond the circle of radius 20";
  EXPECT_TRUE(is_affected_by({64.1, 74.1}, {70, 80}));
  EXPECT_TRUE(is_affected_by({49, 62}, {51, 63})) << "between the corner and the arc";
}

TEST(AffectedPaths, WithoutPointsAreAffectedByEachBox) {
  World world = world_of_hundred();
  const std::vector<Point> goals = {{80, 50}};
  for (const double radius : {0.0, 5.0}) {
    const Path path =
        world.find_paths_from({.start = {20, 50}, .goals = goals, .agent = {.radius = radius}}).value()[0];
    ASSERT_EQ(path.status, PathStatus::found);
    const std::uint64_t version = world.version();
    EXPECT_FALSE(world.is_affected(path, version));
    world.insert_point({50, 50}).value();
    EXPECT_FALSE(world.is_affected(path, version)) << "a point is no wall, so there is no box";
    world.insert_segment({50, 0}, {50, 100}).value();
    EXPECT_TRUE(world.is_affected(path, version));
    world.remove(world.largest_id_seen()).value();
  }
}

TEST(AffectedDiscPaths, CanBeOnePosition) {
  World world = world_of_hundred();
  const std::vector<Path> paths{world.find_path({.start = {50, 50}, .goal = {50, 50}, .agent = {.radius = 5}}).value(),
                                world.find_path({.start = {50, 50}, .goal = {50, 50}}).value()};
  const std::uint64_t version = world.version();
  std::vector<std::size_t> affected;
  world.insert_segment({53.6, 53.6}, {60, 60}).value();
  world.find_affected(paths, version, affected);
  EXPECT_TRUE(affected.empty());
  world.insert_segment({53.5, 53.5}, {60, 60}).value();
  world.find_affected(paths, version, affected);
  EXPECT_EQ(affected, (std::vector<std::size_t>{0}));
}

/// The boxes of items of a huge extent have corners far away from every path.
TEST(AffectedDiscPaths, AreFoundInHugeBoxes) {
  World world = World::create({{-0x1p100, -0x1p100}, {0x1p100, 0x1p100}}, {.keep_bridges = true}).value();
  const Path path = world.find_path({.start = {1, 1}, .goal = {4, 5}, .agent = {.radius = 0.5}}).value();
  const auto is_affected_by = [&](Point a, Point b) {
    const std::uint64_t version = world.version();
    world.insert_segment(a, b).value();
    return world.is_affected(path, version);
  };
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_FALSE(is_affected_by({-0x1p99, 5.6}, {0x1p99, 5.6}));
  EXPECT_FALSE(is_affected_by({4.6, -0x1p99}, {0x1p99, 0x1p99}));
  EXPECT_TRUE(is_affected_by({4.5, -0x1p99}, {4.5, 0x1p99}));
  EXPECT_TRUE(is_affected_by({-0x1p99, 3}, {0x1p99, 3}));
  EXPECT_TRUE(is_affected_by({-0x1p99, -0x1p99}, {0x1p99, 0x1p98}));
}

/// A world whose items change, its walls, and paths of discs that stay valid as long as they are not affected.
class ChangingWorld {
 public:
  ChangingWorld(std::uint64_t seed, const disc::NamedScene& scene)
      : random_(seed), scene_(scene), world_(disc::world_of(scene)), size_(scene.domain.max.x) {
    for (const auto& [start, goal] : scene.queries) {
      for (const double radius : scene.radii)
        queries_.push_back({.start = start, .goal = goal, .agent = {.radius = radius}});
    }
    paths_.resize(queries_.size());
    const disc::Walls walls = live_walls();
    for (std::size_t i = 0; i < queries_.size(); ++i) search(walls, i);
  }

  void change() {
    const std::uint64_t before = world_.version();
    const std::vector<Item> live = world_.items();
    const ItemId victim = live.empty() ? ItemId{} : live[random_.below(live.size())].id;
    switch (random_.below(live.empty() ? 2 : 5)) {
      case 0:
        world_.apply({Change::insert(shape()), Change::insert(shape())}).value();
        break;
      case 1:
        world_.insert(shape()).value();
        break;
      case 2:
        world_.replace(victim, shape()).value();
        break;
      default:
        world_.remove(victim).value();
    }
    check(before);
  }

  std::size_t kept = 0;         ///< paths that an operation did not affect
  std::size_t affected = 0;     ///< paths that an operation affected
  std::size_t still_valid = 0;  ///< affected paths on which no wall is nearer than the radius
  std::size_t wrong = 0;        ///< new paths that are not valid

 private:
  [[nodiscard]] std::string fault_of(const disc::Walls& walls, std::size_t i) const {
    const PathQuery& query = queries_[i];
    return disc::check_path(walls, query.start, query.goal, query.agent.radius, disc::pieces_of(paths_[i])).fault;
  }

  /// Searches for a path, and keeps it if the oracle finds it valid.
  void search(const disc::Walls& walls, std::size_t i) {
    world_.find_path(queries_[i], context_, paths_[i]).value();
    if (paths_[i].status != PathStatus::found || fault_of(walls, i).empty()) return;
    paths_[i] = {};
    ++wrong;
  }

  void check(std::uint64_t before) {
    const disc::Walls walls = live_walls();
    std::vector<std::size_t> listed;
    world_.find_affected(paths_, before, listed);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (paths_[i].status != PathStatus::found) {
        search(walls, i);
        continue;
      }
      const bool is_listed = std::find(listed.begin(), listed.end(), i) != listed.end();
      ASSERT_EQ(is_listed, world_.is_affected(paths_[i], before));
      const std::string fault = fault_of(walls, i);
      if (!is_listed) {
        ++kept;
        ASSERT_EQ(fault, "") << "path " << i << " was not affected";
        continue;
      }
      ++affected;
      still_valid += fault.empty() ? 1 : 0;
      search(walls, i);
    }
  }

  [[nodiscard]] disc::Walls live_walls() const {
    disc::NamedScene now = scene_;
    now.walls.segments.clear();
    for (const Item& item : world_.items()) {
      for (const auto& ring : item.shape.rings) {
        for (std::size_t i = 1; i < ring.size(); ++i) now.walls.segments.emplace_back(ring[i - 1], ring[i]);
        if (item.shape.kind == ItemKind::polygon) now.walls.segments.emplace_back(ring.back(), ring.front());
      }
    }
    return disc::walls_of(now);
  }

  double fraction() { return static_cast<double>(random_.between(0, 1 << 30)) * 0x1p-30; }
  [[nodiscard]] Point inside(Point p) const { return {std::clamp(p.x, 0.0, size_), std::clamp(p.y, 0.0, size_)}; }

  /// Returns a position near a path, often about as far from it as its radius.
  Point near_a_path() {
    const Path& path = paths_[random_.below(paths_.size())];
    if (path.status != PathStatus::found || random_.chance(20)) return {size_ * fraction(), size_ * fraction()};
    const PathPosition position = path.at(path.length * fraction());
    const double away = path.agent.radius * (random_.chance(50) ? 0.9 + 0.3 * fraction() : 4 * fraction());
    const Point left{-position.heading.y, position.heading.x};
    return inside(position.at + (random_.chance(50) ? away : -away) * left);
  }

  Shape shape() {
    const Point p = near_a_path();
    const auto step = [&] { return size_ * (random_.chance(50) ? 0.02 : 0.2) * (2 * fraction() - 1); };
    const Point q = inside(p + Point{step(), step()});
    const Point r = inside(p + Point{step(), step()});
    const std::size_t kind = random_.below(3);
    if (kind == 0) return Shape::segment(p, q);
    return kind == 1 ? Shape::polyline({p, q, r}) : Shape::polygon({p, q, r});
  }

  Random random_;
  const disc::NamedScene& scene_;
  World world_;
  double size_;
  QueryContext context_;
  std::vector<PathQuery> queries_;
  std::vector<Path> paths_;
};

TEST(AffectedDiscPaths, AreAllPathsThatAreNotValidAnyMore) {
  Random random(31);
  std::size_t kept = 0;
  std::size_t affected = 0;
  std::size_t still_valid = 0;
  std::size_t wrong = 0;
  for (std::uint64_t i = 0; i < (case_count() + 1) / 2; ++i) {
    const disc::NamedScene scene = disc::random_scene(random, disc::kSceneKinds[i % disc::kSceneKinds.size()]);
    SCOPED_TRACE("scene " + std::to_string(i));
    ChangingWorld world(random.next(), scene);
    for (int k = 0; k < 20; ++k) {
      SCOPED_TRACE("operation " + std::to_string(k));
      world.change();
      if (testing::Test::HasFatalFailure()) return;
    }
    kept += world.kept;
    affected += world.affected;
    still_valid += world.still_valid;
    wrong += world.wrong;
  }
  EXPECT_GT(kept, affected);
  EXPECT_GT(affected, still_valid);
  RecordProperty("kept", static_cast<int>(kept));
  RecordProperty("affected", static_cast<int>(affected));
  RecordProperty("still valid", static_cast<int>(still_valid));
  RecordProperty("wrong", static_cast<int>(wrong));
}

}  // namespace
}  // namespace waywright::test

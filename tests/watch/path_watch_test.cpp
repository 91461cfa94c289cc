#include "waywright/path_watch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/query_context.hpp"
#include "waywright/world.hpp"
#include "waywright/world_snapshot.hpp"

#include "support/case_count.hpp"
#include "support/divided_town.hpp"
#include "support/random.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

using Keys = std::vector<std::uint64_t>;

bool contains(const Keys& keys, std::uint64_t key) { return std::binary_search(keys.begin(), keys.end(), key); }

const Shape kHouse = Shape::rectangle({{40, 40}, {60, 60}});

PathChanges changes_of(PathWatch& watch, const World& world) {
  PathChanges changes;
  watch.update(world, changes);
  return changes;
}

TEST(PathWatch, SaysWhichPathsAreBlocked) {
  World world = world_of_hundred();
  PathWatch watch(world);
  watch.add(7, world.find_path({.start = {10, 50}, .goal = {90, 50}}).value());
  watch.add(3, world.find_path({.start = {10, 10}, .goal = {90, 10}}).value());
  watch.add(5, world.find_path({.start = {10, 40}, .goal = {90, 40}}).value());
  watch.add(9, world.find_path({.start = {10, 30}, .goal = {90, 30}, .agent = {.radius = 10}}).value());
  watch.add(8, world.find_path({.start = {10, 25}, .goal = {90, 25}, .agent = {.radius = 10}}).value());
  world.insert(kHouse, 1).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{7}, {9}, {}}));
  EXPECT_EQ(changes_of(watch, world), PathChanges{}) << "nothing has changed since";
  world.insert_segment({45, 45}, {55, 55}).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{7}, {}, {}})) << "still blocked, and changed there";
}

TEST(PathWatch, SaysWhichPathsMayBeTooLong) {
  World world = world_of_hundred();
  world.insert(kHouse, 1).value();
  world.insert_segment({20, 95}, {80, 95}, 2).value();
  PathWatch watch(world);
  watch.add(1, world.find_path({.start = {30, 50}, .goal = {70, 50}}).value());
  watch.add(2, world.find_path({.start = {10, 10}, .goal = {90, 10}}).value());
  watch.add(3, world.find_path({.start = {50, 50}, .goal = {90, 10}}).value());  // blocked
  watch.add(4, world.find_path({.start = {41, 50}, .goal = {10, 50}, .end_tolerance = 5.0}).value());
  world.remove(2).value();
  EXPECT_EQ(changes_of(watch, world), PathChanges{});
  world.replace(1, Shape::rectangle({{40, 40}, {60, 59}})).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1, 4}}));
  world.replace(1, Shape::rectangle({{40, 40}, {60, 49}})).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1, 3, 4}}));
}

/// A yard with a door, and houses elsewhere.
World world_with_yard(bool keeps_abstraction = true) {
  World world =
      World::create({{0, 0}, {100, 100}}, {.keep_abstraction = keeps_abstraction, .keep_bridges = true}).value();
  world.insert(Shape::polyline(std::vector<Point>{{20, 40}, {20, 20}, {60, 20}, {60, 60}, {20, 60}, {20, 46}}), 1)
      .value();
  world.insert_segment({20, 40}, {20, 46}, 2).value();
  world.insert(Shape::rectangle({{80, 80}, {90, 90}}), 3).value();
  world.insert(Shape::rectangle({{40, 30}, {50, 40}}), 4).value();
  return world;
}

TEST(PathWatch, SaysWhichPathsHaveBecomePossible) {
  for (const bool keeps_abstraction : {true, false}) {
    World world = world_with_yard(keeps_abstraction);
    PathWatch watch(world);
    const Point inside{30, 50};
    const Point outside{10, 70};
    watch.add(1, world.find_path({.start = inside, .goal = outside}).value());
    watch.add(2, world.find_path({.start = outside, .goal = inside, .agent = {.radius = 2}}).value());
    watch.add(3, world.find_path({.start = outside, .goal = inside, .agent = {.radius = 4}}).value());
    watch.add(4, world.find_path({.start = outside, .goal = {85, 85}}).value());
    watch.add(5, world.find_path({.start = inside, .goal = {45, 35}, .agent = {.radius = 1}}).value());
    watch.add(6, world.find_path({.start = {81, 85}, .goal = inside, .end_tolerance = 5.0}).value());
    watch.add(7, world.find_paths_from({.start = outside, .goals = std::vector<Point>{inside}}).value().front());
    world.remove(3).value();
    EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {4}}));
    EXPECT_EQ(changes_of(watch, world), PathChanges{}) << "nothing has changed since";
    const ItemId house = world.insert(Shape::rectangle({{30, 80}, {40, 90}})).value();
    EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {4}})) << "still possible";
    watch.remove(4);
    world.remove(house).value();
    EXPECT_EQ(changes_of(watch, world), PathChanges{});
    world.remove(4).value();
    EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {5}}));
    watch.remove(5);
    world.remove(2).value();
    EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1, 2, 6, 7}})) << "the door is 6 wide";
    world.remove(1).value();
    EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1, 2, 3, 6, 7}}));
  }
}

// The start of the first path lies in a closed hut. A house over the hut blocks the start, so the query moves it.
TEST(PathWatch, KnowsThatAnInsertionCanMakeAPathPossible) {
  World world = world_of_hundred();
  world.insert(Shape::polyline(std::vector<Point>{{48, 48}, {52, 48}, {52, 52}, {48, 52}, {48, 48}})).value();
  PathWatch watch(world);
  watch.add(1, world.find_path({.start = {50, 50}, .goal = {10, 10}, .end_tolerance = 15.0}).value());
  watch.add(2, world.find_path({.start = {50, 50}, .goal = {10, 10}, .end_tolerance = 5.0}).value());
  world.insert(kHouse).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1}}));
}

// A path that the program has made itself has no ends of a query.
TEST(PathWatch, ReportsAPathWithoutEndsAfterEachRemoval) {
  World world = world_of_hundred();
  world.insert(kHouse, 1).value();
  PathWatch watch(world);
  watch.add(1, Path{});
  world.insert_segment({1, 1}, {2, 2}, 2).value();
  EXPECT_EQ(changes_of(watch, world), PathChanges{});
  world.remove(2).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1}}));
}

TEST(PathWatch, KnowsThatARewindOpensADoor) {
  World world = world_with_yard();
  world.remove(2).value();
  world.keep_history(4);
  const std::uint64_t tick = world.mark();
  world.insert_segment({20, 40}, {20, 46}, 2).value();
  PathWatch watch(world);
  watch.add(1, world.find_path({.start = {30, 50}, .goal = {10, 70}}).value());
  watch.add(2, world.find_path({.start = {30, 50}, .goal = {10, 70}, .agent = {.radius = 2}}).value());
  world.insert_segment({1, 1}, {2, 2}, 9).value();
  EXPECT_EQ(changes_of(watch, world), PathChanges{});
  ASSERT_TRUE(world.attempt({Change::remove({2})}, [](const World&) { return true; }).value());
  EXPECT_EQ(changes_of(watch, world), PathChanges{});
  world.rewind(tick).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1, 2}}));
}

/// Watches refused paths in a town of houses that come and go.
struct Reports {
  std::size_t before = 0;   ///< how often a watch would name a path if it named each refused path after each removal
  std::size_t useless = 0;  ///< how often the watch has named a path for which there is still no path
  std::size_t useful = 0;
};

Reports reports_in_a_divided_town(std::uint64_t seed, bool keeps_abstraction, double radius) {
  DividedTown town(seed, {.keep_abstraction = keeps_abstraction, .keep_bridges = true});
  if (radius == 0.0) town.world.insert_segment({DividedTown::kWall, 490}, {DividedTown::kWall, 510}, 1000).value();
  PathWatch watch(town.world);
  std::map<std::uint64_t, PathQuery> refused;
  for (std::uint64_t key = 0; key < 40; ++key) {
    const PathQuery query = town.query(radius);
    const Path path = town.world.find_path(query).value();
    if (path.status == PathStatus::found) continue;
    watch.add(key, path);
    refused[key] = query;
  }
  Reports reports;
  QueryContext context;
  Path path;
  for (int round = 0; round < 60; ++round) {
    const bool is_removal = town.change();
    if (round == 52) town.world.remove(1).value();  // opens the wall
    const Keys reported = changes_of(watch, town.world).may_be_too_long;
    for (const auto& [key, query] : refused) {
      town.world.find_path(query, context, path).value();
      const bool is_found = path.status == PathStatus::found;
      EXPECT_TRUE(!is_found || contains(reported, key)) << "round " << round << ", key " << key;
      if (radius == 0.0) {
        EXPECT_EQ(is_found, contains(reported, key)) << "round " << round << ", key " << key;
      }
      if (is_removal && !is_found) ++reports.before;
      if (contains(reported, key)) ++(is_found ? reports.useful : reports.useless);
    }
    if (testing::Test::HasFailure()) break;
  }
  return reports;
}

TEST(PathWatch, NamesFewPathsThatAreStillNotPossible) {
  for (const double radius : {0.0, 4.0, 8.0}) {
    for (const bool keeps_abstraction : {true, false}) {
      if (is_quick() && keeps_abstraction == (radius == 4.0)) continue;
      const Reports reports = reports_in_a_divided_town(7, keeps_abstraction, radius);
      EXPECT_GT(reports.before, 500U);
      EXPECT_LE(20 * reports.useless, reports.before);
      EXPECT_GT(reports.useful, 100U);
    }
  }
}

// The wall is beyond the ellipse, but the disc touches it from within the ellipse.
TEST(PathWatch, KnowsHowFarADiscReaches) {
  World world = world_of_hundred();
  world.insert_segment({50, 0}, {50, 45.5}, 1).value();
  PathWatch watch(world);
  watch.add(1, world.find_path({.start = {10, 50}, .goal = {90, 50}, .agent = {.radius = 5}}).value());
  world.remove(1).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1}}));
}

// The start lies in the left one of two adjacent houses. Without the right one, a free position is nearer to it.
TEST(PathWatch, KnowsThatANearerEndMayBeFree) {
  World world = world_of_hundred();
  world.insert(kHouse, 1).value();
  world.insert(Shape::rectangle({{60, 40}, {80, 60}}), 2).value();
  const PathQuery query{.start = {59, 50}, .goal = {59, 20}, .end_tolerance = 15.0};
  const Path path = world.find_path(query).value();
  ASSERT_EQ(path.points.front(), (Point{59, 40}));
  PathWatch watch(world);
  watch.add(1, path);
  world.remove(2).value();
  EXPECT_EQ(world.find_path(query).value().points.front(), (Point{60, 50}));
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1}}));
}

// A point agent may turn at the exact crossing of two walls if a point of its path has the rounded coordinates of the
// crossing. Without one of the walls, this point can lie beyond the other wall.
TEST(PathWatch, KnowsThatARemovalCanBlockAPathAtACrossing) {
  Random random(5);
  std::size_t blocked = 0;
  for (int i = 0; i < 200; ++i) {
    const auto share = [&] { return static_cast<double>(random.below(1U << 30)) * 0x1p-30; };
    World world = world_of_hundred();
    const Point right{80, 40 + 20 * share()};
    const Point top{40 + 20 * share(), 80};
    world.insert_segment({20, 40 + 20 * share()}, right, 1).value();
    PathWatch before_crossing(world);
    world.insert_segment({40 + 20 * share(), 20}, top, 2).value();
    const std::vector<Point> vertices = world.snapshot().vertices;
    const auto is_crossing = [](const Point& p) { return p.x > 21 && p.x < 79 && p.y > 21 && p.y < 79; };
    const Point crossing = *std::find_if(vertices.begin(), vertices.end(), is_crossing);
    Path path;
    path.status = PathStatus::found;
    path.points = {right + Point{0, 5}, crossing, top + Point{5, 0}};
    path.length = distance(path.points[0], crossing) + distance(crossing, path.points[2]);
    ASSERT_TRUE(world.is_clear(path.points).value());
    PathWatch watch(world);
    for (PathWatch* each : {&watch, &before_crossing}) each->add(1, path);
    world.remove(2).value();
    const bool is_clear = world.is_clear(path.points).value();
    blocked += is_clear ? 0 : 1;
    ASSERT_EQ(changes_of(watch, world).blocked, is_clear ? Keys{} : Keys{1});
    ASSERT_EQ(changes_of(before_crossing, world).blocked, is_clear ? Keys{} : Keys{1});
  }
  EXPECT_GT(blocked, 20U);
}

// A path runs along a wall, above it, from a gap around which the agent could also pass below the wall. It ends beyond
// a corner of this wall, where only an agent above the wall arrives.
TEST(PathWatch, KnowsWhetherAPathRunsAboveOrBelowAWall) {
  for (const bool is_reversed : {false, true}) {
    for (const bool is_above : {false, true}) {
      World world = world_of_hundred();
      world.insert(Shape::polyline(std::vector<Point>{{30, 50}, {70, 50}, {70, 80}})).value();
      Path path;
      path.status = PathStatus::found;
      path.points = {{20, 50}, {70, 50}, {60, 65}};
      path.length = 50 + distance(path.points[1], path.points[2]);
      if (is_reversed) std::reverse(path.points.begin(), path.points.end());
      ASSERT_TRUE(world.is_clear(path.points).value());
      PathWatch watch(world);
      watch.add(1, path);
      // Touches the wall from above or from below.
      const double low = is_above ? 50.0 : 44.0;
      world.insert(Shape::rectangle({{40, low}, {45, low + 6.0}})).value();
      EXPECT_EQ(world.is_clear(path.points).value(), !is_above);
      EXPECT_EQ(changes_of(watch, world).blocked, is_above ? Keys{1} : Keys{});
    }
  }
}

TEST(PathWatch, KnowsItsKeys) {
  World world = world_of_hundred();
  PathWatch watch(world);
  const Path path = world.find_path({.start = {10, 50}, .goal = {90, 50}}).value();
  EXPECT_FALSE(watch.remove(4));
  watch.add(4, path);
  watch.add(4, world.find_path({.start = {10, 10}, .goal = {90, 10}}).value());
  EXPECT_TRUE(watch.contains(4));
  EXPECT_EQ(watch.size(), 1U);
  world.insert(kHouse).value();
  EXPECT_EQ(changes_of(watch, world), PathChanges{}) << "the new path is elsewhere";
  EXPECT_TRUE(watch.remove(4));
  EXPECT_FALSE(watch.contains(4));
  PathWatch moved = std::move(watch);
  EXPECT_EQ(moved.size(), 0U);
  EXPECT_DEATH(static_cast<void>(watch.size()), "PathWatch: this object has been moved from");  // NOLINT
}

TEST(PathWatch, ChecksAllPathsIfTheWorldHasForgottenTheBoxes) {
  World world = world_of_hundred();
  PathWatch watch(world);
  watch.add(1, world.find_path({.start = {10, 50}, .goal = {90, 50}}).value());
  watch.add(2, world.find_path({.start = {10, 10}, .goal = {90, 10}}).value());
  watch.add(3, world.find_path({.start = {10, 10}, .goal = {90, 10}, .agent = {.radius = 1}}).value());
  const ItemId house = world.insert(kHouse).value();
  const ItemId other = world.insert_segment({1, 1}, {2, 2}).value();
  for (int i = 0; i < 3000; ++i) world.replace(other, Shape::segment({1, 1}, {2, 2.0 + i % 2})).value();
  ASSERT_FALSE(world.changes_since(0).has_value());
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{1}, {3}, {1, 2, 3}}));
  world.remove(house).value();
  EXPECT_EQ(changes_of(watch, world), (PathChanges{{}, {}, {1}})) << "the house stood on the path";
}

/// Random agents in a random world. The model knows each path and asks for all of them anew.
class Agents {
 public:
  enum class Walls : std::uint8_t { that_cross, that_are_parallel, of_rooms };

  Agents(std::uint64_t seed, std::size_t count, Walls walls)
      : random_(seed),
        world_(World::create({{0, 0}, {100, 100}}, {.keep_abstraction = seed % 3 != 0, .keep_bridges = true}).value()),
        watch_(world_),
        walls_(walls),
        radius_of_discs_(seed % 2 == 0 ? 0.0 : 1.0) {
    for (int i = 0; i < 30; ++i) items_.push_back(world_.insert(shape()).value());
    watch_ = PathWatch(world_);
    for (std::uint64_t key = 0; key < count; ++key) send(key);
  }

  std::size_t blocked = 0;
  std::size_t shortened = 0;
  std::size_t named = 0;
  std::size_t asked = 0;
  std::size_t opened = 0;  ///< the number of paths that were not found before

  void run(std::size_t operations) {
    world_.keep_history(4);
    for (std::size_t i = 0; i < operations; ++i) {
      if (random_.chance(10)) tick_ = world_.mark();
      for (std::size_t count = 1 + random_.below(3); count > 0; --count) operate();
      if (random_.chance(20)) {
        watch_.update(*world_.publish(), changes_);
      } else {
        watch_.update(world_, changes_);
      }
      check();
      if (testing::Test::HasFatalFailure()) return;
    }
  }

 private:
  Point point() {
    // On a coarse lattice, so that walls touch and cross each other's ends.
    return {5.0 * static_cast<double>(random_.between(0, 20)), 5.0 * static_cast<double>(random_.between(0, 20))};
  }
  Shape shape() {
    const Point at = point();
    const auto near = [&] {
      const Point p{at.x + static_cast<double>(random_.between(-12, 12)),
                    at.y + static_cast<double>(random_.between(-12, 12))};
      return Point{std::clamp(p.x, 0.0, 100.0), std::clamp(p.y, 0.0, 100.0)};
    };
    if (walls_ == Walls::of_rooms && random_.chance(60)) {
      const Point size{10.0 + 5.0 * static_cast<double>(random_.below(7)),
                       10.0 + 5.0 * static_cast<double>(random_.below(7))};
      const Point to{std::min(at.x + size.x, 100.0), std::min(at.y + size.y, 100.0)};
      // A closed room, or one with a door.
      const Point end = random_.chance(80) ? at : Point{at.x, std::min(at.y + 3.0, to.y)};
      return Shape::polyline(std::vector<Point>{at, {to.x, at.y}, to, {at.x, to.y}, end});
    }
    if (walls_ == Walls::that_are_parallel) return Shape::segment(at, {at.x, near().y});
    if (random_.chance(50)) return Shape::segment(at, near());
    return random_.chance(80) ? Shape::polygon({at, near(), near()}) : Shape::point(at);
  }
  void send(std::uint64_t key) {
    queries_[key] = {.start = point(), .goal = point(), .agent = {.radius = key % 4 == 0 ? radius_of_discs_ : 0.0}};
    if (random_.chance(30)) queries_[key].end_tolerance = static_cast<double>(random_.below(8));
    search(key);
  }
  void search(std::uint64_t key) {
    paths_[key] = world_.find_path(queries_[key]).value();
    watch_.add(key, paths_[key]);
  }
  void operate() {
    const std::size_t i = random_.below(items_.size());
    if (random_.chance(5) && tick_) {
      world_.rewind(*tick_).value();
      items_ = world_.item_ids();
      return;
    }
    if (items_.size() < 20 || random_.chance(40)) {
      items_.push_back(world_.insert(shape()).value());
    } else if (random_.chance(50)) {
      world_.replace(items_[i], shape()).value();
    } else {
      world_.remove(items_[i]).value();
      items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void check() {
    named += changes_.blocked.size() + changes_.may_be_too_long.size();
    for (auto& [key, path] : paths_) {
      ++asked;
      const bool is_for_disc = queries_[key].agent.radius > 0.0;
      const bool is_found = path.status == PathStatus::found;
      const bool is_blocked = !is_for_disc && is_found && !world_.is_clear(path.points).value();
      ASSERT_EQ(contains(changes_.blocked, key), is_blocked) << "path " << key;
      const Path now = world_.find_path(queries_[key]).value();
      blocked += is_blocked ? 1 : 0;
      if (is_found && queries_[key].end_tolerance && (moved_by(path) > 0.0 || moved_by(now) > 0.0)) {
        // On the lattice, several positions are often equally near to an end.
        send(key);
        continue;
      }
      const bool is_lost =
          is_for_disc && is_found && (now.status != PathStatus::found || now.length > path.length * (1.0 + 1e-9));
      if (is_lost) {
        ASSERT_TRUE(contains(changes_.may_be_blocked, key)) << "disc " << key;
      }
      const bool is_shorter =
          now.status == PathStatus::found &&
          (!is_found || now.length < path.length * (1.0 - 1e-9) || moved_by(now) < moved_by(path) * (1.0 - 1e-9));
      if (!is_found) {
        const bool is_possible = now.status == PathStatus::found;
        const bool is_named = contains(changes_.may_be_too_long, key);
        ASSERT_TRUE(is_named || !is_possible) << "path " << key;
        if (!is_for_disc) {
          ASSERT_EQ(is_named, is_possible) << "path " << key;
        }
        opened += is_possible ? 1 : 0;
      }
      if (is_shorter && !is_blocked && !is_lost) {
        ASSERT_TRUE(contains(changes_.may_be_too_long, key)) << "path " << key;
        ++shortened;
      }
      if (random_.chance(1)) {
        send(key);
      } else if (is_blocked || is_shorter || contains(changes_.may_be_blocked, key)) {
        search(key);
      }
    }
  }
  /// The distance by which the search has moved the ends.
  static double moved_by(const Path& path) {
    double sum = 0.0;
    if (path.moved_start) sum += distance(path.moved_start->from, path.moved_start->to);
    if (path.moved_goal) sum += distance(path.moved_goal->from, path.moved_goal->to);
    return sum;
  }

  Random random_;
  World world_;
  PathWatch watch_;
  Walls walls_;
  double radius_of_discs_;
  std::vector<ItemId> items_;
  std::map<std::uint64_t, PathQuery> queries_;
  std::map<std::uint64_t, Path> paths_;
  PathChanges changes_;
  std::optional<std::uint64_t> tick_;
};

void compare_with_questions_about_all_paths(Agents::Walls walls) {
  std::size_t blocked = 0;
  std::size_t shortened = 0;
  std::size_t named = 0;
  std::size_t asked = 0;
  std::size_t opened = 0;
  const std::uint64_t seeds = std::max<std::uint64_t>(case_count() / 5, 2);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Agents agents(seed, 60, walls);
    agents.run(50);
    if (testing::Test::HasFailure()) return;
    blocked += agents.blocked;
    shortened += agents.shortened;
    opened += agents.opened;
    named += agents.named;
    asked += agents.asked;
  }
  EXPECT_GT(blocked, 100U);
  EXPECT_GT(shortened, 50U);
  EXPECT_GE(opened, seeds);
  EXPECT_LT(named, asked / 2) << "most paths are not near a change";
}

// With WAYWRIGHT_SCRIPTS=1000, each of the three tests makes 10,000 rounds of operations.
TEST(PathWatch, AgreesWithQuestionsAboutAllPaths) { compare_with_questions_about_all_paths(Agents::Walls::that_cross); }

// Many paths are not found until a room opens.
TEST(PathWatch, AgreesWithQuestionsAboutAllPathsBetweenRooms) {
  compare_with_questions_about_all_paths(Agents::Walls::of_rooms);
}

// Without crossings, the removal of an item blocks no path.
TEST(PathWatch, AgreesWithQuestionsAboutAllPathsInAWorldWithoutCrossings) {
  compare_with_questions_about_all_paths(Agents::Walls::that_are_parallel);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/path_watch.hpp"
#include "waywright/save.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

constexpr Box kTen{{0, 0}, {10, 10}};

/// The answers of a world to some queries. They must not depend on how the world came to its items.
struct Answers {
  Answers(const World& world, Flavour flavour, std::uint64_t seed) {
    Random random(seed);
    const Box& domain = world.domain();
    for (int i = 0; i < 3; ++i) {
      PathQuery query{random_point(flavour, domain, random), random_point(flavour, domain, random)};
      for (const double radius : {0.0, (domain.max.x - domain.min.x) / 64}) {
        query.radius = radius;
        if (radius > 0.0 && !world.options().keep_bridges) continue;
        const Path path = world.find_path(query).value();
        points.push_back(path.points);
        numbers.insert(numbers.end(), {path.length, path.lower_bound});
        // How many steps a disc's search takes depends on the numbers of the faces.
        if (radius == 0.0) numbers.push_back(static_cast<double>(path.expansions));
        affected.push_back(world.is_affected(path, world.version() / 2));
      }
      items.push_back(world.items_at(query.start).value());
      numbers.push_back(world.ray(query.start, query.goal).value().at.x);
    }
  }

  std::vector<std::vector<Point>> points;
  std::vector<std::vector<ItemId>> items;
  std::vector<double> numbers;
  std::vector<bool> affected;
};

/// All that a snapshot must have from the moment when it was made.
struct State {
  State(const World& world, const LiveItems& model, Flavour flavour, std::uint64_t seed)
      : live(model),
        answers(world, flavour, seed),
        hash(world.items_hash()),
        version(world.version()),
        largest(world.largest_id_seen()),
        limit(world.new_vertex_limit()) {
    for (std::uint64_t since = 0; since <= version; since += 1 + version / 8) {
      const auto changed = world.changes_since(since);
      boxes.push_back(changed ? changed->size() : std::size_t{1} << 20);
      for (std::size_t i = 0; changed && i < changed->size(); i += 7) corners.push_back((*changed)[i].box.min);
    }
  }

  LiveItems live;
  Answers answers;
  ItemsHash hash;
  std::uint64_t version;
  ItemId largest;
  std::size_t limit;
  std::vector<std::size_t> boxes;
  std::vector<Point> corners;
};

void expect_equal(const World& world, const State& state, Flavour flavour, std::uint64_t seed) {
  const State now(world, state.live, flavour, seed);
  EXPECT_EQ(now.answers.points, state.answers.points);
  EXPECT_EQ(now.answers.items, state.answers.items);
  EXPECT_EQ(now.answers.numbers, state.answers.numbers);
  EXPECT_EQ(now.answers.affected, state.answers.affected);
  EXPECT_EQ(now.hash, state.hash);
  EXPECT_EQ(now.version, state.version);
  EXPECT_EQ(now.largest, state.largest);
  EXPECT_EQ(now.limit, state.limit);
  EXPECT_EQ(now.boxes, state.boxes);
  EXPECT_EQ(now.corners, state.corners);
  World fresh = World::create(world.domain(), world.options()).value();
  fresh.set_new_vertex_limit(kNoVertexLimit);
  for (const auto& [id, shape] : state.live.items()) fresh.insert(shape, id).value();
  EXPECT_EQ(world.dump(), fresh.dump());
  EXPECT_EQ(world.validate().fault, "");
}

/// Runs random operations, marks, rewinds, attempts, snapshots, clones and saves on a world, holds the snapshots for
/// long, releases them in random order, and compares each with what the model says of its moment.
class RandomSnapshots {
 public:
  RandomSnapshots(Flavour flavour, std::uint64_t seed)
      : flavour_(flavour),
        script_(random_changes(flavour, seed, 80, 4 + seed % 20)),
        random_(seed),
        world_(
            World::create(script_.domain, {.keep_abstraction = seed % 5 != 1, .keep_bridges = seed % 3 == 0}).value()),
        live_(script_.domain) {
    world_.keep_history(6);
  }

  void run() {
    for (const Step& step : script_.steps) {
      ASSERT_EQ(perform(world_, step).ok(), live_.apply(step).ok());
      ASSERT_NO_FATAL_FAILURE(do_something_else(step));
      ASSERT_FALSE(testing::Test::HasFailure());
    }
    while (!held_.empty()) ASSERT_NO_FATAL_FAILURE(check_and_release());
  }

 private:
  struct Held {
    WorldSnapshot snapshot;
    State state;
    std::uint64_t seed;
  };

  void do_something_else(const Step& step) {
    const std::size_t dice = random_.below(100);
    if (dice < 45) publish();
    if (dice % 2 == 0 && !held_.empty()) check_and_release();
    // The model knows nothing of reserved ids, so these are ids that items have had.
    if (dice < 8 && !world_.largest_id_seen().is_null()) {
      world_.reserve_ids({(world_.largest_id_seen().value + 1) / 2}).value();
    }
    if (dice % 10 == 3) ticks_.insert_or_assign(world_.mark(), live_);
    if (dice % 10 == 4) rewind();
    if (dice % 10 == 5) static_cast<void>(world_.attempt(step.changes, [](const World& w) { return w.item_count(); }));
    if (dice == 6) world_.shrink_to_fit();
    if (dice == 7) refuse();
    if (dice == 8) world_ = world_.clone();
    if (dice == 9) save_and_load();
  }

  void publish() {
    WorldSnapshot snapshot = world_.publish();
    const std::uint64_t seed = random_.below(1000);
    State state(world_, live_, flavour_, seed);
    expect_equal(*snapshot, state, flavour_, seed);
    if (random_.chance(60)) held_.push_back({std::move(snapshot), std::move(state), seed});
  }

  void check_and_release() {
    const std::size_t i = random_.below(held_.size());
    std::swap(held_[i], held_.back());
    const Held held = std::move(held_.back());
    held_.pop_back();
    const WorldSnapshot copy = held.snapshot;
    expect_equal(*copy, held.state, flavour_, held.seed);
  }

  /// An operation that stops at the limit in the middle.
  void refuse() {
    world_.set_new_vertex_limit(1);
    const Point a = script_.domain.min;
    const Point b = script_.domain.max;
    const std::vector<Change> changes(3, Change::insert(Shape::segment(a + (b - a) * 0.3125, a + (b - a) * 0.4375)));
    const bool is_done = world_.apply(changes).ok();
    world_.set_new_vertex_limit(kNoVertexLimit);
    if (is_done) static_cast<void>(live_.apply({changes, true}));
  }

  /// Goes on with the world that a saved world gives. Its history is empty.
  void save_and_load() {
    std::stringstream file;
    save_world(world_, file).value();
    World loaded = load_world(file).value();
    EXPECT_EQ(loaded.dump(), world_.dump());
    EXPECT_EQ(loaded.items_hash(), world_.items_hash());
    EXPECT_EQ(loaded.largest_id_seen(), world_.largest_id_seen());
    world_ = std::move(loaded);
    world_.keep_history(6);
    ticks_.clear();
  }

  void rewind() {
    while (!ticks_.empty() && random_.chance(50)) ticks_.erase(std::prev(ticks_.end()));
    if (ticks_.empty() || !world_.rewind(ticks_.rbegin()->first).ok()) return;
    live_ = ticks_.rbegin()->second;
  }

  Flavour flavour_;
  ChangeScript script_;
  Random random_;
  World world_;
  LiveItems live_;
  std::map<std::uint64_t, LiveItems> ticks_;
  std::vector<Held> held_;
};

TEST(Snapshot, IsWhatTheWorldWas) {
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 1; seed <= case_count(); ++seed) {
      SCOPED_TRACE(std::string(to_string(flavour)) + ", seed " + std::to_string(seed));
      ASSERT_NO_FATAL_FAILURE(RandomSnapshots(flavour, seed).run());
      ASSERT_FALSE(HasFailure());
    }
  }
}

// Many boxes: the world drops the oldest while replicas lag behind.
TEST(Snapshot, KnowsTheChangesOfTheWorld) {
  World world = World::create({{0, 0}, {1000, 1000}}).value();
  const ItemId id = world.insert(Shape::rectangle({{1, 1}, {2, 2}})).value();
  std::vector<WorldSnapshot> held;
  for (int i = 0; i < 6000; ++i) {
    const double x = 1 + i % 900;
    world.replace(id, Shape::rectangle({{x, 1}, {x + 1, 2}})).value();
    if (i % 70 == 0) held.push_back(world.publish());
    if (i % 170 == 0) held.erase(held.begin());
    if (held.empty() || held.back().version() != world.version()) continue;
    for (std::uint64_t since = 0; since < world.version(); since += 1 + world.version() / 9) {
      const auto expected = world.changes_since(since);
      const auto found = held.back()->changes_since(since);
      ASSERT_EQ(found.has_value(), expected.has_value()) << i;
      if (!expected) continue;
      ASSERT_EQ(found->size(), expected->size()) << i << " since " << since;
      for (std::size_t k = 0; k < found->size(); ++k) {
        ASSERT_EQ((*found)[k].version, (*expected)[k].version);
        ASSERT_EQ((*found)[k].box, (*expected)[k].box);
      }
    }
  }
}

TEST(Snapshot, IsTheSameUntilSomethingChanges) {
  World world = World::create(kTen).value();
  const WorldSnapshot first = world.publish();
  EXPECT_EQ(world.publish(), first);
  world.reserve_ids(7).value();
  const WorldSnapshot second = world.publish();
  EXPECT_FALSE(second == first);
  EXPECT_EQ(first->largest_id_seen(), ItemId{});
  EXPECT_EQ(second->largest_id_seen(), ItemId{7});
}

TEST(Snapshot, UsesTheMemoryOfReleasedSnapshotsAgain) {
  World world = World::create(kTen).value();
  const World* first = nullptr;
  for (int i = 0; i < 5; ++i) {
    world.insert_point({1.0 + i, 1}).value();
    const WorldSnapshot snapshot = world.publish();
    if (first == nullptr) first = &*snapshot;
    EXPECT_EQ(&*snapshot, first);
    EXPECT_EQ(snapshot->item_count(), static_cast<std::size_t>(i + 1));
  }
}

TEST(Snapshot, OutlivesTheWorld) {
  WorldSnapshot snapshot;
  EXPECT_FALSE(snapshot);
  {
    World world = World::create(kTen).value();
    world.insert_segment({4, 0}, {4, 7}, 5).value();
    snapshot = world.publish();
  }
  std::thread([copy = std::move(snapshot)] {
    EXPECT_TRUE(copy->contains(5));
    EXPECT_EQ(copy->validate().fault, "");
  }).join();
  EXPECT_FALSE(snapshot);  // NOLINT: a handle that was moved from is empty
}

TEST(Snapshot, ClonesIntoAWorldWithoutHistory) {
  World world = World::create(kTen).value();
  world.keep_history(3);
  world.mark();
  world.insert_point({1, 1}).value();
  World copy = world.publish()->clone();
  EXPECT_EQ(copy.insert_point({2, 2}).value(), ItemId{2});
  EXPECT_EQ(copy.rewind(1).error().code, ErrorCode::no_history);
  EXPECT_TRUE(world.rewind(1).ok());
}

TEST(Snapshot, EndsASearchWhenItsMemoryIsUsedAgain) {
  World world = World::create(kTen).value();
  world.insert_segment({4, 0}, {4, 7}).value();
  WorldSnapshot snapshot = world.publish();
  PathSearch search;
  search.begin(*snapshot, {.start = {1, 1}, .goal = {7, 1}}).value();
  snapshot.release();
  world.insert_segment({5, 0}, {5, 7}).value();
  snapshot = world.publish();
  EXPECT_EQ(search.step(1).error().code, ErrorCode::world_gone);
}

TEST(Snapshot, LetsAWatchReadOneAfterTheOther) {
  World world = World::create({{0, 0}, {100, 100}}).value();
  PathWatch watch(*world.publish());
  watch.add(1, world.find_path({.start = {10, 50}, .goal = {90, 50}}).value());
  PathChanges changes;
  for (int i = 0; i < 4; ++i) {
    world.insert(Shape::rectangle({{20.0 + 10 * i, 60}, {21.0 + 10 * i, 61}})).value();
    watch.update(*world.publish(), changes);
    EXPECT_TRUE(changes.blocked.empty());
  }
  world.insert(Shape::rectangle({{40, 40}, {60, 60}})).value();
  watch.update(*world.publish(), changes);
  EXPECT_EQ(changes.blocked, std::vector<std::uint64_t>{1});
}

TEST(Snapshot, LeavesNoMemoryAfterShrinking) {
  World world = World::create(kTen).value();
  for (int i = 0; i < 500; ++i) world.insert_point({i / 64.0, i % 37 / 4.0}).value();
  world.shrink_to_fit();
  const std::size_t before = world.memory().total();
  static_cast<void>(world.publish());
  EXPECT_GT(world.memory().total(), before + before / 2);
  world.shrink_to_fit();
  EXPECT_LE(world.memory().total(), before);
}

}  // namespace
}  // namespace waywright::test

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

/// Returns the id that the world would choose for the next item, or null if it has used the largest id.
ItemId next_id(World& world) {
  const Result<ItemId> id = world.attempt({Change::insert(Shape::point(world.domain().min))},
                                          [](const World& changed) { return changed.item_ids().back(); });
  return id ? *id : ItemId{};
}

/// What must be the same after a rewind or an attempt.
struct State {
  explicit State(World& world)
      : dump(world.dump()), hash(world.items_hash()), items(world.items()), next(next_id(world)) {}

  std::string dump;
  ItemsHash hash;
  std::vector<Item> items;
  ItemId next;

  friend bool operator==(const State&, const State&) = default;
};

/// A tick: what the world was, and the model of it.
struct Tick {
  LiveItems live;
  State state;
};

WorldOptions options_of(std::uint64_t seed) {
  return {.keep_abstraction = seed % 5 != 1, .keep_bridges = seed % 3 == 0};
}

/// Runs random operations, marks, rewinds and attempts on a world, and compares the world with a model that keeps the
/// items of each tick.
class RandomHistory {
 public:
  RandomHistory(Flavour flavour, std::uint64_t seed)
      : script_(random_changes(flavour, seed, 60, 4 + seed % 20)),
        random_(seed),
        world_(World::create(script_.domain, options_of(seed)).value()),
        live_(script_.domain),
        limit_(1 + seed % 6) {}

  std::size_t rewinds = 0;
  std::size_t attempts = 0;
  std::size_t refusals = 0;

  void run() {
    world_.keep_history(limit_);
    for (const Step& step : script_.steps) {
      if (random_.chance(40)) mark();
      if (random_.chance(20)) rewind();
      change(random_.chance(30) ? random_step() : step);
      if (testing::Test::HasFatalFailure()) return;
    }
  }

 private:
  void mark() {
    const std::uint64_t tick = world_.mark();
    ASSERT_EQ(tick, last_ + 1);
    last_ = tick;
    ticks_.insert_or_assign(tick, Tick{live_, State(world_)});
    if (ticks_.size() > limit_) ticks_.erase(ticks_.begin());
  }

  void rewind() {
    const std::uint64_t tick = random_.below(static_cast<std::size_t>(last_) + 2);
    const std::uint64_t version = world_.version();
    const Result<void> done = world_.rewind(tick);
    const auto found = ticks_.find(tick);
    if (found == ticks_.end()) {
      ASSERT_FALSE(done.ok());
      ASSERT_EQ(done.error().code, tick == 0 || tick > last_ ? ErrorCode::unknown_tick : ErrorCode::old_tick);
      return;
    }
    ++rewinds;
    ASSERT_TRUE(done.ok());
    ASSERT_EQ(world_.version(), version + 1);
    live_ = found->second.live;
    last_ = tick;
    ticks_.erase(std::next(found), ticks_.end());
    ASSERT_TRUE(State(world_) == ticks_.at(tick).state) << "after a rewind to tick " << tick;
    ASSERT_EQ(world_.validate().fault, "");
    check_items();
  }

  void check_items() {
    std::vector<Item> expected;
    for (const auto& [id, shape] : live_.items()) expected.push_back({id, merged(shape)});
    ASSERT_TRUE(world_.items() == expected);
  }

  void change(const Step& step) {
    std::optional<std::string> then;
    if (random_.chance(40)) then = attempt(step);
    const Result<std::vector<ItemId>> expected = live_.apply(step);
    const Result<std::vector<ItemId>> done = perform(world_, step);
    ASSERT_EQ(done.ok(), expected.ok());
    if (then) {
      ASSERT_EQ(world_.dump(), *then) << "an attempt and the operation differ";
    }
    if (!done) return;
    ASSERT_EQ(*done, *expected);
    check_items();
  }

  /// Returns the dump of the world in the question, or of the unchanged world if it refuses the changes.
  std::string attempt(const Step& step) {
    const State before(world_);
    const std::uint64_t version = world_.version();
    const bool validates = random_.chance(30);
    const Result<std::string> answer = world_.attempt(step.changes, [&](const World& changed) {
      if (validates) {
        EXPECT_EQ(changed.validate().fault, "");
      }
      return changed.dump();
    });
    EXPECT_EQ(world_.version(), version);
    EXPECT_TRUE(State(world_) == before) << "an attempt has changed the world";
    if (validates) {
      EXPECT_EQ(world_.validate().fault, "");
    }
    ++(answer ? attempts : refusals);
    return answer ? *answer : before.dump;
  }

  Step random_step() {
    Step step{{}, true};
    for (std::size_t count = random_.below(6); count > 0; --count) {
      const auto& items = live_.items();
      if (items.empty()) return step;
      const auto any = [&] {
        return std::next(items.begin(), static_cast<std::ptrdiff_t>(random_.below(items.size())));
      };
      switch (random_.below(3)) {
        case 0:
          step.changes.push_back(Change::insert(any()->second));
          break;
        case 1:
          step.changes.push_back(Change::remove(any()->first));
          break;
        default:
          step.changes.push_back(Change::replace(any()->first, any()->second));
      }
    }
    return step;
  }

  ChangeScript script_;
  Random random_;
  World world_;
  LiveItems live_;
  std::size_t limit_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, Tick> ticks_;
};

class Rewind : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, Rewind, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

TEST_P(Rewind, AndAttemptsAgreeWithAModelOfEachTick) {
  std::size_t rewinds = 0;
  std::size_t attempts = 0;
  std::size_t refusals = 0;
  for (std::uint64_t seed = 0; seed < case_count() / 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomHistory history(GetParam(), seed);
    history.run();
    if (HasFailure()) return;
    rewinds += history.rewinds;
    attempts += history.attempts;
    refusals += history.refusals;
  }
  EXPECT_GE(rewinds, case_count() / 4);
  EXPECT_GT(attempts, case_count());
  EXPECT_GT(refusals, 0U);
}

World world_of_hundred() { return World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value(); }

std::vector<Point> row(std::size_t count, double y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({static_cast<double>(i % 97) + 1, y + static_cast<double>(i / 97)});
  return points;
}

TEST(RewindOf, ABulkLoadEmptiesTheWorld) {
  World world = world_of_hundred();
  world.keep_history(2);
  const std::uint64_t tick = world.mark();
  const std::string before = world.dump();
  world.insert_points(row(500, 2)).value();
  EXPECT_LT(world.memory().history, 200U) << "ids that count up take memory only once";
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.insert_point({5, 5}).value(), ItemId{1});
  EXPECT_EQ(world.validate().fault, "");
}

// The mesh that is built anew contains the items that stay.
TEST(RewindOf, MostOfAWorldKeepsTheRest) {
  World world = world_of_hundred();
  world.keep_history(2);
  world.insert(Shape::rectangle({{10, 10}, {20, 20}}), 7).value();
  world.insert_segment({50, 50}, {50, 50}, 9).value();
  const std::uint64_t tick = world.mark();
  const std::string before = world.dump();
  const std::uint64_t version = world.version();
  world.replace(7, Shape::rectangle({{10, 10}, {30, 20}})).value();
  world.insert_points(row(500, 30)).value();
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.shape(9).value(), Shape::segment({50, 50}, {50, 50}));
  EXPECT_EQ(world.version(), version + 3);
  EXPECT_EQ(world.insert_point({5, 5}).value(), ItemId{10});
  EXPECT_EQ(world.validate().fault, "");
}

TEST(RewindOf, ARemovedBulkLoadBringsItBack) {
  World world = world_of_hundred();
  world.insert_points(row(500, 2)).value();
  const std::string before = world.dump();
  world.keep_history(2);
  const std::uint64_t tick = world.mark();
  std::vector<Change> changes;
  for (const ItemId id : world.item_ids()) changes.push_back(Change::remove(id));
  world.apply(changes).value();
  world.rewind(tick).value();
  EXPECT_EQ(world.dump(), before);
  EXPECT_EQ(world.validate().fault, "");
}

TEST(RewindOf, ATickCanBeRepeated) {
  World world = world_of_hundred();
  world.keep_history(10);
  const std::uint64_t tick = world.mark();
  const ItemsHash before = world.items_hash();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(world.insert_segment({10, 10}, {20, 30.0 + i}).value(), ItemId{1});
    EXPECT_EQ(world.mark(), tick + 1);
    world.rewind(tick).value();
    EXPECT_EQ(world.items_hash(), before);
  }
}

TEST(RewindOf, AnUnknownTickIsRefused) {
  World world = world_of_hundred();
  EXPECT_EQ(world.rewind(1).error().code, ErrorCode::no_history);
  world.keep_history(3);
  EXPECT_EQ(world.rewind(1).error().code, ErrorCode::unknown_tick);
  for (int i = 0; i < 5; ++i) world.mark();
  EXPECT_EQ(world.rewind(0).error().code, ErrorCode::unknown_tick);
  EXPECT_EQ(world.rewind(2).error().code, ErrorCode::old_tick);
  EXPECT_EQ(world.rewind(2).error().index, 2U);
  EXPECT_EQ(world.rewind(6).error().code, ErrorCode::unknown_tick);
  EXPECT_TRUE(world.rewind(4).ok());
  EXPECT_EQ(world.rewind(5).error().code, ErrorCode::unknown_tick);
  EXPECT_TRUE(world.rewind(3).ok());
  EXPECT_EQ(world.version(), 2U) << "a refused rewind is no operation";
  world.keep_history(0);
  EXPECT_EQ(world.rewind(3).error().code, ErrorCode::no_history);
  EXPECT_EQ(world.memory().history, 0U);
  world.keep_history(1);
  EXPECT_EQ(world.rewind(3).error().code, ErrorCode::old_tick);
  EXPECT_EQ(world.mark(), 4U);
}

// An item that has moved away and back is not touched, so no path is affected.
TEST(RewindOf, AnItemThatIsWhereItWasChangesNothing) {
  World world = world_of_hundred();
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  const Shape short_wall = Shape::segment({70, 70}, {70, 70});
  const ItemId wall = world.insert(short_wall).value();
  world.keep_history(1);
  const std::uint64_t tick = world.mark();
  world.replace(wall, Shape::segment({70, 70}, {80, 70})).value();
  world.replace(wall, short_wall).value();
  world.replace(box, Shape::rectangle({{40, 10}, {50, 20}})).value();
  world.replace(box, Shape::rectangle({{10, 10}, {20, 20}})).value();
  const std::uint64_t before = world.version();
  world.rewind(tick).value();
  EXPECT_TRUE(world.changes_since(before)->empty());
  EXPECT_EQ(world.version(), before + 1);
}

TEST(RewindOf, AWorldAffectsThePathsThatItTouches) {
  World world = world_of_hundred();
  world.insert_segment({50, 20}, {50, 80}, 1).value();
  world.keep_history(1);
  const std::uint64_t tick = world.mark();
  world.remove(1).value();
  const Path path = world.find_path({.start = {40, 50}, .goal = {60, 50}}).value();
  PathSearch search;
  search.begin(world, {.start = {40, 50}, .goal = {60, 51}}).value();
  const std::uint64_t before = world.version();
  world.rewind(tick).value();
  EXPECT_TRUE(world.is_affected(path, before));
  while (!search.step(1).value()) continue;
  EXPECT_EQ(search.path().points.size(), 3U);
}

TEST(RewindOf, HistoryForgetsOldTicksAndTheirMemory) {
  World world = world_of_hundred();
  const ItemId box = world.insert(Shape::rectangle({{10, 10}, {20, 20}})).value();
  world.keep_history(4);
  std::size_t largest = 0;
  for (int i = 0; i < 1000; ++i) {
    world.mark();
    for (int k = 0; k < 3; ++k) world.replace(box, Shape::rectangle({{10.0 + k, 10}, {20.0 + k, 20}})).value();
    largest = std::max(largest, world.memory().history);
  }
  EXPECT_LT(largest, 4000U);
}

}  // namespace
}  // namespace waywright::test

#include "support/random_changes.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/script.hpp"

#include "support/changes_check.hpp"

namespace waywright::test {
namespace {

TEST(RandomChanges, AreTheSameForTheSameSeed) {
  for (const Flavour flavour : kFlavours) {
    const std::string script = to_script(random_changes(flavour, 5, 100, 20));
    EXPECT_EQ(to_script(random_changes(flavour, 5, 100, 20)), script);
    EXPECT_NE(to_script(random_changes(flavour, 6, 100, 20)), script);
  }
}

/// Counts of events in some scripts of a flavour.
struct Events {
  std::map<Change::Kind, std::size_t> done;
  std::size_t batches = 0;
  std::size_t empty_batches = 0;
  std::size_t full = 0;
  std::size_t emptied = 0;
  std::size_t back_again = 0;  ///< shapes inserted again after their removal
  std::map<ErrorCode, std::size_t> refused;
  std::map<ErrorCode, std::size_t> refused_batches;
};

void count_events(const ChangeScript& script, std::size_t live_count, Events& events) {
  LiveItems live(script.domain);
  std::vector<Shape> removed_shapes;
  for (const Step& step : script.steps) {
    const std::map<ItemId, Shape> before = live.items();
    const Result<std::vector<ItemId>> ids = live.apply(step);
    if (!ids) {
      ++(step.is_batch ? events.refused_batches : events.refused)[ids.error().code];
      continue;
    }
    events.batches += step.is_batch ? 1 : 0;
    events.empty_batches += step.changes.empty() ? 1 : 0;
    for (const Change& change : step.changes) {
      ++events.done[change.kind];
      const bool has_shape = change.kind != Change::Kind::remove;
      events.back_again +=
          has_shape && std::find(removed_shapes.begin(), removed_shapes.end(), change.shape) != removed_shapes.end()
              ? 1
              : 0;
    }
    for (const auto& [id, shape] : before) {
      if (!live.items().contains(id)) removed_shapes.push_back(shape);
    }
    events.full += live.items().size() == live_count ? 1 : 0;
    events.emptied += !before.empty() && live.items().empty() ? 1 : 0;
    ASSERT_LE(live.items().size(), live_count);
  }
}

TEST(RandomChanges, HaveAllThatTheyPromise) {
  for (const Flavour flavour : kFlavours) {
    Events events;
    for (std::uint64_t seed = 0; seed < 8; ++seed) count_events(random_changes(flavour, seed, 500, 15), 15, events);
    SCOPED_TRACE(to_string(flavour));
    // In total 4000 steps.
    EXPECT_GT(events.done[Change::Kind::insert], 800U);
    EXPECT_GT(events.done[Change::Kind::remove], 800U);
    EXPECT_GT(events.done[Change::Kind::replace], 300U);
    EXPECT_GT(events.batches, 200U);
    EXPECT_GT(events.empty_batches, 10U);
    EXPECT_GT(events.full, 100U);
    EXPECT_GT(events.emptied, 8U);
    EXPECT_GT(events.back_again, 200U);
    for (const ErrorCode code : {ErrorCode::unknown_id, ErrorCode::id_in_use, ErrorCode::coordinate_range}) {
      EXPECT_GT(events.refused[code], 3U) << to_string(code);
      EXPECT_GT(events.refused_batches[code], 3U) << to_string(code);
    }
    // In the flavour `mixed` the domain may span the whole range of coordinates; then no point lies outside.
    if (flavour != Flavour::mixed) {
      EXPECT_GT(events.refused_batches[ErrorCode::out_of_domain], 3U);
    }
  }
}

TEST(RandomChanges, PrintAsAScriptThatLeavesTheSameItems) {
  for (const Flavour flavour : kFlavours) {
    const ChangeScript changes = random_changes(flavour, 11, 200, 15);
    LiveItems live(changes.domain);
    for (const Step& step : changes.steps) static_cast<void>(live.apply(step));
    const Result<Script> script = parse_script(to_script(changes), "changes");
    ASSERT_TRUE(script.ok()) << script.error().message();
    std::map<ItemId, Shape> left;
    for (const Item& item : scene_of(*script).items) left.emplace(item.id, item.shape);
    EXPECT_EQ(left, live.items());
    LiveItems again(changes.domain);
    for (const Step& step : changes_of(*script).steps) EXPECT_TRUE(again.apply(step).ok());
    EXPECT_EQ(again.items(), live.items());
  }
}

// The script "fails" if the item with id 901 was inserted and removed and 902 is live. So both insertions and one
// removal are needed.
TEST(ShrinkChanges, LeavesNothingThatIsNotNeeded) {
  const Shape segment{ItemKind::segment, {{{0, 0}, {1, 1}}}};
  const Shape polygon{ItemKind::polygon, {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}}}};
  ChangeScript script = random_changes(Flavour::lattice, 3, 40, 10);
  script.domain = {{-100, -100}, {100, 100}};
  script.steps.push_back({{{Change::Kind::insert, {901}, segment}, {Change::Kind::insert, {902}, polygon}}, true});
  script.steps.push_back({{{Change::Kind::remove, {901}, {}}}, false});
  const auto fails = [](const ChangeScript& changes) {
    LiveItems live(changes.domain);
    bool was_there = false;
    for (const Step& step : changes.steps) {
      static_cast<void>(live.apply(step));
      was_there = was_there || live.items().contains({901});
    }
    return was_there && !live.items().contains({901}) && live.items().contains({902});
  };
  ASSERT_TRUE(fails(script));
  const ChangeScript small = shrink(script, fails);
  ASSERT_EQ(small.steps.size(), 2U);
  ASSERT_EQ(small.steps[0].changes.size(), 2U);
  EXPECT_EQ(small.steps[0].changes[1].shape, (Shape{ItemKind::polygon, {{{1, 1}}}}));
  EXPECT_EQ(small.steps[1].changes.size(), 1U);
}

}  // namespace
}  // namespace waywright::test

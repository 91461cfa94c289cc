#include "waywright/replay.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/random_changes.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

Script parse(const std::string& text) {
  Result<Script> script = parse_script(text, "log");
  EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().message());
  return script.ok() ? *script : Script{};
}

std::string log_with(const std::string& lines) { return "waywright 1\ndomain 0 0 10 10\n" + lines; }

/// The hash of a world with these items, as a log contains it.
std::string hash_in_words(const std::vector<Item>& items) {
  World world = World::create(kTen).value();
  world.insert_all(items).value();
  return to_string(world.items_hash());
}

const std::string kOnePoint = hash_in_words({{1, Shape::point({1, 2})}});
const std::string kNothing = hash_in_words({});

TEST(ReplayWriter, WritesTheHashThatItGets) {
  World world = World::create(kTen).value();
  std::ostringstream out;
  ReplayWriter log(out, world);
  world.insert_point({1, 2}, 1).value();
  const ItemsHash hash = world.items_hash();
  world.remove(1).value();
  EXPECT_TRUE(log.tick(hash).ok());
  EXPECT_EQ(out.str(), log_with("tick 1 " + kOnePoint + "\n"));
}

TEST(ReplayWriter, WritesItemsChangesAndTicks) {
  World world = World::create(kTen).value();
  world.insert_point({1, 2}, 1).value();
  std::ostringstream out;
  ReplayWriter log(out, world, 2);
  world.insert_segment({1, 1}, {2, 2}, 7).value();
  EXPECT_TRUE(log.record(Change::insert(Shape::segment({1, 1}, {2, 2}), 7)).ok());
  EXPECT_TRUE(log.tick(world).ok());
  const std::vector<Change> changes = {Change::replace(7, Shape::polygon({{1, 1}, {3, 1}, {3, 3}}, FillRule::nonzero)),
                                       Change::insert(Shape::point({5, 5})), Change::remove(1)};
  EXPECT_TRUE(log.record(changes, world.apply(changes).value()).ok());
  EXPECT_TRUE(log.tick(world).ok());
  EXPECT_EQ(log.last_tick(), 2U);
  EXPECT_EQ(out.str(), log_with("point 1 1 2\n"
                                "segment 7 1 1 2 2\n"
                                "tick 1\n"
                                "replace polygon 7 nonzero 3 1 1 3 1 3 3\n"
                                "point 8 5 5\n"
                                "remove 1\n"
                                "tick 2 ") +
                           to_string(world.items_hash()) + "\n");
}

TEST(ReplayWriter, RefusesAChangeWithoutAnId) {
  std::ostringstream out;
  const World world = World::create(kTen).value();
  ReplayWriter log(out, world);
  const std::string before = out.str();
  EXPECT_EQ(log.record(Change::insert(Shape::point({1, 2}))).error().code, ErrorCode::bad_id);
  EXPECT_EQ(log.record(Change::remove(-1)).error().code, ErrorCode::bad_id);
  EXPECT_EQ(out.str(), before);
}

TEST(ReplayWriter, ReportsAStreamThatHasFailed) {
  std::ostringstream out;
  const World world = World::create(kTen).value();
  out.setstate(std::ios::badbit);
  ReplayWriter log(out, world);
  EXPECT_EQ(log.record(Change::remove(1)).error().code, ErrorCode::unwritable);
  EXPECT_EQ(log.tick(world).error().code, ErrorCode::unwritable);
}

TEST(Script, HasTicks) {
  const Script script = parse(log_with("tick 3\ntick 18446744073709551615 00000000000000ff8000000000000000\n"));
  ASSERT_EQ(script.lines.size(), 2U);
  EXPECT_EQ(script.lines[0].tick, 3U);
  EXPECT_FALSE(script.lines[0].items_hash.has_value());
  EXPECT_EQ(script.lines[1].tick, ~std::uint64_t{0});
  EXPECT_EQ(script.lines[1].items_hash, (ItemsHash{{255, std::uint64_t{1} << 63}}));
  EXPECT_EQ(to_string(script.lines[1]), "tick");
  for (const std::string line : {"tick", "tick x", "tick -1", "tick 1 ff", "tick 1 00000000000000ff800000000000000g",
                                 "tick 1 00000000000000FF8000000000000000", "tick 1 00000000000000ff8000000000000000 1",
                                 "tick 18446744073709551616"}) {
    const Result<Script> refused = parse_script(log_with(line), "log");
    ASSERT_FALSE(refused.ok()) << line;
    EXPECT_EQ(refused.error().index, 3U) << refused.error().message();
  }
}

TEST(Replay, AcceptsALogWithItsOwnHashes) {
  const ReplayResult result =
      replay(parse(log_with("point 1 1 2\ntick 1 " + kOnePoint + "\nlocate 1 1\nremove 1\ntick 2 " + kNothing + "\n")))
          .value();
  EXPECT_TRUE(result.is_same);
  EXPECT_EQ(result.ticks, 2U);
}

TEST(Replay, StopsAtTheFirstHashThatDiffers) {
  const std::string log = log_with("point 1 1 2\ntick 1 " + kOnePoint + "\npoint 3 1 1\ntick 2\nremove 1\nremove 3\n" +
                                   "tick 3 " + kOnePoint + "\ntick 4 " + kOnePoint + "\n");
  const ReplayResult result = replay(parse(log)).value();
  EXPECT_FALSE(result.is_same);
  EXPECT_EQ(result.tick, 3U);
  EXPECT_EQ(result.last_same, 1U);
  EXPECT_EQ(result.line, 9U);
  EXPECT_EQ(to_string(result.expected), kOnePoint);
  EXPECT_EQ(to_string(result.computed), kNothing);
  EXPECT_EQ(result.changed, (std::vector<ItemId>{1, 3}));
  EXPECT_FALSE(result.refusal.has_value());
}

TEST(Replay, NamesItemsThatARewindHasChanged) {
  // The rewind leads to a tick before the last equal hash, so it also takes back the insertion of item 1.
  const std::string lines = "mark 1\npoint 1 1 2\ntick 1 " + kOnePoint + "\npoint 2 5 5\nrewind 1\nrewind 1\n";
  const ReplayResult result = replay(parse(log_with(lines + "point 3 6 6\ntick 2 " + kNothing + "\n"))).value();
  EXPECT_FALSE(result.is_same);
  EXPECT_EQ(result.last_same, 1U);
  EXPECT_EQ(result.changed, (std::vector<ItemId>{1, 2, 3}));
  const auto difference = find_difference(parse(log_with(lines + "tick 2 " + kNothing + "\n")),
                                          parse(log_with(lines + "tick 2 " + kOnePoint + "\n")));
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->kind, ReplayDifference::Kind::hash);
  EXPECT_EQ(difference->changed, (std::vector<ItemId>{1, 2}));
}

TEST(Replay, RefusesARewindToATickThatNoMarkHas) {
  // The parser refuses such a line, but a program can make the script itself.
  Script log = parse(log_with("point 1 1 2\nmark 1\npoint 2 5 5\nrewind 1\n"));
  for (const std::uint64_t tick : {std::uint64_t{0}, std::uint64_t{2}, ~std::uint64_t{0}}) {
    log.lines.back().tick = tick;
    const ReplayResult result = replay(log).value();
    EXPECT_FALSE(result.is_same);
    EXPECT_EQ(result.line, log.lines.back().line);
    ASSERT_TRUE(result.refusal.has_value());
    EXPECT_EQ(result.refusal->code, ErrorCode::unknown_tick);
    EXPECT_EQ(find_difference(log, log), std::nullopt);
  }
}

TEST(Replay, StopsAtAChangeThatTheWorldRefuses) {
  const ReplayResult in_tick = replay(parse(log_with("point 1 1 2\ntick 1\nremove 1\nremove 9\ntick 2\n"))).value();
  EXPECT_FALSE(in_tick.is_same);
  EXPECT_EQ(in_tick.tick, 2U);
  EXPECT_EQ(in_tick.line, 6U);
  EXPECT_EQ(in_tick.changed, std::vector<ItemId>{9});
  EXPECT_EQ(in_tick.refusal->code, ErrorCode::unknown_id);
  const ReplayResult after_ticks = replay(parse(log_with("tick 1\nremove 9\n"))).value();
  EXPECT_FALSE(after_ticks.is_same);
  EXPECT_EQ(after_ticks.tick, 2U);
  EXPECT_EQ(after_ticks.line, 4U);
}

/// Writes the log of random changes, every third tick with a hash.
std::string random_log(std::uint64_t seed) {
  const ChangeScript script = random_changes(Flavour::small, seed, 60, 12);
  World world = World::create(script.domain).value();
  std::ostringstream out;
  ReplayWriter log(out, world, 3);
  for (const Step& step : script.steps) {
    const auto ids = world.apply(step.changes);
    if (ids.ok()) {
      EXPECT_TRUE(log.record(step.changes, *ids).ok());
    }
    EXPECT_TRUE(log.tick(world).ok());
  }
  return out.str();
}

TEST(Replay, OfRandomLogsFindsNoDifference) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ReplayResult result = replay(parse(random_log(seed))).value();
    EXPECT_TRUE(result.is_same) << seed;
    EXPECT_EQ(result.ticks, 60U);
  }
}

/// Returns whether a log changes the item of a line again before the next hash.
bool is_changed_again(const Script& log, std::size_t line) {
  for (std::size_t i = line + 1; i < log.lines.size() && !log.lines[i].items_hash; ++i) {
    if (log.lines[i].kind != ScriptLineKind::tick && log.lines[i].item.id == log.lines[line].item.id) return true;
  }
  return false;
}

/// Removes one change from a log at a time: the replay must stop, and the comparison must find the change.
TEST(Replay, FindsAMissingChange) {
  const Script log = parse(random_log(1));
  for (std::size_t i = 0; i < log.lines.size(); ++i) {
    if (log.lines[i].kind == ScriptLineKind::tick) continue;
    Script shorter = log;
    shorter.lines.erase(shorter.lines.begin() + static_cast<std::ptrdiff_t>(i));
    const std::optional<ReplayDifference> difference = find_difference(log, shorter);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->kind, ReplayDifference::Kind::change);
    EXPECT_FALSE(replay(shorter).value().is_same && !is_changed_again(log, i)) << "line " << log.lines[i].line;
  }
}

TEST(FindDifference, ComparesChangesAndHashes) {
  using Kind = ReplayDifference::Kind;
  const std::string start = log_with("point 1 1 2\ntick 1 " + kOnePoint + "\n");
  const auto compare = [&](const std::string& a, const std::string& b) {
    return find_difference(parse(start + a), parse(start + b));
  };
  EXPECT_FALSE(compare("", "").has_value());
  EXPECT_FALSE(compare("locate 1 1\nremove 1\ntick 2\n", "remove 1\nhash\ntick 2 " + kNothing + "\n").has_value());
  const auto change = compare("locate 1 1\nremove 1\ntick 2\n", "point 4 1 1\ntick 2\n");
  EXPECT_EQ(change->kind, Kind::change);
  EXPECT_EQ(change->tick, 2U);
  EXPECT_EQ(change->line, 6U);
  EXPECT_EQ(change->other_line, 5U);
  EXPECT_EQ(change->item, ItemId{1});
  EXPECT_EQ(change->other_item, ItemId{4});
  const auto missing = compare("tick 2\n", "remove 1\ntick 2\n");
  EXPECT_EQ(missing->kind, Kind::change);
  EXPECT_EQ(missing->item, ItemId{});
  EXPECT_EQ(missing->other_item, ItemId{1});
  EXPECT_EQ(compare("point 4 1 1\n", "point 4 1 3\n")->kind, Kind::change);
  EXPECT_EQ(compare("polygon 4 1 1 1\n", "polygon 4 nonzero 1 1 1\n")->kind, Kind::change);
  const auto hash = compare("remove 1\ntick 2 " + kNothing + "\n", "remove 1\ntick 2 " + kOnePoint + "\n");
  EXPECT_EQ(hash->kind, Kind::hash);
  EXPECT_EQ(hash->tick, 2U);
  EXPECT_EQ(hash->changed, std::vector<ItemId>{1});
  const auto length = compare("", "tick 2\n");
  EXPECT_EQ(length->kind, Kind::length);
  EXPECT_EQ(length->tick, 1U);
  EXPECT_EQ(length->line, 0U);
  EXPECT_EQ(length->other_line, 5U);
  const auto domain = find_difference(parse("waywright 1\ndomain 0 0 1 1\n"), parse("waywright 1\ndomain 0 0 1 2\n"));
  EXPECT_EQ(domain->kind, Kind::domain);
}

}  // namespace
}  // namespace waywright::test

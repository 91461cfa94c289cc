// The lines `mark` and `rewind` of world scripts.

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/replay.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"
#include "waywright/world.hpp"

namespace waywright {
namespace {

Script parsed_history(const std::string& lines) {
  const Result<Script> script = parse_script("waywright 1\ndomain 0 0 10 10\n" + lines, "test");
  EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().message());
  return script.ok() ? *script : Script{};
}

std::vector<std::uint64_t> ids_after(const std::string& lines) {
  std::vector<std::uint64_t> ids;
  for (const Item& item : scene_of(parsed_history(lines)).items) ids.push_back(item.id.value);
  return ids;
}

TEST(ScriptHistory, IsReadWithTheTicksOfTheWorld) {
  const Script script = parsed_history("mark 1\nmark 2\nrewind 1\nmark 2\nmark 3\nrewind 3\nrewind 2\nmark 3\n");
  ASSERT_EQ(script.lines.size(), 8U);
  EXPECT_EQ(script.lines[0].kind, ScriptLineKind::mark);
  EXPECT_EQ(to_string(script.lines[0]), "mark");
  EXPECT_EQ(script.lines[2].kind, ScriptLineKind::rewind);
  EXPECT_EQ(script.lines[2].tick, 1U);
  EXPECT_EQ(to_string(script.lines[2]), "rewind");
}

TEST(ScriptHistory, DecidesWhichItemsAreLeft) {
  EXPECT_EQ(ids_after("point 1 1 1\nmark 1\npoint 2 2 2\nremove 1\nrewind 1\n"), std::vector<std::uint64_t>{1});
  EXPECT_EQ(ids_after("mark 1\npoint 1 1 1\nmark 2\nremove 1\nrewind 2\nrewind 1\npoint 4 1 1\n"),
            std::vector<std::uint64_t>{4});
  // A state can be brought back more than once.
  EXPECT_EQ(ids_after("point 1 1 1\nmark 1\nremove 1\nrewind 1\nremove 1\nrewind 1\n"), std::vector<std::uint64_t>{1});
}

TEST(ScriptHistory, BringsBackShapes) {
  const Scene scene = scene_of(parsed_history("point 1 1 1\nmark 1\nreplace segment 1 3 3 4 4\nrewind 1\n"));
  EXPECT_EQ(scene.items, (std::vector<Item>{{1, Shape::point({1, 1})}}));
}

/// A script with random changes, marks and rewinds, and the items at its end: the model copies all items at each mark.
struct RandomScript {
  std::string text;
  std::map<ItemId, Shape> items;
};

RandomScript random_script(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint64_t count) { return random() % count; };
  RandomScript result;
  std::vector<std::map<ItemId, Shape>> marks;
  for (std::size_t i = 0; i < 60; ++i) {
    const std::uint64_t id = 1 + below(6);
    const Point at{static_cast<double>(below(12)), static_cast<double>(below(10))};  // some are outside the domain
    const std::string point =
        "point " + std::to_string(id) + " " + std::to_string(at.x) + " " + std::to_string(at.y) + "\n";
    switch (below(6)) {
      case 0:
      case 1:
        if (at.x <= 10) result.items.try_emplace(id, Shape::point(at));
        result.text += point;
        break;
      case 2:
        if (at.x <= 10 && result.items.contains(id)) result.items[id] = Shape::point(at);
        result.text += "replace " + point;
        break;
      case 3:
        result.items.erase(id);
        result.text += "remove " + std::to_string(id) + "\n";
        break;
      case 4:
        marks.push_back(result.items);
        result.text += "mark " + std::to_string(marks.size()) + "\n";
        break;
      default:
        if (marks.empty()) break;
        marks.resize(1 + below(marks.size()));
        result.items = marks.back();
        result.text += "rewind " + std::to_string(marks.size()) + "\n";
    }
  }
  return result;
}

TEST(ScriptHistory, OfRandomScriptsAgreesWithCopiesOfAllItems) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const RandomScript random = random_script(seed);
    std::map<ItemId, Shape> left;
    for (const Item& item : scene_of(parsed_history(random.text)).items) left.emplace(item.id, item.shape);
    ASSERT_EQ(left, random.items) << "seed " << seed << "\n" << random.text;
  }
}

std::string hash_of_point(std::uint64_t id, Point at) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_point(at, id).value();
  return to_string(world.items_hash());
}

TEST(Replay, GoesBack) {
  const std::string one = hash_of_point(1, {1, 1});
  const std::string log = "point 1 1 1\nmark 1\nremove 1\npoint 2 2 2\nmark 2\nrewind 1\ntick 1 " + one + "\n";
  EXPECT_TRUE(replay(parsed_history(log)).value().is_same);
  // Without the rewind, the hash differs.
  const std::string forward = "point 1 1 1\nmark 1\nremove 1\npoint 2 2 2\nmark 2\ntick 1 " + one + "\n";
  EXPECT_FALSE(replay(parsed_history(forward)).value().is_same);
}

TEST(FindDifference, ComparesMarksAndRewinds) {
  const std::string start = "mark 1\npoint 1 1 1\nmark 2\n";
  const auto compare = [&](const std::string& a, const std::string& b) {
    return find_difference(parsed_history(start + a), parsed_history(start + b));
  };
  EXPECT_FALSE(compare("rewind 1\n", "rewind 1\n").has_value());
  for (const std::string other : {"rewind 2\n", "", "mark 3\n", "remove 1\n"}) {
    const auto difference = compare("rewind 1\n", other);
    ASSERT_TRUE(difference.has_value()) << other;
    EXPECT_EQ(difference->kind, ReplayDifference::Kind::change);
    EXPECT_EQ(difference->line, 6U);
    EXPECT_TRUE(difference->item.is_null());
  }
}

}  // namespace
}  // namespace waywright

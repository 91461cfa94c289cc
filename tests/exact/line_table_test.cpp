#include "exact/line_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "exact/geometry.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using exact::LineTable;
using exact::PointPair;

/// The points of a line, the lesser one first.
using Key = std::vector<double>;

Key key_of(const PointPair& points) {
  const auto [a, b] = points;
  return std::pair(a.x, a.y) < std::pair(b.x, b.y) ? Key{a.x, a.y, b.x, b.y} : Key{b.x, b.y, a.x, a.y};
}

/// What the table must contain: the uses of each line, and the slot that the table gave it.
struct Model {
  struct Line {
    std::size_t uses = 0;
    LineTable::Slot slot = LineTable::kNone;
  };
  std::map<Key, Line> lines;

  void drop_unused() {
    std::erase_if(lines, [](const auto& line) { return line.second.uses == 0; });
  }
};

void expect_equal(const LineTable& table, const Model& model) {
  ASSERT_EQ(table.size(), model.lines.size());
  std::vector<LineTable::Slot> slots;
  for (const auto& [key, line] : model.lines) {
    ASSERT_EQ(key_of(table[line.slot]), key);
    slots.push_back(line.slot);
  }
  std::sort(slots.begin(), slots.end());
  ASSERT_EQ(std::adjacent_find(slots.begin(), slots.end()), slots.end()) << "two lines have one slot";
}

// Operations of random length on few different lines, so that the table frees lines, uses their records again, and
// revives lines without a use. Some operations are rolled back.
TEST(LineTable, CountsUsesAndFreesLinesWithoutUse) {
  Random random(1);
  LineTable table;
  Model model;
  std::size_t most = 0, freed = 0, rolled_back = 0;
  // Few values, and for each also the next double, so that keys differ in high and in low bits. Zero has both signs.
  const auto coordinate = [&] {
    const double value = static_cast<double>(random.between(-3, 3)) * 0x1p-2;
    if (value == 0.0) return random.chance(50) ? 0.0 : -0.0;
    return random.chance(90) ? value : std::nextafter(value, 9.0);
  };
  for (int operation = 0; operation < case_count(3000, 4); ++operation) {
    table.begin();
    freed += model.lines.size();
    model.drop_unused();
    freed -= model.lines.size();
    ASSERT_NO_FATAL_FAILURE(expect_equal(table, model));
    const Model before = model;
    const bool grows = operation / 300 % 2 == 0;
    std::vector<std::pair<bool, std::array<LineTable::Slot, 2>>> log;  // whether the uses were added, and the lines
    LineTable::Slot hint = LineTable::kNone;
    for (std::int64_t i = random.between(0, 20); i > 0; --i) {
      std::array<LineTable::Slot, 2> pair{};
      const bool adds = model.lines.size() < 4 || random.chance(grows ? 60 : 40);
      if (adds) {
        for (LineTable::Slot& slot : pair) {
          const PointPair points = {{coordinate(), coordinate()}, {9, coordinate()}};
          slot = random.chance(50) ? table.find_or_make(points, hint) : table.find_or_make({points.b, points.a});
          Model::Line& line = model.lines[key_of(points)];
          if (line.slot == LineTable::kNone) line.slot = slot;
          ASSERT_EQ(slot, line.slot) << "a second record of one line";
        }
        hint = static_cast<LineTable::Slot>(random.below(50));
        table.add_uses(pair[0], pair[1]);
      } else {
        std::vector<LineTable::Slot> used;
        for (const auto& [key, line] : model.lines) {
          if (line.uses > 0) used.push_back(line.slot);
        }
        if (used.size() < 2) continue;
        const std::size_t first = random.below(used.size());
        pair = {used[first], used[(first + 1 + random.below(used.size() - 1)) % used.size()]};
        table.remove_uses(pair[0], pair[1]);
      }
      log.emplace_back(adds, pair);
      for (const LineTable::Slot slot : pair) {
        for (auto& [key, line] : model.lines) {
          if (line.slot == slot) adds ? ++line.uses : --line.uses;
        }
      }
    }
    most = std::max(most, model.lines.size());
    if (random.chance(30)) {
      for (; !log.empty(); log.pop_back()) {
        const auto [was_added, pair] = log.back();
        was_added ? table.take_back_uses(pair[0], pair[1]) : table.add_uses(pair[0], pair[1]);
      }
      table.roll_back();
      model = before;
      ++rolled_back;
    }
    ASSERT_NO_FATAL_FAILURE(expect_equal(table, model));
  }
  EXPECT_GT(most, 200U);
  EXPECT_GT(freed, case_count<std::size_t>(1000, 4));
  EXPECT_GT(rolled_back, case_count<std::size_t>(500, 4));
}

// Ten thousand lines with one use each, which then all go.
TEST(LineTable, UsesFreedRecordsAgain) {
  LineTable table;
  const auto line = [](int i) { return PointPair{{0.0, static_cast<double>(i)}, {1.0, 0.5}}; };
  MemoryUse use;
  for (int round = 0; round < 3; ++round) {
    table.begin();
    std::vector<LineTable::Slot> slots;
    for (int i = 0; i < 10000; ++i) slots.push_back(table.find_or_make(line(i + round * 10000)));
    for (std::size_t i = 0; i < slots.size(); i += 2) table.add_uses(slots[i], slots[i + 1]);
    EXPECT_EQ(table.size(), 10000U);
    MemoryUse now;
    table.count_memory(now, &MemoryUse::crossings);
    if (round > 0) {
      EXPECT_EQ(now.crossings, use.crossings);
    }
    use = now;
    for (std::size_t i = 0; i < slots.size(); i += 2) table.remove_uses(slots[i], slots[i + 1]);
    table.begin();
    EXPECT_EQ(table.size(), 0U);
  }
}

TEST(LineTable, FindsALineWhateverTheSignOfZero) {
  LineTable table;
  const LineTable::Slot line = table.find_or_make({{0.0, 5.0}, {-0.0, -1.0}});
  (void)table.find_or_make({{-3.0, 5.0}, {-3.0, -1.0}});  // the sign of the first coordinate divides the two
  EXPECT_EQ(table.find_or_make({{0.0, -1.0}, {-0.0, 5.0}}), line);
  EXPECT_EQ(table.find_or_make({{-0.0, -1.0}, {-0.0, 5.0}}), line);
  EXPECT_EQ(table.size(), 2U);
}

/// Puts the ends of `count` horizontal and of `count` vertical sides into a geometry, as vertices, and all crossings of
/// these sides. No crossing has coordinates that doubles can express, because the horizontal sides rise slightly.
void add_grid(exact::Geometry& geometry, std::uint32_t count) {
  std::uint32_t vertex = 0;
  const double size = count + 1.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    geometry.set_position(vertex++, {0.0, i + 1.0});
    geometry.set_position(vertex++, {3 * size, i + 2.0});
    geometry.set_position(vertex++, {3.0 * i + 1.0, 0.0});
    geometry.set_position(vertex++, {3.0 * i + 2.0, size + 1.0});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = 0; j < count; ++j) {
      geometry.set_crossing(vertex++, 4 * i, 4 * i + 1, 4 * j + 2, 4 * j + 3);
    }
  }
}

// The bytes, derived by hand: 8 for the slots of the two lines of a vertex, in pages of 64 vertices, and less than 1
// for the table of pages. A line takes 40 bytes, and its fork 12.
TEST(Geometry, StoresEachLineOnce) {
  constexpr std::uint32_t kCount = 100;
  exact::Geometry geometry(Box{{0, 0}, {400, 400}});
  add_grid(geometry, kCount);
  MemoryUse use;
  geometry.count_memory(use);
  std::size_t constructed = 0;
  for (std::uint32_t v = 4 * kCount; v < 4 * kCount + kCount * kCount; ++v)
    constructed += geometry.is_explicit(v) ? 0 : 1;
  EXPECT_GT(constructed, 9000U);
  EXPECT_LE(use.crossings, (8 + 1) * (kCount * kCount + 2 * 64) + 2 * kCount * (40 + 12));
}

// Whether there are constructed vertices decides how much distances may be rounded, so it must not depend on vertices
// that no longer exist.
TEST(Geometry, HasNoConstructedVertexAfterItsRemoval) {
  exact::Geometry geometry(Box{{0, 0}, {40, 40}});
  EXPECT_FALSE(geometry.has_constructed());
  add_grid(geometry, 2);
  EXPECT_TRUE(geometry.has_constructed());
  geometry.begin();
  for (std::uint32_t v = 8; v < 12; ++v) geometry.clear(v);
  EXPECT_FALSE(geometry.has_constructed());
  geometry.roll_back();
  EXPECT_TRUE(geometry.has_constructed());
  for (std::uint32_t v = 8; v < 12; ++v) geometry.clear(v);
  geometry.begin();
  geometry.set_crossing(8, 0, 1, 2, 3);
  EXPECT_TRUE(geometry.has_constructed());
  geometry.roll_back();
  EXPECT_FALSE(geometry.has_constructed());
}

TEST(Geometry, TakesBackCrossings) {
  exact::Geometry geometry(Box{{0, 0}, {40, 40}});
  add_grid(geometry, 5);
  geometry.begin();
  const auto text = [&](std::uint32_t vertex) { return exact::to_fractions(geometry.exact(vertex)); };
  std::vector<std::string> before;
  for (std::uint32_t v = 20; v < 45; ++v) before.push_back(text(v));
  for (std::uint32_t v = 20; v < 45; v += 2) geometry.clear(v);
  geometry.set_crossing(20, 4, 5, 6, 7);  // the slots of two removed vertices, with other crossings
  geometry.set_crossing(22, 0, 1, 18, 19);
  geometry.set_position(24, {0.5, 0.5});
  geometry.set_crossing(45, 0, 3, 1, 2);  // two new lines
  EXPECT_NE(text(20), before[0]);
  geometry.roll_back();
  for (std::uint32_t v = 20; v < 45; ++v) EXPECT_EQ(text(v), before[v - 20]) << "vertex " << v;
  geometry.begin();
  for (std::uint32_t v = 20; v < 45; ++v) EXPECT_EQ(text(v), before[v - 20]) << "vertex " << v;
}

}  // namespace
}  // namespace waywright::test

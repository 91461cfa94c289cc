#include "constraint/item_table.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

using constraint::ItemTable;
using constraint::Outline;
using mesh::Vertex;

using Ring = std::vector<Vertex>;

struct Entry {
  ItemKind kind;
  std::vector<Ring> rings;
};
using Entries = std::map<ItemId, Entry>;

Outline outline_of(const std::vector<Ring>& rings) {
  Outline outline;
  for (const Ring& ring : rings) {
    outline.corners.insert(outline.corners.end(), ring.begin(), ring.end());
    outline.ring_ends.push_back(static_cast<std::uint32_t>(outline.corners.size()));
  }
  return outline;
}

std::uint32_t add(ItemTable& table, ItemId id, const Entry& entry) {
  const std::uint32_t slot = table.add_item(id, entry.kind, FillRule::even_odd);
  table.set_outline(slot, outline_of(entry.rings));
  return slot;
}

using Ends = std::vector<std::pair<Vertex, Vertex>>;

Ends sides_of(const ItemTable& table, std::uint32_t item) {
  Ends ends;
  table.for_each_side(item, [&](std::uint32_t slot) {
    EXPECT_EQ(table.side(slot).item, item);
    ends.emplace_back(table.side(slot).from, table.side(slot).to);
  });
  return ends;
}

/// Returns the sides between consecutive corners, and from the last corner to the first where the rings are closed.
Ends expected_sides(const Entry& entry) {
  Ends ends;
  for (const Ring& ring : entry.rings) {
    if (ring.size() == 1) continue;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) ends.emplace_back(ring[i], ring[i + 1]);
    if (entry.kind == ItemKind::polygon) ends.emplace_back(ring.back(), ring.front());
  }
  return ends;
}

void expect_entries(const ItemTable& table, const Entries& entries) {
  std::vector<ItemId> ids;
  Outline outline;
  for (const auto& [id, entry] : entries) {
    ids.push_back(id);
    ASSERT_TRUE(table.contains(id));
    const std::uint32_t slot = table.slot(id);
    ASSERT_EQ(table.id(slot), id);
    ASSERT_EQ(table.kind(slot), entry.kind);
    table.outline(slot, outline);
    ASSERT_EQ(outline.corners, outline_of(entry.rings).corners);
    ASSERT_EQ(outline.ring_ends, outline_of(entry.rings).ring_ends);
    ASSERT_EQ(sides_of(table, slot), expected_sides(entry));
  }
  ASSERT_EQ(table.ids(), ids);
  ASSERT_EQ(table.size(), ids.size());
}

/// Returns random corners. Each differs from the corner before it, and the last differs from the first.
Ring random_ring(std::size_t count, Random& random) {
  Ring ring;
  while (ring.size() < count) {
    const Vertex v{static_cast<std::uint32_t>(random.below(100))};
    if (ring.empty() || (ring.back() != v && ring.front() != v)) ring.push_back(v);
  }
  return ring;
}

Entry random_entry(Random& random) {
  switch (random.below(4)) {
    case 0:
      return {ItemKind::point, {random_ring(1, random)}};
    case 1:
      return {ItemKind::segment, {random_ring(1 + random.below(2), random)}};
    case 2:
      return {ItemKind::polyline, {random_ring(1 + random.below(5), random)}};
    default: {
      Entry entry{ItemKind::polygon, {}};
      for (std::size_t rings = 1 + random.below(3); rings > 0; --rings) {
        entry.rings.push_back(random_ring(1 + random.below(5), random));
      }
      return entry;
    }
  }
}

TEST(ItemTable, HoldsItemsOfEveryKindThroughOperationsTakenBackOrNot) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    ItemTable table;
    Entries entries;
    for (int operation = 0; operation < 120; ++operation) {
      const Entries before = entries;
      table.begin();
      for (std::size_t changes = random.below(6); changes > 0; --changes) {
        // Either small consecutive ids, or ids that differ only in their highest bits.
        const std::uint64_t number = 1 + random.below(60);
        const ItemId id{random.chance(50) ? number : number << 57 | 1};
        if (const auto found = entries.find(id); found == entries.end()) {
          entries[id] = random_entry(random);
          add(table, id, entries[id]);
        } else {
          table.remove_item(table.slot(id), {});
          entries.erase(found);
        }
      }
      ASSERT_NO_FATAL_FAILURE(expect_entries(table, entries)) << "seed " << seed << ", operation " << operation;
      if (random.chance(70)) continue;
      table.roll_back();
      entries = before;
      ASSERT_NO_FATAL_FAILURE(expect_entries(table, entries)) << "taken back, seed " << seed;
    }
  }
}

TEST(ItemTable, ReusesTheSlotsOfItemsThatWentOnceTheirOperationIsOver) {
  ItemTable table;
  const Entry square{ItemKind::polygon, {{Vertex{1}, Vertex{2}, Vertex{3}, Vertex{4}}}};
  table.begin();
  const std::uint32_t first = add(table, {7}, square);
  std::uint32_t first_side = 0;
  table.for_each_side(first, [&](std::uint32_t side) { first_side = std::max(first_side, side); });
  table.begin();
  table.remove_item(first, {});
  EXPECT_NE(add(table, {8}, square), first) << "it may yet be taken back";
  table.begin();
  const std::uint32_t again = add(table, {9}, square);
  EXPECT_EQ(again, first);
  table.for_each_side(again, [&](std::uint32_t side) { EXPECT_LE(side, first_side); });
}

}  // namespace
}  // namespace waywright::test

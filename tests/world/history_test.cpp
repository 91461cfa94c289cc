#include "world/history.hpp"

#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

/// Inserts a point into a history.
void insert(History& history, std::uint64_t id) {
  history.begin();
  history.add_insertion({id});
  history.commit();
}

void remove(History& history, std::uint64_t id) {
  history.begin();
  history.add_removal({id}, ItemKind::point, FillRule::even_odd);
  history.add_ring();
  history.add_point({1, 2});
  history.commit();
}

/// Returns the version after the last change of an item since a tick.
std::optional<std::uint64_t> version_after(History& history, History::Tick tick, std::uint64_t id) {
  for (const History::ChangedItem& item : history.changed_since(tick)) {
    if (item.id.value == id) return history.version_after(item);
  }
  ADD_FAILURE() << "item " << id << " has not changed";
  return std::nullopt;
}

TEST(History, KnowsTheTickAfterTheLastChangeOfAnItem) {
  History history;
  history.keep(10);
  const History::Tick first = history.mark(5, {});
  insert(history, 1);
  insert(history, 2);
  const History::Tick second = history.mark(7, {2});
  remove(history, 2);
  insert(history, 2);
  history.mark(9, {2});
  history.mark(9, {2});
  insert(history, 3);
  EXPECT_EQ(version_after(history, first, 1), 7U);
  EXPECT_EQ(version_after(history, first, 2), 9U);
  EXPECT_EQ(version_after(history, second, 2), 9U);
  EXPECT_EQ(version_after(history, first, 3), std::nullopt) << "no tick follows";
  history.return_to(second);
  EXPECT_EQ(version_after(history, first, 2), 7U);
  history.mark(12, {2});
  insert(history, 4);
  history.mark(13, {4});
  EXPECT_EQ(version_after(history, first, 4), 13U);
}

}  // namespace
}  // namespace waywright::test

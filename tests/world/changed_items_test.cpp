#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "world/snapshot_pool.hpp"

namespace waywright::test {
namespace {

std::vector<std::uint64_t> since(ChangedItems& record, std::uint64_t version) {
  std::vector<ItemId> ids;
  record.since(version, ids);
  std::vector<std::uint64_t> numbers;
  for (const ItemId id : ids) numbers.push_back(id.value);
  return numbers;
}

using Numbers = std::vector<std::uint64_t>;

TEST(ChangedItems, AreListedOnceInTheOrderOfTheirVersions) {
  ChangedItems record(10);
  record.add({7}, 11);
  record.add({9}, 12);
  record.add({8}, 12);
  record.add({7}, 13);
  EXPECT_EQ(since(record, 10), (Numbers{8, 9, 7}));
  EXPECT_EQ(since(record, 12), (Numbers{7}));
  EXPECT_FALSE(record.has_all_since(9));
  record.forget_until(12);
  EXPECT_FALSE(record.has_all_since(11));
  EXPECT_EQ(since(record, 12), (Numbers{7}));
}

// The versions before 10 come from a history. Item 3 has changed again after version 10.
TEST(ChangedItems, ReachBackToAnEarlierVersion) {
  constexpr std::uint64_t kUnknown = 0xffffffffffffffff;
  ChangedItems record(10);
  record.add({3}, 12);
  record.extend_to(4, {{7, {2}}, {kUnknown, {3}}, {5, {1}}, {kUnknown, {4}}});
  EXPECT_TRUE(record.has_all_since(4));
  EXPECT_FALSE(record.has_all_since(3));
  EXPECT_EQ(since(record, 4), (Numbers{1, 2, 4, 3}));
  EXPECT_EQ(since(record, 5), (Numbers{2, 4, 3}));
  EXPECT_EQ(since(record, 7), (Numbers{4, 3}));
  EXPECT_EQ(since(record, 9), (Numbers{4, 3}));
  EXPECT_EQ(since(record, 10), (Numbers{3}));
}

TEST(ChangedItems, DropTheOldestIfThereAreTooMany) {
  ChangedItems record(0);
  for (std::uint64_t i = 1; i <= 100'000; ++i) record.add({i}, i);
  EXPECT_FALSE(record.has_all_since(0));
  EXPECT_TRUE(record.has_all_since(99'900));
  EXPECT_EQ(since(record, 99'998), (Numbers{99'999, 100'000}));
}

}  // namespace
}  // namespace waywright::test

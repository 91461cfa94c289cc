#include "memory/journal.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "memory/scratch.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

TEST(Journal, UndoesTheNewestChangeFirst) {
  memory::Journal<int> journal;
  journal.add(7);  // belongs to an earlier operation
  journal.begin();
  journal.add(1);
  journal.add(2);
  journal.add(3);
  std::vector<int> seen;
  journal.for_each([&](int change) { seen.push_back(change); });
  EXPECT_EQ(seen, (std::vector{1, 2, 3}));
  seen.clear();
  journal.roll_back([&](int change) { seen.push_back(change); });
  EXPECT_EQ(seen, (std::vector{3, 2, 1}));
  journal.roll_back([&](int) { FAIL() << "there is nothing left to undo"; });
}

// Random operations, some of which are rolled back, compared with copies of a plain vector.
TEST(JournaledArray, IsAsBeforeAfterRollBack) {
  Random random(3);
  memory::JournaledArray<int> array;
  std::vector<int> expected;
  for (int operation = 0; operation < 500; ++operation) {
    array.begin();
    const std::vector<int> before = expected;
    for (std::uint64_t i = random.below(8); i > 0; --i) {
      const int value = static_cast<int>(random.below(1000));
      if (expected.empty() || random.chance(30)) {
        array.append(value);
        expected.push_back(value);
      } else {
        const auto at = static_cast<std::uint32_t>(random.below(expected.size()));
        array.write(at, value);
        expected[at] = value;
      }
    }
    if (random.chance(50)) {
      array.roll_back();
      expected = before;
    }
    ASSERT_EQ(array.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(array[i], expected[i]) << "operation " << operation;
  }
}

TEST(JournaledArray, RollBackKeepsUnrecordedChanges) {
  memory::JournaledArray<int> array;
  array.begin();
  array.grow_to(3, 5);
  array.write(1, 6);
  array.unrecorded(2) = 7;
  std::vector<std::uint32_t> written;
  array.for_each_written([&](std::uint32_t i) { written.push_back(i); });
  EXPECT_EQ(written, (std::vector<std::uint32_t>{1}));
  array.roll_back();
  ASSERT_EQ(array.size(), 3U);
  EXPECT_EQ(array[0], 5);
  EXPECT_EQ(array[1], 5);
  EXPECT_EQ(array[2], 7);
}

TEST(FreeList, HandsOutTheSlotFreedLast) {
  std::vector<std::uint32_t> links(3);
  memory::FreeList list;
  EXPECT_TRUE(list.is_empty());
  for (const std::uint32_t slot : {2U, 0U, 1U}) links[slot] = list.push(slot);
  for (const std::uint32_t slot : {1U, 0U, 2U}) {
    ASSERT_FALSE(list.is_empty());
    EXPECT_EQ(list.first(), slot);
    EXPECT_EQ(list.pop(links[slot]), slot);
  }
  EXPECT_TRUE(list.is_empty());
}

struct Cleared {
  int times = 0;
  void clear() { ++times; }
};

TEST(Stamp, ClearsTheArraysBeforeANumberComesTwice) {
  memory::Stamp stamp;
  Cleared first;
  Cleared second;
  constexpr std::uint32_t kStep = 1U << 30;
  for (const std::uint32_t value : {1U, 2U, 3U}) {
    stamp.next(kStep, first, second);
    EXPECT_EQ(stamp.value(), value * kStep);
  }
  EXPECT_EQ(first.times, 0);
  stamp.next(kStep, first, second);
  EXPECT_EQ(stamp.value(), kStep);
  EXPECT_EQ(first.times, 1);
  EXPECT_EQ(second.times, 1);
}

}  // namespace
}  // namespace waywright::test

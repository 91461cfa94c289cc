#include "memory/sliding_array.hpp"

#include <cstdint>
#include <deque>

#include <gtest/gtest.h>

#include "waywright/memory_use.hpp"

#include "support/random.hpp"

namespace waywright::memory {
namespace {

TEST(SlidingArray, AgreesWithAQueue) {
  test::Random random(3);
  SlidingArray<int> array;
  std::deque<int> queue;
  std::uint64_t begin = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t size = queue.size();
    if (random.chance(80)) {
      array.push_back(i);
      queue.push_back(i);
    } else if (random.chance(50)) {
      const std::uint64_t kept = size - random.below(size / 4 + 1);
      array.truncate(begin + kept);
      queue.resize(kept);
    } else {
      const std::uint64_t dropped = random.below(size / 2 + 1);
      begin += dropped;
      array.drop_before(begin);
      queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(dropped));
    }
    ASSERT_EQ(array.begin(), begin);
    ASSERT_EQ(array.end(), begin + queue.size());
    for (std::uint64_t k = 0; k < queue.size(); k += 1 + queue.size() / 8) ASSERT_EQ(array[begin + k], queue[k]);
  }
  EXPECT_GT(begin, 100U);
}

TEST(SlidingArray, FreesTheMemoryOfWhatItDrops) {
  SlidingArray<std::uint64_t> array;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    array.push_back(i);
    if (i >= 10) array.drop_before(i - 10);
  }
  MemoryUse use;
  array.count_memory(use, &MemoryUse::history);
  EXPECT_LE(use.total(), 8U * 64U);
  array.drop_before(array.end());
  array.shrink_to_fit();
  MemoryUse empty;
  array.count_memory(empty, &MemoryUse::history);
  EXPECT_EQ(empty.total(), 0U);
  EXPECT_EQ(array.begin(), 100000U);
}

}  // namespace
}  // namespace waywright::memory

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "locate/sectors.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using locate::CompactArray;

void expect_equal(const CompactArray& array, const std::vector<std::uint32_t>& expected) {
  ASSERT_EQ(array.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(array[i], expected[i]) << "index " << i;
}

std::size_t bytes_of(const CompactArray& array) {
  MemoryUse use;
  array.count_memory(use, &MemoryUse::sectors);
  return use.sectors;
}

std::vector<std::uint32_t> ascending(std::size_t count) {
  std::vector<std::uint32_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::uint32_t>(1000 + 17 * i);
  return values;
}

// 16 numbers that ascend by 17 span 255, which is the largest difference. A block of 16 numbers takes 20 bytes.
TEST(CompactArray, PacksNumbersThatAscendSlowly) {
  for (const std::size_t count : {15U, 16U, 17U, 160U, 1000U}) {
    const std::vector<std::uint32_t> values = ascending(count);
    CompactArray array(memory::Array<std::uint32_t>{values});
    EXPECT_EQ(bytes_of(array), 4 * count);
    array.pack();
    expect_equal(array, values);
    EXPECT_EQ(bytes_of(array), (count + 15) / 16 * 20);
  }
}

TEST(CompactArray, StaysPlainIfPackingSavesNothing) {
  std::vector<std::uint32_t> values = ascending(160);
  for (std::size_t i = 0; i < values.size(); i += 16) values[i] += 300;
  CompactArray array(memory::Array<std::uint32_t>{values});
  array.pack();
  expect_equal(array, values);
  EXPECT_EQ(bytes_of(array), 4U * 160);
  CompactArray three(memory::Array<std::uint32_t>{std::vector<std::uint32_t>{7, 8, 9}});
  three.pack();
  EXPECT_EQ(bytes_of(three), 12U);
  CompactArray empty;
  empty.pack();
  EXPECT_EQ(empty.size(), 0U);
}

// A number that does not fit widens its block by 64 bytes. With 10 blocks (200 bytes), the seventh wide block takes the
// array above the 640 bytes of a plain one. Only shrink_to_fit() makes it plain, so a change never takes linear time.
TEST(CompactArray, WidensBlocks) {
  for (const std::uint32_t value : {1000000U, 0U, 0x80000000U, 0xffffffffU, 0x7fffffffU}) {
    std::vector<std::uint32_t> values = ascending(160);
    CompactArray array(memory::Array<std::uint32_t>{values});
    array.pack();
    for (std::size_t block = 0; block < 10; ++block) {
      values[16 * block + block] = value;
      array.set(16 * block + block, value);
      expect_equal(array, values);
      EXPECT_EQ(bytes_of(array), 200 + 64 * (block + 1));
      CompactArray small = array;
      small.shrink_to_fit();
      expect_equal(small, values);
      EXPECT_EQ(bytes_of(small), block < 6 ? 200 + 64 * (block + 1) : 640);
    }
  }
}

TEST(CompactArray, AgreesWithAVector) {
  Random random(1);
  std::size_t packed = 0, plain = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint32_t> values = ascending(random.below(400));
    CompactArray array(memory::Array<std::uint32_t>{values});
    for (int step = 0; step < 60; ++step) {
      const auto value = [&]() -> std::uint32_t {
        if (random.chance(5)) return static_cast<std::uint32_t>(random.next());
        return static_cast<std::uint32_t>(1000 + random.below(17 * (values.size() + 16)));
      };
      const std::uint64_t kind = random.below(100);
      if (kind < 2) {
        const std::size_t size = random.below(values.size() + 1);
        values.resize(size);
        array.truncate(size);
      } else if (kind < 20) {
        const std::uint32_t added = random.chance(50) || values.empty() ? value() : values.back();
        values.insert(values.end(), 4, added);
        array.append(4, added);
      } else if (kind < 25) {
        array.truncate(values.size());  // makes it plain
        array.pack();
      } else if (!values.empty()) {
        const std::size_t i = random.below(values.size());
        const std::uint32_t near = values[i / 16 * 16] + static_cast<std::uint32_t>(random.below(300));
        values[i] = random.chance(30) ? value() : near;
        array.set(i, values[i]);
      }
      const bool is_plain = bytes_of(array) == 4 * values.size();
      ++(is_plain ? plain : packed);
      EXPECT_LE(bytes_of(array), is_plain ? 4 * values.size() : (values.size() + 15) / 16 * (20 + 64));
    }
    const CompactArray copy = array;
    array.shrink_to_fit();
    ASSERT_NO_FATAL_FAILURE(expect_equal(array, values));
    ASSERT_NO_FATAL_FAILURE(expect_equal(copy, values));
  }
  EXPECT_GT(packed, 2000U);
  EXPECT_GT(plain, 2000U);
}

}  // namespace
}  // namespace waywright::test

#include "memory/array.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "memory/allocations.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using memory::Array;

struct Wide {
  std::uint64_t a, b, c;
  friend bool operator==(const Wide&, const Wide&) = default;
};

Wide wide(std::uint64_t i) { return {i, i * i, ~i}; }

std::vector<Wide> values_of(const Array<Wide>& array) { return {array.begin(), array.end()}; }

TEST(Array, AgreesWithAVector) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    Array<Wide> array;
    std::vector<Wide> expected;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const std::size_t size = expected.size();
      switch (random.below(9)) {
        case 0:
          if (size != 0) array.pop_back(), expected.pop_back();
          break;
        case 1: {
          const std::size_t next = random.below(2 * size + 2);
          array.resize(next, wide(i)), expected.resize(next, wide(i));
          break;
        }
        case 2:
          array.push_front(wide(i)), expected.insert(expected.begin(), wide(i));
          break;
        case 3:
          array.shrink_to_fit();
          EXPECT_EQ(array.capacity(), size);
          break;
        case 4:
          array.reserve(size + random.below(20));
          break;
        case 5: {
          Array<Wide> copy(array);
          EXPECT_EQ(values_of(copy), expected);
          array = std::move(copy);
          break;
        }
        case 6:
          if (size != 0) array[size / 2] = wide(i), expected[size / 2] = wide(i);
          break;
        default:
          array.push_back(wide(i)), expected.push_back(wide(i));
      }
      ASSERT_EQ(values_of(array), expected);
      ASSERT_LE(array.size(), array.capacity());
    }
  }
}

// The value lies in the memory that the array leaves when it grows.
TEST(Array, AppendsOneOfItsOwnValues) {
  Array<Wide> array;
  array.push_back(wide(7));
  for (int i = 0; i < 100; ++i) {
    array.push_back(array[0]);
    array.resize(array.size() + array.capacity(), array.back());
    array.shrink_to_fit();
    if (array.size() > 1000) break;
  }
  for (const Wide& value : array) EXPECT_EQ(value, wide(7));
}

TEST(Array, StaysAsItIsIfMemoryRunsOut) {
  Array<Wide> array(4, wide(3));
  array.shrink_to_fit();
  EXPECT_FALSE(gets_through(1, [&] { array.push_back(wide(4)); }));
  EXPECT_FALSE(gets_through(1, [&] { array.resize(9); }));
  EXPECT_FALSE(gets_through(1, [&] { array.reserve(9); }));
  EXPECT_FALSE(gets_through(1, [&] { Array<Wide> copy(array); }));
  EXPECT_EQ(values_of(array), std::vector<Wide>(4, wide(3)));
  array.reserve(9);
  EXPECT_TRUE(gets_through(1, [&] { array.shrink_to_fit(); }));
  EXPECT_EQ(array.capacity(), 9U);
  EXPECT_EQ(values_of(array), std::vector<Wide>(4, wide(3)));
}

}  // namespace
}  // namespace waywright::test

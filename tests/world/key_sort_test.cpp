#include "world/key_sort.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

TEST(SortKeys, AgreesWithTheSortOfTheStandardLibrary) {
  Random random(1);
  std::vector<std::uint64_t> scratch;
  for (const std::size_t size : {0U, 1U, 2U, 64U, 65U, 300U, 5000U}) {
    // Keys that differ in no byte, in some bytes, in all bytes.
    for (const std::uint64_t mask : {std::uint64_t{0}, std::uint64_t{0xff}, std::uint64_t{0xffff},
                                     std::uint64_t{0xff00ff0000ff00}, ~std::uint64_t{0}}) {
      std::vector<std::uint64_t> keys;
      for (std::size_t i = 0; i < size; ++i) keys.push_back((random.next() & mask) | (~mask & 0x0123456789abcdefU));
      std::vector<std::uint64_t> expected = keys;
      std::sort(expected.begin(), expected.end());
      sort_keys(keys, scratch);
      EXPECT_EQ(keys, expected) << size << " keys, mask " << mask;
    }
  }
}

}  // namespace
}  // namespace waywright::test

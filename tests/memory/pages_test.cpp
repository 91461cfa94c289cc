#include "memory/pages.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

TEST(Pages, ComeWithTheFirstValueAndHoldNothingElse) {
  memory::Pages<std::uint32_t> pages;
  pages.grow_to(5000);
  EXPECT_FALSE(pages.has_room(4999));
  pages.make_room(4999);
  pages[4999] = 7;
  EXPECT_TRUE(pages.has_room(4096));
  EXPECT_EQ(pages[4096], 0U);
  EXPECT_FALSE(pages.has_room(4095));
  pages.make_room(4999);
  EXPECT_EQ(pages[4999], 7U);
  MemoryUse use;
  pages.count_memory(use, &MemoryUse::walls);
  EXPECT_EQ(use.walls, 5 * sizeof(void*) + 4096);
}

TEST(Pages, AreClearedToWhatTheyCover) {
  memory::Pages<std::uint32_t> pages;
  pages.grow_to(3000);
  pages.make_room(2500);
  pages[2500] = 7;
  pages.clear();
  EXPECT_FALSE(pages.has_room(2500));
  pages.make_room(2500);
  EXPECT_EQ(pages[2500], 0U);
  pages.grow_to(2000);
  EXPECT_TRUE(pages.has_room(2500)) << "covers no less than before";
}

}  // namespace
}  // namespace waywright::test

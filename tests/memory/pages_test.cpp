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

TEST(Pages, FindValuesWhereThereIsRoom) {
  memory::Pages<std::uint32_t, 64> pages;
  EXPECT_EQ(pages.find(0), nullptr);
  pages.grow_to(200);
  pages.make_room(130);
  pages[130] = 7;
  ASSERT_NE(pages.find(130), nullptr);
  EXPECT_EQ(*pages.find(130), 7U);
  ASSERT_NE(pages.find(191), nullptr);
  EXPECT_EQ(*pages.find(191), 0U);
  EXPECT_EQ(pages.find(127), nullptr) << "another page";
  EXPECT_EQ(pages.find(192), nullptr) << "another page";
  EXPECT_EQ(pages.find(1000), nullptr) << "beyond the table";
  MemoryUse use;
  pages.count_memory(use, &MemoryUse::walls);
  EXPECT_EQ(use.walls, 4 * sizeof(void*) + 256);
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

#include "memory/arena.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "memory/array.hpp"
#include "memory/pages.hpp"

namespace waywright::test {
namespace {

using memory::Arena;
using memory::ArenaScope;
using Numbers = memory::Array<std::uint32_t>;

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// A large object: its copy constructor copies arrays.
struct Large {
  Large() : numbers(100'000, 7) {
    pages.grow_to(10'000);
    for (std::size_t i = 0; i < 10'000; i += 3000) {
      pages.make_room(i);
      pages[i] = static_cast<std::uint32_t>(i);
    }
  }

  Numbers numbers;
  memory::Pages<std::uint32_t> pages;
};

Large copy_in(Arena& arena, const Large& original) {
  const ArenaScope scope(arena);
  return Large(original);
}

bool are_equal(const Large& a, const Large& b) {
  if (!std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end())) return false;
  for (std::size_t i = 0; i < 10'000; ++i) {
    if (a.pages.has_room(i) != b.pages.has_room(i)) return false;
    if (a.pages.has_room(i) && a.pages[i] != b.pages[i]) return false;
  }
  return true;
}

class ArenaTest : public testing::Test {
 protected:
  void SetUp() override {
    arena = Arena::make(kMegabyte);
    if (arena == nullptr) GTEST_SKIP() << "this system does not share pages";
  }

  std::unique_ptr<Arena> arena;
};

TEST_F(ArenaTest, ContainsTheArraysOfACopy) {
  const Large original;
  const Large base = copy_in(*arena, original);
  EXPECT_TRUE(are_equal(base, original));
  EXPECT_FALSE(arena->contains(original.numbers.data()));
  EXPECT_TRUE(arena->contains(base.numbers.data()));
  EXPECT_TRUE(arena->contains(&base.pages[3000]));
  EXPECT_FALSE(arena->contains(&base));
  EXPECT_GT(base.numbers.capacity(), base.numbers.size()) << "spare room";
  const Numbers copied_outside_of_a_scope(base.numbers);
  EXPECT_FALSE(arena->contains(copied_outside_of_a_scope.data()));
}

TEST_F(ArenaTest, KeepsTheValuesOfEachCopyApart) {
  const Large base = copy_in(*arena, Large());
  std::vector<std::unique_ptr<Arena>> arenas;
  std::vector<Large> copies;
  copies.reserve(5);
  for (std::uint32_t i = 0; i < 5; ++i) {
    arenas.push_back(arena->share());
    ASSERT_NE(arenas.back(), nullptr);
    copies.push_back(copy_in(*arenas.back(), base));
    ASSERT_TRUE(arenas.back()->contains(copies.back().numbers.data()));
    ASSERT_TRUE(arenas.back()->contains(&copies.back().pages[3000]));
    ASSERT_TRUE(are_equal(copies.back(), base));
    copies.back().numbers[50'000] = i;
    copies.back().pages[3000] = i;
  }
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(copies[i].numbers[50'000], i);
    EXPECT_EQ(copies[i].pages[3000], i);
    EXPECT_EQ(copies[i].numbers[99'999], 7U);
  }
  EXPECT_TRUE(are_equal(base, Large()));
}

TEST_F(ArenaTest, MayBeDestroyedBeforeTheArenasThatShareItsPages) {
  auto base = std::make_unique<Large>(copy_in(*arena, Large()));
  const std::unique_ptr<Arena> second = arena->share();
  const Large copy = copy_in(*second, *base);
  base.reset();
  arena.reset();
  EXPECT_TRUE(are_equal(copy, Large()));
}

TEST_F(ArenaTest, LetsArraysGrowAndMoveAway) {
  const Large base = copy_in(*arena, Large());
  const std::unique_ptr<Arena> second = arena->share();
  Large copy = copy_in(*second, base);
  copy.numbers.push_back(1);
  EXPECT_TRUE(second->contains(copy.numbers.data())) << "spare room";
  copy.numbers.shrink_to_fit();
  EXPECT_TRUE(second->contains(copy.numbers.data()));
  copy.numbers.resize(copy.numbers.capacity() + 1, 2);
  EXPECT_FALSE(second->contains(copy.numbers.data()));
  copy.pages.make_room(5000);
  copy.pages[5000] = 9;
  EXPECT_FALSE(second->contains(&copy.pages[5000]));
  Large moved = std::move(copy);
  EXPECT_EQ(moved.numbers[100'000], 1U);
  EXPECT_EQ(moved.pages[5000], 9U);
  EXPECT_EQ(moved.pages[9000], 9000U);
  moved.pages.clear();
  moved.numbers = Numbers(3, 4);
  EXPECT_TRUE(are_equal(base, Large()));
}

TEST_F(ArenaTest, LeavesArraysOutsideForWhichItHasNoRoom) {
  Large original;
  original.numbers.resize(kMegabyte, 3);  // four times as many bytes
  const Large base = copy_in(*arena, original);
  EXPECT_TRUE(are_equal(base, original));
  EXPECT_FALSE(arena->contains(base.numbers.data()));
  EXPECT_TRUE(arena->contains(&base.pages[3000]));
  const std::unique_ptr<Arena> second = arena->share();
  Large copy = copy_in(*second, base);
  EXPECT_TRUE(are_equal(copy, original));
  EXPECT_FALSE(second->contains(copy.numbers.data()));
  copy.numbers[0] = 5;
  EXPECT_TRUE(are_equal(base, original));
}

TEST(ArenaOnOtherSystems, DoesNotExist) { EXPECT_TRUE(base::kHasPageFiles || Arena::make(kMegabyte) == nullptr); }

}  // namespace
}  // namespace waywright::test

#include "waywright/id.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

namespace waywright::test {
namespace {

static_assert(ItemId(7).value == 7);
static_assert(ItemId{7U} == ItemId{std::int8_t{7}});
static_assert(ItemId{}.is_null() && ItemId(0).is_null());
static_assert(ItemId(std::numeric_limits<std::uint64_t>::max()).value > ItemId::kLargest);

// Only integers convert to ids.
static_assert(std::is_convertible_v<int, ItemId> && std::is_convertible_v<std::size_t, ItemId>);
static_assert(!std::is_constructible_v<ItemId, double> && !std::is_constructible_v<ItemId, float>);
static_assert(!std::is_constructible_v<ItemId, bool> && !std::is_constructible_v<ItemId, char>);
static_assert(!std::is_constructible_v<ItemId, const char*> && !std::is_constructible_v<ItemId, ItemKind>);
static_assert(std::is_trivially_copyable_v<ItemId> && sizeof(ItemId) == 8);

template <int kNumber>
concept ConstantId = requires {
  typename std::integral_constant<std::uint64_t, ItemId(kNumber).value>;
};
static_assert(ConstantId<7>);
static_assert(!ConstantId<-1>, "a negative id in a constant expression does not compile");

TEST(ItemId, IsAnIntegerWhereOneIsWanted) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  EXPECT_EQ(world.insert_point({1, 2}, 7).value(), 7);
  EXPECT_TRUE(world.contains(7));
  EXPECT_EQ(world.shape(7).value(), Shape::point({1, 2}));
  world.replace(7, Shape::point({2, 1})).value();
  const std::int64_t signed_id = 7;
  world.remove(signed_id).value();
  EXPECT_FALSE(world.contains(7));
}

TEST(ItemId, OfANegativeNumberIsRefused) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  world.insert_point({1, 1}, 1).value();
  const auto expect_bad = [](const auto& result, const char* number) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::bad_id);
    EXPECT_EQ(result.error().message(), std::string("ids go from 1 to 2^63 - 1, and ") + number + " is not an id");
  };
  expect_bad(world.insert_point({1, 2}, -1), "-1");
  expect_bad(world.remove(-1), "-1");
  expect_bad(world.replace(-2, Shape::point({1, 1})), "-2");
  expect_bad(world.shape(-3), "-3");
  expect_bad(world.remove(std::numeric_limits<std::int64_t>::min()), "2^63");
  world.reserve_ids(ItemId::kLargest).value();
  expect_bad(world.insert_point({1, 2}), "2^63");
  EXPECT_FALSE(world.contains(-1));
  EXPECT_EQ(world.item_count(), 1U);
}

}  // namespace
}  // namespace waywright::test

#include "constraint/item_hash.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/item_hash_oracle.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {
namespace {

using namespace item_hash;

constexpr Box kFour{{-4, -4}, {4, 4}};

// The expected values are the published test vectors of SplitMix64 for seed 1234567.
TEST(ItemHash, MixIsAStepOfSplitMix64) {
  constexpr std::array<std::uint64_t, 3> kPublished{6457827717110365317U, 3203168211198807973U, 9817491932198370423U};
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : kPublished) {
    EXPECT_EQ(step_of_splitmix(state), expected);
    state += 0x9e3779b97f4a7c15;
  }
}

TEST(ItemHash, OfAnEmptyWorldIsTheDomains) {
  const World world = World::create(kFour).value();
  EXPECT_EQ(world.items_hash().words, hash_of(kFour, {}));
  const World signed_zero = World::create({{-0.0, -0.0}, {1, 1}}).value();
  EXPECT_EQ(signed_zero.items_hash().words, hash_of({{0, 0}, {1, 1}}, {}));
}

TEST(ItemHash, FollowsThePageForEveryShape) {
  const std::vector<Shape> shapes{
      {ItemKind::point, {{{1, 2}}}},
      {ItemKind::point, {{{-0.0, 0.0}}}},
      {ItemKind::segment, {{{0.1, -0.0}, {1.0 / 3, 3}}}},
      {ItemKind::segment, {{{2, 2}, {2, 2}}}},
      {ItemKind::polyline, {{{0, 0}}}},
      {ItemKind::polyline, {{{0, 0}, {-0.0, 0}, {1, 1}, {1, 1}, {0, 0}}}},
      {ItemKind::polygon, {{{0, 0}, {1, 0}, {0, 1}}}},
      {ItemKind::polygon, {{{0, 0}, {1, 0}, {0, 1}, {0, -0.0}, {-0.0, 0}}}},
      {ItemKind::polygon, {{{3, 3}, {3, 3}, {3, 3}}, {{-3, -3}, {3, -3}, {3, 2}, {-3, -3}}, {{0, 0}, {0, 1}}}},
  };
  World world = World::create(kFour).value();
  std::map<ItemId, Shape> items;
  for (const Shape& shape : shapes) {
    const ItemId id = world.insert(shape).value();
    items.emplace(id, shape);
    EXPECT_EQ(world.items_hash().words, hash_of(kFour, items)) << id.value;
  }
  while (!items.empty()) {
    const auto middle = std::next(items.begin(), static_cast<std::ptrdiff_t>(items.size() / 2));
    ASSERT_TRUE(world.remove(middle->first).ok());
    items.erase(middle);
    EXPECT_EQ(world.items_hash().words, hash_of(kFour, items));
  }
}

TEST(ItemHash, FollowsThePageThroughRandomChanges) {
  for (const Flavour flavour : kFlavours) {
    const ChangeScript script = random_changes(flavour, 7, 300, 20);
    World world = World::create(script.domain).value();
    LiveItems live(script.domain);
    for (const Step& step : script.steps) {
      EXPECT_EQ(perform(world, step).ok(), live.apply(step).ok());
      ASSERT_EQ(world.items_hash().words, hash_of(script.domain, live.items())) << to_string(flavour);
    }
  }
}

TEST(ItemHash, DiffersForDifferentItems) {
  const Shape segment{ItemKind::segment, {{{0, 0}, {1, 1}}}};
  const Shape backwards{ItemKind::segment, {{{1, 1}, {0, 0}}}};
  const Shape polyline{ItemKind::polyline, segment.rings};
  const Shape one_ring{ItemKind::polygon, {{{0, 0}, {1, 1}}}};
  const Shape two_rings{ItemKind::polygon, {{{0, 0}}, {{1, 1}}}};
  std::vector<Lanes> hashes;
  for (const Shape& shape : {segment, backwards, polyline, one_ring, two_rings}) {
    for (const std::uint64_t id : {1U, 2U}) {
      World world = World::create(kFour).value();
      ASSERT_TRUE(world.insert(shape, {id}).ok());
      hashes.push_back(world.items_hash().words);
    }
  }
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(hashes[i], hashes[j]) << i << ' ' << j;
  }
}

TEST(ItemHash, PrintsTheFirstLaneFirst) {
  EXPECT_EQ(to_string(ItemsHash{{0x0123456789abcdefU, 0xfU}}), "0123456789abcdef000000000000000f");
}

TEST(ItemHash, WordsFollowThePage) {
  constraint::ItemHash hash({9}, ItemKind::polyline, FillRule::even_odd, 1);
  hash.begin_ring(2);
  hash.add({1.0, 0.0});
  hash.add({-2.0, 0.5});
  const std::vector<std::uint64_t> words{9, 2, 1, 2, 0x3ff0000000000000, 0, 0xc000000000000000, 0x3fe0000000000000};
  EXPECT_EQ(hash.words(), hash_of_words(words));
}

}  // namespace
}  // namespace waywright::test

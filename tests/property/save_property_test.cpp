#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "waywright/save.hpp"
#include "waywright/world.hpp"

#include "support/each_flavour.hpp"
#include "support/live_items.hpp"
#include "support/random_changes.hpp"
#include "support/saved_world_oracle.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kSaveSteps = 60;

/// Makes one step in a world. Returns the id of the step's last item, or the refusal.
Result<ItemId> make(World& world, const Step& step) {
  const auto ids = world.apply(step.changes);
  if (!ids.ok()) return ids.error();
  return ids->empty() ? ItemId{} : ids->back();
}

void expect_equal_worlds(const World& a, const World& b) {
  EXPECT_EQ(a.domain(), b.domain());
  EXPECT_EQ(a.items_hash(), b.items_hash());
  EXPECT_EQ(a.mesh_hash(), b.mesh_hash());
  EXPECT_EQ(a.largest_id_seen(), b.largest_id_seen());
  EXPECT_EQ(a.options().keep_abstraction, b.options().keep_abstraction);
  EXPECT_EQ(a.options().keep_bridges, b.options().keep_bridges);
}

/// Makes the steps from `begin` to the end in both worlds, and an insertion whose id the worlds choose after each.
void expect_same_future(World& a, World& b, const ChangeScript& script, std::size_t begin) {
  for (std::size_t i = begin; i < script.steps.size(); ++i) {
    const Result<ItemId> in_a = make(a, script.steps[i]);
    const Result<ItemId> in_b = make(b, script.steps[i]);
    ASSERT_EQ(in_a.ok(), in_b.ok());
    if (in_a.ok()) {
      ASSERT_EQ(*in_a, *in_b);
    } else {
      ASSERT_EQ(in_a.error().code, in_b.error().code);
    }
    const Result<ItemId> chosen = a.insert_point(script.domain.min);
    const Result<ItemId> also_chosen = b.insert_point(script.domain.min);
    ASSERT_EQ(chosen.ok(), also_chosen.ok());  // the script may have used the largest id
    ASSERT_EQ(a.items_hash(), b.items_hash());
    if (!chosen.ok()) continue;
    ASSERT_EQ(*chosen, *also_chosen);
    ASSERT_TRUE(a.remove(*chosen).ok() && b.remove(*chosen).ok());
  }
  expect_equal_worlds(a, b);
  EXPECT_EQ(b.validate().fault, "");
}

/// Makes the first half of a script in a world and in `contents`.
World make_first_half(const ChangeScript& script, const WorldOptions& options, saved_world::Contents& contents) {
  World world = World::create(script.domain, options).value();
  LiveItems live(script.domain);
  contents = {script.domain, (options.keep_abstraction ? 1U : 0U) | (options.keep_bridges ? 2U : 0U), 0, {}};
  for (std::size_t i = 0; i < script.steps.size() / 2; ++i) {
    const Result<std::vector<ItemId>> ids = live.apply(script.steps[i]);
    EXPECT_EQ(make(world, script.steps[i]).ok(), ids.ok());
    if (!ids.ok()) continue;
    for (const ItemId id : *ids) contents.largest_id = std::max(contents.largest_id, id.value);
  }
  contents.items = live.items();
  return world;
}

void check_saved_script(Flavour flavour, std::uint64_t seed) {
  const WorldOptions options{.keep_abstraction = seed % 3 != 0, .keep_bridges = seed % 5 == 1};
  const ChangeScript script = random_changes(flavour, seed, kSaveSteps, 12);
  saved_world::Contents contents;
  World world = make_first_half(script, options, contents);
  std::stringstream stream;
  ASSERT_TRUE(save_world(world, stream).ok());
  ASSERT_EQ(stream.str(), saved_world::bytes_of(contents));
  Result<World> loaded = load_world(stream);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  ASSERT_EQ(loaded->items_hash().words, item_hash::hash_of(contents.domain, contents.items));
  expect_equal_worlds(world, *loaded);
  expect_same_future(world, *loaded, script, script.steps.size() / 2);
}

TEST(SaveProperty, ASavedWorldHasTheBytesOfThePageAndContinuesAsTheWorldDoes) {
  check_each_flavour(check_saved_script);
}

}  // namespace
}  // namespace waywright::test

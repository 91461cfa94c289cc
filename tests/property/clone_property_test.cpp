#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/each_flavour.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kSteps = 60;

void expect_equal(const World& a, const World& b) {
  ASSERT_EQ(a.domain(), b.domain());
  ASSERT_EQ(a.items_hash(), b.items_hash());
  ASSERT_EQ(a.dump(), b.dump());
  ASSERT_EQ(a.version(), b.version());
  ASSERT_EQ(a.largest_id_seen(), b.largest_id_seen());
  ASSERT_EQ(a.options().keep_abstraction, b.options().keep_abstraction);
  ASSERT_EQ(a.options().keep_bridges, b.options().keep_bridges);
}

/// Asks both worlds for the path between the corners of the domain, as a point and as a disc.
void expect_equal_paths(const World& a, const World& b, bool has_bridges) {
  const Box& domain = a.domain();
  for (const double radius : {0.0, (domain.max.x - domain.min.x) / 64}) {
    if (radius > 0.0 && !has_bridges) continue;
    const PathQuery query{.start = domain.min + (domain.max - domain.min) * 0.1,
                          .goal = domain.min + (domain.max - domain.min) * 0.9,
                          .agent = {.radius = radius}};
    const Path of_a = a.find_path(query).value();
    const Path of_b = b.find_path(query).value();
    ASSERT_EQ(of_a.status, of_b.status);
    ASSERT_EQ(of_a.length, of_b.length);
    ASSERT_EQ(of_a.points, of_b.points);
  }
}

/// Copies a world in the middle of a script, and makes the rest of the script in the copy, then in the world. The world
/// must not change together with the copy, and the two must come to the same end.
void check_script(Flavour flavour, std::uint64_t seed) {
  const WorldOptions options{.keep_abstraction = seed % 3 != 0, .keep_bridges = seed % 2 == 0};
  const ChangeScript script = random_changes(flavour, seed, kSteps, 12);
  World world = World::create(script.domain, options).value();
  const std::size_t half = script.steps.size() / 2;
  for (std::size_t i = 0; i < half; ++i) static_cast<void>(world.apply(script.steps[i].changes));
  const std::string dump = world.dump();
  World copy = world.clone();
  ASSERT_NO_FATAL_FAILURE(expect_equal(world, copy));
  ASSERT_EQ(copy.validate().fault, "");
  for (std::size_t i = half; i < script.steps.size(); ++i) static_cast<void>(copy.apply(script.steps[i].changes));
  ASSERT_EQ(world.dump(), dump);
  ASSERT_EQ(world.validate().fault, "");
  for (std::size_t i = half; i < script.steps.size(); ++i) static_cast<void>(world.apply(script.steps[i].changes));
  ASSERT_NO_FATAL_FAILURE(expect_equal(world, copy));
  ASSERT_EQ(copy.validate().fault, "");
  ASSERT_NO_FATAL_FAILURE(expect_equal_paths(world, copy, options.keep_bridges));
}

TEST(CloneProperty, ACopyIsEqualAndIndependent) { check_each_flavour(check_script); }

}  // namespace
}  // namespace waywright::test

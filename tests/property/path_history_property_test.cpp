#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

const std::uint64_t kScripts = case_count<std::uint64_t>(60, 6);
constexpr std::size_t kPathSteps = 80;
constexpr std::size_t kLiveItems = 25;
constexpr std::size_t kStepsBetween = 8;
constexpr int kQueries = 12;

/// Compares paths in both worlds. Returns the number of paths found.
std::size_t compare(const World& world, const World& fresh, Flavour flavour, Random& random, QueryContext& context) {
  std::size_t found = 0;
  Path path;
  for (int i = 0; i < kQueries; ++i) {
    PathQuery query{random_point(flavour, world.domain(), random), random_point(flavour, world.domain(), random)};
    query.wants_channel = true;
    query.budget.expansions = i % 2 == 0 ? PathBudget::kNoLimit : 0;
    for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal}) {
      query.algorithm = algorithm;
      world.find_path(query, context, path).value();
      const Path other = fresh.find_path(query).value();
      EXPECT_EQ(path.status, other.status);
      EXPECT_EQ(path.length, other.length);
      EXPECT_EQ(path.lower_bound, other.lower_bound);
      EXPECT_EQ(path.points, other.points);
      EXPECT_EQ(path.channel, other.channel);
      EXPECT_EQ(path.expansions, other.expansions) << "algorithm " << static_cast<int>(algorithm);
      if (path.status == PathStatus::found) ++found;
    }
  }
  return found;
}

class PathHistory : public ::testing::TestWithParam<Flavour> {};

// Two worlds with the same items must give the same paths with equally many expansions, whatever their histories, and
// with a context that has served other worlds.
TEST_P(PathHistory, MakesNoDifferenceToPaths) {
  QueryContext context;
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= kScripts; ++seed) {
    const ChangeScript script = random_changes(GetParam(), seed, kPathSteps, kLiveItems);
    World world = World::create(script.domain).value();
    LiveItems live(script.domain);
    Random random(seed);
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
      ASSERT_EQ(perform(world, script.steps[i]).ok(), live.apply(script.steps[i]).ok());
      if (i % kStepsBetween != kStepsBetween - 1) continue;
      found += compare(world, fresh_world(live), GetParam(), random, context);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << i;
    }
    EXPECT_TRUE(world.validate().ok);
  }
  EXPECT_GT(found, 125 * kScripts / 3);
}

INSTANTIATE_TEST_SUITE_P(Flavours, PathHistory, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/script.hpp"
#include "waywright/world.hpp"

#include "support/bridges_check.hpp"
#include "support/changes_check.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {
namespace {

std::filesystem::path scripts_folder() { return std::filesystem::path(WAYWRIGHT_SOURCE_DIR) / "tests/scripts"; }

/// Returns the names of the scripts, without their ending.
std::vector<std::string> script_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scripts_folder())) {
    if (entry.path().extension() == ".wws") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class HardScript : public ::testing::TestWithParam<std::string> {};

// Compares with a new world and the oracle after every step. A script without refused steps, applied as one batch, must
// give the same world.
TEST_P(HardScript, IsRightAfterEveryStep) {
  const std::filesystem::path path = scripts_folder() / (GetParam() + ".wws");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Result<Script> script = parse_script(text, path.filename().string());
  ASSERT_TRUE(script.ok()) << script.error().message();
  ChangeScript changes = changes_of(*script);
  ASSERT_FALSE(changes.steps.empty());
  const ChangesReport report = check_changes(changes, 1, {.with_rebuild = 1000, .with_oracle = 1000});
  ASSERT_FALSE(report.fault) << *report.fault;
  if (report.counts.refusals > 0) return;
  Step batch{{}, true};
  for (const Step& step : changes.steps) batch.changes.push_back(step.changes.front());
  const ChangesReport together = check_changes({changes.domain, {batch}}, 1);
  EXPECT_FALSE(together.fault) << *together.fault;
}

// With different seeds, the bridges are found with and without the tree of walls.
TEST_P(HardScript, KeepsTheBridgesOfARebuild) {
  std::ifstream file(scripts_folder() / (GetParam() + ".wws"), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const ChangeScript changes = changes_of(parse_script(text, GetParam()).value());
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const BridgesReport report = check_bridges(changes, seed);
    EXPECT_FALSE(report.fault) << *report.fault << ", seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Scripts, HardScript, ::testing::ValuesIn(script_names()),
                         [](const auto& name) { return name.param; });

TEST(HardScripts, AreAllThere) { EXPECT_GE(script_names().size(), 33U); }

constexpr Box kEight{{0, 0}, {8, 8}};

// Four corners of the domain. Each wall adds two ends; the crossing counts once.
TEST(Removal, KeepsACrossingAsLongAsTwoWallsMeetThere) {
  World world = World::create(kEight).value();
  ASSERT_TRUE(world.insert_segment({1, 1}, {7, 7}, {1}).ok());
  ASSERT_TRUE(world.insert_segment({1, 7}, {7, 1}, {2}).ok());
  ASSERT_TRUE(world.insert_segment({1, 4}, {7, 4}, {3}).ok());
  EXPECT_EQ(world.vertex_count(), 11U);
  ASSERT_TRUE(world.remove({1}).ok());
  EXPECT_EQ(world.vertex_count(), 9U);
  EXPECT_EQ(world.locate({4, 4}).value().kind, LocationKind::vertex);
  ASSERT_TRUE(world.remove({2}).ok());
  EXPECT_EQ(world.vertex_count(), 6U);
  EXPECT_EQ(world.locate({4, 4}).value().kind, LocationKind::edge);
  ASSERT_TRUE(world.remove({3}).ok());
  EXPECT_EQ(world.vertex_count(), 4U);
  EXPECT_EQ(world.item_count(), 0U);
}

// Walls 1 to 5 and 3 to 7 on one line: three pieces, then one again.
TEST(Removal, MergesThePiecesOfTheRemainingSide) {
  World world = World::create(kEight).value();
  ASSERT_TRUE(world.insert_segment({1, 4}, {5, 4}, {1}).ok());
  ASSERT_TRUE(world.insert_segment({3, 4}, {7, 4}, {2}).ok());
  EXPECT_EQ(world.snapshot().constraints.size(), 4U + 3U);
  ASSERT_TRUE(world.remove({1}).ok());
  const MeshSnapshot mesh = world.snapshot();
  EXPECT_EQ(mesh.constraints.size(), 4U + 1U);
  // In canonical order the wall, from x = 3 to x = 7, comes before the domain's right side alone.
  EXPECT_EQ(mesh.ids, (std::vector<ItemId>{{0}, {0}, {0}, {2}, {0}}));
  EXPECT_EQ(world.vertex_count(), 6U);
}

TEST(Removal, GivesBackTheMeshFromBefore) {
  World world = World::create(kEight).value();
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{1, 1}, {7, 1}, {4, 6}}, {1}).ok());
  ASSERT_TRUE(world.insert_segment({0, 3}, {8, 2.5}, {2}).ok());
  const std::string dump = world.dump();
  const ItemsHash hash = world.items_hash();
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{0, 0}, {8, 2.5}, {4, 6}, {1, 1}, {8, 8}}, {3}).ok());
  EXPECT_NE(world.dump(), dump);
  EXPECT_NE(world.items_hash(), hash);
  ASSERT_TRUE(world.remove({3}).ok());
  EXPECT_EQ(world.dump(), dump);
  EXPECT_EQ(world.items_hash(), hash);
}

TEST(Removal, OfTheBiggestIdDoesNotGiveItOutAgain) {
  World world = World::create(kEight).value();
  ASSERT_TRUE(world.insert_point({1, 1}, {7}).ok());
  ASSERT_TRUE(world.remove({7}).ok());
  EXPECT_EQ(world.insert_point({1, 1}).value(), ItemId{8});
}

}  // namespace
}  // namespace waywright::test

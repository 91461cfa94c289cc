#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/data_folder.hpp"
#include "support/foreign_formats.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;

/// Returns whether all coordinates are in the range that the library accepts. Only this may make a world refuse an item
/// of a real scene.
bool is_in_range(const Shape& shape) {
  return std::all_of(shape.rings.begin(), shape.rings.end(), [](const std::vector<Point>& ring) {
    return std::all_of(ring.begin(), ring.end(), [](Point p) { return is_in_range(p); });
  });
}

/// Builds the scene's world. Validates it after every item if the scene is small, otherwise only at the end.
void build_and_validate(const Scene& scene) {
  constexpr std::size_t kSmall = 40;
  Result<World> world = World::create(scene.domain);
  ASSERT_TRUE(world.ok()) << world.error().message();
  std::size_t accepted = 0;
  for (const Item& item : scene.items) {
    const Result<ItemId> inserted = world->insert(item.shape, item.id);
    if (!is_in_range(item.shape)) {
      ASSERT_FALSE(inserted.ok()) << "item " << item.id.value;
      EXPECT_EQ(inserted.error().code, ErrorCode::coordinate_range) << inserted.error().message();
      continue;
    }
    ASSERT_TRUE(inserted.ok()) << "item " << item.id.value << ": " << inserted.error().message();
    EXPECT_EQ(*inserted, item.id);
    ++accepted;
    if (scene.items.size() > kSmall) continue;
    const Validation validation = world->validate();
    ASSERT_TRUE(validation.ok) << "after item " << item.id.value << ": " << validation.fault;
  }
  EXPECT_EQ(world->item_count(), accepted);
  const Validation validation = world->validate();
  EXPECT_TRUE(validation.ok) << validation.fault;
}

class RealData : public testing::TestWithParam<std::string> {};

TEST_P(RealData, IsTakenAndGivesAValidMesh) {
  const fs::path folder = data_folder() / GetParam();
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no real inputs in " << folder << "; set WAYWRIGHT_DATA";
  std::size_t scenes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    const std::optional<Scene> scene = read_any_scene(entry.path());
    if (!scene) continue;
    ++scenes;
    build_and_validate(*scene);
  }
  EXPECT_GT(scenes, 0U);
}

INSTANTIATE_TEST_SUITE_P(Folders, RealData,
                         testing::Values("poly/cdt", "poly/city", "poly/earcut", "poly/poly2tri", "poly/triangle",
                                         "nasty/cdt", "nasty/constrainautor", "nasty/delaunator_points", "nasty/earcut",
                                         "nasty/poly2tri"),
                         [](const testing::TestParamInfo<std::string>& folder) {
                           std::string name = folder.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace waywright::test

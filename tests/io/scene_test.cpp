#include "waywright/scene.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/save.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

/// A test that writes files into its own folder. The folder is deleted with the test.
class ReadScene : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test_name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / ("waywright_read_scene_" + test_name);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file_of(std::string_view name) const { return (folder_ / name).string(); }

  std::string write(std::string_view name, std::string_view text) const {
    std::ofstream(file_of(name), std::ios::binary) << text;
    return file_of(name);
  }

  static void expect_error(const std::string& file_name, ErrorCode code, const std::string& start) {
    const Result<Scene> scene = read_scene(file_name);
    ASSERT_FALSE(scene.ok()) << file_name;
    EXPECT_EQ(scene.error().code, code) << scene.error().message();
    EXPECT_EQ(scene.error().message().rfind(start, 0), 0U) << scene.error().message() << " starts not with " << start;
  }

 private:
  fs::path folder_;
};

TEST(SceneFormatOf, DependsOnTheFileNameExtension) {
  EXPECT_EQ(*scene_format("a.wws"), SceneFormat::script);
  EXPECT_EQ(*scene_format("/b/c.d/a.map"), SceneFormat::movingai);
  EXPECT_EQ(*scene_format("a.b.poly"), SceneFormat::triangle_poly);
  EXPECT_EQ(*scene_format(".node"), SceneFormat::triangle_node);
  EXPECT_EQ(*scene_format("a.wwb"), SceneFormat::saved_world);
  for (const std::string_view name : {"a.txt", "a", "", "wws", "a.map.scen", "a.poly/b"}) {
    const Result<SceneFormat> format = scene_format(name);
    ASSERT_FALSE(format.ok()) << name;
    EXPECT_EQ(format.error().code, ErrorCode::not_supported) << name;
    EXPECT_EQ(format.error().message().rfind(std::string(name) + ": ", 0), 0U) << format.error().message();
  }
}

TEST_F(ReadScene, ReadsAScript) {
  const Result<Scene> scene =
      read_scene(write("a.wws", "waywright 1\ndomain 0 0 4 4\npoint 1 1 1\npoint 2 2 2\nremove 1\n"));
  ASSERT_TRUE(scene.ok()) << scene.error().message();
  EXPECT_EQ(*scene, (Scene{.domain = {{0, 0}, {4, 4}}, .items = {{{2}, {ItemKind::point, {{{2, 2}}}}}}}));
}

TEST_F(ReadScene, ReadsAMap) {
  const Result<Scene> scene = read_scene(write("a.map", "type octile\nheight 1\nwidth 2\nmap\n.@\n"));
  ASSERT_TRUE(scene.ok()) << scene.error().message();
  EXPECT_EQ(*scene, (Scene{.domain = {{0, 0}, {2, 1}},
                           .items = {{{1}, {ItemKind::polygon, {{{1, 0}, {2, 0}, {2, 1}, {1, 1}}}}}},
                           .y_down = true}));
}

TEST_F(ReadScene, ReadsASavedWorldUnderAnyName) {
  World world = World::create({{0, 0}, {4, 4}}).value();
  world.insert_segment({1, 1}, {2, 2}, 7).value();
  std::ostringstream bytes;
  ASSERT_TRUE(save_world(world, bytes).ok());
  const Scene expected{.domain = {{0, 0}, {4, 4}}, .items = {{{7}, {ItemKind::segment, {{{1, 1}, {2, 2}}}}}}};
  for (const std::string_view name : {"a.wwb", "a.wws", "a.map", "a"}) {
    const Result<Scene> scene = read_scene(write(name, bytes.str()));
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    EXPECT_EQ(*scene, expected);
  }
  expect_error(write("b.wwb", bytes.str() + "x"), ErrorCode::malformed, file_of("b.wwb") + ": ");
  expect_error(write("c.wwb", "waywright 1"), ErrorCode::malformed, file_of("c.wwb") + ": byte ");
  expect_error(file_of("missing.wwb"), ErrorCode::unreadable, file_of("missing.wwb") + ": ");
}

TEST_F(ReadScene, ReadsNodesAndPolysWithAndWithoutVertices) {
  const std::string node = write("a.node", "2 2 0 0\n1 0 0\n2 8 8\n");
  const Result<Scene> points = read_scene(node);
  ASSERT_TRUE(points.ok()) << points.error().message();
  EXPECT_EQ(points->items.size(), 2U);

  const Result<Scene> beside = read_scene(write("a.poly", "0 2 0 0\n1 0\n1 1 2\n0\n"));
  ASSERT_TRUE(beside.ok()) << beside.error().message();
  EXPECT_EQ(beside->items, (std::vector<Item>{{{1}, {ItemKind::segment, {{{0, 0}, {8, 8}}}}}}));

  const Result<Scene> alone = read_scene(write("b.poly", "1 2 0 0\n1 5 6\n0\n0\n"));
  ASSERT_TRUE(alone.ok()) << alone.error().message();
  EXPECT_EQ(alone->items, (std::vector<Item>{{{1}, {ItemKind::point, {{{5, 6}}}}}}));
}

TEST_F(ReadScene, NamesTheFileThatCannotBeRead) {
  expect_error(file_of("missing.wws"), ErrorCode::unreadable, file_of("missing.wws") + ": ");
  fs::create_directories(file_of("folder.map"));
  expect_error(file_of("folder.map"), ErrorCode::unreadable, file_of("folder.map") + ": ");
  expect_error(write("a.poly", "0 2 0 0\n0\n0\n"), ErrorCode::unreadable, file_of("a.node") + ": ");
  EXPECT_EQ(read_scene(file_of("a.poly")).error().message(),
            file_of("a.node") + ": cannot be read: No such file or directory; it should hold the vertices, of which " +
                file_of("a.poly") + " counts none");
}

TEST_F(ReadScene, NamesTheFileAndLineThatIsMalformed) {
  expect_error(write("a.wws", "waywright 1\nfoo\n"), ErrorCode::malformed, file_of("a.wws") + ":2: ");
  expect_error(write("a.map", "type octile\nheight x\n"), ErrorCode::malformed, file_of("a.map") + ":2: ");
  expect_error(write("b.node", "1 3\n"), ErrorCode::malformed, file_of("b.node") + ":1: ");
  expect_error(write("b.poly", "0 2 0 0\n0\n0\n"), ErrorCode::malformed, file_of("b.node") + ":1: ");
  expect_error(write("c.poly", "1 2 0 0\n1 1e99 0\n0\n0\n"), ErrorCode::coordinate_range, file_of("c.poly") + ":2: ");
}

TEST_F(ReadScene, KnowsNoOtherFormat) {
  expect_error(write("a.txt", "waywright 1\n"), ErrorCode::not_supported, file_of("a.txt") + ": ");
}

TEST_F(ReadScene, ReadsFilesLargerThanItsBuffer) {
  std::string text = "waywright 1\ndomain 0 0 1 1\n";
  constexpr std::size_t kItems = 20000;
  for (std::size_t id = 1; id <= kItems; ++id) text += "point " + std::to_string(id) + " 0.5 0.25\n";
  const Result<Scene> scene = read_scene(write("large.wws", text));
  ASSERT_TRUE(scene.ok()) << scene.error().message();
  EXPECT_EQ(scene->items.size(), kItems);
}

}  // namespace
}  // namespace waywright

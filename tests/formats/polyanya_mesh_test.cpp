#include "formats/polyanya_mesh.hpp"

#include <string>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "formats/broken_text.hpp"

namespace waywright::test {
namespace {

using formats::parse_polyanya_mesh;

/// The square [0, 3] x [0, 3] without the square [1, 2] x [1, 2]: four polygons around the hole.
const std::string kFrame =
    "mesh\n2\n8 4\n"
    "0 0 3 0 3 -1\n3 0 3 0 -1 1\n3 3 3 1 -1 2\n0 3 3 2 -1 3\n"
    "1 1 3 0 -1 3\n2 1 3 0 1 -1\n2 2 3 1 2 -1\n1 2 3 2 3 -1\n"
    "4 0 1 5 4 3 -1 1 -1\n"
    "4 1 2 6 5 0 -1 2 -1\n"
    "4 2 3 7 6 1 -1 3 -1\n"
    "4 3 0 4 7 2 -1 0 -1\n";

bool is_blocked(const World& world, const Point& point) {
  return world.find_path({.start = point, .goal = {0.5, 0.5}}).value().status == PathStatus::start_blocked;
}

TEST(PolyanyaMesh, CoversWhatIsNotFree) {
  const Scene scene = parse_polyanya_mesh(kFrame, "file").value();
  ASSERT_EQ(scene.items.size(), 1U);
  EXPECT_EQ(scene.domain, parse_triangle_node("2 2 0 0\n1 0 0\n2 3 3\n", "file").value().domain);
  EXPECT_EQ(scene.items[0].shape.rings.size(), 3U);
  World world = World::create(scene.domain).value();
  world.insert_all(scene.items).value();
  EXPECT_TRUE(is_blocked(world, {1.5, 1.5}));
  EXPECT_TRUE(is_blocked(world, {3.5, 1.5}));
  EXPECT_TRUE(is_blocked(world, {-0.5, -0.5}));
  EXPECT_FALSE(is_blocked(world, {2.5, 1.5}));
  // Around the corner (2, 1) of the hole.
  const Path path = world.find_path({.start = {1.25, 0.5}, .goal = {2.5, 1.75}}).value();
  ASSERT_EQ(path.status, PathStatus::found);
  EXPECT_EQ(path.points, (std::vector<Point>{{1.25, 0.5}, {2, 1}, {2.5, 1.75}}));
}

TEST(PolyanyaMesh, TheExampleOfTheFormatIsOneSquare) {
  const Scene scene =
      parse_polyanya_mesh(
          "mesh\n2\n4 2\n0.0 0.0 2 0 -1\n1.5 0.0 3 0 1 -1\n1.5 1.5 2 1 -1\n0.0 1.5 3 -1 1 0\n3 0 1 3 -1 -1 1\n"
          "3 1 2 3 0 -1 -1\n",
          "file")
          .value();
  ASSERT_EQ(scene.items[0].shape.rings.size(), 2U);
  EXPECT_EQ(std::vector<Point>(scene.items[0].shape.rings[1].begin(), scene.items[0].shape.rings[1].end()),
            (std::vector<Point>{{0, 0}, {1.5, 0}, {1.5, 1.5}, {0, 1.5}}));
}

TEST(PolyanyaMesh, ObstaclesThatTouchAtAVertexStayApartFromEachOther) {
  // Two free triangles that share only the vertex (2, 2).
  const std::string text =
      "mesh 2 5 2  0 0 2 0 -1  4 0 2 0 -1  2 2 4 0 -1 1 -1  4 4 2 1 -1  0 4 2 1 -1  3 0 1 2 -1 -1 -1  3 2 3 4 -1 -1 -1";
  const Scene scene = parse_polyanya_mesh(text, "file").value();
  World world = World::create(scene.domain).value();
  world.insert_all(scene.items).value();
  EXPECT_FALSE(is_blocked(world, {2, 1}));
  EXPECT_FALSE(is_blocked(world, {2, 3}));
  EXPECT_TRUE(is_blocked(world, {1, 2}));
  EXPECT_TRUE(is_blocked(world, {3, 2}));
  EXPECT_EQ(world.find_path({.start = {2, 1}, .goal = {2, 3}}).value().status, PathStatus::no_path);
}

TEST(PolyanyaMesh, EveryBeginningIsReadOrRefused) { read_beginnings(parse_polyanya_mesh, kFrame); }

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kFrame;
  return text.replace(text.find(from), from.size(), to);
}

class BrokenMesh : public testing::TestWithParam<BrokenText> {};

TEST_P(BrokenMesh, IsRefusedWithItsLine) { expect_refused(parse_polyanya_mesh, GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    All, BrokenMesh,
    testing::Values(
        BrokenText{"empty", "", 1, "the word 'mesh'"},
        BrokenText{"other", "MeshVersionFormatted 1", 1, "the word 'mesh'"},
        BrokenText{"version_1", changed("\n2\n", "\n1\n"), 2, "found version 1; move the last neighbour"},
        BrokenText{"version_3", changed("\n2\n", "\n3\n"), 2, "version 2, found '3'"},
        BrokenText{"too_few_vertices", changed("8 4", "2 4"), 3, "the number of vertices"},
        BrokenText{"negative_count", changed("8 4", "8 -4"), 3, "the number of polygons"},
        BrokenText{"no_polygons", changed("8 4", "8 0"), 3, "at least 1"},
        BrokenText{"huge_count", changed("8 4", "8000000000000 4"), 3, "at most the length of the file"},
        BrokenText{"count_beyond_64_bits", changed("8 4", "99999999999999999999 4"), 3, "the number of vertices"},
        BrokenText{"vertex_word", changed("3 3 3 1", "3 x 3 1"), 6, "found 'x'"},
        BrokenText{"vertex_nan", changed("3 3 3 1", "3 nan 3 1"), 6, "found 'nan'", ErrorCode::coordinate_range},
        BrokenText{"vertex_huge", changed("3 3 3 1", "3 1e40 3 1"), 6, "2^100", ErrorCode::coordinate_range},
        BrokenText{"vertex_unknown_polygon", changed("3 3 3 1 -1 2", "3 3 3 1 -1 4"), 6, "from -1 to 3, found '4'"},
        BrokenText{"vertex_count_negative", changed("3 3 3 1 -1 2", "3 3 -3 1 -1 2"), 6, "polygons at the vertex"},
        BrokenText{"polygon_of_two", changed("4 0 1 5 4", "2 0 1"), 12, "at least 3"},
        BrokenText{"unknown_vertex", changed("4 0 1 5 4", "4 0 1 5 8"), 12, "a vertex from 0 to 7, found '8'"},
        BrokenText{"negative_vertex", changed("4 0 1 5 4", "4 0 1 5 -1"), 12, "found '-1'"},
        BrokenText{"unknown_neighbour", changed("4 3 -1 1 -1\n", "4 3 -1 9 -1\n"), 12, "from -1 to 3, found '9'"},
        BrokenText{"not_mutual", changed("5 4 3 -1 1 -1\n", "5 4 3 -1 2 -1\n"), 12,
                   "to name each other, found the neighbour 2"},
        BrokenText{"one_sided", changed("5 4 3 -1 1 -1\n", "5 4 3 -1 -1 -1\n"), 13, "found the neighbour 0"},
        BrokenText{"same_polygon_twice", changed("4 1 2 6 5 0 -1 2 -1\n", "4 0 1 5 4 3 -1 1 -1\n"), 13,
                   "on the same side"},
        BrokenText{"more_behind", kFrame + "\n7\n", 17, "the end of the text"},
        BrokenText{"cut", kFrame.substr(0, kFrame.size() - 4), 15, "found the end of the text"}),
    name_of_broken);

}  // namespace
}  // namespace waywright::test

#include "formats/wavefront_obj.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"
#include "waywright/scene.hpp"

#include "formats/broken_text.hpp"

namespace waywright::test {
namespace {

using formats::parse_wavefront_obj;

std::vector<Item> items_of_obj(const std::string& text) { return parse_wavefront_obj(text, "file").value().items; }

const std::string kVertices = "v 0 0\nv 4 0\nv 4 4\nv 0 4\n";

TEST(WavefrontObj, EachElementBecomesItsItems) {
  EXPECT_EQ(items_of_obj(kVertices + "p 1 3\nl 1 2\nl 1 2 3 4\nf 1 2 3 4\n"),
            (std::vector<Item>{{1, Shape::point({0, 0})},
                               {2, Shape::point({4, 4})},
                               {3, Shape::segment({0, 0}, {4, 0})},
                               {4, Shape::polyline(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}})},
                               {5, Shape::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})}}));
}

TEST(WavefrontObj, IndicesMayCountFromTheEndAndNameTexturesAndNormals) {
  const std::vector<Item> expected{{1, Shape::polygon({{0, 0}, {4, 0}, {4, 4}})}};
  for (const std::string face : {"f -4 -3 -2", "f 1/1 2/2 3/1", "f 1//1 2//2 3//3", "f 1/1/1 2/2/2 -2/3/3"}) {
    EXPECT_EQ(items_of_obj(kVertices + face), expected) << face;
  }
  EXPECT_EQ(items_of_obj("v 1 1\nv 2 2\nl -2 -1\nv 3 3\nv 5 5\nl -2 -1\n"),
            (std::vector<Item>{{1, Shape::segment({1, 1}, {2, 2})}, {2, Shape::segment({3, 3}, {5, 5})}}));
}

TEST(WavefrontObj, OtherStatementsAndCommentsAreSkipped) {
  const std::string text =
      "# a map\r\nmtllib a.mtl\r\no house\r\n\r\nv 0 0 0.5 1\r\nv 4 0 0.5 0.1 0.2 0.3 # red\r\nvt 0 0\r\nvn 0 0 1\r\n"
      "v 4 4 \\\r\n 0.5\r\ng a b\r\ns off\r\nusemtl stone\r\nf 1 2 \\\r\n3\r\n";
  EXPECT_EQ(items_of_obj(text), (std::vector<Item>{{1, Shape::polygon({{0, 0}, {4, 0}, {4, 4}})}}));
}

TEST(WavefrontObj, NumbersAreReadAsTheNearestDouble) {
  // The library tinyobjloader reads such numbers one unit in the last place off.
  EXPECT_EQ(items_of_obj("v 133.76984470226458 879.37850187616539\np 1")[0].shape,
            Shape::point({133.76984470226458, 879.37850187616539}));
}

TEST(WavefrontObj, TheDomainIsTheOneOfAPolyFile) {
  EXPECT_EQ(parse_wavefront_obj("v 0 10\nv 100 30\nv 900 900\np 1 2", "file").value().domain,
            parse_triangle_node("2 2 0 0\n1 0 10\n2 100 30\n", "file").value().domain);
}

TEST(WavefrontObj, EveryBeginningIsReadOrRefused) {
  read_beginnings(parse_wavefront_obj, kVertices + "vt 0 0\nf 1/1 2/1 \\\n -1/1\nl 1 2\np 1\n");
}

class BrokenObj : public testing::TestWithParam<BrokenText> {};

TEST_P(BrokenObj, IsRefusedWithItsLine) { expect_refused(parse_wavefront_obj, GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    All, BrokenObj,
    testing::Values(
        BrokenText{"empty", "", 1, "expected a geometry, found none"},
        BrokenText{"only_vertices", kVertices, 1, "expected a geometry, found none"},
        BrokenText{"one_number", "v 1", 1, "2 to 7 numbers in a vertex"},
        BrokenText{"eight_numbers", "v 1 2 0 4 5 6 7 8", 1, "2 to 7 numbers in a vertex"},
        BrokenText{"word", "v 1 two", 1, "found 'two'"}, BrokenText{"colour_word", "v 1 2 0 red", 1, "found 'red'"},
        BrokenText{"nan", "v 1 2\nv nan 2", 2, "found 'nan'", ErrorCode::coordinate_range},
        BrokenText{"too_large", "v 1 1e31", 1, "2^100", ErrorCode::coordinate_range},
        BrokenText{"overflow", "v 1 1e999", 1, "2^100", ErrorCode::coordinate_range},
        BrokenText{"not_flat", "v 1 2 0\nv 1 2\nv 1 2 0.5", 3,
                   "the z of the vertices above, 0, found 0.5; a map has only x and y"},
        BrokenText{"face_of_one", kVertices + "f 1", 5, "at least 3 vertices in a face, found 1"},
        BrokenText{"face_of_two", kVertices + "f 1 2", 5, "at least 3 vertices in a face, found 2"},
        BrokenText{"face_of_none", kVertices + "f", 5, "found 0"},
        BrokenText{"line_of_one", kVertices + "l 1", 5, "at least 2 vertices in a line"},
        BrokenText{"point_of_none", kVertices + "p", 5, "at least 1 vertex in a point"},
        BrokenText{"index_zero", kVertices + "f 0 1 2", 5, "1 to 4 or -1 to -4, found '0'"},
        BrokenText{"index_too_large", kVertices + "f 1 2 5", 5, "found '5'"},
        BrokenText{"index_too_negative", kVertices + "f 1 2 -5", 5, "found '-5'"},
        BrokenText{"index_huge", kVertices + "f 1 2 99999999999999999999", 5, "found '99999999999999999999'"},
        BrokenText{"index_least", kVertices + "f 1 2 -9223372036854775808", 5, "found '-9223372036854775808'"},
        BrokenText{"index_fraction", kVertices + "f 1 2 1.5", 5, "found '1.5'"},
        BrokenText{"index_word", kVertices + "f 1 2 x", 5, "found 'x'"},
        BrokenText{"index_missing", kVertices + "f 1 2 /1", 5, "found '/1'"},
        BrokenText{"index_of_later", "v 0 0\nl 1 2\nv 1 1", 2, "found '2'"},
        BrokenText{"curve", "v 0 0\n\ncurv 0 1 1 2", 3, "found 'curv'; replace curves"},
        BrokenText{"other_format", "solid cube\n", 1, "found 'solid'"},
        BrokenText{"broken_continued", kVertices + "f 1 \\\n2 \\\n7\n", 5, "found '7'"},
        BrokenText{"utf16", std::string("v\0 \0", 4), 1, "iconv"}),
    name_of_broken);

}  // namespace
}  // namespace waywright::test

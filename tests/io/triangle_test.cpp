#include "io/triangle.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"

namespace waywright {
namespace {

Scene parsed_node(std::string_view text) {
  const Result<Scene> scene = parse_triangle_node(text, "test.node");
  EXPECT_TRUE(scene.ok()) << scene.error().message();
  return scene.ok() ? *scene : Scene{};
}

Scene parsed_poly(std::string_view text, std::string_view node_text = {}) {
  const Result<Scene> scene = parse_triangle_poly(text, "test.poly", node_text, "test.node");
  EXPECT_TRUE(scene.ok()) << scene.error().message();
  return scene.ok() ? *scene : Scene{};
}

Item point(std::uint64_t id, Point p) { return {{id}, {ItemKind::point, {{p}}}}; }
Item segment(std::uint64_t id, Point a, Point b) { return {{id}, {ItemKind::segment, {{a, b}}}}; }

TEST(ParseTriangleNode, ReadsVerticesAsPoints) {
  const std::vector<Item> expected{point(1, {1, 2}), point(2, {-3.5, 0}), point(3, {1, 2})};
  for (const std::string_view text :
       {"3 2 0 0\n1 1 2\n2 -3.5 0\n3 1 2\n",                                           // ids from 1
        "3 2 0 0\n0 1 2\n1 -3.5 0\n2 1 2\n",                                           // ids from 0
        "# a title\n\n3 2 0 0 # header\r\n1 1 2\r\n# between\n2 -3.5 0 # x\n3\t1\t2",  // comments, line ends
        "3 2 2 1\n1 1 2 .5 7 -1\n2 -3.5 0 1e3 nan 0\n3 1 2 0 0 1\n",                   // attributes and markers
        "3\n1 1 2\n2 -3.5 0\n3 1 2\n", "3 2\n1 1 2\n2 -3.5 0\n3 1 2\n",                // a short header
        "3 2 1\n1 1 2 9\n2 -3.5 0 9\n3 1 2 9\n"}) {
    EXPECT_EQ(parsed_node(text).items, expected) << text;
  }
}

TEST(ParseTriangleNode, GrowsTheBoundingBoxToADomain) {
  // An eighth of 8 is 1. An eighth of 100 is 12.5, and the bounds are rounded to multiples of 4.
  EXPECT_EQ(parsed_node("2\n1 0 0\n2 8 4\n").domain, (Box{{-1, -1}, {9, 5}}));
  EXPECT_EQ(parsed_node("2\n1 0 0\n2 100 50\n").domain, (Box{{-16, -16}, {116, 64}}));
  EXPECT_EQ(parsed_node("1\n1 3 4\n").domain, (Box{{2, 3}, {4, 5}}));
  EXPECT_EQ(parsed_node("2\n1 0.25 0.25\n2 -0.25 0.5\n").domain, (Box{{-2, -1}, {2, 2}}));
  EXPECT_EQ(parsed_node("0\n").domain, (Box{{-1, -1}, {1, 1}}));
  EXPECT_FALSE(parsed_node("0\n").y_down);
}

TEST(ParseTriangleNode, FindsADomainFarFromTheOriginAndAtTheEndsOfTheRange) {
  for (const std::string_view text :
       {"1\n1 1267650600228229401496703205376 0\n", "1\n1 0 -1267650600228229401496703205376\n",
        "2\n1 -1267650600228229401496703205376 0\n2 1267650600228229401496703205376 1\n",
        "2\n1 1e20 1e20\n2 1.0000000000001e20 1e20\n", "1\n1 1e-30 1e-30\n"}) {
    const Scene scene = parsed_node(text);
    EXPECT_LT(scene.domain.min.x, scene.domain.max.x) << text;
    EXPECT_LT(scene.domain.min.y, scene.domain.max.y) << text;
    EXPECT_GE(scene.domain.min.x, -0x1p100) << text;
    EXPECT_GE(scene.domain.min.y, -0x1p100) << text;
    EXPECT_LE(scene.domain.max.x, 0x1p100) << text;
    EXPECT_LE(scene.domain.max.y, 0x1p100) << text;
    for (const Item& item : scene.items) {
      const Point p = item.shape.rings.points().front();
      EXPECT_TRUE(p.x >= scene.domain.min.x && p.x <= scene.domain.max.x) << text;
      EXPECT_TRUE(p.y >= scene.domain.min.y && p.y <= scene.domain.max.y) << text;
    }
  }
}

TEST(ParseTriangleNode, RefusesCoordinatesOutOfRange) {
  for (const std::string_view number : {"1e31", "-1e31", "1e999", "inf", "nan", "1e-31", "1e-320"}) {
    const Result<Scene> scene = parse_triangle_node("1\n1 0 " + std::string(number) + "\n", "a.node");
    ASSERT_FALSE(scene.ok()) << number;
    EXPECT_EQ(scene.error().code, ErrorCode::coordinate_range) << number;
    EXPECT_EQ(scene.error().message().rfind("a.node:2: ", 0), 0U) << scene.error().message();
    EXPECT_EQ(scene.error().index, 2U);
  }
}

TEST(ParseTrianglePoly, ReadsFreeVerticesThenSegments) {
  const std::vector<Item> expected{point(1, {9, 9}), segment(2, {0, 0}, {4, 0}), segment(3, {4, 0}, {0, 4}),
                                   segment(4, {0, 0}, {0, 0})};
  for (const std::string_view text :
       {"4 2 0 0\n1 0 0\n2 4 0\n3 9 9\n4 0 4\n3 0\n1 1 2\n2 2 4\n3 1 1\n0\n",
        "4 2 0 0\n0 0 0\n1 4 0\n2 9 9\n3 0 4\n3 1\n0 0 1 7\n1 1 3 -7\n2 0 0 0\n0\n",
        "4 2 0 0\n1 0 0\n2 4 0\n3 9 9\n4 0 4\n3\n1 1 2\n2 2 4\n3 1 1\n2 # holes\n1 1 1\n2 2 2\n",
        "4 2 0 0\n1 0 0\n2 4 0\n3 9 9\n4 0 4\n3 0\n1 1 2\n2 2 4\n3 1 1\n0\n2\n1 1 1 7 0.5\n2 1 1 7\n"}) {
    EXPECT_EQ(parsed_poly(text).items, expected) << text;
  }
}

TEST(ParseTrianglePoly, TakesVerticesFromTheNodeFile) {
  const Scene scene = parsed_poly("# none here\n0 2 0 0\n1 0\n1 0 1\n0\n", "3 2 0 0\n0 0 0\n1 8 0\n2 0 8\n");
  EXPECT_EQ(scene.items, (std::vector<Item>{point(1, {0, 8}), segment(2, {0, 0}, {8, 0})}));
  EXPECT_EQ(scene.domain, (Box{{-1, -1}, {9, 9}}));
}

TEST(ParseTrianglePoly, PassesOverTheNodeFileWhereItHasVertices) {
  EXPECT_EQ(parsed_poly("1\n1 5 5\n0\n0\n", "no node file").items, std::vector<Item>{point(1, {5, 5})});
}

TEST(ParseTrianglePoly, NamesTheNodeFileInItsErrors) {
  const Result<Scene> scene = parse_triangle_poly("0\n0\n0\n", "a.poly", "1\n1 x 0\n", "a.node");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().message(), "a.node:2: expected a coordinate, found 'x'");
}

TEST(LacksVertices, LooksAtTheFirstCount) {
  EXPECT_TRUE(io::lacks_vertices("# x\n\n 0 2 0 0\n1 0\n"));
  EXPECT_FALSE(io::lacks_vertices("10 2 0 0\n"));
  EXPECT_FALSE(io::lacks_vertices("zero\n0\n"));
  EXPECT_FALSE(io::lacks_vertices("# 0\n"));
  EXPECT_FALSE(io::lacks_vertices(""));
}

}  // namespace
}  // namespace waywright

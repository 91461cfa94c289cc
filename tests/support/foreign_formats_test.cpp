#include "support/foreign_formats.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

using Items = std::vector<Item>;

Item point(std::uint64_t id, Point p) { return {{id}, {ItemKind::point, {{p}}}}; }
Item segment(std::uint64_t id, Point a, Point b) { return {{id}, {ItemKind::segment, {{a, b}}}}; }

TEST(ForeignFormats, ReadsCdt) {
  const Scene scene = read_cdt("3 1\r\n 0 0 \n8   -4.5\n1e1 .5\n0 1\n");
  EXPECT_EQ(scene.items, (Items{point(1, {10, 0.5}), segment(2, {0, 0}, {8, -4.5})}));
  // The larger extent is 10; an eighth of it is 1.25.
  EXPECT_EQ(scene.domain, (Box{{-2, -6}, {12, 2}}));
  EXPECT_THROW(static_cast<void>(read_cdt("2 0\n0 0\n")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(read_cdt("1 1\n0 0\n0 1\n")), std::runtime_error);
}

TEST(ForeignFormats, ReadsPointsOfDelaunator) {
  EXPECT_EQ(read_json("[[1,2],[3.5,-4]]")->items, (Items{point(1, {1, 2}), point(2, {3.5, -4})}));
}

TEST(ForeignFormats, ReadsRingsOfEarcut) {
  EXPECT_EQ(
      read_json("[[[0,0],[9,0],[9,9]],[[5,2]],[[6,1],[7,1],[7,2]],[]]")->items,
      (Items{{{1}, {ItemKind::polygon, {{{0, 0}, {9, 0}, {9, 9}}, {{6, 1}, {7, 1}, {7, 2}}}}}, point(2, {5, 2})}));
}

TEST(ForeignFormats, ReadsGraphsOfConstrainautor) {
  EXPECT_EQ(read_json(R"({"points":[[0,0],[1,1],[2,0]],"edges":[[2,0]],"error":"none"})")->items,
            (Items{point(1, {1, 1}), segment(2, {2, 0}, {0, 0})}));
}

TEST(ForeignFormats, ReadsGeojson) {
  const std::optional<Scene> scene = read_json(R"({"type":"FeatureCollection","features":[
    {"geometry":{"type":"MultiPolygon","coordinates":[
      [[[0,0],[4,0],[0,4]],[[1,1],[2,1],[1,2]]],[[[8,8],[9,8],[8,9]]]]}},
    {"geometry":{"type":"Polygon","coordinates":[[[5,5],[6,5],[5,6]]]}}]})");
  ASSERT_TRUE(scene.has_value());
  EXPECT_EQ(scene->items, (Items{{{1}, {ItemKind::polygon, {{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {2, 1}, {1, 2}}}}},
                                 {{2}, {ItemKind::polygon, {{{8, 8}, {9, 8}, {8, 9}}}}},
                                 {{3}, {ItemKind::polygon, {{{5, 5}, {6, 5}, {5, 6}}}}}}));
}

TEST(ForeignFormats, KnowsJsonThatIsNoScene) {
  EXPECT_EQ(read_json(R"({"triangles":{}})"), std::nullopt);
  EXPECT_EQ(read_json(R"([{"title":"x"}])"), std::nullopt);
}

TEST(ForeignFormats, ReadsPoly2triWithHolesAndSteinerPoints) {
  const Scene scene =
      read_poly2tri("[0,0],[8, 0],\n{\"X\": 8.0, \"Y\": -8}", "1 1\n2 1\n1 2\n\n \n3,3 4,3 3,4\n", "5 5");
  EXPECT_EQ(
      scene.items,
      (Items{
          {{1}, {ItemKind::polygon, {{{0, 0}, {8, 0}, {8, -8}}, {{1, 1}, {2, 1}, {1, 2}}, {{3, 3}, {4, 3}, {3, 4}}}}},
          point(2, {5, 5})}));
  EXPECT_THROW(static_cast<void>(read_poly2tri("1 2 3", "", "")), std::runtime_error);
}

TEST(ForeignFormats, ReadsSumoInHundredths) {
  const Scene scene = read_sumo(
      "<additional>\n <poly id=\"-1\" layer=\"2.00\" shape=\"0.10,0.29 8434.73,4950.54 -1.00,2\"/>\n"
      " <poi x=\"1\" y=\"2\"/>\n <poly id=\"2\" shape=\"1,1 2,1 1,2\"></poly>\n</additional>\n");
  EXPECT_EQ(scene.items, (Items{{{1}, {ItemKind::polygon, {{{10, 29}, {843473, 495054}, {-100, 200}}}}},
                                {{2}, {ItemKind::polygon, {{{100, 100}, {200, 100}, {100, 200}}}}}}));
}

}  // namespace
}  // namespace waywright::test

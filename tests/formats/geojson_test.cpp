#include "formats/geojson.hpp"

#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"
#include "waywright/scene.hpp"

#include "formats/broken_text.hpp"

namespace waywright::test {
namespace {

using formats::parse_geojson;

std::string geometry(const std::string& type, const std::string& coordinates) {
  return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
}

std::string feature(const std::string& geometry, const std::string& more = R"(,"properties":null)") {
  return R"({"type":"Feature","geometry":)" + geometry + more + "}";
}

std::string collection(const std::string& features, const std::string& more = {}) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]" + more + "}";
}

std::vector<Item> items_of(const std::string& text) { return parse_geojson(text, "file").value().items; }

TEST(GeoJson, EachGeometryBecomesItsItems) {
  const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
  const std::string hole = "[[1,1],[1,2],[2,2],[1,1]]";
  const Shape with_hole = Shape::polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}}});
  EXPECT_EQ(items_of(geometry("Point", "[3,-4.5]")), (std::vector<Item>{{1, Shape::point({3, -4.5})}}));
  EXPECT_EQ(items_of(geometry("MultiPoint", "[[1,2],[3,4]]")),
            (std::vector<Item>{{1, Shape::point({1, 2})}, {2, Shape::point({3, 4})}}));
  EXPECT_EQ(items_of(geometry("LineString", "[[1,2],[3,4]]")),
            (std::vector<Item>{{1, Shape::segment({1, 2}, {3, 4})}}));
  const std::vector<Point> chain{{1, 2}, {3, 4}, {5, 0}};
  EXPECT_EQ(items_of(geometry("LineString", "[[1,2],[3,4],[5,0]]")), (std::vector<Item>{{1, Shape::polyline(chain)}}));
  EXPECT_EQ(items_of(geometry("MultiLineString", "[[[1,2],[3,4],[5,0]],[[7,7],[8,8]]]")),
            (std::vector<Item>{{1, Shape::polyline(chain)}, {2, Shape::segment({7, 7}, {8, 8})}}));
  EXPECT_EQ(items_of(geometry("Polygon", "[" + square + "," + hole + "]")), (std::vector<Item>{{1, with_hole}}));
  EXPECT_EQ(items_of(geometry("MultiPolygon", "[[" + square + "," + hole + "],[" + hole + "]]")),
            (std::vector<Item>{{1, with_hole}, {2, Shape::polygon({{1, 1}, {1, 2}, {2, 2}})}}));
  EXPECT_EQ(items_of(R"({"type":"GeometryCollection","geometries":[)" + geometry("Point", "[3,4]") + "," +
                     geometry("LineString", "[[1,2],[3,4]]") + "]}"),
            (std::vector<Item>{{1, Shape::point({3, 4})}, {2, Shape::segment({1, 2}, {3, 4})}}));
}

TEST(GeoJson, TheOrderOfMembersDoesNotMatter) {
  const std::vector<Item> expected{{7, Shape::polyline(std::vector<Point>{{1, 2}, {3, 4}})}};
  EXPECT_EQ(items_of(R"({"features":[{"id":7,"properties":{"waywright":"polyline"},
      "geometry":{"coordinates":[[1,2],[3,4]],"type":"LineString"},"type":"Feature"}],"type":"FeatureCollection"})"),
            expected);
  EXPECT_EQ(items_of(R"({"type":"FeatureCollection","features":[{"type":"Feature",
      "geometry":{"type":"LineString","coordinates":[[1,2],[3,4]]},"properties":{"waywright":"polyline"},"id":7}]})"),
            expected);
}

TEST(GeoJson, OtherMembersAreSkipped) {
  const std::string text = R"({"type":"FeatureCollection","name":"x","crs":{"type":"name","properties":{"name":"y"}},
      "bbox":[0,0,1,1],"features":[{"type":"Feature","properties":{"a":[1,{"type":"Point"},[[]]],"b":null,"c":-1e300,
      "d":18446744073709551616,"e":true},"geometry":{"type":"Point","bbox":[0,0,0,0],"coordinates":[1,2],
      "x":{"coordinates":{}}}}]})";
  EXPECT_EQ(items_of(text), (std::vector<Item>{{1, Shape::point({1, 2})}}));
}

TEST(GeoJson, IdsThatFitAreKeptAndTheOthersFollowTheLargest) {
  const std::string point = geometry("Point", "[1,2]");
  const std::vector<Item> items = items_of(
      collection(feature(point) + "," + feature(point, R"(,"properties":{},"id":40)") + "," +
                 feature(geometry("MultiPoint", "[[1,2],[1,2]]"), R"(,"properties":{},"id":9)") + "," +
                 feature(point, R"(,"properties":{},"id":"way/9")") + "," +
                 feature(point, R"(,"properties":{},"id":0)") + "," + feature(point, R"(,"properties":{},"id":2.0)")));
  std::vector<std::uint64_t> ids;
  for (const Item& item : items) ids.push_back(item.id.value);
  EXPECT_THAT(ids, testing::ElementsAre(41, 40, 9, 42, 43, 44, 45));
}

TEST(GeoJson, FeaturesWithoutAPlaceAndEmptyGeometriesGiveNoItems) {
  const std::string text = collection(feature("null") + "," + feature(geometry("Polygon", "[]")) + "," +
                                      feature(geometry("Point", "[]")) + "," + feature(geometry("Point", "[5,6]")));
  EXPECT_EQ(items_of(text), (std::vector<Item>{{1, Shape::point({5, 6})}}));
}

TEST(GeoJson, TheOwnMemberSaysTheDomainAndTheAxis) {
  const std::string text = collection("", R"(,"waywright":{"domain":[-1,-2,3,4.5],"y_down":true,"later":[1]})");
  EXPECT_EQ(parse_geojson(text, "file").value(), (Scene{.domain = {{-1, -2}, {3, 4.5}}, .items = {}, .y_down = true}));
}

TEST(GeoJson, WithoutADomainTheDomainIsTheOneOfAPolyFile) {
  const Scene scene = parse_geojson(geometry("MultiPoint", "[[0,10],[100,30]]"), "file").value();
  EXPECT_EQ(scene.domain, parse_triangle_node("2 2 0 0\n1 0 10\n2 100 30\n", "file").value().domain);
}

TEST(GeoJson, ThePropertySaysTheKindOfTheItem) {
  const auto kind_of = [](const std::string& kind, const std::string& type, const std::string& coordinates) {
    const std::string more = R"(,"properties":{"waywright":")" + kind + R"("})";
    return items_of(collection(feature(geometry(type, coordinates), more), R"(,"waywright":{"domain":[0,0,9,9]})"));
  };
  const std::string line = "[[1,2],[3,4]]";
  const std::string ring = "[[[1,1],[1,2],[2,2],[1,1]]]";
  EXPECT_EQ(kind_of("segment", "LineString", line)[0].shape.kind, ItemKind::segment);
  EXPECT_EQ(kind_of("polyline", "LineString", line)[0].shape.kind, ItemKind::polyline);
  EXPECT_EQ(kind_of("polygon", "Polygon", ring)[0].shape.fill, FillRule::even_odd);
  EXPECT_EQ(kind_of("polygon nonzero", "Polygon", ring)[0].shape.fill, FillRule::nonzero);
  EXPECT_TRUE(kind_of("path", "LineString", line).empty());
  EXPECT_TRUE(kind_of("triangle", "Polygon", ring).empty());
  EXPECT_TRUE(kind_of("edge", "LineString", line).empty());
}

/// The expected values are literals that the compiler rounds.
TEST(GeoJson, NumbersAreReadAsTheNearestDouble) {
  const auto x_of = [](const std::string& number) {
    return items_of(geometry("Point", "[" + number + ",0]"))[0].shape.rings[0][0].x;
  };
  EXPECT_EQ(x_of("0.1"), 0.1);
  EXPECT_EQ(x_of("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(x_of("9007199254740993.00000000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(x_of("18446744073709551615"), 18446744073709551616.0);
  EXPECT_EQ(x_of("36893488147419103233"), 36893488147419103232.0);
  EXPECT_EQ(x_of("-9007199254740993"), -9007199254740992.0);
  EXPECT_EQ(x_of("1.7976931348623157e-5"), 1.7976931348623157e-5);
  EXPECT_EQ(x_of("1E+2"), 100.0);
  EXPECT_FALSE(std::signbit(x_of("0e5")));
  EXPECT_EQ(x_of("1e-400"), 0.0);
}

TEST(GeoJson, ProgressCountsUpToTheLength) {
  const std::string text =
      collection(feature(geometry("Point", "[1,2]")) + ",\n" + feature(geometry("Point", "[1,2]")));
  std::vector<std::size_t> steps;
  const auto note = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, text.size());
    steps.push_back(done);
  };
  ASSERT_TRUE(parse_geojson(text, "file", note).ok());
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_LT(steps[0], steps[1]);
  EXPECT_LT(steps[1], text.size());
}

TEST(GeoJson, DeepNestingIsNoTrouble) {
  constexpr std::size_t kDepth = 1'000'000;
  const std::string deep = std::string(kDepth, '[') + std::string(kDepth, ']');
  EXPECT_EQ(items_of(R"({"x":)" + deep + R"(,"type":"Point","coordinates":[1,2]})").size(), 1U);
  EXPECT_FALSE(parse_geojson(deep, "file").ok());
  EXPECT_FALSE(parse_geojson(std::string(kDepth, '['), "file").ok());
  EXPECT_FALSE(parse_geojson(geometry("Polygon", deep), "file").ok());
  std::string nested = geometry("Point", "[1,2]");
  for (int i = 0; i < 100; ++i) nested = R"({"type":"GeometryCollection","geometries":[)" + nested + "]}";
  const Result<Scene> refused = parse_geojson(nested, "file");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("64 deep"), std::string::npos);
}

TEST(GeoJson, EveryBeginningIsReadOrRefused) {
  read_beginnings(parse_geojson, collection(feature(geometry("MultiPolygon", "[[[[0,0],[4,0],[4,4],[0,0]]]]"),
                                                    R"(,"properties":{"waywright":"polygon"},"id":3)"),
                                            R"(,"waywright":{"domain":[-1,-1,9,9],"y_down":false})") +
                                     "\n");
}

class BrokenGeoJson : public testing::TestWithParam<BrokenText> {};

TEST_P(BrokenGeoJson, IsRefusedWithItsLine) { expect_refused(parse_geojson, GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Json, BrokenGeoJson,
    testing::Values(
        BrokenText{"empty", "", 1, "cannot be read"}, BrokenText{"blank", " \n\n", 1, "cannot be read"},
        BrokenText{"cut", "{\"type\":\"Point\",\n\"coordinates\":[1,", 2, "unexpected end of input"},
        BrokenText{"two_texts", geometry("Point", "[1,2]") + "\n{}", 2, "expected end of input"},
        BrokenText{"not_a_number", geometry("Point", "\n[1,\nNaN]"), 3, "invalid literal"},
        BrokenText{"infinite", geometry("Point", "[1,Infinity]"), 1, "invalid literal"},
        BrokenText{"overflow", geometry("Point", "[1,\n1e999]"), 2, "number overflow"},
        BrokenText{"comment", "// a\n{}", 1, "cannot be read"}, BrokenText{"not_utf8", "{\"a\":\"\xff\"}", 1, "UTF-8"},
        BrokenText{"utf16", std::string("{\0\"\0", 4), 1, "iconv -f UTF-16LE"},
        BrokenText{"array", "[]", 1, "a GeoJSON object"}, BrokenText{"number", "\n5", 2, "a GeoJSON object"},
        BrokenText{"text", "\"Point\"", 1, "a GeoJSON object"}, BrokenText{"null_alone", "null", 1, "a GeoJSON object"},
        BrokenText{"true_alone", "true", 1, "a GeoJSON object"}),
    name_of_broken);

INSTANTIATE_TEST_SUITE_P(
    Objects, BrokenGeoJson,
    testing::Values(
        BrokenText{"no_type", "\n{}", 2, "a member 'type'"},
        BrokenText{"type_number", "{\"type\":5}", 1, "a text, the type"},
        BrokenText{"type_unknown", R"({"type":"Circle"})", 1, "found the type 'Circle'"},
        BrokenText{"topology", R"({"type":"Topology","objects":{}})", 1, "'Topology'"},
        BrokenText{"type_twice", R"({"type":"Point","type":"Point","coordinates":[1,2]})", 1, "a second one"},
        BrokenText{"no_coordinates", R"({"type":"Point"})", 1, "a member 'coordinates' in a Point"},
        BrokenText{"coordinates_null", geometry("Point", "null"), 1, "found null"},
        BrokenText{"coordinates_number", geometry("Point", "5"), 1, "found the number 5"},
        BrokenText{"coordinates_object", geometry("Point", "{}"), 1, "found an object"},
        BrokenText{"no_features", R"({"type":"FeatureCollection"})", 1, "a member 'features'"},
        BrokenText{"features_object", R"({"type":"FeatureCollection","features":{}})", 1, "an array of features"},
        BrokenText{"feature_null", collection("null"), 1, "expected a Feature"},
        BrokenText{"feature_is_geometry", collection(geometry("Point", "[1,2]")), 1, "type Feature"},
        BrokenText{"feature_without_geometry", collection("\n" + std::string(R"({"type":"Feature"})")), 2,
                   "'geometry'"},
        BrokenText{"feature_with_coordinates", feature("null", R"(,"coordinates":[1,2])"), 1,
                   "no member 'coordinates'"},
        BrokenText{"geometry_text", feature("\"x\""), 1, "found the text 'x'"},
        BrokenText{"geometry_is_feature", feature(feature("null")), 1, "found the type 'Feature'"},
        BrokenText{"properties_number", feature("null", R"(,"properties":3)"), 1, "the properties"},
        BrokenText{"id_object", feature("null", R"(,"id":{})"), 1, "the id of the feature"},
        BrokenText{"no_geometries", R"({"type":"GeometryCollection"})", 1, "'geometries'"},
        BrokenText{"geometries_null", R"({"type":"GeometryCollection","geometries":[null]})", 1, "found null"},
        BrokenText{"nothing_at_all", collection(""), 1, "expected a geometry, found none"},
        BrokenText{"nothing_located", collection(feature("null")), 1, "expected a geometry, found none"},
        BrokenText{"id_twice",
                   collection(feature(geometry("Point", "[1,2]"), R"(,"id":4)") + ",\n" +
                              feature(geometry("Point", "[1,2]"), R"(,"id":4)")),
                   2, "an id that no feature above has, found 4"},
        BrokenText{"id_largest",
                   collection(feature(geometry("Point", "[1,2]"), R"(,"id":9223372036854775807)") + "," +
                              feature(geometry("Point", "[1,2]"))),
                   1, "no id is left"}),
    name_of_broken);

INSTANTIATE_TEST_SUITE_P(
    Coordinates, BrokenGeoJson,
    testing::Values(
        BrokenText{"height", geometry("Point", "[1,2,\n3]"), 2, "found a third number; a map has only x and y"},
        BrokenText{"one_number", geometry("Point", "[1]"), 1, "a position of two numbers, found one number"},
        BrokenText{"number_text", geometry("Point", "[\"1\",\"2\"]"), 1, "found the text '1'"},
        BrokenText{"number_null", geometry("Point", "[1,null]"), 1, "found null"},
        BrokenText{"number_true", geometry("Point", "[1,true]"), 1, "found true"},
        BrokenText{"too_large", geometry("LineString", "[[1,2],\n[1e31,2]]"), 2, "found '1e31'; scale the coordinates",
                   ErrorCode::coordinate_range},
        BrokenText{"too_small", geometry("Point", "[1,1e-31]"), 1, "found '1e-31'", ErrorCode::coordinate_range},
        BrokenText{"integer_too_large", geometry("Point", "[1,12676506002282294014967032053760]"), 1, "2^100",
                   ErrorCode::coordinate_range},
        BrokenText{"point_too_deep", geometry("Point", "[[1,2]]"), 1, "the coordinates of a Point: one array"},
        BrokenText{"polygon_too_flat", geometry("Polygon", "[[1,2],[3,4],[5,5],[1,2]]"), 1, "3 deep, found arrays"},
        BrokenText{"five_deep", geometry("MultiPolygon", "[[[[[1,2]]]]]"), 1, "more than 4 deep"},
        BrokenText{"array_in_position", geometry("LineString", "[[1,[2]]]"), 1, "a number in a position"},
        BrokenText{"number_beside_array", geometry("LineString", "[[1,2],3]"), 1, "expected an array, found a number"},
        BrokenText{"uneven", geometry("Polygon", "[[[1,2],[[3,4]]]]"), 1, "equally deep"},
        BrokenText{"empty_inside", geometry("Polygon", "[[]]"), 1, "found nothing"},
        BrokenText{"empty_position", geometry("LineString", "[[1,2],[]]"), 1, "found nothing"},
        BrokenText{"line_of_one", geometry("LineString", "[[1,2]]"), 1, "at least 2 positions"},
        BrokenText{"lines_of_one", geometry("MultiLineString", "[[[1,2],[3,4]],[[1,2]]]"), 1, "at least 2 positions"},
        BrokenText{"ring_of_three", geometry("Polygon", "[[[1,2],[3,4],[1,2]]]"), 1, "at least 4 positions in ring 1"},
        BrokenText{"unclosed", geometry("Polygon", "\n[[[0,0],[4,0],[4,4],[0,0]],[[1,1],[2,1],[2,2],[1,3]]]"), 2,
                   "ring 2 of these coordinates to end where it starts, at (1, 1), found (1, 3); repeat"},
        BrokenText{"unclosed_in_many", geometry("MultiPolygon", "[[[[0,0],[4,0],[4,4],[0,1]]]]"), 1, "to end where"}),
    name_of_broken);

INSTANTIATE_TEST_SUITE_P(
    OwnMembers, BrokenGeoJson,
    testing::Values(
        BrokenText{"own_text", collection("", R"(,"waywright":"x")"), 1, "an object, such as"},
        BrokenText{"domain_three", collection("", R"(,"waywright":{"domain":[0,0,1]})"), 1, "found 3 numbers"},
        BrokenText{"domain_turned", collection("", R"(,"waywright":{"domain":[0,0,1,-1]})"), 1, "a box without area"},
        BrokenText{"domain_text", collection("", R"(,"waywright":{"domain":[0,0,1,"1"]})"), 1, "four numbers"},
        BrokenText{"domain_huge", collection("", R"(,"waywright":{"domain":[0,0,1,1e40]})"), 1, "2^100",
                   ErrorCode::coordinate_range},
        BrokenText{"y_down_number", collection("", R"(,"waywright":{"y_down":1})"), 1, "true or false"},
        BrokenText{"kind_unknown",
                   feature(geometry("Point", "[1,2]"), "\n" + std::string(R"(,"properties":{"waywright":"wall"})")), 2,
                   "found 'wall'"},
        BrokenText{"kind_of_another", feature(geometry("Point", "[1,2]"), R"(,"properties":{"waywright":"segment"})"),
                   1, "that fits the geometry, such as 'point'"},
        BrokenText{"kind_number", feature(geometry("Point", "[1,2]"), R"(,"properties":{"waywright":1})"), 1,
                   "one of the texts point"},
        BrokenText{"segment_of_three",
                   feature(geometry("LineString", "[[1,2],[3,4],[4,4]]"), R"(,"properties":{"waywright":"segment"})"),
                   1, "such as 'polyline', found 'segment'"}),
    name_of_broken);

}  // namespace
}  // namespace waywright::test

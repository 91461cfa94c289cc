#include "formats/wkt.hpp"

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>
#include <gtest/gtest.h>

#include "waywright/item.hpp"
#include "waywright/scene.hpp"

#include "formats/broken_text.hpp"

namespace waywright::test {
namespace {

using formats::parse_wkt;

std::vector<Item> items_of_wkt(const std::string& text) { return parse_wkt(text, "file").value().items; }

TEST(Wkt, EachGeometryBecomesItsItems) {
  const Shape with_hole = Shape::polygon({{{0, 0}, {4, 0}, {4, 4}}, {{2, 1}, {3, 1}, {3, 2}}});
  const std::string rings = "((0 0, 4 0, 4 4, 0 0), (2 1, 3 1, 3 2, 2 1))";
  const Shape chain = Shape::polyline(std::vector<Point>{{1, 2}, {3, 4}, {5, 0}});
  EXPECT_EQ(items_of_wkt("POINT (3 -4.5)"), (std::vector<Item>{{1, Shape::point({3, -4.5})}}));
  EXPECT_EQ(items_of_wkt("LINESTRING(1 2, 3 4)"), (std::vector<Item>{{1, Shape::segment({1, 2}, {3, 4})}}));
  EXPECT_EQ(items_of_wkt("linestring(1 2,3 4,5 0)"), (std::vector<Item>{{1, chain}}));
  EXPECT_EQ(items_of_wkt("POLYGON" + rings), (std::vector<Item>{{1, with_hole}}));
  EXPECT_EQ(items_of_wkt("MULTIPOINT(1 2, (3 4), EMPTY)"),
            (std::vector<Item>{{1, Shape::point({1, 2})}, {2, Shape::point({3, 4})}}));
  EXPECT_EQ(items_of_wkt("MultiLineString((1 2, 3 4, 5 0), EMPTY, (1 2, 3 4))"),
            (std::vector<Item>{{1, chain}, {2, Shape::segment({1, 2}, {3, 4})}}));
  EXPECT_EQ(items_of_wkt("MULTIPOLYGON(" + rings + ", " + rings + ")"),
            (std::vector<Item>{{1, with_hole}, {2, with_hole}}));
  EXPECT_EQ(items_of_wkt("GEOMETRYCOLLECTION(POINT(1 2), GEOMETRYCOLLECTION(POLYGON" + rings + "), POINT EMPTY)"),
            (std::vector<Item>{{1, Shape::point({1, 2})}, {2, with_hole}}));
}

TEST(Wkt, GeometriesFollowEachOtherOnLinesOrBehindSemicolons) {
  const std::vector<Item> expected{{1, Shape::point({1, 2})}, {2, Shape::point({3, 4})}, {3, Shape::point({5, 6})}};
  EXPECT_EQ(items_of_wkt("\xef\xbb\xbfPOINT\n(1\r\n2)\r\n\nPOINT(3 4);POINT(5 6) ;\n"), expected);
  EXPECT_EQ(items_of_wkt("SRID=4326;POINT(1 2)\nSRID=4326;POINT(3 4)\nsrid = 4326 ; POINT(5 6)\n"), expected);
  EXPECT_EQ(items_of_wkt("POLYGON EMPTY POINT(1 2) GEOMETRYCOLLECTION EMPTY POINT(3 4)\nPOINT(5 6)"), expected);
}

TEST(Wkt, TheDomainIsTheOneOfAPolyFile) {
  EXPECT_EQ(parse_wkt("MULTIPOINT(0 10, 100 30)", "file").value().domain,
            parse_triangle_node("2 2 0 0\n1 0 10\n2 100 30\n", "file").value().domain);
}

TEST(Wkt, EveryBeginningIsReadOrRefused) {
  read_beginnings(parse_wkt,
                  "SRID=1;GEOMETRYCOLLECTION(MULTIPOLYGON(((0 0,4 0,4 4,0 0)),EMPTY),MULTIPOINT(1 2,(3 4)))\n");
}

TEST(Wkt, DeepNestingIsRefused) {
  std::string nested;
  for (int i = 0; i < 1'000'000; ++i) nested += "GEOMETRYCOLLECTION(";
  expect_refused(parse_wkt, {"deep", "POINT(1 2)\n" + nested, 2, "more than 64 deep; flatten them"});
  expect_refused(parse_wkt, {"parentheses", "POLYGON" + std::string(1'000'000, '('), 1, "a coordinate"});
}

class BrokenWkt : public testing::TestWithParam<BrokenText> {};

TEST_P(BrokenWkt, IsRefusedWithItsLine) { expect_refused(parse_wkt, GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    All, BrokenWkt,
    testing::Values(
        BrokenText{"empty", "", 1, "expected a geometry, found none"},
        BrokenText{"only_empty", "POINT EMPTY", 1, "expected a geometry, found none"},
        BrokenText{"cut", "POINT(1 2)\nLINESTRING(1 2,\n", 2, "found the end of the text"},
        BrokenText{"unknown", "\nCIRCLE(1 2)", 2, "found 'CIRCLE'; convert curves"},
        BrokenText{"curve", "CIRCULARSTRING(0 0, 1 1, 2 0)", 1, "ST_CurveToLine"},
        BrokenText{"longer_word", "POINTS(1 2)", 1, "found 'POINTS'"},
        BrokenText{"csv", "1;POINT(1 2)", 1, "found '1'"}, BrokenText{"utf16", std::string("P\0O\0", 4), 1, "iconv"},
        BrokenText{"z", "POINT Z (1 2 3)", 1, "found one with Z; a map has only x and y"},
        BrokenText{"zm_attached", "POINT(1 2)\nPointZM(1 2 3 4)", 2, "found one with ZM"},
        BrokenText{"m", "LINESTRING M (1 2 3, 4 5 6)", 1, "found one with M"},
        BrokenText{"z_empty", "POINT Z EMPTY", 1, "found one with Z"},
        BrokenText{"third_number", "POINT(1 2\n3)", 2, "found a third number; a map has only x and y"},
        BrokenText{"one_number", "POINT(1)", 1, "a coordinate, a decimal number such as -1.5 or 2e3, found ')'"},
        BrokenText{"one_number_inside", "LINESTRING(1 2, 3)", 1, "found ')'"},
        BrokenText{"word", "POINT(1 two)", 1, "found 'two'"},
        BrokenText{"hexadecimal", "POINT(1 0x10)", 1, "found '0x10'"},
        BrokenText{"nan", "POINT(1 nan)", 1, "found 'nan'", ErrorCode::coordinate_range},
        BrokenText{"infinite", "POINT(1 -inf)", 1, "found '-inf'", ErrorCode::coordinate_range},
        BrokenText{"overflow", "POINT(1\n1e999)", 2, "found '1e999'", ErrorCode::coordinate_range},
        BrokenText{"too_large", "POINT(1 1e31)", 1, "2^100", ErrorCode::coordinate_range},
        BrokenText{"no_parenthesis", "POINT 1 2", 1, "'(' or EMPTY, found '1'"},
        BrokenText{"two_points", "POINT(1 2, 3 4)", 1, "')' after the position of a POINT, found ','"},
        BrokenText{"double_comma", "LINESTRING(1 2,,3 4)", 1, "found ','"},
        BrokenText{"line_of_one", "LINESTRING(1 2)", 1, "at least 2 positions in a LINESTRING, found 1"},
        BrokenText{"empty_list", "LINESTRING()", 1, "found ')'"},
        BrokenText{"ring_of_three", "POLYGON((0 0, 1 1, 0 0))", 1, "at least 4 positions in ring 1"},
        BrokenText{"unclosed", "POLYGON((0 0, 4 0, 4 4, 0 0),\n(1 1, 2 1, 2 2, 1 3))", 2,
                   "ring 2 of the polygon to end where it starts, at (1, 1), found (1, 3); repeat"},
        BrokenText{"not_closed_at_all", "POLYGON((0 0, 4 0, 4 4, 0 0)", 1, "',' or ')', found the end of the text"},
        BrokenText{"more_behind", "POINT(1 2))", 1, "found ')'"},
        BrokenText{"srid_word", "SRID=x;POINT(1 2)", 1, "a whole number, the SRID"},
        BrokenText{"srid_without_end", "SRID=4326 POINT(1 2)", 1, "';' after the SRID"},
        BrokenText{"srid_alone", "SRID=4326;", 1, "found the end of the text"},
        BrokenText{"srid_changes", "SRID=4326;POINT(1 2)\nSRID=3857;POINT(1 2)", 2,
                   "SRID 4326, as before the first geometry, found SRID 3857; transform"},
        BrokenText{"srid_begins", "POINT(1 2)\nSRID=3857;POINT(1 2)", 2, "expected no SRID"},
        BrokenText{"srid_ends", "SRID=3857;POINT(1 2)\nPOINT(1 2)", 2, "found no SRID"}),
    name_of_broken);

// Boost.Geometry reads the same well-formed texts. It is no reader for the command, because it takes POINT(1) for
// POINT(1 0), closes open rings without a word and says no line.
namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint>;

template <class Ring>
std::vector<Point> points_of(const Ring& ring, std::size_t without) {
  std::vector<Point> points;
  for (const BoostPoint& point : ring) points.push_back({point.x(), point.y()});
  points.resize(points.size() - without);
  return points;
}

class RandomText {
 public:
  std::string position() { return number() + blanks() + number(); }

  std::string positions(std::size_t count, bool is_closed) {
    std::string text = "(" + position();
    const std::string first = text.substr(1);
    for (std::size_t i = 1; i < count; ++i) text += "," + blanks() + position();
    return text + (is_closed ? "," + first : "") + ")";
  }

  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

 private:
  std::string blanks() { return std::string(1 + below(2), ' '); }

  std::string number() {
    std::string text = below(2) == 0 ? "-" : "";
    for (std::size_t digits = 1 + below(9); digits > 0; --digits) text += static_cast<char>('0' + below(10));
    text += '.';
    for (std::size_t digits = 1 + below(20); digits > 0; --digits) text += static_cast<char>('0' + below(10));
    if (below(3) == 0) text += "e" + std::to_string(static_cast<int>(below(12)) - 3);
    return text;
  }

  std::mt19937_64 random_{7};
};

TEST(Wkt, ReadsTheSameCoordinatesAsBoostGeometry) {
  RandomText random;
  for (int i = 0; i < 500; ++i) {
    const std::string line_text = "LINESTRING" + random.positions(3 + random.below(5), false);
    bg::model::linestring<BoostPoint> line;
    bg::read_wkt(line_text, line);
    EXPECT_EQ(items_of_wkt(line_text)[0].shape, Shape::polyline(points_of(line, 0))) << line_text;

    std::string polygon_text = "POLYGON (" + random.positions(3 + random.below(5), true);
    const std::size_t holes = random.below(3);
    for (std::size_t hole = 0; hole < holes; ++hole) polygon_text += " ," + random.positions(3, true);
    polygon_text += ")";
    BoostPolygon polygon;
    bg::read_wkt(polygon_text, polygon);
    Rings rings{points_of(polygon.outer(), 1)};
    for (const auto& hole : polygon.inners()) rings.push_back(points_of(hole, 1));
    EXPECT_EQ(items_of_wkt(polygon_text)[0].shape, Shape::polygon(rings)) << polygon_text;
  }
}

}  // namespace
}  // namespace waywright::test

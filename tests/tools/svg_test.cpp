#include "waywright/svg.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "tools/command.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

/// What a picture holds, as an XML parser that knows nothing of us sees it: how many elements each group has, the
/// legend's labels, the title, and all numbers' range. Null where the picture is not well-formed.
json outline(const std::string& svg) {
  static const char* const kScript =
      "import json, re, sys, xml.etree.ElementTree as tree\n"
      "root = tree.fromstring(sys.stdin.buffer.read())\n"
      "name = lambda e: e.tag.split('}')[1]\n"
      "groups = {e.get('id'): e for e in root if name(e) == 'g'}\n"
      "texts = {e.get('id'): e.text for e in root if name(e) == 'text'}\n"
      "data = [n for e in root.iter() for n in re.findall(r'[-+.\\w]+', re.sub('[MLZ]', ' ', e.get('d', '')))\n"
      "        if e.get('d') and not e.get('d').endswith('H27')]\n"
      "print(json.dumps({'groups': {k: len(g) for k, g in groups.items()},\n"
      "  'solids': [e.get('d').count('Z') for e in groups['solids']],\n"
      "  'labels': [e.text for e in groups['legend'].iter() if name(e) == 'text'],\n"
      "  'mesh': sum(e.get('d').count('M') for e in groups['mesh']) if 'mesh' in groups else 0,\n"
      "  'title': texts.get('title'), 'numbers': [float(n) for n in data],\n"
      "  'size': [float(root.get('width')), float(root.get('height'))]}))\n";
  const auto result = run_program("python3", {"-c", kScript}, svg);
  return result.status == 0 ? json::parse(result.out) : json(result.err);
}

void put(World& world, ItemKind kind, const std::vector<std::vector<Point>>& rings) {
  ASSERT_TRUE(world.insert({kind, rings}).ok());
}

World make_world(const Box& domain) { return World::create(domain).value(); }

TEST(ToSvg, DrawsEachThingOnceInItsGroup) {
  World world = make_world({{0, 0}, {10, 10}});
  const std::vector<std::vector<Point>> rings{{{1, 1}, {5, 1}, {5, 5}, {1, 5}}, {{2, 2}, {3, 2}, {2, 3}}};
  put(world, ItemKind::polygon, rings);
  put(world, ItemKind::polygon, {{{6, 6}, {8, 6}, {7, 8}}});
  put(world, ItemKind::segment, {{{0, 9}, {4, 9}}});
  put(world, ItemKind::polyline, {{{6, 1}, {7, 2}, {8, 1}}});
  put(world, ItemKind::point, {{{9, 9}}});
  put(world, ItemKind::segment, {{{9, 5}, {9, 5}}});
  Path path;
  path.status = PathStatus::found;
  path.length = 12.345678;
  path.points = {{0.5, 0.5}, {0.5, 6}, {5, 6}};
  const Path none;

  const json drawn = outline(to_svg(world, {path, none}, {}));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["groups"]["solids"], 2);
  EXPECT_EQ(drawn["solids"], json::parse("[2,1]"));
  EXPECT_EQ(drawn["groups"]["walls"], 2);
  EXPECT_EQ(drawn["groups"]["points"], 2);
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  EXPECT_EQ(drawn["groups"]["ends"], 2);
  EXPECT_EQ(drawn["title"], nullptr);
  const std::string triangles = std::to_string(world.triangle_count()) + " triangles";
  EXPECT_EQ(drawn["labels"],
            json({"2 solids", "2 walls", "2 points", triangles, "path, length 12.346", "start", "goal"}));
}

TEST(ToSvg, FillsEachPolygonByItsRule) {
  const std::vector<Point> star = {{5, 9}, {2, 1}, {9, 6}, {1, 6}, {8, 1}};
  const auto drawn_by = [&](FillRule rule) {
    World world = make_world({{0, 0}, {10, 10}});
    EXPECT_TRUE(world.insert({ItemKind::polygon, {star}, rule}).ok());
    return to_svg(world, {}, {});
  };
  // The group's rule is even-odd; a path may have its own.
  const std::string attribute = " fill-rule=\"nonzero\"";
  std::string nonzero = drawn_by(FillRule::nonzero);
  const std::size_t at = nonzero.find("<path" + attribute);
  ASSERT_NE(at, std::string::npos);
  nonzero.erase(nonzero.find(attribute), attribute.size());
  EXPECT_EQ(nonzero, drawn_by(FillRule::even_odd));
  EXPECT_NE(nonzero.find("id=\"solids\""), std::string::npos);
  EXPECT_NE(nonzero.find("fill-rule=\"evenodd\""), std::string::npos);
}

TEST(ToSvg, DrawsEveryFreeEdgeOnceAndNoneWithoutMesh) {
  World world = make_world({{0, 0}, {10, 10}});
  put(world, ItemKind::point, {{{2, 3}}});
  put(world, ItemKind::segment, {{{4, 4}, {6, 9}}});
  // Seven vertices, four of them on the hull: 3 * 7 - 3 - 4 edges, of which the four sides and the wall are not free.
  const json drawn = outline(to_svg(world, {}, {}));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["mesh"], 3 * 7 - 3 - 4 - 5);

  SvgOptions bare;
  bare.mesh = false;
  const json without = outline(to_svg(world, {}, bare));
  EXPECT_EQ(without["mesh"], 0);
  EXPECT_EQ(without["labels"], json({"1 wall", "1 point"}));
}

TEST(ToSvg, IsTheSameTextEveryTime) {
  World world = make_world({{0, 0}, {10, 10}});
  put(world, ItemKind::segment, {{{1, 1}, {9, 8}}});
  World other = make_world({{0, 0}, {10, 10}});
  put(other, ItemKind::segment, {{{1, 1}, {9, 8}}});
  EXPECT_EQ(to_svg(world, {}, {}), to_svg(other, {}, {}));
}

TEST(ToSvg, EscapesTheTitle) {
  const World world = make_world({{0, 0}, {1, 1}});
  SvgOptions options;
  options.title = "a<b> & \"c\" \xc3\xa9\x01\xff\xed\xa0\x80.";
  const json drawn = outline(to_svg(world, {}, options));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["title"], "a<b> & \"c\" \u00e9 ????.");
}

/// The centre of the only dot, in pixels.
Point only_dot(const std::string& svg) {
  const std::regex dot("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\" r=\"[-0-9.]+\"/>\n</g>");
  std::smatch found;
  if (!std::regex_search(svg, found, dot)) return {-1, -1};
  return {std::stod(found[1]), std::stod(found[2])};
}

TEST(ToSvg, PointsYUpOrDown) {
  World world = make_world({{0, 0}, {10, 10}});
  put(world, ItemKind::point, {{{2, 9}}});
  SvgOptions options;
  const Point up = only_dot(to_svg(world, {}, options));
  options.y_down = true;
  const Point down = only_dot(to_svg(world, {}, options));
  ASSERT_GT(up.x, 0);
  EXPECT_EQ(up.x, down.x);
  EXPECT_NEAR(down.y - up.y, 0.8 * (options.width - 40), 0.02);
}

TEST(ToSvg, FitsAnyDomainIntoThePicture) {
  const double tiny = std::ldexp(1.0, -90);
  const double huge = std::ldexp(1.0, 100);
  for (const Box& domain : {Box{{0, 0}, {tiny, tiny}}, Box{{-huge, -huge}, {huge, huge}}, Box{{0, 0}, {huge, tiny}},
                            Box{{0, 0}, {tiny, huge}}, Box{{1e9, 1e9}, {1e9 + 1, 1e9 + 2}}}) {
    World world = make_world(domain);
    put(world, ItemKind::segment, {{domain.min, domain.max}});
    const json drawn = outline(to_svg(world, {}, {}));
    ASSERT_TRUE(drawn.is_object()) << drawn;
    ASSERT_GE(drawn["numbers"].size(), 4U);
    EXPECT_LE(drawn["size"][1], 2000);
    const double largest = std::max(drawn["size"][0].get<double>(), drawn["size"][1].get<double>());
    for (const double number : drawn["numbers"]) {
      EXPECT_TRUE(std::isfinite(number));
      EXPECT_GE(number, 0);
      EXPECT_LE(number, largest);
    }
  }
}

TEST(ToSvg, TakesAnyWidth) {
  const World world = make_world({{0, 0}, {1, 1}});
  for (const double width : {-5.0, 0.0, 1e300, std::nan(""), HUGE_VAL}) {
    SvgOptions options;
    options.width = width;
    const json drawn = outline(to_svg(world, {}, options));
    ASSERT_TRUE(drawn.is_object()) << drawn;
    EXPECT_GE(drawn["size"][0], 100) << width;
    EXPECT_LE(drawn["size"][0], 100000) << width;
  }
}

TEST(ToSvg, TakesPathsThatLeaveThePicture) {
  const World world = make_world({{0, 0}, {1, 1}});
  Path path;
  path.status = PathStatus::found;
  path.points = {{0, 0}, {1e300, -1e300}, {std::nan(""), HUGE_VAL}, {1, 1}};
  const json drawn = outline(to_svg(world, {path}, {}));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  for (const double number : drawn["numbers"]) EXPECT_LE(std::abs(number), 1e7);
}

TEST(ToSvg, CountsPathsWhereThereAreMoreThanColours) {
  const World world = make_world({{0, 0}, {1, 1}});
  Path path;
  path.status = PathStatus::found;
  path.length = 1.0;
  path.points = {{0, 0}, {0, 1}};
  const std::string four = to_svg(world, std::vector<Path>(4, path), {});
  EXPECT_THAT(four, ::testing::HasSubstr("path, length 1<"));
  EXPECT_THAT(four, ::testing::Not(::testing::HasSubstr("paths<")));
  const std::string five = to_svg(world, std::vector<Path>(5, path), {});
  EXPECT_THAT(five, ::testing::HasSubstr("5 paths<"));
  EXPECT_THAT(five, ::testing::Not(::testing::HasSubstr("path, length")));
}

TEST(SvgFile, OfARunShowsTheFinalWorldAndThePathsFoundInIt) {
  const TemporaryFolder folder;
  const std::string picture = folder.file("world.svg");
  const auto result = run_script(
      "waywright 1\ndomain 0 0 10 10\npath 1 1 9 9 0\nsegment 1 5 0 5 6\n"
      "path 2 3 8 3 0\npath 1 1 2 2 0\npoint 1 2 2\n",
      {"--svg", picture});
  EXPECT_EQ(result.status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["groups"]["walls"], 1);
  EXPECT_EQ(drawn["groups"]["paths"], 2);
  EXPECT_THAT(read_file(picture), ::testing::HasSubstr("path, length 8.4853"));  // 6 sqrt(2)
  EXPECT_THAT(read_file(picture), ::testing::HasSubstr("path, length 1.4142"));
  EXPECT_EQ(drawn["title"], "standard input");
  EXPECT_GT(drawn["mesh"], 0);
}

TEST(SvgFile, OfAPathIsTitledWithTheMapAndDrawnTheMapsWayUp) {
  const TemporaryFolder folder;
  const std::string map = folder.file("one & two.map", "type octile\nheight 4\nwidth 4\nmap\n@...\n....\n....\n....\n");
  const std::string picture = folder.file("a.svg");
  const auto result = run_command({"path", map, "--from", "0", "3", "--to", "4", "0", "--svg", picture, "--no-mesh"});
  EXPECT_EQ(result.status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["title"], "one & two.map");
  EXPECT_EQ(drawn["mesh"], 0);
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  // The blocked cell is the uppermost thing: its smallest y is that of the whole map.
  const auto numbers = drawn["numbers"].get<std::vector<double>>();
  ASSERT_GE(numbers.size(), 8U);
  EXPECT_LT(*std::min_element(numbers.begin(), numbers.begin() + 8), 100);
}

TEST(SvgFile, OfAConversionHoldsEveryItem) {
  const TemporaryFolder folder;
  const std::string map = folder.file("a.wws", "waywright 1\ndomain 0 0 9 9\npoint 1 1 1\npolygon 2 3 2 2 4 2 3 4\n");
  const std::string picture = folder.file("a.svg");
  EXPECT_EQ(run_command({"convert", map, picture}).status, 0);
  const json drawn = outline(read_file(picture));
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(drawn["groups"]["solids"], 1);
  EXPECT_EQ(drawn["groups"]["points"], 1);
  EXPECT_GT(drawn["mesh"], 0);
}

}  // namespace
}  // namespace waywright::test

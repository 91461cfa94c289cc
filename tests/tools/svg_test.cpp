#include "waywright/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <locale>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "tools/command.hpp"
#include "tools/svg_outline.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

TEST(ToSvg, DrawsEachThingOnceInItsGroup) {
  World world = make_world({{0, 0}, {10, 10}});
  const std::vector<std::vector<Point>> rings{{{1, 1}, {5, 1}, {5, 5}, {1, 5}}, {{2, 2}, {3, 2}, {2, 3}}};
  put(world, ItemKind::polygon, rings);
  put(world, ItemKind::polygon, {{{6, 6}, {8, 6}, {7, 8}}});
  put(world, ItemKind::segment, {{{0, 9}, {4, 9}}});
  put(world, ItemKind::polyline, {{{6, 1}, {7, 2}, {8, 1}}});
  put(world, ItemKind::point, {{{9, 9}}});
  put(world, ItemKind::segment, {{{9, 5}, {9, 5}}});
  const Path path = path_through({{0.5, 0.5}, {0.5, 6}, {5, 6}}, 12.345678);
  const Path none;

  const json drawn = drawing_of(world, {.paths = {path, none}});
  EXPECT_EQ(drawn["groups"]["polygons"], 2);
  EXPECT_EQ(drawn["polygons"], json::parse("[2,1]"));
  EXPECT_EQ(drawn["groups"]["lines"], 2);
  EXPECT_EQ(drawn["groups"]["points"], 2);
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  EXPECT_EQ(drawn["groups"]["ends"], 2);
  EXPECT_EQ(drawn["title"], nullptr);
  const std::string triangles = std::to_string(world.triangle_count()) + " triangles";
  EXPECT_EQ(drawn["labels"], json({"2 polygons", "2 polylines", "2 points", triangles, "path, length 12.346", "start",
                                   "goal", "1", "y up"}));
}

TEST(ToSvg, FillsEachPolygonByItsRule) {
  const std::vector<Point> star = {{5, 9}, {2, 1}, {9, 6}, {1, 6}, {8, 1}};
  const auto drawn_by = [&](FillRule rule) {
    World world = make_world({{0, 0}, {10, 10}});
    EXPECT_TRUE(world.insert({ItemKind::polygon, {star}, rule}).ok());
    return picture_of(world);
  };
  // The group's fill rule is even-odd; a path may have its own.
  const std::string attribute = " fill-rule=\"nonzero\"";
  std::string nonzero = drawn_by(FillRule::nonzero);
  const std::size_t at = nonzero.find("<path" + attribute);
  ASSERT_NE(at, std::string::npos);
  nonzero.erase(nonzero.find(attribute), attribute.size());
  EXPECT_EQ(nonzero, drawn_by(FillRule::even_odd));
  EXPECT_NE(nonzero.find("id=\"polygons\""), std::string::npos);
  EXPECT_NE(nonzero.find("fill-rule=\"evenodd\""), std::string::npos);
}

TEST(ToSvg, DrawsEveryFreeEdgeOnceAndNoneWithoutMesh) {
  World world = make_world({{0, 0}, {10, 10}});
  put(world, ItemKind::point, {{{2, 3}}});
  put(world, ItemKind::segment, {{{4, 4}, {6, 9}}});
  // Seven vertices, four of them on the convex hull: 3 * 7 - 3 - 4 edges. Of these, the four sides and the wall are not
  // free.
  EXPECT_EQ(drawing_of(world)["mesh"], 3 * 7 - 3 - 4 - 5);

  const json without = drawing_of(world, {}, bare_options());
  EXPECT_EQ(without["mesh"], 0);
  EXPECT_EQ(without["labels"], json({"1 polyline", "1 point"}));
}

/// A locale with a decimal comma and digits in groups.
class ForeignDigits : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(ToSvg, IsTheSameTextEveryTimeWhateverTheLocale) {
  World world = make_world({{0, 0}, {1e4, 1e4}});
  put(world, ItemKind::segment, {{{1.25, 1}, {9000, 8000}}});
  World other = make_world({{0, 0}, {1e4, 1e4}});
  put(other, ItemKind::segment, {{{1.25, 1}, {9000, 8000}}});
  const SvgOverlay overlay{.paths = {path_through({{0.5, 0.5}, {1234.5, 6}}, 1234.5)},
                           .locations = {{{1234.25, 6000.5}, {}}}};
  const std::string text = picture_of(world, overlay);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new ForeignDigits));
  EXPECT_EQ(picture_of(other, overlay), text);
  std::locale::global(before);
}

TEST(ToSvg, ShowsPointsWhereItsFrameSays) {
  World world = make_world({{-10, 5}, {30, 25}});
  const Point point{2, 9};
  put(world, ItemKind::point, {{point}});
  for (const bool y_down : {false, true}) {
    for (const bool axes : {false, true}) {
      SvgOptions options;
      options.y_down = y_down;
      options.axes = axes;
      options.title = "title";
      const SvgFrame frame = frame_of(world, options);
      const json dot = elements_of(drawing_of(world, {}, options), "points", "circle").at(0);
      EXPECT_NEAR(number_of(dot, "cx"), frame.to_picture(point).x, 0.006);
      EXPECT_NEAR(number_of(dot, "cy"), frame.to_picture(point).y, 0.006);
      // The position in the map is the same fraction of the width and of the height as in the world, measured from
      // below or from above.
      const Box& map = frame.map();
      EXPECT_NEAR(frame.to_picture(point).x, map.min.x + 0.3 * (map.max.x - map.min.x), 1e-9);
      EXPECT_NEAR(frame.to_picture(point).y, map.min.y + (y_down ? 0.2 : 0.8) * (map.max.y - map.min.y), 1e-9);
      EXPECT_NEAR((map.max.x - map.min.x) / frame.scale(), 40.0, 1e-9);
      EXPECT_NEAR(frame.to_world(frame.to_picture(point)).x, point.x, 1e-9);
      EXPECT_NEAR(frame.to_world(frame.to_picture(point)).y, point.y, 1e-9);
    }
  }
}

TEST(ToSvg, HasTicksWhereTheirCoordinatesAre) {
  World world = make_world({{-10, 5}, {30, 25}});
  for (const bool y_down : {false, true}) {
    SvgOptions options;
    options.y_down = y_down;
    const SvgFrame frame = frame_of(world, options);
    const json drawn = drawing_of(world, {}, options);
    int along_x = 0;
    int along_y = 0;
    for (const json& label : elements_of(drawn, "axes", "text")) {
      const double value = std::stod(label["text"].get<std::string>());
      if (number_of(label, "y") > frame.map().max.y) {
        EXPECT_NEAR(number_of(label, "x"), frame.to_picture({value, 5}).x, 0.006);
        ++along_x;
      } else {
        EXPECT_NEAR(number_of(label, "y"), frame.to_picture({-10, value}).y + 4.0, 0.006);
        EXPECT_GE(number_of(label, "x"), 0);
        ++along_y;
      }
    }
    EXPECT_GE(along_x, 5);
    EXPECT_GE(along_y, 4);
    EXPECT_EQ(drawn["labels"].back(), y_down ? "y down" : "y up");
  }
  SvgOptions without;
  without.axes = false;
  EXPECT_TRUE(elements_of(drawing_of(world, {}, without), "axes", "text").empty());
}

TEST(ToSvg, HasAScaleBarAsLongAsItSays) {
  for (const double size : {0.03, 1.0, 7.0, 512.0, 3e9}) {
    const World world = make_world({{0, 0}, {size, size}});
    const json drawn = drawing_of(world);
    const std::string data = elements_of(drawn, "legend", "path").at(1)["d"];  // the first is the sample of the mesh
    const double pixels = std::stod(data.substr(data.find('L') + 1)) - 1.0;
    const double length = std::stod(drawn["labels"].at(1).get<std::string>());
    EXPECT_NEAR(pixels, length * frame_of(world, {}).scale(), 0.006);
    EXPECT_LE(pixels, 120.0);
    EXPECT_GE(pixels, 120.0 / 2.5 - 0.01);
  }
}

TEST(ToSvg, HasTheIdOfEachItemOnHover) {
  World world = make_world({{0, 0}, {10, 10}});
  world.insert_polygon({{1, 1}, {2, 1}, {1, 2}}, {7}).value();
  world.insert_segment({3, 3}, {4, 4}, {ItemId::kLargest}).value();
  world.insert_polyline({{5, 3}, {6, 4}, {7, 3}}, {5}).value();
  world.insert_point({8, 8}, {1}).value();
  const json drawn = drawing_of(world);
  using Hints = std::vector<std::string>;
  EXPECT_EQ(hints_of(drawn, "polygons"), Hints{"polygon 7"});
  EXPECT_EQ(hints_of(drawn, "lines"), (Hints{"polyline 5", "segment 9223372036854775807"}));
  EXPECT_EQ(hints_of(drawn, "points"), Hints{"point 1"});
  SvgOptions options;
  options.ids = false;
  const json without = drawing_of(world, {}, options);
  EXPECT_EQ(hints_of(without, "polygons"), Hints{});
  EXPECT_EQ(without["groups"]["polygons"], 1);
  EXPECT_EQ(without["groups"]["points"], 1);
}

TEST(ToSvg, StaysSmallOfALargeWorld) {
  World world = make_world({{0, 0}, {400, 400}});
  std::vector<Point> points;
  for (int x = 1; x < 350; ++x) {
    for (int y = 1; y < 300; ++y) points.push_back({x + 0.25 * (y % 3), y + 0.2 * (x % 4)});
  }
  world.insert_points(points).value();
  const std::string text = picture_of(world);
  EXPECT_LT(text.size(), 25 * points.size());
  const json drawn = outline(text);
  ASSERT_TRUE(drawn.is_object()) << drawn;
  EXPECT_EQ(hints_of(drawn, "points"), std::vector<std::string>{});
  EXPECT_EQ(drawn["mesh"], 0);
  EXPECT_EQ(drawn["labels"][1], std::to_string(world.triangle_count()) + " triangles, too many edges to draw");
  std::string dots;
  for (const json& element : elements_of(drawn, "points", "path")) {
    const std::string data = element["d"];
    EXPECT_LT(data.size(), 2000000U);  // libxml2 refuses attributes of 10 MB
    dots += data;
  }
  EXPECT_EQ(static_cast<std::size_t>(std::count(dots.begin(), dots.end(), 'M')), points.size());

  // A cropped picture draws every point of its region.
  SvgOptions options;
  options.crop = Box{{20, 30}, {40, 50}};
  const std::string part = picture_of(world, {}, options);
  EXPECT_LT(part.size(), 200000U);
  const json shown = outline(part);
  ASSERT_TRUE(shown.is_object()) << shown;
  const auto expected = std::count_if(points.begin(), points.end(),
                                      [](const Point& p) { return p.x >= 20 && p.x <= 40 && p.y >= 30 && p.y <= 50; });
  EXPECT_EQ(shown["groups"]["points"], expected);
  EXPECT_EQ(hints_of(shown, "points").size(), static_cast<std::size_t>(expected));
  EXPECT_GT(shown["mesh"], 1000);
}

TEST(ToSvg, HoldsNothingOutsideTheCropBox) {
  World world = make_world({{0, 0}, {1000, 1000}});
  world.insert_segment({0, 0}, {1000, 500}, {1}).value();    // through the box
  world.insert_segment({0, 900}, {900, 1000}, {2}).value();  // beside it
  world.insert_polygon({{500, 200}, {900, 200}, {900, 900}, {500, 900}}, {3}).value();
  world.insert_polygon({{10, 10}, {20, 10}, {10, 20}}, {4}).value();
  world.insert_point({505, 255}, {5}).value();
  world.insert_point({600, 600}, {6}).value();
  SvgOptions options;
  options.crop = Box{{490, 230}, {520, 260}};
  SvgOverlay overlay{.paths = {path_through({{0, 250}, {1000, 250}}), path_through({{0, 0}, {1, 1}})},
                     .rays = {{{400, 400}, {420, 420}, {}}},
                     .failed_paths = {{{1, 1}, {2, 2}, PathStatus::no_path}},
                     .locations = {{{700, 700}, {}}, {{500, 250}, {}}},
                     .polylines = {{.points = {{0, 0}, {10, 0}}}},
                     .discs = {{{900, 900}, 20, "", ""}, {{480, 240}, 15, "", ""}},
                     .labels = {{.at = {900, 900}, .text = "outside"}, {.at = {500, 240}, .text = "inside"}}};
  const json drawn = drawing_of(world, overlay, options);
  EXPECT_EQ(hints_of(drawn, "lines"), std::vector<std::string>{"segment 1"});
  EXPECT_EQ(hints_of(drawn, "polygons"), std::vector<std::string>{"polygon 3"});
  EXPECT_EQ(hints_of(drawn, "points"), std::vector<std::string>{"point 5"});
  EXPECT_EQ(drawn["groups"]["paths"], 1);
  EXPECT_EQ(drawn["groups"]["ends"], 0);
  EXPECT_EQ(drawn["groups"]["rays"], 0);
  EXPECT_EQ(drawn["groups"]["failed-paths"], 0);
  EXPECT_EQ(drawn["groups"]["locations"], 1);
  EXPECT_EQ(drawn["groups"]["polylines"], 0);
  EXPECT_EQ(drawn["groups"]["discs"], 1);
  EXPECT_EQ(elements_of(drawn, "labels", "text").at(0)["text"], "inside");
  for (const double number : drawn["numbers"]) {
    EXPECT_GE(number, -65);
    EXPECT_LE(number, 1300);
  }

  // The wall through the box keeps its position: at x = 500 it has y = 250.
  const SvgFrame frame = frame_of(world, options);
  const std::string data = elements_of(drawn, "lines", "path").at(0)["d"];
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  ASSERT_EQ(std::sscanf(data.c_str(), "M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1), 4) << data;
  const Point middle = frame.to_picture({500, 250});
  EXPECT_NEAR(y0 + (middle.x - x0) / (x1 - x0) * (y1 - y0), middle.y, 0.02);
  EXPECT_LT(std::min(x0, x1), frame.map().min.x);
  EXPECT_GT(std::max(x0, x1), frame.map().max.x);
}

TEST(ToSvg, RefusesABadCropBox) {
  const World world = make_world({{0, 0}, {10, 10}});
  const auto code_of = [&](const Box& crop) {
    SvgOptions options;
    options.crop = crop;
    const Result<std::string> text = to_svg(world, {}, options);
    const Result<SvgFrame> frame = svg_frame(world.domain(), options);
    EXPECT_EQ(text.ok(), frame.ok());
    if (text.ok()) return std::string("ok");
    EXPECT_EQ(text.error().message(), frame.error().message());
    EXPECT_NE(text.error().message().find("the crop box, ("), std::string::npos);
    return std::string(to_string(text.error().code));
  };
  EXPECT_EQ(code_of({{1, 1}, {2, 2}}), "ok");
  EXPECT_EQ(code_of({{-5, -5}, {0.5, 99}}), "ok");
  EXPECT_EQ(code_of({{2, 1}, {1, 2}}), "bad-domain");
  EXPECT_EQ(code_of({{1, 2}, {2, 2}}), "bad-domain");
  EXPECT_EQ(code_of({{10, 0}, {11, 1}}), "out-of-domain");
  EXPECT_EQ(code_of({{0, -3}, {10, 0}}), "out-of-domain");
  EXPECT_EQ(code_of({{0, std::nan("")}, {1, 1}}), "coordinate-range");
  EXPECT_EQ(code_of({{0, 0}, {HUGE_VAL, 1}}), "coordinate-range");
  EXPECT_EQ(code_of({{0, 0}, {1e-60, 1}}), "coordinate-range");
}

TEST(ToSvg, FitsAnyDomainIntoThePicture) {
  const double tiny = std::ldexp(1.0, -90);
  const double huge = std::ldexp(1.0, 100);
  for (const Box& domain : {Box{{0, 0}, {tiny, tiny}}, Box{{-huge, -huge}, {huge, huge}}, Box{{0, 0}, {huge, tiny}},
                            Box{{0, 0}, {tiny, huge}}, Box{{1e9, 1e9}, {1e9 + 1, 1e9 + 2}}}) {
    World world = make_world(domain);
    put(world, ItemKind::segment, {{domain.min, domain.max}});
    const json drawn = drawing_of(world);
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
    const json drawn = drawing_of(world, {}, options);
    EXPECT_GE(drawn["size"][0], 100) << width;
    EXPECT_LE(drawn["size"][0], 100000) << width;
  }
}

TEST(ToSvg, ShrinksALongTitleToOneLine) {
  const World world = make_world({{0, 0}, {1, 1}});
  SvgOptions options;
  options.title = "short";
  EXPECT_EQ(number_of(elements_of(drawing_of(world, {}, options), "", "text").at(0), "font-size"), 22);
  options.title.assign(120, 'm');
  const json title = elements_of(drawing_of(world, {}, options), "", "text").at(0);
  EXPECT_LT(number_of(title, "font-size") * 120 * 0.6, 1200);
  EXPECT_GE(number_of(title, "font-size"), 11);

  options.width = 240;
  options.title.clear();
  for (int i = 0; i < 60; ++i) options.title += "\xc3\xa9";
  const json cut = elements_of(drawing_of(world, {}, options), "", "text").at(0);
  const std::string text = cut["text"];
  EXPECT_TRUE(text.starts_with("\xc3\xa9\xc3\xa9")) << text;
  EXPECT_TRUE(text.ends_with("\xc3\xa9\xe2\x80\xa6")) << text;
  EXPECT_LT(number_of(cut, "font-size") * static_cast<double>(text.size() / 2) * 0.6, 220);
}

}  // namespace
}  // namespace waywright::test

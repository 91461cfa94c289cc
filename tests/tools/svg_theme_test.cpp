#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "tools/command.hpp"
#include "tools/svg_outline.hpp"

namespace waywright::test {
namespace {

using nlohmann::json;

/// Draws a world and an overlay with every element that has a colour of the theme.
json colourful(SvgTheme theme) {
  World world = make_world({{0, 0}, {10, 10}});
  world.insert_polygon({{1, 1}, {4, 1}, {4, 4}, {1, 4}}, {8}).value();
  world.insert_segment({6, 1}, {6, 9}, {2}).value();
  world.insert_point({9, 9}).value();
  SvgOverlay overlay{.paths = std::vector<Path>(4, path_through({{5, 5}, {6, 5}})),
                     .rays = {{{5, 7}, {9, 7}, world.ray({5, 7}, {9, 7}).value()}},
                     .failed_paths = {{{5, 5}, {2, 2}, PathStatus::goal_blocked}},
                     .discs = {{{8, 8}, 1, "", ""}},
                     .labels = {{.at = {8, 8}, .text = "label"}}};
  for (const Point& point : {Point{8, 5.25}, Point{6, 5}, Point{6, 9}, Point{2, 3}}) {
    overlay.locations.push_back({point, world.locate(point).value()});
  }
  SvgOptions options;
  options.title = "title";
  options.theme = theme;
  return drawing_of(world, overlay, options);
}

TEST(ToSvg, HasColoursOfEnoughContrastInBothThemes) {
  for (const SvgTheme theme : {SvgTheme::light, SvgTheme::dark}) {
    const json drawn = colourful(theme);
    const std::string page = elements_of(drawn, "", "rect").at(0)["fill"];
    EXPECT_EQ(luminance(page) < 0.2, theme == SvgTheme::dark) << page;
    std::set<std::string> marks;
    for (const json& element : drawn["elements"]) {
      EXPECT_NE(element["tag"], "style");
      EXPECT_FALSE(element.contains("class")) << element;
      if (element["tag"] == "text") {
        EXPECT_GE(contrast(element["shown-fill"], page), 4.5) << element;
      }
      const std::string group = element["group"];
      const bool is_mark = group == "paths" || group == "locations" || group.starts_with("rays") ||
                           group.starts_with("failed") || group == "discs" || group == "ends" || group == "lines";
      if (!is_mark) continue;
      for (const char* name : {"fill", "stroke"}) {
        const std::string colour = element.value(name, std::string("none"));
        if (colour != "none" && colour != page) marks.insert(colour);
      }
    }
    EXPECT_GE(marks.size(), 11U);
    const std::string ground = elements_of(drawn, "map", "path").at(0)["fill"];
    for (const std::string& colour : marks) EXPECT_GE(contrast(colour, ground), 2.8) << colour;
  }
}

TEST(ToSvg, IsLightOrDarkAsTheViewerPrefersUnlessATheme) {
  const json light = colourful(SvgTheme::light);
  const json dark = colourful(SvgTheme::dark);
  const json both = colourful(SvgTheme::automatic);
  std::string sheet;
  for (const json& element : both["elements"]) {
    if (element["tag"] == "style") sheet = element["text"];
  }
  ASSERT_TRUE(sheet.starts_with("@media (prefers-color-scheme:dark){")) << sheet;
  // Without the style sheet the picture looks light. With it, each element has the colours of the dark picture.
  std::vector<json> elements;
  for (const json& element : both["elements"]) {
    if (element["tag"] != "style") elements.push_back(element);
  }
  ASSERT_EQ(elements.size(), light["elements"].size());
  ASSERT_EQ(elements.size(), dark["elements"].size());
  int coloured = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::istringstream classes(elements[i].value("class", std::string()));
    json shown = elements[i];
    shown.erase("class");
    EXPECT_EQ(shown, light["elements"][i]);
    for (std::string name; classes >> name;) {
      const char* const property = name[0] == 'f' ? "fill" : "stroke";
      const std::string rule = "." + name + "{" + property + ":";
      const std::size_t at = sheet.find(rule);
      ASSERT_NE(at, std::string::npos) << rule;
      shown[property] = sheet.substr(at + rule.size(), 7);
      ++coloured;
    }
    json expected = dark["elements"][i];
    for (json* element : {&shown, &expected}) element->erase("shown-fill");  // inherited: no rule of its own
    EXPECT_EQ(shown, expected);
  }
  EXPECT_GT(coloured, 50);
}

}  // namespace
}  // namespace waywright::test

#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "tools/command.hpp"

namespace waywright::test {

using nlohmann::json;

/// Returns what a picture contains, as a generic XML parser reads it: how many elements each group has; every element
/// with its group, attributes, text, hint and fill; the labels of the legend; the title; and all numbers of paths.
/// Returns a text if the picture is not well-formed XML.
inline json outline(const std::string& svg) {
  static const char* const kScript =
      "import json, re, sys, xml.etree.ElementTree as tree\n"
      "root = tree.fromstring(sys.stdin.buffer.read())\n"
      "name = lambda e: e.tag.split('}')[1]\n"
      "elements, groups = [], {}\n"
      "def visit(e, group, fill):\n"
      "  fill = e.get('fill', fill)\n"
      "  hint = [c.text for c in e if name(c) == 'title']\n"
      "  elements.append({'tag': name(e), 'group': group, 'text': e.text, 'hint': hint[0] if hint else None, "
      "'shown-fill': fill, "
      "**e.attrib})\n"
      "  if name(e) == 'g' and e.get('id'): group = e.get('id'); groups[group] = e\n"
      "  for c in e: visit(c, group, fill)\n"
      "visit(root, '', 'black')\n"
      "count = lambda g: sum(1 for c in g if name(c) != 'title')\n"
      "data = [n for e in elements if e['group'] != 'legend' for n in re.findall(r'[-+.\\w]+',\n"
      "        re.sub('h0|[MLZA]', ' ', e.get('d', '')))]\n"
      "print(json.dumps({'groups': {k: count(g) for k, g in groups.items()}, 'elements': elements,\n"
      "  'polygons': [e.get('d').count('Z') for e in groups['polygons']],\n"
      "  'labels': [e['text'] for e in elements if e['group'] == 'legend' and e['tag'] == 'text'],\n"
      "  'mesh': sum(e.get('d').count('M') for e in groups['mesh']) if 'mesh' in groups else 0,\n"
      "  'title': next((e['text'] for e in elements if e.get('id') == 'title'), None),\n"
      "  'numbers': [float(n) for n in data], 'size': [float(root.get('width')), float(root.get('height'))]}))\n";
  const auto result = run_program("python3", {"-c", kScript}, svg);
  return result.status == 0 ? json::parse(result.out) : json(result.err);
}

/// Returns the picture's elements in a group that have a given tag.
inline std::vector<json> elements_of(const json& drawn, const std::string& group, const std::string& tag) {
  std::vector<json> found;
  for (const json& element : drawn["elements"]) {
    if (element["group"] == group && element["tag"] == tag) found.push_back(element);
  }
  return found;
}

inline std::vector<std::string> hints_of(const json& drawn, const std::string& group) {
  std::vector<std::string> hints;
  for (const json& element : drawn["elements"]) {
    if (element["group"] == group && element["hint"].is_string()) hints.push_back(element["hint"]);
  }
  return hints;
}

inline double number_of(const json& element, const char* name) { return std::stod(element[name].get<std::string>()); }

inline std::string picture_of(const World& world, const SvgOverlay& overlay = {}, const SvgOptions& options = {}) {
  Result<std::string> text = to_svg(world, overlay, options);
  EXPECT_TRUE(text.ok()) << text.error().message();
  return text.ok() ? *std::move(text) : std::string();
}

inline json drawing_of(const World& world, const SvgOverlay& overlay = {}, const SvgOptions& options = {}) {
  json drawn = outline(picture_of(world, overlay, options));
  EXPECT_TRUE(drawn.is_object()) << drawn;
  return drawn;
}

/// Returns options for a picture whose legend contains only what the test sets.
inline SvgOptions bare_options() {
  SvgOptions options;
  options.mesh = false;
  options.axes = false;
  return options;
}

inline SvgFrame frame_of(const World& world, const SvgOptions& options) {
  return svg_frame(world.domain(), options).value();
}

inline Path path_through(std::vector<Point> points, double length = 1.0) {
  Path path;
  path.status = PathStatus::found;
  path.length = length;
  path.points = std::move(points);
  return path;
}

inline void put(World& world, ItemKind kind, const std::vector<std::vector<Point>>& rings) {
  ASSERT_TRUE(world.insert({kind, rings}).ok());
}

inline World make_world(const Box& domain) { return World::create(domain).value(); }

/// Returns how bright a colour looks, from 0 to 1. Source: WCAG 2.1, relative luminance.
inline double luminance(const std::string& colour) {
  const auto part = [&](std::size_t i) {
    const double value = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * part(0) + 0.7152 * part(1) + 0.0722 * part(2);
}

inline double contrast(const std::string& a, const std::string& b) {
  const double bright = std::max(luminance(a), luminance(b));
  const double dark = std::min(luminance(a), luminance(b));
  return (bright + 0.05) / (dark + 0.05);
}

}  // namespace waywright::test

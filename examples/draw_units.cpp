// A game draws its own units into a picture of its world: discs with names, the paths that they take, and a range of
// fire. It draws the range of fire itself, in the picture's coordinates.
//
// usage: draw_units [FILE]   writes the picture to FILE; without it, only checks the picture

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

namespace {

using waywright::Path;
using waywright::Point;
using waywright::World;

struct Unit {
  std::string name;
  Point at;
  Point goal;
  double radius = 1.0;
  bool is_ours = true;
};

World make_world() {
  World world = World::create({{0, 0}, {100, 60}}).value();
  const std::vector<std::vector<Point>> keep{{{42, 20}, {66, 18}, {70, 40}, {46, 44}},
                                             {{50, 25}, {61, 24}, {62, 35}, {52, 37}}};
  world.insert_polygon(keep).value();
  world.insert_polygon({{16, 38}, {27, 34}, {32, 44}, {22, 52}}).value();
  world.insert_polygon({{78, 8}, {88, 6}, {90, 16}, {80, 19}}).value();
  world.insert_polyline({{20, 6}, {26, 14}, {24, 24}}).value();
  world.insert_polyline({{70, 51}, {79, 48}, {82, 38}}).value();
  return world;
}

std::vector<Unit> make_units() {
  return {{"Archers", {10, 14}, {72, 10}, 1.5, true},
          {"Cavalry", {9, 46}, {72, 55}, 2.0, true},
          {"Scouts", {54.5, 30}, {54.5, 30}, 1.2, false},
          {"Siege tower", {92, 34}, {36, 30}, 2.6, false}};
}

/// Returns a whole number as text. Unlike a stream, this puts no separators between the digits in any locale.
std::string rounded(double value) { return std::to_string(std::lround(value)); }

/// Returns a circle in the picture's own coordinates. The overlay has no member for this.
std::string range_of_fire(const waywright::SvgFrame& frame, const Unit& unit, double range) {
  const Point centre = frame.to_picture(unit.at);
  return "<circle cx=\"" + rounded(centre.x) + "\" cy=\"" + rounded(centre.y) + "\" r=\"" +
         rounded(range * frame.scale()) +
         "\" fill=\"#d55e00\" fill-opacity=\"0.12\" stroke=\"#d55e00\" stroke-dasharray=\"4 4\"/>";
}

std::string draw(const World& world, const std::vector<Unit>& units) {
  waywright::SvgOptions options;
  options.mesh = false;
  options.title = "Siege of the keep";
  options.theme = waywright::SvgTheme::light;

  waywright::SvgOverlay overlay;
  for (const Unit& unit : units) {
    const std::string colour = unit.is_ours ? "#0072b2" : "#d55e00";
    const Path path = world.find_path({.start = unit.at, .goal = unit.goal}).value();
    overlay.polylines.push_back({.points = path.points, .width = 2.0, .dashed = true, .colour = colour});
    overlay.discs.push_back({unit.at, unit.radius, colour, unit.name + ", " + rounded(path.length) + " to go"});
    overlay.labels.push_back({.at = unit.at, .text = unit.name, .radius = unit.radius});
  }
  overlay.elements = range_of_fire(waywright::svg_frame(world.domain(), options).value(), units.back(), 15.0);
  overlay.keys = {{"our units", "#0072b2"}, {"theirs", "#d55e00"}};
  return waywright::to_svg(world, overlay, options).value();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Unit> units = make_units();
  const std::string picture = draw(make_world(), units);
  bool is_right = picture.starts_with("<svg");
  for (const Unit& unit : units) is_right = is_right && picture.find(">" + unit.name + "<") != std::string::npos;
  std::printf("a picture of %zu units: %s\n", units.size(), is_right ? "right" : "WRONG");
  if (argc < 2) return is_right ? 0 : 1;

  std::FILE* const file = std::fopen(argv[1], "wb");
  if (file == nullptr) return 1;
  const bool is_written = std::fwrite(picture.data(), 1, picture.size(), file) == picture.size();
  return std::fclose(file) == 0 && is_written && is_right ? 0 : 1;
}

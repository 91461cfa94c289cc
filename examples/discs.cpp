// Discs of four sizes take four paths through one world, and a fifth one does not get through. docs/guides/discs.md
// explains this example.

#include <cstdio>

#include "waywright/waywright.hpp"

using waywright::DiscFit;
using waywright::ItemId;
using waywright::Path;
using waywright::PathPiece;
using waywright::PathStatus;
using waywright::Point;
using waywright::WidestPath;
using waywright::World;

namespace {

constexpr Point kStart{12, 40};
constexpr Point kGoal{108, 40};

/// Makes the world of examples/maps/rocks.wws.
World make_world() {
  World world = World::create({{0, 0}, {120, 96}}, {.keep_bridges = true}).value();
  // Five rocks between the left and the right. The gaps between them are 10, 2, 5 and 18 wide, from below.
  world.insert_polygon({{46, 0}, {74, 0}, {69, 7}, {58, 11}, {50, 7}}, 1).value();
  world.insert_polygon({{58, 21}, {66, 25}, {67, 32}, {60, 37}, {53, 33}, {51, 25}}, 2).value();
  world.insert_polygon({{60, 39}, {68, 43}, {65, 49}, {56, 50}, {52, 43}}, 3).value();
  world.insert_polygon({{56, 55}, {66, 57}, {70, 62}, {62, 66}, {50, 61}}, 4).value();
  world.insert_polygon({{62, 84}, {73, 87}, {78, 96}, {44, 96}, {51, 87}}, 5).value();
  // A boulder on the left and one on the right.
  world.insert_polygon({{27, 26}, {32, 24}, {36, 28}, {34, 33}, {28, 32}}, 6).value();
  world.insert_polygon({{92, 61}, {97, 58}, {101, 62}, {99, 68}, {93, 67}}, 7).value();
  return world;
}

void print_pieces(const Path& path) {
  for (const PathPiece& piece : path.pieces) {
    if (piece.kind == PathPiece::Kind::line) {
      std::printf("  line to (%.2f, %.2f)\n", piece.to.x, piece.to.y);
    } else {
      std::printf("  arc around (%g, %g) to (%.2f, %.2f)\n", piece.centre.x, piece.centre.y, piece.to.x, piece.to.y);
    }
  }
}

void print_paths(const World& world) {
  for (const double radius : {1.0, 2.5, 5.0, 9.0, 10.0}) {
    const Path path = world.find_path({.start = kStart, .goal = kGoal, .agent = {.radius = radius}}).value();
    if (path.status == PathStatus::found) {
      std::printf("radius %g: length %.2f, %zu pieces\n", radius, path.length, path.pieces.size());
    } else if (path.widest) {
      const WidestPath& widest = *path.widest;
      std::printf("radius %g: no path; the gap from (%g, %g) to (%g, %g) lets %g through\n", radius, widest.from.x,
                  widest.from.y, widest.to.x, widest.to.y, widest.radius);
    }
  }
}

void print_fits(const World& world) {
  for (const double radius : {9.0, 9.5}) {
    const DiscFit fit = world.fit_disc({62, 75}, {.radius = radius}).value();
    std::printf("radius %g %s at (62, 75)", radius, fit.fits ? "fits" : "does not fit");
    for (const ItemId item : fit.items) std::printf(", stopped by item %u", static_cast<unsigned>(item.value));
    std::puts("");
  }
}

void print_widest(World& world) {
  world.remove(4).value();
  const WidestPath widest = world.widest_path(kStart, kGoal).value();
  std::printf("without rock 4: radius %g gets through\n", widest.radius);
}

}  // namespace

int main() {
  World world = make_world();
  print_paths(world);
  std::puts("the pieces for radius 2.5:");
  print_pieces(world.find_path({.start = kStart, .goal = kGoal, .agent = {.radius = 2.5}}).value());
  print_fits(world);
  print_widest(world);
}

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/location.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// @addtogroup pictures
/// @{

/// The colour theme of a picture.
enum class SvgTheme : std::uint8_t {
  automatic,  ///< the theme that the viewer prefers (CSS prefers-color-scheme); light in programs without this rule
  light,
  dark,
};

/// The options of a picture of a world. The part of the picture that shows the world is the *map*. The title, the axes
/// and the legend lie around the map.
///
/// @code{.cpp}
/// const SvgOptions options{.width = 800, .mesh = false, .crop = Box{{0, 0}, {50, 50}}, .title = "South-west"};
/// const std::string svg = to_svg(world, {}, options).value();
/// @endcode
struct SvgOptions {
  /// The width of the picture in pixels, 240 to 100,000: a smaller or larger number counts as the nearer limit,
  /// and infinity and NaN count as 1200. The height follows from the content.
  double width = 1200.0;
  bool mesh = true;  ///< draw the edges of the mesh that are not constrained
  bool axes = true;  ///< draw marks with coordinates on the axes, a scale bar, and a sign that shows the direction of y
  bool ids = true;   ///< show the kind and the id of an item while the pointer is on it
  bool y_down = false;  ///< whether the y axis of the world points down
  SvgTheme theme = SvgTheme::automatic;
  /// The box that the picture shows. It may extend beyond the domain. If `crop` is empty, the picture shows the domain.
  /// The SVG text contains nothing that lies outside the box.
  std::optional<Box> crop = std::nullopt;
  std::string title = {};  ///< the text above the map; empty for no title
};

/// A path query that found no path. The picture shows a dashed line between two marks, and the status.
struct SvgFailedPath {
  Point start;
  Point goal;
  PathStatus status = PathStatus::no_path;
};

/// A path query with a radius above 0, and its answer. The picture shows the path of the disc's centre, the area that
/// the disc covers on its path, and the disc at the start and at the goal. If there is no path, the picture shows the
/// same marks as for SvgFailedPath. If the disc does not fit at an end, it also shows the items that stop the disc. If
/// the answer has Path::widest, it also shows the narrowest gap with its width, and the items at the ends of the gap.
///
/// @code{.cpp}
/// World yard = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
/// yard.insert_segment({50, 0}, {50, 60}, 1).value();
/// const PathQuery query{.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}};
/// const std::string svg = to_svg(yard, {.disc_paths = {{query, yard.find_path(query).value()}}}, {}).value();
/// @endcode
struct SvgDiscPath {
  PathQuery query;
  Path answer = {};
};

/// A query of World::ray and its answer. The picture shows the start, the end and the position of the hit.
struct SvgRay {
  Point from;
  Point to;
  RayHit answer = {};
};

/// A query of World::locate and its answer. The colour and shape of the mark show the answer.
struct SvgLocation {
  Point at;
  Location answer = {};
};

/// A disc that you add to a picture, for example a unit.
struct SvgDisc {
  Point centre;
  double radius = 0.0;      ///< in units of the world; in the picture, the radius is at least 3 pixels
  std::string colour = {};  ///< any CSS colour, for example `#d55e00` or `red`; empty for the colour of the theme
  std::string hint = {};    ///< the text on hover; empty for none
};

/// A line through several points that you add to a picture.
struct SvgPolyline {
  std::vector<Point> points = {};
  double width = 2.0;  ///< in pixels, 0.1 to 60
  bool dashed = false;
  std::string colour = {};  ///< as in SvgDisc
  std::string hint = {};    ///< as in SvgDisc
};

/// A text that you add to a picture. The picture shows it to the right of `at`, or to the left if the map has no room
/// on the right.
struct SvgLabel {
  Point at;
  std::string text = {};
  double radius = 0.0;      ///< in units of the world: the radius of a disc around `at` that the text keeps free
  double size = 14.0;       ///< the font size in pixels, 4 to 200
  std::string colour = {};  ///< any CSS colour; empty for the colour of all text
};

/// An entry that you add to the legend.
struct SvgKey {
  std::string text = {};
  std::string colour = {};  ///< as in SvgDisc
};

/// The content of a picture on top of the world: queries with their answers, and other marks that you add. Texts and
/// colours may contain any bytes. The picture omits marks whose coordinates are not finite. It draws later members of
/// this struct over earlier ones, with one exception: the marks and texts of all queries (`disc_paths` to `locations`)
/// lie over the lines of all queries.
///
/// @code{.cpp}
/// SvgOverlay overlay;
/// overlay.paths.push_back(world.find_path({.start = start, .goal = goal}).value());
/// overlay.discs.push_back({.centre = start, .radius = 1.5, .colour = "#d55e00", .hint = "Archers"});
/// overlay.labels.push_back({.at = start, .text = "Archers", .radius = 1.5});
/// overlay.keys.push_back({.text = "our units", .colour = "#d55e00"});
/// overlay.polylines.push_back({.points = {{5, 5}, {9, 8}, {5, 11}}, .width = 4, .dashed = true});
/// overlay.rays.push_back({start, goal, world.ray(start, goal).value()});
/// overlay.locations.push_back({goal, world.locate(goal).value()});
/// overlay.failed_paths.push_back({start, {50, 50}, PathStatus::goal_blocked});
/// const std::string svg = to_svg(world, overlay, {}).value();
/// @endcode
struct SvgOverlay {
  std::vector<SvgDiscPath> disc_paths = {};  ///< the picture omits queries without a radius above 0
  std::vector<Path> paths = {};              ///< the picture omits paths without points
  std::vector<SvgRay> rays = {};
  std::vector<SvgFailedPath> failed_paths = {};
  std::vector<SvgLocation> locations = {};
  std::vector<SvgPolyline> polylines = {};
  std::vector<SvgDisc> discs = {};
  /// SVG elements in the coordinates of the picture (SvgFrame). to_svg writes them as they are and clips them to the
  /// map.
  /// Requires: well-formed XML.
  std::string elements = {};
  std::vector<SvgLabel> labels = {};
  std::vector<SvgKey> keys = {};  ///< the last entries of the legend
};

/// The transform between the coordinates of a world and the coordinates of its picture. The coordinates of a picture
/// are pixels, from its upper left corner to the right and downwards. Use it to draw SvgOverlay::elements.
///
/// @code{.cpp}
/// const SvgOptions options;
/// const SvgFrame frame = svg_frame(world.domain(), options).value();
/// const Point pixel = frame.to_picture({50, 50});
/// SvgOverlay overlay;
/// overlay.elements = "<circle cx=\"" + std::to_string(std::lround(pixel.x)) + "\" cy=\"" +
///                    std::to_string(std::lround(pixel.y)) + "\" r=\"20\"/>";
/// const std::string svg = to_svg(world, overlay, options).value();
/// @endcode
class WAYWRIGHT_API SvgFrame {
 public:
  /// Makes the transform of a picture that shows the box `shown`. In the picture, the upper left corner of this box is
  /// at the pixel `corner`, and a unit of length is `scale` pixels long. If `y_down` is true, the y axis of the world
  /// points down in the picture, otherwise up.
  SvgFrame(const Box& shown, Point corner, double scale, bool y_down);

  /// Returns the position of a point of the world in the picture, in pixels.
  [[nodiscard]] Point to_picture(Point point) const;
  /// Returns the point of the world at a pixel.
  [[nodiscard]] Point to_world(Point pixels) const;
  /// Returns the number of pixels of one unit of length.
  [[nodiscard]] double scale() const { return scale_; }
  /// Returns the box that the picture shows, in the coordinates of the world.
  [[nodiscard]] const Box& shown() const { return shown_; }
  /// Returns whether the y axis of the world points down in the picture.
  [[nodiscard]] bool y_down() const { return y_down_; }
  /// Returns the box of the map (see SvgOptions) in the coordinates of the picture. `min` is its upper left corner.
  [[nodiscard]] const Box& map() const { return map_; }

 private:
  Box shown_;
  Box map_;
  double scale_ = 1.0;
  bool y_down_ = false;
};

/// Returns the transform of the picture that to_svg draws of a world over `domain`.
/// Errors: the errors of to_svg.
/// Cost: O(1).
[[nodiscard]] WAYWRIGHT_API Result<SvgFrame> svg_frame(const Box& domain, const SvgOptions& options);

/// Returns a picture of the world as SVG text: polygons, polylines, items of one point, the mesh, the overlay,
/// coordinates and a legend. Equal worlds, overlays and options give equal text on every machine. docs/pictures.md
/// shows examples.
///
/// @code{.cpp}
/// const std::string svg = to_svg(world, {.paths = {path}}, {.title = "My world"}).value();
/// if (std::FILE* const file = std::fopen("world.svg", "wb")) {
///   std::fwrite(svg.data(), 1, svg.size(), file);
///   std::fclose(file);
/// }
/// @endcode
///
/// The function computes positions in doubles. If an item reaches out of a crop box by more than 2^40 times the size of
/// the box, the picture may show the item at a wrong position. An SvgDisc whose radius would be more than 10^7 pixels
/// has this radius in the picture. The function omits details of large worlds to keep the text small:
/// - It omits a mesh of more than 300,000 edges in the picture, and the legend says so.
/// - If the picture shows more than 50,000 items, no item shows its id on hover.
///
/// Errors: coordinate_range; bad_domain, if min of the crop box is not below its max; out_of_domain, if the crop box
/// has no area in common with the domain.
/// Cost: the sum of the cost of World::snapshot (if the picture shows the mesh), the cost of World::items (with a crop
/// box: World::items_in), and the length of the text.
[[nodiscard]] WAYWRIGHT_API Result<std::string> to_svg(const World& world, const SvgOverlay& overlay,
                                                       const SvgOptions& options);

/// @}

}  // namespace waywright

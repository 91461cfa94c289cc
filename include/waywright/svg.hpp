#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/ray.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// The colours of a picture.
enum class SvgTheme : std::uint8_t {
  automatic,  ///< as the viewer prefers (CSS prefers-color-scheme); light in programs that ignore this rule
  light,
  dark,
};

/// How a picture shows the world.
struct SvgOptions {
  double width = 1200.0;  ///< of the picture, in pixels, 240 to 100,000; its height follows from what it shows
  bool mesh = true;       ///< draw the free edges
  bool axes = true;       ///< draw ticks with coordinates, a scale bar, and a sign that says where y points
  bool ids = true;        ///< give each item its id as text on hover
  bool y_down = false;    ///< the world's y axis points down
  SvgTheme theme = SvgTheme::automatic;
  /// The part of the world to show; without it, the domain. It may reach beyond the domain. The text holds nothing of
  /// what lies outside.
  std::optional<Box> crop = std::nullopt;
  std::string title = {};  ///< printed above the map; empty for no title
};

/// A query for a path that found none: a dashed line between two marks, and its status.
struct SvgFailedPath {
  Point start;
  Point goal;
  PathStatus status = PathStatus::no_path;
};

/// A segment that World::ray was asked about, and the answer: start, end, and where it hit.
struct SvgRay {
  Point from;
  Point to;
  RayHit answer = {};
};

/// A place that World::locate was asked about, and the answer: its colour and shape say which.
struct SvgPlace {
  Point at;
  Location answer = {};
};

/// A disc of the caller's, such as a unit.
struct SvgDisc {
  Point centre;
  double radius = 0.0;      ///< in units of the world; drawn with at least 3 pixels
  std::string colour = {};  ///< any CSS colour, such as `#d55e00` or `red`; empty for the theme's
  std::string hint = {};    ///< text on hover; empty for none
};

/// A line of the caller's through several points.
struct SvgPolyline {
  std::vector<Point> points = {};
  double width = 2.0;  ///< in pixels, 0.1 to 60
  bool dashed = false;
  std::string colour = {};  ///< as in SvgDisc
  std::string hint = {};    ///< as in SvgDisc
};

/// A text of the caller's. It stands to the right of its place, or to the left where the map has no room on the right.
struct SvgLabel {
  Point at;
  std::string text = {};
  double radius = 0.0;      ///< in units of the world: of the disc around the place that the text leaves free
  double size = 14.0;       ///< of the letters, in pixels, 4 to 200
  std::string colour = {};  ///< any CSS colour; empty for that of all text
};

/// An entry of the legend, for what the caller adds.
struct SvgKey {
  std::string text = {};
  std::string colour = {};  ///< as in SvgDisc
};

/// What a picture shows on top of the world: queries with their answers, and whatever else the caller wants there.
/// Texts and colours may hold any bytes. What has no finite place is left out. Later members are drawn over earlier
/// ones.
struct SvgOverlay {
  std::vector<Path> paths = {};  ///< those without points are left out
  std::vector<SvgRay> rays = {};
  std::vector<SvgFailedPath> failed_paths = {};
  std::vector<SvgPlace> places = {};
  std::vector<SvgPolyline> polylines = {};
  std::vector<SvgDisc> discs = {};
  /// SVG elements in the picture's coordinates (SvgFrame), written as they are and clipped to the map. Requires:
  /// well-formed XML.
  std::string elements = {};
  std::vector<SvgLabel> labels = {};
  std::vector<SvgKey> keys = {};  ///< at the end of the legend
};

/// The transform of a picture: which place of the world stands where. A picture's coordinates are pixels, from its
/// upper left corner to the right and downwards.
class WAYWRIGHT_API SvgFrame {
 public:
  /// Shows the box `shown` so that its upper left corner stands at `corner`, a unit of length being `scale` pixels.
  SvgFrame(const Box& shown, Point corner, double scale, bool y_down);

  [[nodiscard]] Point to_picture(Point place) const;
  [[nodiscard]] Point to_world(Point pixels) const;
  /// The pixels of one unit of length.
  [[nodiscard]] double scale() const { return scale_; }
  /// What is shown, in the world's coordinates.
  [[nodiscard]] const Box& shown() const { return shown_; }
  /// Where the map is in the picture; `min` is its upper left corner.
  [[nodiscard]] const Box& map() const { return map_; }

 private:
  Box shown_;
  Box map_;
  double scale_ = 1.0;
  bool y_down_ = false;
};

/// The transform of the picture that to_svg draws of a world over `domain`. Errors: those of to_svg. Cost: O(1).
[[nodiscard]] WAYWRIGHT_API Result<SvgFrame> svg_frame(const Box& domain, const SvgOptions& options);

/// A picture of the world as SVG text: solids, walls, free points, mesh, the overlay, coordinates and a legend.
/// Equal worlds, overlays and options give equal text on every machine. Positions are computed in doubles: what reaches
/// out of a crop box by more than 2^40 times its size may be drawn displaced. Large worlds give a smaller text: a mesh
/// of more than 300,000 edges in the picture is left out, and the legend says so; of more than 50,000 items in the
/// picture none has its id on hover.
/// Errors: coordinate_range, bad_domain (where the crop box's min is not below its max), out_of_domain (where the crop
/// box has no area in common with the domain). Cost: that of World::snapshot if there is a mesh to draw; that of
/// World::items or, with a crop box, World::items_in; and that of the text.
[[nodiscard]] WAYWRIGHT_API Result<std::string> to_svg(const World& world, const SvgOverlay& overlay,
                                                       const SvgOptions& options);

}  // namespace waywright

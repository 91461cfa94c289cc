#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/svg.hpp"

namespace waywright::svg {

/// Builds the `d` attribute of a path element from points of the world. It omits lines far outside the map, and cuts
/// lines at the border of a box that is a little larger than the map.
class PathData {
 public:
  /// `stroke_width` is the width of the stroke in pixels, if the stroke may be wide.
  explicit PathData(const SvgFrame& frame, double stroke_width = 0.0);

  /// Adds an open line through the points, or those pieces of it that are near the map.
  void add_chain(PointSpan points);
  /// Adds a closed line. Cuts it so that its winding number around each point of the map stays the same.
  void add_ring(PointSpan points);
  /// Adds a point, for strokes with round ends.
  void add_dot(const Point& position);
  void add_segment(const Point& a, const Point& b);
  /// Adds the lines and arcs of the path of a disc, or those that are near the map.
  void add_pieces(std::span<const PathPiece> pieces);

  /// Returns the text so far and starts a new one, if it is long: XML readers refuse attributes of 10 MB. Otherwise
  /// returns an empty text.
  [[nodiscard]] std::string take_if_long();

  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// An arc in pixels. Its angle counts from the x axis of the picture towards the y axis, which points down.
  struct Arc {
    Point centre;
    double radius = 0.0;
    bool is_rising = false;  // whether the angle increases from the start of the arc to its end
    Point from;
    Point to;
    double angle = 0.0;  // between `from` and `to`, 0 or more
  };

  /// Adds a line between two points of the picture, or the piece of it that is near the map.
  void add_line(Point a, Point b);
  void add_arc(const Arc& arc);
  void add_whole_arc(const Arc& arc);
  [[nodiscard]] static Point middle_of(const Arc& arc);
  void move_to(const Point& pixels);
  void line_to(const Point& pixels);
  void append(char command, const Point& pixels);

  const SvgFrame& frame_;
  Box near_;  // the box of the map, enlarged by room for wide strokes
  std::string text_;
  Point last_;  // rounded as in the text
  bool has_line_ = false;
  bool is_continued_ = false;  // whether the next line starts where the text ends
  std::vector<Point> ring_;
  std::vector<Point> scratch_;
};

/// Cuts a segment to a closed box. Returns false if they have no point in common, or if a coordinate of the segment is
/// not finite. Does not change an end that lies inside the box. Source: Liang and Barsky, *A new concept and method for
/// line clipping*, 1984.
[[nodiscard]] bool clip_segment(const Box& box, Point& a, Point& b);

/// Cuts a ring to a box. The winding number of the ring around each point inside the box stays the same. Source:
/// Sutherland and Hodgman, *Reentrant polygon clipping*, 1974.
void clip_ring(const Box& box, std::vector<Point>& ring, std::vector<Point>& scratch);

}  // namespace waywright::svg

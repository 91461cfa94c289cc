#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/svg.hpp"

namespace waywright::io {

/// Appends a number with at most two decimals, without trailing zeros. A hundredth of a pixel is invisible.
void append_pixels(std::string& out, double value);

/// Appends a text that is safe for XML: escapes markup, replaces control characters by blanks, and bytes that are not
/// UTF-8 by `?`.
void append_escaped(std::string& out, std::string_view text);

/// Appends ` name="value"`, with the value as it is.
void append_attribute(std::string& out, std::string_view name, std::string_view value);
void append_attribute(std::string& out, std::string_view name, double value);

/// Appends `<title>text</title>`, escaped. A browser shows this text on hover.
void append_hint(std::string& out, std::string_view text);

/// The number of characters in a UTF-8 text.
[[nodiscard]] std::size_t character_count(std::string_view text);

/// Returns the text or, if it has more than `most` characters, the first `most` - 1 of them and `…`. Requires: `most`
/// is 1 or more.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

[[nodiscard]] bool is_finite(const Point& point);
[[nodiscard]] bool contains(const Box& box, const Point& point);
[[nodiscard]] bool contains(const Box& box, const Box& other);
/// Returns whether two closed boxes have a point in common.
[[nodiscard]] bool meets(const Box& box, const Box& other);

/// Returns whether a disc may have a point in common with a box. Compares the box around the disc.
[[nodiscard]] bool meets(const Box& box, const Point& centre, double radius);

[[nodiscard]] std::string circle(const Point& centre, double radius);

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

}  // namespace waywright::io

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

[[nodiscard]] std::string circle(const Point& centre, double radius);

/// Builds the `d` attribute of a path element from points of the world. It omits lines far outside the map, and cuts
/// lines at the border of a box that is a little larger than the map.
class PathData {
 public:
  explicit PathData(const SvgFrame& frame);

  /// Adds an open line through the points, or those pieces of it that are near the map.
  void add_chain(PointSpan points);
  /// Adds a closed line. Cuts it so that its winding number around each point of the map stays the same.
  void add_ring(PointSpan points);
  /// Adds a point, for strokes with round ends.
  void add_dot(const Point& position);
  void add_segment(const Point& a, const Point& b);

  /// Returns the text so far and starts a new one, if it is long: XML readers refuse attributes of 10 MB. Otherwise
  /// returns an empty text.
  [[nodiscard]] std::string take_if_long();

  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void move_to(const Point& pixels);
  void line_to(const Point& pixels);
  void append(char command, const Point& pixels);

  const SvgFrame& frame_;
  Box near_;  // the box of the map, enlarged by room for wide strokes
  std::string text_;
  Point last_;  // rounded as in the text
  bool has_line_ = false;
  std::vector<Point> ring_;
  std::vector<Point> scratch_;
};

}  // namespace waywright::io

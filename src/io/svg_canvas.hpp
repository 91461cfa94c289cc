#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/svg.hpp"

namespace waywright::io {

/// A number as text with at most two decimals, without trailing zeros; nobody sees a hundredth of a pixel.
void append_pixels(std::string& out, double value);

/// Text made safe for XML: markup escaped, control characters replaced by blanks, bytes that are no UTF-8 by `?`.
void append_escaped(std::string& out, std::string_view text);

/// ` name="value"`, the value written as it is.
void append_attribute(std::string& out, std::string_view name, std::string_view value);
void append_attribute(std::string& out, std::string_view name, double value);

/// `<title>text</title>`, escaped: what a browser shows on hover.
void append_hint(std::string& out, std::string_view text);

/// The number of characters of a UTF-8 text.
[[nodiscard]] std::size_t character_count(std::string_view text);

/// The text or, if it has more than `most` characters, the first of them and `…`. Requires: `most` is 1 or more.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

[[nodiscard]] bool is_finite(const Point& point);
[[nodiscard]] bool contains(const Box& box, const Point& point);

[[nodiscard]] std::string circle(const Point& centre, double radius);

/// Collects the `d` attribute of a path element, of places of the world. What lies far outside the map is left out, and
/// what crosses its edge is cut.
class PathData {
 public:
  explicit PathData(const SvgFrame& frame);

  /// An open line through the points, or of those parts of it that are near the map.
  void add_chain(PointSpan points);
  /// A closed line. Cut so that it turns around each place of the map as often as before.
  void add_ring(PointSpan points);
  /// A point, for strokes with round ends.
  void add_dot(const Point& place);
  void add_segment(const Point& a, const Point& b);

  /// The text so far, once it is long: XML readers refuse attributes of 10 MB. The rest begins anew. Empty before.
  [[nodiscard]] std::string take_if_long();

  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void move_to(const Point& pixels);
  void line_to(const Point& pixels);
  void append(char command, const Point& pixels);

  const SvgFrame& frame_;
  Box near_;  // the map and the room that broad strokes need
  std::string text_;
  Point last_;  // as rounded in the text
  bool has_line_ = false;
  std::vector<Point> ring_;
  std::vector<Point> scratch_;
};

}  // namespace waywright::io

#pragma once

#include <string>
#include <string_view>

#include "waywright/point.hpp"

namespace waywright::io {

/// A number as text with at most two decimals, trailing zeros dropped; the hundredth of a pixel is finer than any eye.
void append_pixels(std::string& out, double value);

/// Text made safe for XML: markup escaped, control characters blanked, bytes that are no UTF-8 replaced.
void append_escaped(std::string& out, std::string_view text);

/// ` name="value"`, the value taken as it is.
void append_attribute(std::string& out, std::string_view name, std::string_view value);
void append_attribute(std::string& out, std::string_view name, double value);

/// Where the domain lies in the picture, all in pixels but the scale.
class Frame {
 public:
  /// Fits `domain` into a picture of the given width below a strip of height `top`, keeping its proportions.
  Frame(const Box& domain, double picture_width, double top, bool y_down);

  [[nodiscard]] Point to_pixels(const Point& place) const;
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  /// The lower end of the map, its margin included.
  [[nodiscard]] double bottom() const { return panel_bottom_; }

 private:
  Box domain_;
  bool y_down_ = false;
  double scale_ = 1.0;
  double left_ = 0.0;
  double top_ = 0.0;
  double width_ = 0.0;
  double height_ = 0.0;
  double panel_bottom_ = 0.0;
};

/// Collects the `d` attribute of a path element.
class PathData {
 public:
  explicit PathData(const Frame& frame) : frame_(frame) {}

  void move_to(const Point& place);
  void line_to(const Point& place);
  void close() { text_ += 'Z'; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void append(char command, const Point& place);

  const Frame& frame_;
  std::string text_;
};

}  // namespace waywright::io

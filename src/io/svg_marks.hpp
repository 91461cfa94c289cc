#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

#include "io/svg_theme.hpp"

namespace waywright::io {

/// Returns the point as text: `(3, 4.5)`.
[[nodiscard]] std::string point_text(const Point& position);

/// Returns the ids as text. For a long list, the first few and the number of the others. The id 0 becomes `the domain`.
[[nodiscard]] std::string ids_text(const std::vector<ItemId>& ids);

/// Each function returns a mark at a point of the picture. A browser shows `hint` on hover, unless it is empty.
[[nodiscard]] std::string disc_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                    const Paint& stroke, double stroke_width, std::string_view hint = {});
[[nodiscard]] std::string square_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                      std::string_view hint = {});
[[nodiscard]] std::string diamond_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                       std::string_view hint = {});
/// A cross of two strokes.
[[nodiscard]] std::string cross_mark(const Palette& palette, const Point& at, double radius, const Paint& stroke,
                                     std::string_view hint = {});
/// A target of two rings.
[[nodiscard]] std::string goal_mark(const Palette& palette, const Point& at, double radius, const Paint& colour,
                                    std::string_view hint = {});

/// A text with a rim in the colour of the page. The rim makes the text readable on any background.
struct TextMark {
  Point at;
  std::string_view anchor = "start";
  double size = 14.0;
  Paint colour{Ink::text};
};
[[nodiscard]] std::string text_mark(const Palette& palette, const TextMark& mark, std::string_view text);

}  // namespace waywright::io

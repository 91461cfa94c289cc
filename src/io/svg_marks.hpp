#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

#include "io/svg_theme.hpp"

namespace waywright::io {

/// `(3, 4.5)`
[[nodiscard]] std::string place_text(const Point& place);

/// The ids, of a long list the first few and how many more there are; 0 as `the domain`.
[[nodiscard]] std::string ids_text(const std::vector<ItemId>& ids);

/// Marks at a place of the picture. `hint` is shown on hover; none where it is empty.
[[nodiscard]] std::string disc_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                    const Paint& stroke, double stroke_width, std::string_view hint = {});
[[nodiscard]] std::string square_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                      std::string_view hint = {});
[[nodiscard]] std::string diamond_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                                       std::string_view hint = {});
/// Two strokes.
[[nodiscard]] std::string cross_mark(const Palette& palette, const Point& at, double radius, const Paint& stroke,
                                     std::string_view hint = {});
/// A target of two rings.
[[nodiscard]] std::string goal_mark(const Palette& palette, const Point& at, double radius, const Paint& colour,
                                    std::string_view hint = {});

/// A text with a rim of the page's colour, so that it can be read on anything.
struct TextMark {
  Point at;
  std::string_view anchor = "start";
  double size = 14.0;
  Paint colour{Ink::text};
};
[[nodiscard]] std::string text_mark(const Palette& palette, const TextMark& mark, std::string_view text);

}  // namespace waywright::io

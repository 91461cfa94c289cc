#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"
#include "waywright/svg.hpp"

#include "svg/theme.hpp"

namespace waywright::svg {

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

/// Returns a line as a sample for the legend.
[[nodiscard]] std::string line_sample(const Palette& palette, const Paint& colour, double stroke_width,
                                      std::string_view attributes = {});

/// Returns a count with its noun: `1 polyline`, `2 polylines`.
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace waywright::svg

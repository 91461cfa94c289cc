#include "io/svg_marks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "io/svg_canvas.hpp"
#include "text/text.hpp"

namespace waywright::io {

namespace {

constexpr std::size_t kMostIds = 8;

std::string path_through(std::span<const Point> corners) {
  std::string data;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    data += i == 0 ? 'M' : 'L';
    append_pixels(data, corners[i].x);
    data += ' ';
    append_pixels(data, corners[i].y);
  }
  return data;
}

/// Appends the end of an element whose start tag still lacks its `>`.
std::string close_element(std::string out, std::string_view name, std::string_view hint) {
  if (hint.empty()) return out + "/>";
  out += '>';
  append_hint(out, hint);
  out += "</";
  out += name;
  return out + '>';
}

std::string filled_mark(const Palette& palette, std::span<const Point> corners, const Paint& fill,
                        std::string_view hint) {
  std::string out = "<path d=\"" + path_through(corners) + "Z\" stroke-width=\"1.5\"";
  palette.append(out, fill, {Ink::page});
  return close_element(std::move(out), "path", hint);
}

}  // namespace

std::string point_text(const Point& position) {
  std::string text = "(";
  text::append_number(text, position.x);
  text += ", ";
  text::append_number(text, position.y);
  return text += ')';
}

std::string ids_text(const std::vector<ItemId>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), kMostIds); ++i) {
    if (i > 0) text += ", ";
    if (ids[i].is_null()) {
      text += "the domain";
    } else {
      text::append_unsigned(text, ids[i].value);
    }
  }
  if (ids.size() > kMostIds) text += text::with_number(" and ", ids.size() - kMostIds, " more");
  return text;
}

std::string disc_mark(const Palette& palette, const Point& at, double radius, const Paint& fill, const Paint& stroke,
                      double stroke_width, std::string_view hint) {
  std::string out = circle(at, radius);
  out.erase(out.size() - 2);  // removes the end of the element, `/>`
  palette.append(out, fill, stroke);
  append_attribute(out, "stroke-width", stroke_width);
  return close_element(std::move(out), "circle", hint);
}

std::string square_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                        std::string_view hint) {
  const std::array<Point, 4> corners{Point{at.x - radius, at.y - radius}, Point{at.x + radius, at.y - radius},
                                     Point{at.x + radius, at.y + radius}, Point{at.x - radius, at.y + radius}};
  return filled_mark(palette, corners, fill, hint);
}

std::string diamond_mark(const Palette& palette, const Point& at, double radius, const Paint& fill,
                         std::string_view hint) {
  const std::array<Point, 4> corners{Point{at.x, at.y - radius}, Point{at.x + radius, at.y}, Point{at.x, at.y + radius},
                                     Point{at.x - radius, at.y}};
  return filled_mark(palette, corners, fill, hint);
}

std::string cross_mark(const Palette& palette, const Point& at, double radius, const Paint& stroke,
                       std::string_view hint) {
  const std::array<Point, 2> falling{Point{at.x - radius, at.y - radius}, Point{at.x + radius, at.y + radius}};
  const std::array<Point, 2> rising{Point{at.x - radius, at.y + radius}, Point{at.x + radius, at.y - radius}};
  const std::string data = path_through(falling) + path_through(rising);
  std::string out = "<g stroke-linecap=\"round\">";
  if (!hint.empty()) append_hint(out, hint);
  for (const bool is_rim : {true, false}) {
    out += "<path d=\"" + data + "\"";
    palette.append(out, {Ink::none}, is_rim ? Paint{Ink::page} : stroke);
    append_attribute(out, "stroke-width", radius * (is_rim ? 1.0 : 0.5));
    out += "/>";
  }
  return out + "</g>";
}

std::string goal_mark(const Palette& palette, const Point& at, double radius, const Paint& colour,
                      std::string_view hint) {
  std::string out = "<g>";
  if (!hint.empty()) append_hint(out, hint);
  out += disc_mark(palette, at, radius * 1.25, colour, {Ink::page}, 2.0);
  out += disc_mark(palette, at, radius * 0.8, {Ink::page}, {Ink::none}, 0.0);
  out += disc_mark(palette, at, radius * 0.45, colour, {Ink::none}, 0.0);
  return out + "</g>";
}

std::string text_mark(const Palette& palette, const TextMark& mark, std::string_view text) {
  std::string out = "<text";
  append_attribute(out, "x", mark.at.x);
  append_attribute(out, "y", mark.at.y);
  append_attribute(out, "text-anchor", mark.anchor);
  append_attribute(out, "font-size", mark.size);
  palette.append(out, mark.colour, {Ink::page});
  out += R"( stroke-width="3" stroke-linejoin="round" paint-order="stroke">)";
  append_escaped(out, text);
  return out + "</text>";
}

}  // namespace waywright::io

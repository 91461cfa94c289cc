#include "svg/elements.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/number_text.hpp"

namespace waywright::svg {

namespace {

constexpr double kFarthest = 1e7;

void append_integer(std::string& out, long long value) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Returns the length of the UTF-8 sequence at the start of `text`, or 0 if there is no sequence that XML accepts.
std::size_t sequence_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead < 0x80U ? 1 : lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
  if (length == 0 || lead > 0xF4U || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), is_continuation)) return 0;
  if (length < 3) return length;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (lead == 0xE0U && second < 0xA0U) || (lead == 0xF0U && second < 0x90U);
  const bool beyond = (lead == 0xEDU && second > 0x9FU) || (lead == 0xF4U && second > 0x8FU);
  const bool noncharacter = lead == 0xEFU && second == 0xBFU && static_cast<unsigned char>(text[2]) > 0xBDU;
  return overlong || beyond || noncharacter ? 0 : length;
}

void append_character(std::string& out, char character) {
  switch (character) {
    case '&':
      out += "&amp;";
      return;
    case '<':
      out += "&lt;";
      return;
    case '>':
      out += "&gt;";
      return;
    case '"':
      out += "&quot;";
      return;
    default:
      out += static_cast<unsigned char>(character) < 0x20U ? ' ' : character;
      return;
  }
}

}  // namespace

void append_pixels(std::string& out, double value) {
  const double shown = std::isfinite(value) ? std::clamp(value, -kFarthest, kFarthest) : 0.0;
  long long hundredths = std::llround(shown * 100.0);
  if (hundredths < 0) {
    out += '-';
    hundredths = -hundredths;
  }
  append_integer(out, hundredths / 100);
  const long long rest = hundredths % 100;
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

void append_escaped(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) {
      out += '?';
    } else if (length == 1) {
      append_character(out, text[0]);
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
}

void append_attribute(std::string& out, std::string_view name, std::string_view value) {
  out += ' ';
  out += name;
  out += "=\"";
  out += value;
  out += '"';
}

void append_attribute(std::string& out, std::string_view name, double value) {
  std::string text;
  append_pixels(text, value);
  append_attribute(out, name, text);
}

void append_hint(std::string& out, std::string_view text) {
  out += "<title>";
  append_escaped(out, text);
  out += "</title>";
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

std::string shortened(std::string_view text, std::size_t most) {
  if (character_count(text) <= most) return std::string(text);
  std::size_t count = 0;
  const auto end =
      std::find_if(text.begin(), text.end(), [&](char c) { return !is_continuation(c) && ++count == most; });
  return std::string(text.begin(), end) + "\xe2\x80\xa6";
}

bool is_finite(const Point& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

bool contains(const Box& box, const Point& point) {
  return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

bool contains(const Box& box, const Box& other) { return contains(box, other.min) && contains(box, other.max); }

bool meets(const Box& box, const Box& other) {
  return other.max.x >= box.min.x && other.min.x <= box.max.x && other.max.y >= box.min.y && other.min.y <= box.max.y;
}

bool meets(const Box& box, const Point& centre, double radius) {
  return meets(box, Box{{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}});
}

std::string circle(const Point& centre, double radius) {
  std::string out = "<circle";
  append_attribute(out, "cx", centre.x);
  append_attribute(out, "cy", centre.y);
  append_attribute(out, "r", radius);
  return out + "/>";
}

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
  base::append_number(text, position.x);
  text += ", ";
  base::append_number(text, position.y);
  return text += ')';
}

std::string ids_text(const std::vector<ItemId>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), kMostIds); ++i) {
    if (i > 0) text += ", ";
    if (ids[i].is_null()) {
      text += "the domain";
    } else {
      base::append_unsigned(text, ids[i].value);
    }
  }
  if (ids.size() > kMostIds) text += base::with_number(" and ", ids.size() - kMostIds, " more");
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

std::string line_sample(const Palette& palette, const Paint& colour, double stroke_width, std::string_view attributes) {
  std::string out = "<path d=\"M1 8H27\" stroke-linecap=\"round\"";
  palette.append(out, {Ink::none}, colour);
  append_attribute(out, "stroke-width", stroke_width);
  out += attributes;
  return out + "/>";
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return base::with_number("", count, " ") + std::string(count == 1 ? one : many);
}

}  // namespace waywright::svg

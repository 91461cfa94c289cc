#include "io/svg_canvas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include "io/svg_clip.hpp"

namespace waywright::io {

namespace {

constexpr double kFarthest = 1e7;
constexpr std::size_t kLong = 1000000;
constexpr double kStrokeRoom = 64.0;  // more than half the width of the widest stroke

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

PathData::PathData(const SvgFrame& frame, double stroke_width) : frame_(frame), near_(frame.map()) {
  const double room = kStrokeRoom + stroke_width / 2.0;
  near_.min = {near_.min.x - room, near_.min.y - room};
  near_.max = {near_.max.x + room, near_.max.y + room};
}

void PathData::add_chain(PointSpan points) {
  is_continued_ = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    add_line(frame_.to_picture(points[i - 1]), frame_.to_picture(points[i]));
  }
}

void PathData::add_line(Point a, Point b) {
  const Point whole = b;
  if (!clip_segment(near_, a, b)) {
    is_continued_ = false;
    return;
  }
  if (!is_continued_) move_to(a);
  line_to(b);
  is_continued_ = b == whole;
}

void PathData::add_segment(const Point& a, const Point& b) {
  const std::array<Point, 2> ends{a, b};
  add_chain(ends);
}

void PathData::add_ring(PointSpan points) {
  ring_.clear();
  for (const Point& point : points) ring_.push_back(frame_.to_picture(point));
  clip_ring(near_, ring_, scratch_);
  if (ring_.empty()) return;
  move_to(ring_.front());
  for (std::size_t i = 1; i < ring_.size(); ++i) line_to(ring_[i]);
  text_ += 'Z';
}

void PathData::add_dot(const Point& position) {
  const Point pixels = frame_.to_picture(position);
  if (!contains(near_, pixels)) return;
  move_to(pixels);
  line_to(pixels);
}

std::string PathData::take_if_long() { return text_.size() < kLong ? std::string() : std::exchange(text_, {}); }

void PathData::move_to(const Point& pixels) {
  has_line_ = false;
  append('M', pixels);
}

/// Leaves out a point that rounds to the same two decimals as the point before, but never all points of a line.
void PathData::line_to(const Point& pixels) {
  const Point rounded{std::round(pixels.x * 100.0), std::round(pixels.y * 100.0)};
  if (rounded == last_) {
    if (!has_line_) text_ += "h0";
  } else {
    append('L', pixels);
  }
  has_line_ = true;
}

void PathData::append(char command, const Point& pixels) {
  last_ = {std::round(pixels.x * 100.0), std::round(pixels.y * 100.0)};
  text_ += command;
  append_pixels(text_, pixels.x);
  text_ += ' ';
  append_pixels(text_, pixels.y);
}

}  // namespace waywright::io

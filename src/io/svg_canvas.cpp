#include "io/svg_canvas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace waywright::io {

namespace {

constexpr double kMargin = 20.0;
constexpr double kTallest = 1.5;  // a map's height, in widths
constexpr double kFarthest = 1e7;
constexpr double kLeastPanel = 48.0;  // a flat domain still gets a band one can see

void append_integer(std::string& out, long long value) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The length of the UTF-8 sequence that `text` starts with; 0 when it starts with none that XML would take.
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
  // A caller's path may lead anywhere: what is far outside the picture is drawn at its rim.
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

Frame::Frame(const Box& domain, double picture_width, double top, bool y_down) : domain_(domain), y_down_(y_down) {
  const double across = domain.max.x - domain.min.x;
  const double up = domain.max.y - domain.min.y;
  const double widest = picture_width - 2.0 * kMargin;
  // Proportions of up to 2^200 : 1 are legal; the shorter side then shrinks to a line.
  scale_ = std::min(widest / across, widest * kTallest / up);
  width_ = across * scale_;
  height_ = up * scale_;
  const double panel = std::max(height_, kLeastPanel);
  left_ = kMargin + (widest - width_) / 2.0;
  top_ = top + (panel - height_) / 2.0;
  panel_bottom_ = top + panel + kMargin;
}

Point Frame::to_pixels(const Point& place) const {
  const double down = y_down_ ? place.y - domain_.min.y : domain_.max.y - place.y;
  return {left_ + (place.x - domain_.min.x) * scale_, top_ + down * scale_};
}

void PathData::move_to(const Point& place) { append('M', place); }

void PathData::line_to(const Point& place) { append('L', place); }

void PathData::append(char command, const Point& place) {
  const Point pixels = frame_.to_pixels(place);
  text_ += command;
  append_pixels(text_, pixels.x);
  text_ += ' ';
  append_pixels(text_, pixels.y);
}

}  // namespace waywright::io

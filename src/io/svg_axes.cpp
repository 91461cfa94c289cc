#include "io/svg_axes.hpp"

#include <algorithm>
#include <string_view>

#include "io/svg_canvas.hpp"

namespace waywright::io {

namespace {

constexpr double kScaleBar = 120.0;  // largest length in pixels

void append_line(std::string& data, const Point& from, const Point& to) {
  for (const auto& [letter, position] : {std::pair{'M', from}, std::pair{'L', to}}) {
    data += letter;
    append_pixels(data, position.x);
    data += ' ';
    append_pixels(data, position.y);
  }
}

std::string label(const Point& at, std::string_view anchor, const std::string& text) {
  std::string out = "<text";
  append_attribute(out, "x", at.x);
  append_attribute(out, "y", at.y);
  append_attribute(out, "text-anchor", anchor);
  return out + ">" + text + "</text>\n";
}

/// Returns a bar between two end strokes, 16 pixels high.
std::string bar_sample(double length, const Palette& palette) {
  std::string data;
  append_line(data, {1.0, 8.0}, {length + 1.0, 8.0});
  append_line(data, {1.0, 4.0}, {1.0, 12.0});
  append_line(data, {length + 1.0, 4.0}, {length + 1.0, 12.0});
  return "<path id=\"scale-bar\" d=\"" + data + "\" stroke-width=\"1.5\"" + palette({Ink::none}, {Ink::quiet_text}) +
         "/>";
}

/// Returns two arrows from one corner: x to the right, y up or down.
std::string directions_sample(bool y_down, const Palette& palette) {
  const std::string_view data =
      y_down ? "M4 2H19M16 -1L19 2L16 5M4 2V15M1 12L4 15L7 12" : "M4 14H19M16 11L19 14L16 17M4 14V1M1 4L4 1L7 4";
  return "<path d=\"" + std::string(data) +
         "\" stroke-width=\"1.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\"" +
         palette({Ink::none}, {Ink::quiet_text}) + "/>";
}

}  // namespace

std::string draw_axes(const Layout& layout, const Palette& palette) {
  const Box& map = layout.frame.map();
  const Point& origin = layout.frame.shown().min;
  std::string marks;
  std::string labels;
  for (const Tick& tick : layout.x_ticks) {
    const double x = layout.frame.to_picture({tick.position, origin.y}).x;
    append_line(marks, {x, map.max.y + 1.0}, {x, map.max.y + 1.0 + kTickLength});
    const double half = static_cast<double>(tick.label.size()) * kTickCharacter / 2.0 + 3.0;
    const double middle = std::max(std::min(x, layout.width - half), half);
    labels += label({middle, map.max.y + kTickLength + 14.0}, "middle", tick.label);
  }
  for (const Tick& tick : layout.y_ticks) {
    const double y = layout.frame.to_picture({origin.x, tick.position}).y;
    append_line(marks, {map.min.x - 1.0, y}, {map.min.x - 1.0 - kTickLength, y});
    labels += label({map.min.x - kTickLength - 4.0, y + 4.0}, "end", tick.label);
  }
  std::string out = "<g id=\"axes\"";
  append_attribute(out, "font-size", kTickFont);
  out += palette({Ink::quiet_text}, {Ink::none}) + ">\n<path d=\"" + marks + "\" stroke-width=\"1\"";
  return out + palette({Ink::none}, {Ink::quiet_text}) + "/>\n" + labels + "</g>\n";
}

void add_axes_entries(std::vector<LegendEntry>& entries, const Layout& layout, bool y_down, const Palette& palette) {
  const double scale = layout.frame.scale();
  const Tick length = scale_bar_length(kScaleBar / scale);
  const double pixels = length.position * scale;
  entries.push_back({bar_sample(pixels, palette), length.label, pixels + 2.0});
  entries.push_back({directions_sample(y_down, palette), y_down ? "y down" : "y up", 20.0});
}

}  // namespace waywright::io

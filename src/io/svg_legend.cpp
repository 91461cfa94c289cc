#include "io/svg_legend.hpp"

#include <cstddef>

#include "waywright/point.hpp"

#include "io/svg_canvas.hpp"
#include "io/svg_layout.hpp"

namespace waywright::io {

namespace {

constexpr double kRowHeight = 26.0;
constexpr double kSampleSpace = 8.0;      // between a sample and its label
constexpr double kSpacing = 26.0;         // between entries
constexpr double kLegendCharacter = 7.6;  // width of a wide character; the real fonts are not known here

double entry_width(const LegendEntry& entry) {
  return entry.sample_width + kSampleSpace + static_cast<double>(character_count(entry.label)) * kLegendCharacter +
         kSpacing;
}

/// Returns the position of each entry, in rows that fit the width.
std::vector<Point> arrange(const std::vector<LegendEntry>& entries, double left, double width) {
  std::vector<Point> positions;
  Point next{left, 0.0};
  for (const LegendEntry& entry : entries) {
    const double needed = entry_width(entry) - kSpacing;
    if (next.x > left && next.x + needed > width - kPageMargin) next = {left, next.y + kRowHeight};
    positions.push_back(next);
    next.x += entry_width(entry);
  }
  return positions;
}

}  // namespace

std::string legend(const std::vector<LegendEntry>& entries, const Palette& palette, double width, double left,
                   double top, double& height) {
  height = 0.0;
  std::string out = R"(<g id="legend" font-size="14")" + palette({Ink::quiet_text}, {Ink::none}) + ">\n";
  const std::vector<Point> positions = arrange(entries, left, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    out += "<g transform=\"translate(";
    append_pixels(out, positions[i].x);
    out += ' ';
    append_pixels(out, top + positions[i].y);
    out += ")\">";
    out += entries[i].sample;
    out += "<text";
    append_attribute(out, "x", entries[i].sample_width + kSampleSpace);
    append_attribute(out, "y", 13.0);
    out += '>';
    append_escaped(out, entries[i].label);
    out += "</text></g>\n";
    height = positions[i].y + kRowHeight + kPageMargin / 2.0;
  }
  return out + "</g>\n";
}

}  // namespace waywright::io

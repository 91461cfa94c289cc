#include "io/svg_legend.hpp"

#include <cstddef>

#include "waywright/point.hpp"

#include "io/svg_canvas.hpp"

namespace waywright::io {

namespace {

constexpr double kMargin = 20.0;
constexpr double kRowHeight = 26.0;
constexpr double kSampleWidth = 28.0;
constexpr double kGap = 8.0;        // between sample and label
constexpr double kSpacing = 26.0;   // between entries
constexpr double kCharacter = 7.6;  // fonts are not at hand: a broad character's width

double entry_width(const LegendEntry& entry) {
  return kSampleWidth + kGap + static_cast<double>(entry.label.size()) * kCharacter + kSpacing;
}

/// Where each entry goes, in rows that fit the width.
std::vector<Point> arrange(const std::vector<LegendEntry>& entries, double width) {
  std::vector<Point> places;
  Point next{kMargin, 0.0};
  for (const LegendEntry& entry : entries) {
    const double needed = entry_width(entry) - kSpacing;
    if (next.x > kMargin && next.x + needed > width - kMargin) next = {kMargin, next.y + kRowHeight};
    places.push_back(next);
    next.x += entry_width(entry);
  }
  return places;
}

}  // namespace

double legend_height(const std::vector<LegendEntry>& entries, double width) {
  if (entries.empty()) return 0.0;
  return arrange(entries, width).back().y + kRowHeight + kMargin / 2.0;
}

std::string legend(const std::vector<LegendEntry>& entries, double width, double top) {
  std::string out = R"(<g id="legend" font-size="14" fill="#3b4650">)";
  out += '\n';
  const std::vector<Point> places = arrange(entries, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    out += "<g transform=\"translate(";
    append_pixels(out, places[i].x);
    out += ' ';
    append_pixels(out, top + places[i].y);
    out += ")\">";
    out += entries[i].sample;
    out += "<text";
    append_attribute(out, "x", kSampleWidth + kGap);
    append_attribute(out, "y", 13.0);
    out += '>';
    append_escaped(out, entries[i].label);
    out += "</text></g>\n";
  }
  return out + "</g>\n";
}

}  // namespace waywright::io

#pragma once

#include <string>
#include <vector>

#include "io/svg_theme.hpp"

namespace waywright::io {

/// One entry of the legend: a sample, 16 pixels high, and its meaning.
struct LegendEntry {
  std::string sample;  ///< SVG elements
  std::string label;
  double sample_width = 28.0;
};

/// Returns the legend as one SVG group, in rows that fit the picture's width. Its upper left corner is (`left`, `top`).
/// Writes the height of the legend, including the lower margin, to `height`.
[[nodiscard]] std::string legend(const std::vector<LegendEntry>& entries, const Palette& palette, double width,
                                 double left, double top, double& height);

}  // namespace waywright::io

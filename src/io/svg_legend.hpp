#pragma once

#include <string>
#include <vector>

#include "io/svg_theme.hpp"

namespace waywright::io {

/// One entry of the legend: a sample, 16 pixels high, and what it stands for.
struct LegendEntry {
  std::string sample;  ///< SVG elements
  std::string label;
  double sample_width = 28.0;
};

/// The legend as one SVG group, its upper left corner at (`left`, `top`), in rows that fit the picture's width. Puts
/// its height, the lower margin included, into `height`.
[[nodiscard]] std::string legend(const std::vector<LegendEntry>& entries, const Palette& palette, double width,
                                 double left, double top, double& height);

}  // namespace waywright::io

#pragma once

#include <string>
#include <vector>

namespace waywright::io {

/// One line of the legend: a sample, drawn into a box of 28 by 16 pixels, and what it stands for.
struct LegendEntry {
  std::string sample;  ///< SVG elements
  std::string label;
};

/// How high the legend is, its lower margin included.
[[nodiscard]] double legend_height(const std::vector<LegendEntry>& entries, double width);

/// The legend as one SVG group, its upper end at `top`.
[[nodiscard]] std::string legend(const std::vector<LegendEntry>& entries, double width, double top);

}  // namespace waywright::io

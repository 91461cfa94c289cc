#pragma once

#include <string>
#include <vector>

#include "io/svg_layout.hpp"
#include "io/svg_legend.hpp"
#include "io/svg_theme.hpp"

namespace waywright::io {

/// Draws the ticks below and to the left of the map, with their coordinates.
[[nodiscard]] std::string draw_axes(const Layout& layout, const Palette& palette);

/// Adds a scale bar, and a sign that shows the direction of y.
void add_axes_entries(std::vector<LegendEntry>& entries, const Layout& layout, bool y_down, const Palette& palette);

}  // namespace waywright::io

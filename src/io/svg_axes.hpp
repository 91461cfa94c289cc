#pragma once

#include <string>
#include <vector>

#include "io/svg_layout.hpp"
#include "io/svg_legend.hpp"
#include "io/svg_theme.hpp"

namespace waywright::io {

/// The ticks below and left of the map, with their coordinates.
[[nodiscard]] std::string draw_axes(const Layout& layout, const Palette& palette);

/// A scale bar, and a sign that says where y points.
void add_axes_entries(std::vector<LegendEntry>& entries, const Layout& layout, bool y_down, const Palette& palette);

}  // namespace waywright::io

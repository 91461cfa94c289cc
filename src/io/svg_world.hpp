#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "io/svg_legend.hpp"
#include "io/svg_theme.hpp"

namespace waywright::io {

/// The drawing of a world, and its entries in the legend.
struct WorldDrawing {
  std::string elements;
  std::vector<LegendEntry> entries;
};

/// Returns a line as a sample for the legend.
[[nodiscard]] std::string line_sample(const Palette& palette, const Paint& colour, double stroke_width,
                                      std::string_view attributes = {});

/// Returns a count with its noun: `1 polyline`, `2 polylines`.
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

[[nodiscard]] WorldDrawing draw_world(const World& world, const SvgFrame& frame, const SvgOptions& options,
                                      const Palette& palette);

}  // namespace waywright::io

#pragma once

#include <string>
#include <vector>

#include "waywright/svg.hpp"

#include "io/svg_legend.hpp"
#include "io/svg_theme.hpp"

namespace waywright::io {

/// A part of what lies over the world.
struct OverlayDrawing {
  std::string clipped;  ///< elements to be cut at the map's edge
  std::string whole;    ///< elements to be drawn over those, whole
  std::vector<LegendEntry> entries;
};

/// Paths, rays, failed paths and places.
[[nodiscard]] OverlayDrawing draw_queries(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette);

/// What the caller adds.
[[nodiscard]] OverlayDrawing draw_additions(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette);

}  // namespace waywright::io

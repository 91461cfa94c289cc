#pragma once

#include <string>
#include <vector>

#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "io/svg_legend.hpp"
#include "io/svg_theme.hpp"

namespace waywright::io {

/// A group of elements that lie over the world.
struct OverlayDrawing {
  std::string clipped;  ///< elements that are cut at the border of the map
  std::string whole;    ///< elements that are drawn over the clipped ones and not cut
  std::vector<LegendEntry> entries;
};

/// Draws the paths of discs.
[[nodiscard]] OverlayDrawing draw_disc_paths(const World& world, const SvgOverlay& overlay, const SvgFrame& frame,
                                             const Palette& palette);

/// Draws paths, rays, failed paths and located points.
[[nodiscard]] OverlayDrawing draw_queries(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette);

/// Draws what the caller has added.
[[nodiscard]] OverlayDrawing draw_additions(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette);

}  // namespace waywright::io

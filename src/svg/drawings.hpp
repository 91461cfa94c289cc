#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "svg/theme.hpp"

namespace waywright::svg {

/// One entry of the legend: a sample, 16 pixels high, and its meaning.
struct LegendEntry {
  std::string sample;  ///< SVG elements
  std::string label;
  double sample_width = 28.0;
};

/// The drawing of a world, and its entries in the legend.
struct WorldDrawing {
  std::string elements;
  std::vector<LegendEntry> entries;
};

/// Draws the domain, the items and the mesh.
[[nodiscard]] WorldDrawing draw_world(const World& world, const SvgFrame& frame, const SvgOptions& options,
                                      const Palette& palette);

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

}  // namespace waywright::svg

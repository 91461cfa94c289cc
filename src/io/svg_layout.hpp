#pragma once

#include <vector>

#include "waywright/svg.hpp"

#include "io/svg_ticks.hpp"

namespace waywright::io {

/// Where the map, the title, the ticks and the legend of a picture lie, in pixels from the upper left corner of the
/// picture.
struct Layout {
  SvgFrame frame;             ///< where the map lies, and its scale
  double width = 0.0;         ///< the width of the picture
  double text_left = 0.0;     ///< the left end of the title and of the legend
  double legend_top = 0.0;    ///< the top of the legend: the map and the labels of its ticks lie above it
  std::vector<Tick> x_ticks;  ///< the ticks below the map
  std::vector<Tick> y_ticks;  ///< the ticks on the left of the map
};

inline constexpr double kPageMargin = 20.0;
inline constexpr double kTickLength = 5.0;
inline constexpr double kTickFont = 12.0;
inline constexpr double kTickCharacter = 7.2;  // the largest width of a digit in the font of the ticks

/// Computes the layout of a picture of `domain`, or of the crop box in `options`. The map has the proportions of that
/// box. Errors: the errors of to_svg().
[[nodiscard]] Result<Layout> lay_out(const Box& domain, const SvgOptions& options);

}  // namespace waywright::io

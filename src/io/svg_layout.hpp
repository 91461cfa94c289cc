#pragma once

#include <vector>

#include "waywright/svg.hpp"

#include "io/svg_ticks.hpp"

namespace waywright::io {

/// The positions of the pieces of a picture, in pixels.
struct Layout {
  SvgFrame frame;
  double width = 0.0;   ///< of the picture
  double left = 0.0;    ///< where the title and the legend start
  double bottom = 0.0;  ///< of the map with its ticks; the legend starts there
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;
};

inline constexpr double kPageMargin = 20.0;
inline constexpr double kTickLength = 5.0;
inline constexpr double kTickFont = 12.0;
inline constexpr double kTickCharacter = 7.2;  // largest width of a digit in that font

/// Computes the layout of a picture of `domain`, or of the crop box in `options`. The map has the proportions of that
/// box. Errors: the errors of to_svg().
[[nodiscard]] Result<Layout> lay_out(const Box& domain, const SvgOptions& options);

}  // namespace waywright::io

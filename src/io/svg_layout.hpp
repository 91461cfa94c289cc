#pragma once

#include <vector>

#include "waywright/svg.hpp"

#include "io/svg_ticks.hpp"

namespace waywright::io {

/// Where the parts of a picture are.
struct Layout {
  SvgFrame frame;
  double width = 0.0;   ///< of the picture
  double left = 0.0;    ///< where title and legend begin
  double bottom = 0.0;  ///< of the map with its ticks, where the legend begins
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;
};

inline constexpr double kPageMargin = 20.0;
inline constexpr double kTickLength = 5.0;
inline constexpr double kTickFont = 12.0;
inline constexpr double kTickCharacter = 7.2;  // how broad a digit of that font is at most

/// Fits what the options show of `domain` into the picture, keeping its proportions. Errors: those of to_svg.
[[nodiscard]] Result<Layout> lay_out(const Box& domain, const SvgOptions& options);

}  // namespace waywright::io

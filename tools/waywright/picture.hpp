#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/svg.hpp"

namespace waywright::command {

/// How a picture shows the world: the options that all commands with a picture share.
struct PictureOptions {
  bool no_mesh = false;
  bool no_axes = false;
  SvgTheme theme = SvgTheme::automatic;
  std::vector<std::string> crop;  ///< x0, y0, x1, y1; empty for the whole domain
};

/// What to_svg is told: the options, and the title and orientation of what is drawn. Throws Failure if the crop box is
/// none, or shows nothing of the domain: to be called before any work.
[[nodiscard]] SvgOptions svg_options(const PictureOptions& options, const Box& domain, std::string_view title,
                                     bool y_down);

/// The picture's text. Throws Failure.
[[nodiscard]] std::string draw(const World& world, const SvgOverlay& overlay, const SvgOptions& options);

/// Puts a query's answer, found or not, where the picture shows it.
void add_answer(SvgOverlay& overlay, const PathQuery& query, Path path);

}  // namespace waywright::command

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/svg.hpp"

namespace waywright::command {

/// The options of a picture that all commands with a picture share.
struct PictureOptions {
  bool no_mesh = false;
  bool no_axes = false;
  SvgTheme theme = SvgTheme::automatic;
  std::vector<std::string> crop;  ///< x0, y0, x1, y1; empty for the whole domain
};

/// Returns the options for to_svg(), with the title and the direction of the y axis. Throws Failure if the crop box is
/// empty or shows nothing of the domain; so call it before any work.
[[nodiscard]] SvgOptions svg_options(const PictureOptions& options, const Box& domain, std::string_view title,
                                     bool y_down);

/// Returns the text of the picture. Throws Failure.
[[nodiscard]] std::string draw(const World& world, const SvgOverlay& overlay, const SvgOptions& options);

/// Adds the answer of a query to the overlay: a path, a failed path, or the answer for a disc.
void add_answer(SvgOverlay& overlay, const PathQuery& query, Path path);

}  // namespace waywright::command

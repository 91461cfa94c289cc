#pragma once

#include <string>
#include <vector>

#include "waywright/export.hpp"
#include "waywright/path.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// What a picture shows.
struct SvgOptions {
  double width = 1200.0;  ///< of the picture, in pixels, 240 to 100,000; its height follows from the domain
  bool mesh = true;       ///< the free edges
  bool y_down = false;    ///< the world's y axis points down
  std::string title;      ///< printed above; none when empty
};

/// A picture of the world as SVG text: solids, walls, free points, mesh, the given paths, and a legend. A path without
/// points is passed over. Cost: that of World::snapshot, and of the text.
[[nodiscard]] WAYWRIGHT_API std::string to_svg(const World& world, const std::vector<Path>& paths,
                                               const SvgOptions& options);

}  // namespace waywright
